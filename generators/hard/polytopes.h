// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "raygauge/sweep/instance.h"

namespace raygauge {

/// The gauge bodies whose gauge has a closed form.
///
///     cross_polytope   conv{±e_k}                gauge ‖x‖₁                                2n points
///     cube             conv{±1}^n                gauge ‖x‖∞                                2^n points
///     simplex          conv{e_1, …, e_n, -1}     gauge Σx_k + (n+1) max(0, -min x_k)       n+1 points
enum class Body { cross_polytope, cube, simplex };

/// The parameter `body`: which of `choices` (names as above, the first is the default) Q is.
ParameterInfo body_parameter(const std::vector<std::string>& choices);

/// The value of the parameter `body`.
Body body_of(const Parameters& parameters);

/// The vertices, one a column. Throws InvalidParameterError where `body` is a cube with n > 12.
Eigen::MatrixXd vertices(Body body, int n);

/// gauge_body(x); exact where the coordinates are integers whose sum is below 2^53 / (n+1).
double gauge(Body body, const Vector& x);

/// The 2^n points center ± half_width, coordinate by coordinate. Throws InvalidParameterError for n > 12.
Eigen::MatrixXd box(const Vector& center, const Vector& half_width);

/// {(height, ±e_k) : k = 2, …, n} ∪ {(top, 0)} for n >= 2: a facet on the hyperplane x_1 = height, with
/// (height, 0) in its middle, and an apex.
Eigen::MatrixXd facet_and_apex(int n, double height, double top);

}  // namespace raygauge
