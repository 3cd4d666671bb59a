// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/portable_circle.h"

#include <string>

#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

// Σ_{k>=0} (-1)^k x^(2k+first) / (2k+first)!, the series of cos (first = 0) or sin (first = 1); for x <= π/4
// the terms left out are below 2^-60.
double alternating_series(double x, int first) {
  constexpr int kTerms = 10;
  double sum = 1;
  for (int k = kTerms; k >= 1; --k) {
    const int power = 2 * k + first;
    sum = 1 - x * x / (power * (power - 1)) * sum;
  }
  return first == 0 ? sum : x * sum;
}

}  // namespace

Eigen::Vector2d circle_point(std::int64_t j, std::int64_t m) {
  constexpr std::int64_t kLargest = std::int64_t{1} << 50;
  constexpr double kQuarterPi = 0.78539816339744830962;
  if (j < 0 || j >= m || m > kLargest) {
    throw InvalidParameterError("circle point: needs 0 <= j < m <= 2^50, got j = " + std::to_string(j) +
                                ", m = " + std::to_string(m));
  }
  const std::int64_t octant = 8 * j / m;
  const std::int64_t rest = 8 * j - octant * m;
  const bool mirrored = octant % 2 == 1;  // measured back from the octant's end
  const double angle =
      kQuarterPi * (static_cast<double>(mirrored ? m - rest : rest) / static_cast<double>(m));
  const double c = alternating_series(angle, 0);
  const double s = alternating_series(angle, 1);
  switch (octant) {
    case 0:
      return {c, s};
    case 1:
      return {s, c};
    case 2:
      return {-s, c};
    case 3:
      return {-c, s};
    case 4:
      return {-c, -s};
    case 5:
      return {-s, -c};
    case 6:
      return {s, -c};
    default:
      return {c, -s};
  }
}

}  // namespace raygauge
