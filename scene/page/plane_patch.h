// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "raygauge/scene/scene.h"
#include "raygauge/sets/half_space.h"

namespace raygauge::cli {

/// A picture of a half-space, which has no end: the part of its plane (in R^2 a strip below its line) that
/// lies under all other bodies of the scene, in the frame of its own body. `plane` marks it for the page.
nlohmann::json plane_patch(const Scene& scene, const Body& body, const HalfSpace& half_space);

}  // namespace raygauge::cli
