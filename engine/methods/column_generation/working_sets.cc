// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/column_generation/working_sets.h"

#include <algorithm>
#include <limits>

#include "engine/lp/shared_pass.h"
#include "engine/methods/column_generation/tuning.h"
#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

// Basic points lie on the threshold, and rounding may put any point of the working set above it. Whether a
// new one is above.
bool drop_known(const ColumnPool& working, std::ptrdiff_t size, double threshold, Collection& found) {
  bool any = false;
  std::ptrdiff_t kept = 0;
  for (std::ptrdiff_t i = 0; i < found.count; ++i) {
    const std::int64_t index = std::min<std::int64_t>(found.index[i], size - 1);
    if (working.holds(index)) continue;
    any = any || found.value[i] > threshold;
    found.index[kept] = index;
    found.value[kept++] = found.value[i];
  }
  found.count = kept;
  return any;
}

}  // namespace

void WorkingSets::begin(const PointSet& A, const PointSet& Q, const DistanceOptions& options) {
  n_ = A.dimension();
  tolerance_ = options.tolerance;
  threads_ = options.threads;
  kernels_ = &kernels_for(options.instruction_set);
  counters_ = {};
  scaling_.compute(A, Q);
  A_.set = &A;
  Q_.set = &Q;
  A_.factor = scaling_.factor_A();
  Q_.factor = scaling_.factor_Q();
  A_.violators = Q_.violators = {};
  direction_.reserve(2 * static_cast<std::size_t>(n_));
}

void WorkingSets::choose() {
  A_.pool.choose(*A_.set, A_.factor, scaling_.trivial_A(), true);
  Q_.pool.choose(*Q_.set, Q_.factor, scaling_.trivial_Q(), true);
  A_.chosen = Q_.chosen = {};
}

void WorkingSets::choose(std::span<const std::int64_t> chosen_A, std::span<const std::int64_t> chosen_Q) {
  A_.chosen = chosen_A;
  Q_.chosen = chosen_Q;
  for (Side* side : {&A_, &Q_}) {
    side->pool.clear(n_);
    for (const std::int64_t i : side->chosen) side->pool.add(*side->set, side->factor, i);
    side->pool.fill_up();
  }
}

void WorkingSets::aim(const double* y) noexcept {
  double* u = direction_.data();
  for (int k = 0; k < n_; ++k) {
    u[k] = Scaling::direction_component(A_.factor[k], y[k]);
    u[n_ + k] = -Scaling::direction_component(Q_.factor[k], y[k]);
  }
}

double WorkingSets::bound(const double* y) {
  aim(y);
  counters_.support_queries += 2;
  counters_.points_priced += A_.set->size() + Q_.set->size();
  A_.h = support_value(*kernels_, *A_.set, direction_.data(), nullptr, resolution_for(tolerance_));
  Q_.h = support_value(*kernels_, *Q_.set, direction_.data() + n_, nullptr, resolution_for(tolerance_));
  return lower_bound(A_.h, Q_.h);
}

double WorkingSets::bound_twofold(const double* y, const double* y_low, std::int64_t* best_A,
                                  std::int64_t* best_Q) {
  aim(y);
  direction_low_.reserve(2 * static_cast<std::size_t>(n_));
  const double* u = direction_.data();
  double* u_low = direction_low_.data();
  for (int k = 0; k < n_; ++k) {
    u_low[k] = Scaling::direction_component(A_.factor[k], y_low[k]);
    u_low[n_ + k] = -Scaling::direction_component(Q_.factor[k], y_low[k]);
  }
  counters_.support_queries += 2;
  counters_.points_priced += A_.set->size() + Q_.set->size();
  std::ptrdiff_t index_A = 0;
  std::ptrdiff_t index_Q = 0;
  A_.h = support_value_twofold(*kernels_, *A_.set, u, u_low, &index_A);
  Q_.h = support_value_twofold(*kernels_, *Q_.set, u + n_, u_low + n_, &index_Q);
  *best_A = id_of_A(index_A);
  *best_Q = id_of_Q(index_Q);
  return lower_bound(A_.h, Q_.h);
}

