// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace raygauge {

/// (cos 2πj/m, sin 2πj/m) for 0 <= j < m, within 2^-52 in each coordinate, from + - * / alone: the same bits
/// on every IEEE 754 machine. The eight octants are exact mirror images of each other. Throws
/// InvalidParameterError unless 0 <= j < m <= 2^50.
Eigen::Vector2d circle_point(std::int64_t j, std::int64_t m);

}  // namespace raygauge
