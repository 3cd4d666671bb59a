// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sweep/instance.h"

namespace raygauge {

/// `needle`: an instance built as in `example2`, then both sets mapped by the stretch
///
///     x -> x + (aspect - 1) (w·x) w,      w uniform on the unit sphere,
///
/// which makes needles of the spheres. A linear map leaves d as it is (but for the rounding of the
/// coordinates, about 1e-16 · aspect), so d stays that of two unit spheres at `separation`, while the
/// conditioning of the problem is ruined. At n = 1 it is a mere change of units.
Component<Generator> needle_generator();

}  // namespace raygauge
