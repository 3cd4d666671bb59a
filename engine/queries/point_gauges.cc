// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/point_gauges.h"

#include <algorithm>
#include <numeric>

#include "engine/numerics/floating_point.h"
#include "engine/queries/tuning.h"

namespace raygauge {
PointGauges::PointGauges(const ConvexSet& S, const PointsOptions& options)
    : S_(&S),
      options_(options),
      batch_(options_of_membership(S, options.tolerance), options.threads),
      points_(static_cast<std::size_t>(std::max(options.threads, 1))),
      may_walk_(as_point_set(S) != nullptr) {
  if (options.stop) batch_.set_stop(options.stop);
}

bool PointGauges::may_walk(const ConvexSet& S, std::ptrdiff_t points) noexcept {
  const PointSet* set = as_point_set(S);
  return points >= tuned::kLeastForWalks && set != nullptr && FacetWalks::suits(*set);
}

void PointGauges::solve(const Points& X, const Indices& which, const Pose* pose, bool with_normals) {
  lower.assign(which.size(), 0.0);
  upper.assign(which.size(), kInfinity);
  normal.assign(with_normals ? which.size() * static_cast<std::size_t>(S_->dimension()) : 0, 0.0);
  Indices rest(which.size());
  std::iota(rest.begin(), rest.end(), std::size_t{0});
  if (pose == nullptr && may_walk_ && may_walk(*S_, std::ssize(which))) walk(X, which, rest, with_normals);
  solve_alone(X, which, rest, pose, with_normals);
}

// The columns which[i] for i in `at`.
void PointGauges::solve_alone(const Points& X, const Indices& which, const Indices& at, const Pose* pose,
                              bool with_normals) {
  const auto n = static_cast<std::size_t>(S_->dimension());
  lower_.assign(at.size(), 0.0);
  upper_.assign(at.size(), kInfinity);
  normal_.assign(with_normals ? at.size() * n : 0, 0.0);
  BatchAnswers answers;
  answers.lower = lower_;
  answers.upper = upper_;
  answers.normal = normal_;
  const auto pair = [&](std::size_t i, int thread) {
    std::optional<PointSet>& point = points_[static_cast<std::size_t>(thread)];
    point.emplace(Eigen::MatrixXd(X.col(static_cast<Eigen::Index>(which[at[i]]))));
    return pose == nullptr ? PosedPair{*point, *S_} : PosedPair{{*point, *pose}, {*S_, *pose}};
  };
  batch_.gauge_distances(at.size(), pair, S_->dimension(), answers);
  for (std::size_t i = 0; i < at.size(); ++i) {
    lower[at[i]] = lower_[i];
    upper[at[i]] = upper_[i];
    if (!normal.empty()) std::copy_n(normal_.data() + i * n, n, normal.data() + at[i] * n);
  }
}

const Vector& PointGauges::axis_gauges() {
  if (axis_gauges_.size() > 0) return axis_gauges_;
  const int n = S_->dimension();
  Eigen::MatrixXd axes(n, 2 * n);
  axes << Eigen::MatrixXd::Identity(n, n), -Eigen::MatrixXd::Identity(n, n);
  Indices all(static_cast<std::size_t>(2 * n));
  std::iota(all.begin(), all.end(), std::size_t{0});
  PointGauges measured(*S_, options_);
  measured.solve(axes, all, nullptr, false);
  axis_gauges_.resize(n);
  for (int k = 0; k < n; ++k) {
    const auto at = static_cast<std::size_t>(k);
    axis_gauges_[k] = std::max(measured.upper[at], measured.upper[at + static_cast<std::size_t>(n)]);
  }
  return axis_gauges_;
}

// Facets for so many points, from solves of some of them, which leave the rest.
bool PointGauges::walks_begin(const Points& X, const Indices& which, Indices& rest) {
  if (!walks_) walks_.emplace(*as_point_set(*S_), axis_gauges(), options_.tolerance, options_.threads);
  if (!walks_->usable()) return false;
  const std::ptrdiff_t more = FacetWalks::facets_for(which.size()) - walks_->facets();
  if (more <= 0) return true;
  const auto n = static_cast<std::size_t>(S_->dimension());
  const std::size_t step = which.size() / static_cast<std::size_t>(more);
  Indices sample, others;
  for (const std::size_t i : rest) (i % step == 0 ? sample : others).push_back(i);
  solve_alone(X, which, sample, nullptr, true);
  for (std::size_t i = 0; i < sample.size(); ++i) {
    if (upper_[i] < kInfinity && lower_[i] > 0)
      walks_->add_facet(-Vector::Map(normal_.data() + i * n, S_->dimension()));
  }
  rest = others;
  return walks_->facets() > 0;
}

// What walks leave open is left in `rest`.
void PointGauges::walk(const Points& X, const Indices& which, Indices& rest, bool with_normals) {
  may_walk_ = walks_begin(X, which, rest);
  if (!may_walk_) return;
  const auto n = static_cast<std::size_t>(S_->dimension());
  Indices columns(rest.size()), open;
  for (std::size_t i = 0; i < rest.size(); ++i) columns[i] = which[rest[i]];
  walked_.assign(rest.size(), {});
  normal_.assign(with_normals ? rest.size() * n : 0, 0.0);
  walks_->solve(X, columns, options_.stop, walked_, normal_);
  for (std::size_t i = 0; i < rest.size(); ++i) {
    if (!walked_[i].closed) {
      open.push_back(rest[i]);
      continue;
    }
    lower[rest[i]] = walked_[i].lower;
    upper[rest[i]] = walked_[i].upper;
    if (with_normals) std::copy_n(normal_.data() + i * n, n, normal.data() + rest[i] * n);
  }
  may_walk_ = 2 * open.size() <= rest.size();
  rest = open;
}

}  // namespace raygauge
