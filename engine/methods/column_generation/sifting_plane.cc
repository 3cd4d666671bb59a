// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// Planes between A and a Q that lies on them in part, so that none leaves all of it behind by a margin.
#include <algorithm>
#include <cmath>

#include "engine/methods/column_generation/sifting.h"
#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

// Points of Q so close to the plane of a direction, relative to the farthest, may lie in it.
constexpr double kMaybeInPlane[] = {1e-6, 1e-9};
constexpr double kLeastInPlane = 1e-15, kMostInPlane = 1e-5;  // at the widest gap

}  // namespace

// A plane between A and Q, orthogonal to nearly farkas_, that holds points of Q, so that no other one leaves
// all of Q behind by a margin.
bool Sifting::certify_by_plane(Effects effects, DistanceResult& result) {
  if (farkas_.empty() || !is_complete()) return false;
  return std::any_of(std::begin(kMaybeInPlane), std::end(kMaybeInPlane),
                     [&](double near) { return certify_by_plane(near, effects, result); }) ||
         certify_by_plane(widest_gap(farkas_.data()), effects, result);
}

// Between the points of Q in the plane of u and the others where a direction is not so close to the one that
// leaves them there: relative to the farthest, where |u·q| rises the most from one point to the next.
double Sifting::widest_gap(const double* u) {
  const double* values = products_with(working_Q_, u);
  std::vector<double> sizes(values, values + working_Q_.size());
  for (double& size : sizes) size = std::fabs(size);
  std::sort(sizes.begin(), sizes.end());
  double widest = 1, gap = 0;
  for (std::size_t i = 0; i + 1 < sizes.size() && sizes[i] <= kMostInPlane * sizes.back(); ++i) {
    const double least = std::max(sizes[i], kLeastInPlane * sizes.back());
    if (!(sizes[i + 1] > widest * least)) continue;
    widest = sizes[i + 1] / least;
    gap = std::sqrt(sizes[i + 1] * least);
  }
  return gap / sizes.back();
}

// Points so `near` its plane are taken to lie in it.
bool Sifting::certify_by_plane(double near, Effects effects, DistanceResult& result) {
  std::vector<double> u = farkas_;
  double size = 0;
  for (const double coordinate : u) size = std::max(size, std::fabs(coordinate));
  if (!(size > 0) || !(size < kInfinity)) return false;
  for (double& coordinate : u) coordinate /= size;
  const std::vector<bool> in_plane = collect_plane(u.data(), near);
  if (!face_.choose(*stopwatch_)) return false;
  std::vector<double> u_low(u.size()), uncertain(u.size());
  const double error = face_.enclose_orthogonal(u.data(), u_low.data(), *stopwatch_);
  if (!(error < kInfinity)) return false;
  // How far the computed u·p may be from that of the orthogonal direction, for each |p_k|: the error of
  // Kernels::products_twofold, and that of the enclosure.
  const double rounding = 8.0 * (n_ + 4) * (n_ + 4) * 0x1p-106;
  std::transform(u.begin(), u.end(), uncertain.begin(),
                 [&](double coordinate) { return rounding * std::fabs(coordinate); });
  for (int i = 0; i < face_.rank(); ++i) uncertain[static_cast<std::size_t>(face_.pivot_row(i))] += error;
  if (!is_beyond(working_A_, u, u_low, -1, uncertain, {})) return false;
  if (!is_beyond(working_Q_, u, u_low, 1, uncertain, in_plane)) return false;
  for (int k = 0; k < n_; ++k) {
    const double component = u[static_cast<std::size_t>(k)];
    direction_[static_cast<std::size_t>(n_) + static_cast<std::size_t>(k)] =
        -Scaling::direction_component(scaling_.factor_Q()[k], component);
  }
  h_Q_ = {};
  finish(DistanceStatus::unreachable, kInfinity, kInfinity, effects, result);
  return true;
}

// Whether sign u·p > 0 by more than `uncertain` for all points p that are not left out.
bool Sifting::is_beyond(const ColumnPool& pool, const std::vector<double>& u,
                        const std::vector<double>& u_low, double sign, const std::vector<double>& uncertain,
                        const std::vector<bool>& left_out) {
  const PricedPoints points = pool.view();
  collected_value_.reserve(static_cast<std::size_t>(points.block_count) * PointSet::kLanes);
  kernels_->products_twofold(points.blocks, points.block_count, n_, u.data(), u_low.data(),
                             collected_value_.data());
  std::vector<double> point(u.size());
  for (std::ptrdiff_t i = 0; i < pool.size(); ++i) {
    if (!left_out.empty() && left_out[static_cast<std::size_t>(i)]) continue;
    pool.copy_point(i, point.data());
    double sum = 0;
    for (std::size_t k = 0; k < point.size(); ++k) sum += uncertain[k] * std::fabs(point[k]);
    if (!(sign * collected_value_[static_cast<std::size_t>(i)] > 1.01 * sum + kUnderflow)) return false;
  }
  return true;
}

// The points of Q near the plane of u, into face_, and which they are.
std::vector<bool> Sifting::collect_plane(const double* u, double near) {
  const double* values = products_with(working_Q_, u);
  const std::ptrdiff_t count = working_Q_.size();
  const double farthest = *std::max_element(values, values + count);
  std::vector<double> point(static_cast<std::size_t>(n_));
  std::vector<bool> in_plane(static_cast<std::size_t>(count));
  face_.begin(n_, *kernels_);
  for (std::ptrdiff_t j = 0; j < count; ++j) {
    if (!(std::fabs(values[j]) <= near * farthest)) continue;
    in_plane[static_cast<std::size_t>(j)] = true;
    working_Q_.copy_point(j, point.data());
    face_.add(point.data(), 0, 1, id_of_Q(j));
  }
  return in_plane;
}

}  // namespace raygauge
