// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/facet_walks.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <memory>
#include <mutex>
#include <numeric>

#include "engine/proof/certificate.h"
#include "engine/queries/facet_walker.h"
#include "engine/queries/tuning.h"

namespace raygauge {
namespace {

constexpr std::ptrdiff_t kMostPoints = 65536;  // a group sorts them
constexpr double kLeastTolerance = 1e-10;      // what is found has been proven to about 1e-12
constexpr double kFlattest = 0x1p-10;          // the least extent along a coordinate, relative to the largest
constexpr std::size_t kMostFacets = 1024;      // that a point is compared with
constexpr std::ptrdiff_t kChunk = 1024;        // points that a thread sorts at once

}  // namespace

WalkedPoints::WalkedPoints(const PointSet& set, const Vector& gauge_of_axes, double given_tolerance,
                           const Kernels& given_kernels)
    : kernels(&given_kernels), S(&set), n(set.dimension()), tolerance(given_tolerance) {
  const Eigen::Map<const Eigen::VectorXd> extent(set.coordinate_magnitude(), n);
  const double largest = extent.norm();
  if (!FacetWalks::suits(set) || tolerance < kLeastTolerance) return;
  if (!gauge_of_axes.allFinite() || !std::isfinite(largest)) return;
  if (!(extent.minCoeff() >= kFlattest * largest) || !(largest > 0x1p-900)) return;
  factor = std::ldexp(1.0, -std::ilogb(largest) - 1);
  magnitude = extent * factor;
  axis_gauge = gauge_of_axes / factor;
  const auto numbers = static_cast<std::size_t>(set.size()) * kRow;
  rows.reserve(numbers);
  pairs.reserve(numbers / 2);
  std::fill_n(rows.data(), numbers, 0.0);
  for (std::ptrdiff_t i = 0; i < set.size(); ++i) {
    double* row = rows.data() + i * kRow;
    set.copy_point(i, row);
    for (int k = 0; k < n; ++k) row[k] *= factor;
  }
  for (std::size_t i = 0; i < numbers / 2; ++i)
    pairs[i] = pair_of(kScale * rows[2 * i], kScale * rows[2 * i + 1]);
  usable = true;
}

FacetWalks::FacetWalks(const PointSet& S, const Vector& gauge_of_axes, double tolerance, int threads,
                       const Kernels& kernels)
    : points_(S, gauge_of_axes, tolerance, kernels) {
  if (!usable()) return;
  for (int k = 0; k < threads; ++k) walkers_.add(std::make_unique<std::unique_ptr<FacetWalker>>());
  team_.be_patient();
}

FacetWalks::~FacetWalks() = default;

bool FacetWalks::suits(const PointSet& S) noexcept {
  const int n = S.dimension();
  return n >= 2 && n <= WalkedPoints::kRow && S.size() >= tuned::kLeastPointsOfWalks * n &&
         S.size() <= kMostPoints;
}

std::ptrdiff_t FacetWalks::facets_for(std::size_t points) noexcept {
  const std::size_t few = std::min(points / tuned::kFewPointsOfFacet, std::size_t{tuned::kFewFacets});
  return static_cast<std::ptrdiff_t>(std::min(std::max(points / tuned::kPointsOfFacet, few), kMostFacets));
}

void FacetWalks::add_facet(const Vector& normal) {
  const double above = support_value(*points_.kernels, *points_.S, normal.data()).above();
  if (!(above > 0)) return;
  constexpr std::ptrdiff_t kLanes = PointSet::kSingleLanes;
  const std::ptrdiff_t n = points_.n, at = facets();
  normals_.emplace_back(normal / above);
  if (at % kLanes == 0) {
    blocks_.reserve(static_cast<std::size_t>((at + kLanes) * n));
    std::fill_n(blocks_.data() + at * n, kLanes * n, 0.0F);
  }
  for (std::ptrdiff_t k = 0; k < n; ++k)
    blocks_[static_cast<std::size_t>(at / kLanes * n * kLanes + k * kLanes + at % kLanes)] =
        static_cast<float>(normals_.back()[k]);
}

// Each point to the facet whose plane it is farthest beyond; in a group in their order.
void FacetWalks::sort_by_group(const Eigen::Ref<const Eigen::MatrixXd>& X,
                               std::span<const std::size_t> which) {
  const auto count = std::ssize(which), groups = facets();
  group_of_.resize(which.size());
  PricedPoints facets;
  facets.single_blocks = blocks_.data();
  facets.single_block_count = (groups + PointSet::kSingleLanes - 1) / PointSet::kSingleLanes;
  facets.size = groups;
  team_.run(static_cast<int>((count + kChunk - 1) / kChunk), true, [&](int chunk) {
    alignas(64) float x[WalkedPoints::kRow];
    LaneList best;
    for (std::ptrdiff_t i = chunk * kChunk; i < std::min(count, (chunk + 1) * kChunk); ++i) {
      const auto at = static_cast<std::size_t>(i);
      points_.kernels->price_lanes(&facets, points_.n, X.col(static_cast<Eigen::Index>(which[at])).data(), x,
                                   &best);
      group_of_[at] = static_cast<std::size_t>(best.best);
    }
  });
  first_.assign(static_cast<std::size_t>(groups) + 1, 0);
  for (const std::size_t group : group_of_) ++first_[group + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  by_group_.resize(which.size());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t i = 0; i < which.size(); ++i) by_group_[next[group_of_[i]]++] = i;
}

void FacetWalks::solve(const Eigen::Ref<const Eigen::MatrixXd>& X, std::span<const std::size_t> which,
                       const std::function<bool()>& stop, std::span<WalkAnswer> answers,
                       std::span<double> normals) {
  team_.resize(static_cast<int>(std::clamp<std::ptrdiff_t>(facets(), 1, std::ssize(walkers_.all()))));
  sort_by_group(X, which);
  std::mutex mutex;
  std::exception_ptr error;
  std::atomic<bool> ended = false;
  const auto question = [&](std::size_t at) {
    const double* x = X.col(static_cast<Eigen::Index>(which[at])).data();
    double* normal = normals.empty() ? nullptr : normals.data() + at * static_cast<std::size_t>(points_.n);
    return WalkQuestion{x, &answers[at], normal};
  };
  const auto walk_group = [&](std::size_t group) {
    walkers_.lend([&](std::unique_ptr<FacetWalker>& walker) {
      if (!walker) walker = std::make_unique<FacetWalker>(points_);
      if (first_[group] == first_[group + 1] || !walker->begin(normals_[group])) return;
      std::vector<WalkQuestion> questions;
      for (std::size_t k = first_[group]; k < first_[group + 1]; ++k)
        questions.push_back(question(by_group_[k]));
      walker->solve(questions);
    });
  };
  team_.run(static_cast<int>(facets()), true, [&](int group) {
    try {
      if (!ended && stop && stop()) ended = true;
      if (!ended) walk_group(static_cast<std::size_t>(group));
    } catch (...) {
      const std::lock_guard lock(mutex);
      error = std::current_exception();
      ended = true;
    }
  });
  if (error) std::rethrow_exception(error);
}

}  // namespace raygauge
