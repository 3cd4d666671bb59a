// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "generators/point_clouds.h"
#include "generators/random.h"

namespace raygauge {

// Maps that leave d_Q(A) exactly as it is, because they are linear and free of rounding, or only reorder.

/// Permutes the coordinates and changes some of their signs, in both sets alike.
void turn_axes(PointClouds& clouds, RandomStream& stream);

/// The clouds as an instance, after turn_axes with the random numbers of (key, generator,
/// RandomPurpose::shape).
Instance turned_instance(PointClouds clouds, const InstanceKey& key, std::string_view generator,
                         std::optional<double> exact_distance);

/// Applies x -> U x to both sets, U a random integer matrix of determinant 1 with entries up to about
/// `largest_entry` (the identity for n = 1). No rounding for integer coordinates below
/// 2^53 / (n · largest_entry).
void apply_unimodular(PointClouds& clouds, RandomStream& stream, double largest_entry);

/// Every column `copies` times, in random order.
Eigen::MatrixXd repeated_and_shuffled(const Eigen::MatrixXd& points, int copies, RandomStream& stream);

/// The points times 2^exponent: exact unless a coordinate leaves the range of normal numbers.
Eigen::MatrixXd scaled_by_power_of_two(const Eigen::MatrixXd& points, int exponent);

/// Uniform on {first, …, last} as a real, and the same with a random sign.
double random_integer(RandomStream& stream, std::int64_t first, std::int64_t last);
double signed_integer(RandomStream& stream, std::int64_t first, std::int64_t last);

}  // namespace raygauge
