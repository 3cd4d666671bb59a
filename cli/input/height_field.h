// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "raygauge/sets/convex_set.h"

namespace raygauge::cli {

/// The solid between z = floor and the surface of heights on a regular grid (a MeshObject): the number h in
/// row i and column j of `source`, from 0 on, stands for the point (j spacing, i spacing, h unit). Each cell
/// is two triangles, with the diagonal from (i, j) to (i+1, j+1). `source` is a grey picture (.pgm, text or
/// binary, h from 0 to 65535) or what read_point_source reads. Throws what that throws,
/// InvalidParameterError for a picture that is not understood, fewer than 2 rows or columns, a height not
/// above the floor (the message names row and column) and a spacing that is not positive.
std::shared_ptr<const ConvexSet> read_height_field(const std::string& source, double spacing, double unit,
                                                   double floor);

}  // namespace raygauge::cli
