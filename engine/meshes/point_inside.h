// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "engine/meshes/box_tree.h"

namespace raygauge {

enum class Inside : std::uint8_t { no, yes, unknown };

/// Whether the closed surface winds about p, which must not be on it: the triangles that the ray from p along
/// an axis meets are counted with the sides that it meets them from. Whether it does is decided without
/// rounding, by exact sums, for p moved by an infinitely small amount across the ray: so edges and vertices
/// on the ray count once. `unknown` where a triangle that the ray meets is too thin to say on which side p
/// is, along all three axes. (Edelsbrunner & Mücke, "Simulation of simplicity", 1990.)
Inside point_inside(const BoxTree& tree, const Vector3& p);

}  // namespace raygauge
