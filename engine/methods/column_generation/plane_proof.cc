// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/column_generation/plane_proof.h"

#include <algorithm>
#include <cmath>

#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

// Points of Q so close to the plane of a direction, relative to the farthest, may lie in it.
constexpr double kMaybeInPlane[] = {1e-6, 1e-9};
constexpr double kLeastInPlane = 1e-15, kMostInPlane = 1e-5;  // at the widest gap

// A direction in twice the precision, and how far the computed u·p may be off, for each |p_k|.
struct EnclosedDirection {
  std::vector<double> u, u_low, uncertain;
};

// Whether sign u·p > 0 by more than what is uncertain for all points p that are not left out.
bool is_beyond(WorkingSets& sets, const ColumnPool& pool, const EnclosedDirection& direction, double sign,
               const std::vector<bool>& left_out) {
  const double* products = sets.products(pool, direction.u.data(), direction.u_low.data());
  std::vector<double> point(direction.u.size());
  for (std::ptrdiff_t i = 0; i < pool.size(); ++i) {
    if (!left_out.empty() && left_out[static_cast<std::size_t>(i)]) continue;
    pool.copy_point(i, point.data());
    double sum = 0;
    for (std::size_t k = 0; k < point.size(); ++k) sum += direction.uncertain[k] * std::fabs(point[k]);
    if (!(sign * products[i] > 1.01 * sum + kUnderflow)) return false;
  }
  return true;
}

}  // namespace

bool PlaneProof::certify(const SiftingSolve& solve) {
  if (!has_direction() || !solve.sets.is_complete()) return false;
  return std::any_of(std::begin(kMaybeInPlane), std::end(kMaybeInPlane),
                     [&](double near) { return certify(solve, near); }) ||
         certify(solve, widest_gap(solve.sets));
}

// Between the points of Q in the plane and the others where a direction is not so close to the one that
// leaves them there: relative to the farthest, where |u·q| rises the most from one point to the next.
double PlaneProof::widest_gap(WorkingSets& sets) const {
  const double* values = sets.products(sets.Q().pool, direction_.data());
  std::vector<double> sizes(values, values + sets.Q().pool.size());
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

bool PlaneProof::certify(const SiftingSolve& solve, double near) {
  EnclosedDirection direction{direction_, {}, {}};
  std::vector<double>& u = direction.u;
  double size = 0;
  for (const double coordinate : u) size = std::max(size, std::fabs(coordinate));
  if (!(size > 0) || !(size < kInfinity)) return false;
  for (double& coordinate : u) coordinate /= size;
  const std::vector<bool> in_plane = collect(solve.sets, u.data(), near);
  if (!face_.choose(solve.stopwatch)) return false;
  direction.u_low.resize(u.size());
  direction.uncertain.resize(u.size());
  const double error = face_.enclose_orthogonal(u.data(), direction.u_low.data(), solve.stopwatch);
  if (!(error < kInfinity)) return false;
  // Of the orthogonal direction: the error of Kernels::products_twofold, and that of the enclosure.
  const double n = solve.sets.n(), rounding = 8.0 * (n + 4) * (n + 4) * 0x1p-106;
  std::transform(u.begin(), u.end(), direction.uncertain.begin(),
                 [&](double coordinate) { return rounding * std::fabs(coordinate); });
  for (int i = 0; i < face_.rank(); ++i)
    direction.uncertain[static_cast<std::size_t>(face_.pivot_row(i))] += error;
  if (!is_beyond(solve.sets, solve.sets.A().pool, direction, -1, {})) return false;
  if (!is_beyond(solve.sets, solve.sets.Q().pool, direction, 1, in_plane)) return false;
  solve.sets.take_plane(u.data());
  write_answer(solve, DistanceStatus::unreachable, kInfinity, kInfinity);
  return true;
}

// The points of Q near the plane of u, into face_, and which they are.
std::vector<bool> PlaneProof::collect(WorkingSets& sets, const double* u, double near) {
  const ColumnPool& pool = sets.Q().pool;
  const double* values = sets.products(pool, u);
  const std::ptrdiff_t count = pool.size();
  const double farthest = *std::max_element(values, values + count);
  std::vector<double> point(static_cast<std::size_t>(sets.n()));
  std::vector<bool> in_plane(static_cast<std::size_t>(count));
  face_.begin(sets.n(), sets.kernels());
  for (std::ptrdiff_t j = 0; j < count; ++j) {
    if (!(std::fabs(values[j]) <= near * farthest)) continue;
    in_plane[static_cast<std::size_t>(j)] = true;
    pool.copy_point(j, point.data());
    face_.add(point.data(), 0, 1, id_of_Q(j));
  }
  return in_plane;
}

}  // namespace raygauge
