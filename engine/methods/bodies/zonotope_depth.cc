// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/bodies/zonotope_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/numerics/fused.h"

namespace raygauge {
namespace {

constexpr double kParallel = 1e-8;        // sine of an angle
constexpr double kTurned = 17 * 0x1p-53;  // of n, relative to |g_i||g_j|/|g_i × g_j|

}  // namespace

RAYGAUGE_VECTORS void ZonotopeDepth::measure(const ZonotopeDepth& of, double size, Lanes& lanes) noexcept {
  const Vector3 c = of.center_;
  Vector3 half[kMost];
  for (int k = 0; k < kMost; ++k) half[k] = of.half_[k];
  for (int first = 0; first < of.lanes_count_; first += Lanes::kVector) {
    for (int lane = 0; lane < Lanes::kVector; ++lane) {
      const int i = first + lane;
      const Vector3 a{lanes.first[0][i], lanes.first[1][i], lanes.first[2][i]},
          b{lanes.second[0][i], lanes.second[1][i], lanes.second[2][i]};
      const Vector3 across = cross(a, b);
      const double of_a = dot(a, a), of_b = dot(b, b);
      const double length = std::sqrt(dot(across, across)), product = std::sqrt(of_a * of_b);
      const bool is_flat = !(length > kParallel * product);
      const double inverse = 1 / length, scale = is_flat ? 0.0 : inverse;
      double sum = 0;
      for (const Vector3& g : half) sum += std::fabs(dot(across, g));
      const double height = (sum - std::fabs(dot(across, c))) * scale;
      const double lower = height - (kTurned * product * scale + kHeight) * size;
      lanes.n[0][i] = across.x * scale;
      lanes.n[1][i] = across.y * scale;
      lanes.n[2][i] = across.z * scale;
      lanes.height[i] = is_flat ? std::numeric_limits<double>::infinity() : height;
      lanes.lower[i] = is_flat ? std::numeric_limits<double>::infinity() : lower;
      lanes.area[i] = is_flat ? length : 0.0;
    }
  }
}

Vector3 ZonotopeDepth::outward(int lane) const noexcept {
  const Vector3 n{lanes_.n[0][lane], lanes_.n[1][lane], lanes_.n[2][lane]};
  return dot(n, center_) > 0 ? -n : n;
}

double ZonotopeDepth::longer_of(int lane) const noexcept {
  double square[2] = {0, 0};
  for (int k = 0; k < 3; ++k) {
    square[0] += lanes_.first[k][lane] * lanes_.first[k][lane];
    square[1] += lanes_.second[k][lane] * lanes_.second[k][lane];
  }
  return std::sqrt(std::max(square[0], square[1]));
}

bool ZonotopeDepth::solve(double size) noexcept {
  if (!(size < kLargest)) return false;
  int pairs = 0;
  for (int j = 1; j < count_; ++j) {
    for (int i = 0; i < j; ++i, ++pairs) {
      for (int k = 0; k < 3; ++k) {
        lanes_.first[k][pairs] = (&half_[i].x)[k];
        lanes_.second[k][pairs] = (&half_[j].x)[k];
      }
    }
  }
  for (int k = 0; k < count_; ++k)
    if (!(dot(half_[k], half_[k]) > kSmallest * kSmallest)) return false;
  for (int k = count_; k < kMost; ++k) half_[k] = {};
  lanes_count_ = pairs;
  measure(*this, size, lanes_);
  double lost = 0;  // by how much D changes where pairs are parallel but for rounding
  lower_ = upper_ = std::numeric_limits<double>::infinity();
  for (int i = 0; i < pairs; ++i) {
    lower_ = std::min(lower_, lanes_.lower[i]);
    nearest_ = lanes_.height[i] < upper_ ? i : nearest_;
    upper_ = std::min(upper_, lanes_.height[i]);
    lost += lanes_.area[i] <= 0 ? 0.0 : lanes_.area[i] / longer_of(i);
  }
  lower_ -= 2 * lost * (1 + 0x1p-40);
  if (!(lower_ > 0 && lower_ < std::numeric_limits<double>::max())) return false;
  upper_ += kHeight * size;
  normal_ = outward(nearest_);
  return true;
}

// Σ s_k g_k = w, in the plane of the facet, of the g_k that are in it, by the least Σ s_k²: two or, of
// parallel faces, more.
bool ZonotopeDepth::find_contact(Vector3& of_first) const noexcept {
  constexpr double kInPlane = 1e-13, kOutside = 1 + 1e-12;
  const Vector3& n = normal_;
  Vector3 w = n * lanes_.height[nearest_] - center_;
  double share[kMost];
  bool is_in_plane[kMost];
  for (int k = 0; k < count_; ++k) {
    const double along = dot(half_[k], n);
    is_in_plane[k] = std::fabs(along) <= kInPlane * std::sqrt(dot(half_[k], half_[k]));
    share[k] = is_in_plane[k] ? 0.0 : along < 0 ? -1.0 : 1.0;
    w = w - half_[k] * share[k];
  }
  const Vector3 first{lanes_.first[0][nearest_], lanes_.first[1][nearest_], lanes_.first[2][nearest_]};
  const Vector3 e = first * (1 / std::sqrt(dot(first, first))), f = cross(n, e);
  double ee = 0, ef = 0, ff = 0;
  for (int k = 0; k < count_; ++k) {
    if (!is_in_plane[k]) continue;
    const double x = dot(half_[k], e), y = dot(half_[k], f);
    ee += x * x;
    ef += x * y;
    ff += y * y;
  }
  const double determinant = ee * ff - ef * ef, x = dot(w, e), y = dot(w, f);
  const Vector3 by = (e * (ff * x - ef * y) + f * (ee * y - ef * x)) * (1 / determinant);
  for (int k = 0; k < count_; ++k) {
    if (!is_in_plane[k]) continue;
    share[k] = dot(half_[k], by);
    if (!(std::fabs(share[k]) <= kOutside)) return false;
    share[k] = std::clamp(share[k], -1.0, 1.0);
  }
  of_first = {};
  for (int k = 0; k < first_count_; ++k) of_first = of_first + half_[k] * share[k];
  return true;
}

}  // namespace raygauge
