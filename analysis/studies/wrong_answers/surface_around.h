// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "analysis/studies/wrong_answers/refutation.h"

namespace raygauge {

/// A surface around the origin in A2 - A1 all of whose planes are more than `depth` from it: from a
/// tetrahedron on, the triangle of the nearest plane is expanded by the support point beyond it. Empty
/// outside of R^3, and where 4000 points do not suffice.
std::optional<SurfaceAround> surface_around(const ConvexSet& A1, const ConvexSet& A2, double depth);

}  // namespace raygauge
