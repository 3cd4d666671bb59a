// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "engine/numerics/threshold.h"

/// What was found by measurement for simulations.
namespace raygauge::tuned {

/// Islands of more contacts are solved roughly while it is open which bodies meet, to the residual that
/// tells.
inline constinit const Threshold<std::size_t> kManyContacts{100};
inline constinit const Threshold<double> kRoughFriction{1e-4};

/// Passes within which the residual is to fall to half: to the end, and where a rough answer is enough.
inline constinit const Threshold<int> kPatienceOfPasses{30};
inline constinit const Threshold<int> kPatienceOfRoughPasses{10};

/// Passes after one of which the residual is looked at, while it is far from enough.
inline constinit const Threshold<int> kPassesOfLook{8};

/// How steep the equations of Newton's method for friction are at first, and rounds within which the residual
/// is to fall to half.
inline constinit const Threshold<double> kFirstSteepness{300};
inline constinit const Threshold<int> kPatienceOfRounds{15};

/// Contacts, and bodies, that are worth a second thread.
inline constinit const Threshold<std::size_t> kContactsOfThreads{32};
inline constinit const Threshold<std::size_t> kBodiesOfThreads{16};

}  // namespace raygauge::tuned
