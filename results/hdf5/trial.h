// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace raygauge::hdf5 {

/// Whether `work`, done in a copy of this process, comes to an end, be it by an exception, without a signal
/// and in so many seconds of processor time. What it changes is lost, and it must start no threads: only the
/// calling one is in the copy. Throws ResultsError where there can be no copy.
bool survives(const std::function<void()>& work, double seconds);

}  // namespace raygauge::hdf5