std::optional<double> WorkingSets::bound_as_priced(const PrimalSimplex& program) {
  if (!scaling_.trivial_A() || !scaling_.trivial_Q()) return std::nullopt;
  const double* y = program.normal();
  double* u = direction_.data();
  for (int k = 0; k < n_; ++k) {
    u[k] = y[k];
    u[n_ + k] = -y[k];
  }
  A_.h = {program.loop().h_A, dot_error(*A_.set, u)};
  Q_.h = {program.loop().h_Q, dot_error(*Q_.set, u)};
  const double resolution = resolution_for(tolerance_);
  if (!well_resolved(A_.h.value, A_.h.error, resolution) ||
      !well_resolved(Q_.h.value, Q_.h.error, resolution))
    return std::nullopt;
  return lower_bound(A_.h, Q_.h);
}

double WorkingSets::price(const PrimalSimplex& program, bool roughly) {
  aim(program.normal());
  if (!is_complete()) {
    const std::ptrdiff_t most_A = ColumnPool::growth(*A_.set), most_Q = ColumnPool::growth(*Q_.set);
    const auto both = static_cast<std::size_t>(most_A + most_Q);
    collected_.reserve(both);
    collected_value_.reserve(both);
    A_.violators.points = {collected_.data(), collected_value_.data(), most_A, 0, kInfinity};
    Q_.violators.points = {collected_.data() + most_A, collected_value_.data() + most_A, most_Q, 0,
                           kInfinity};
  }
  const double resolution = roughly ? std::numeric_limits<double>::max() : resolution_for(tolerance_);
  const PrimalSimplex::Thresholds thresholds = program.thresholds();
  price_side(A_, direction_.data(), thresholds.A, resolution);
  price_side(Q_, direction_.data() + n_, thresholds.Q, resolution);
  return lower_bound(A_.h, Q_.h);
}

void WorkingSets::price_side(Side& side, const double* direction, double threshold, double resolution) {
  const PointSet& S = *side.set;
  ++counters_.support_queries;
  counters_.points_priced += S.size();
  if (!side.pool.is_complete()) {
    Violators& violators = side.violators;
    violators.points.threshold = threshold - violators.reach;
    const double value = shared_pass(*kernels_, S, direction, violators.points, threads_, team_);
    violators.any = drop_known(side.pool, S.size(), threshold, violators.points);
    violators.reach = violators.any ? tuned::kReachOfViolators * (value - threshold) : 0;
    side.h = {value, dot_error(S, direction)};
    if (well_resolved(value, side.h.error, resolution)) return;
  }
  side.h = support_value(*kernels_, S, direction, nullptr, resolution);
}

void WorkingSets::take_plane(const double* y) {
  aim(y);
  Q_.h = {};
}

void WorkingSets::add_violators() {
  for (Side* side : {&A_, &Q_}) {
    const Collection& found = side->violators.points;
    for (std::ptrdiff_t i = 0; i < found.count; ++i) side->pool.add(*side->set, side->factor, found.index[i]);
    side->pool.fill_up();
  }
}

const double* WorkingSets::products(const ColumnPool& pool, const double* u, const double* u_low) {
  const PricedPoints points = pool.view();
  collected_value_.reserve(static_cast<std::size_t>(points.block_count) * PointSet::kLanes);
  if (u_low == nullptr) {
    kernels_->products(points.blocks, points.block_count, n_, u, collected_value_.data());
  } else {
    kernels_->products_twofold(points.blocks, points.block_count, n_, u, u_low, collected_value_.data());
  }
  return collected_value_.data();
}

void WorkingSets::to_own_units(double* point) const noexcept {
  for (int k = 0; k < n_; ++k) point[k] /= A_.factor[k];
}

}  // namespace raygauge
