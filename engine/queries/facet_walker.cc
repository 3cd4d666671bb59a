// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/facet_walker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "engine/numerics/decompositions.h"
#include "engine/numerics/floating_point.h"
#include "engine/queries/tuning.h"

namespace raygauge {
namespace {

constexpr int kSingleLanes = PointSet::kSingleLanes;
constexpr int kRow = WalkedPoints::kRow;
constexpr float kLeastShare = 0.2F, kMostShare = 0.9F;  // of the highest points along x
constexpr int kCandidates = 4;                          // for a first basis, times n
constexpr double kInPlane = 1e-9;                       // relative: points of a facet
constexpr double kIndependent = 1e-16;  // squared distance of a point from the space of others
constexpr double kSlack = 1e-9;         // for sums in double
constexpr int kBuckets = 64;

// Walks as kernels take them.
class Raw {
 public:
  void add(PointWalk* walk) { walks_[static_cast<std::size_t>(size_++)] = &walk->walk(); }
  FacetWalk* const* data() const { return walks_.data(); }
  int size() const { return size_; }

 private:
  std::array<FacetWalk*, kWalksTogether> walks_{};
  int size_ = 0;
};

}  // namespace

void KnownFacets::clear(int n) {
  n_ = n;
  count_ = 0;
  const auto size = static_cast<std::size_t>(n);
  inverses_.reserve((size + 1) * kRow * kMost);
  ids_.reserve(size * kMost);
  normals_.reserve(size * kMost);
}

void KnownFacets::add(const FacetWalk& walk) {
  if (count_ == kMost) return;
  const std::ptrdiff_t at = count_++;
  float* to = inverses_.data() + at * (n_ + 1) * kRow;
  std::copy_n(walk.R, n_ * kRow, to);
  std::copy_n(walk.y, kRow, to + static_cast<std::ptrdiff_t>(n_) * kRow);
  std::copy_n(walk.id, n_, ids_.data() + at * n_);
  if (at % kSingleLanes == 0) std::fill_n(normals_.data() + at * n_, n_ * kSingleLanes, 0.0F);
  float* lane = normals_.data() + at / kSingleLanes * n_ * kSingleLanes + at % kSingleLanes;
  for (int k = 0; k < n_; ++k) lane[static_cast<std::ptrdiff_t>(k) * kSingleLanes] = walk.y[k];
}

FacetWalker::FacetWalker(const WalkedPoints& points)
    : all_(&points), block_count_((points.S->single_block_count() + 1) / 2 * 2) {
  const auto lanes = static_cast<std::size_t>(block_count_) * kSingleLanes;
  reach_.reserve(lanes);
  order_.reserve(lanes);
  blocks_.reserve(lanes * static_cast<std::size_t>(points.n));
  group_.n = points.n;
  group_.points = points.rows.data();
  group_.order = order_.data();
  rounded_.reserve(lanes * static_cast<std::size_t>((points.n + 1) / 2));
  group_.blocks = blocks_.data();
  group_.rounded = rounded_.data();
  group_.room = PointWalk::kRoom;
  group_.pivot_limit = tuned::kPivotsOfWalk * points.n;
  for (int i = 0; i < kWalksTogether; ++i) {
    walks_.push_back(std::make_unique<PointWalk>(points));
    idle_.push_back(walks_.back().get());
  }
}

bool FacetWalker::begin(const Vector& facet_normal) {
  const int n = all_->n;
  normal_ = facet_normal / all_->factor;
  sort_points(facet_normal);
  const std::vector<std::int32_t> facet = points_in_plane();
  if (std::ssize(facet) < n) return false;
  Eigen::MatrixXd B(n, n);
  for (int i = 0; i < n; ++i) B.col(i) = point_at(facet[static_cast<std::size_t>(i)]);
  const Eigen::MatrixXd R = lu_inverse(B);
  if (!R.allFinite()) return false;
  const FacetWalk& first = walks_.front()->walk();
  for (int k = 0; k < n; ++k) {
    for (int i = 0; i < n; ++i) first.R[k * kRow + i] = static_cast<float>(R(i, k));
    first.y[k] = static_cast<float>(R.col(k).sum());
    first.id[k] = facet[static_cast<std::size_t>(k)];
  }
  share_ = tuned::kFirstShare;
  known_.clear(n);
  known_.add(first);
  return true;
}

// By w·p in buckets, the highest first.
void FacetWalker::sort_points(const Vector& facet_normal) {
  const PointSet& S = *all_->S;
  all_->kernels->products(S.data(), S.block_count(), all_->n, facet_normal.data(), reach_.data());
  const auto bucket_of = [&](std::ptrdiff_t i) {
    const double below = (1 - reach_[static_cast<std::size_t>(i)]) * (0.5 * kBuckets);
    return static_cast<std::size_t>(std::clamp(below, 0.0, kBuckets - 1.0));
  };
  std::array<std::int32_t, kBuckets + 1> next{};
  for (std::ptrdiff_t i = 0; i < S.size(); ++i) ++next[bucket_of(i) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  for (std::ptrdiff_t i = 0; i < S.size(); ++i)
    order_[static_cast<std::size_t>(next[bucket_of(i)]++)] = static_cast<std::int32_t>(i);
  highest_ = next.front();
  blocks_filled_ = rounded_filled_ = 0;
  tops_.assign(static_cast<std::size_t>(block_count_), -kInfinity);
  for (std::ptrdiff_t place = 0; place < S.size(); ++place) {
    double& top = tops_[static_cast<std::size_t>(place / kSingleLanes)];
    top = std::max(top, reach_[static_cast<std::size_t>(order_[static_cast<std::size_t>(place)])]);
  }
  for (std::size_t b = tops_.size() - 1; b > 0; --b) tops_[b - 1] = std::max(tops_[b - 1], tops_[b]);
}

// The first blocks, as far as they are read.
void FacetWalker::fill_blocks(std::ptrdiff_t count) {
  const std::ptrdiff_t n = all_->n;
  for (; blocks_filled_ < count; ++blocks_filled_) {
    float* block = blocks_.data() + blocks_filled_ * n * kSingleLanes;
    std::fill_n(block, n * kSingleLanes, 0.0F);
    const std::ptrdiff_t first = blocks_filled_ * kSingleLanes;
    for (std::ptrdiff_t lane = 0; lane < std::min<std::ptrdiff_t>(kSingleLanes, all_->S->size() - first);
         ++lane) {
      const auto point = point_at(first + lane);
      for (std::ptrdiff_t k = 0; k < n; ++k) block[k * kSingleLanes + lane] = static_cast<float>(point[k]);
    }
  }
}

void FacetWalker::fill_rounded(std::ptrdiff_t count) {
  const std::ptrdiff_t pairs = (all_->n + 1) / 2;
  for (; rounded_filled_ < count; ++rounded_filled_) {
    std::int32_t* block = rounded_.data() + rounded_filled_ * pairs * kSingleLanes;
    std::fill_n(block, pairs * kSingleLanes, 0);
    const std::ptrdiff_t first = rounded_filled_ * kSingleLanes;
    for (std::ptrdiff_t lane = 0; lane < std::min<std::ptrdiff_t>(kSingleLanes, all_->S->size() - first);
         ++lane) {
      const std::int32_t* row =
          all_->pairs.data() +
          static_cast<std::ptrdiff_t>(order_[static_cast<std::size_t>(first + lane)]) * (kRow / 2);
      for (std::ptrdiff_t k = 0; k < pairs; ++k) block[k * kSingleLanes + lane] = row[k];
    }
  }
}

// The places of n independent points in the plane; fewer where there are no n.
std::vector<std::int32_t> FacetWalker::points_in_plane() const {
  const int n = all_->n;
  double highest = -kInfinity;
  const auto reach = [&](std::ptrdiff_t place) {
    return reach_[static_cast<std::size_t>(order_[static_cast<std::size_t>(place)])];
  };
  for (std::ptrdiff_t place = 0; place < highest_; ++place) highest = std::max(highest, reach(place));
  std::vector<std::int32_t> places, chosen;
  for (std::ptrdiff_t place = 0; place < highest_ && std::ssize(places) < std::ptrdiff_t{kCandidates} * n;
       ++place) {
    if (reach(place) >= highest * (1 - kInPlane)) places.push_back(static_cast<std::int32_t>(place));
  }
  // Gram and Schmidt: the one that is farthest from the space of those before it.
  Eigen::MatrixXd rest(n, std::ssize(places));
  for (Eigen::Index c = 0; c < rest.cols(); ++c) rest.col(c) = point_at(places[static_cast<std::size_t>(c)]);
  while (std::ssize(chosen) < n) {
    Eigen::Index best = 0;
    if (rest.cols() == 0 || !(rest.colwise().squaredNorm().maxCoeff(&best) > kIndependent)) break;
    chosen.push_back(places[static_cast<std::size_t>(best)]);
    const Eigen::VectorXd q = rest.col(best).normalized();
    rest -= q * (q.transpose() * rest).eval();
  }
  return chosen;
}

// Over points near by.
void FacetWalker::walk() {
  group_.known = known_.list();
  const int listed = tuned::kListedPoints * all_->n / kSingleLanes / 2 * 2;
  group_.listed = std::min(listed, static_cast<int>(block_count_));
  group_.share_of_highest = share_;
  fill_blocks(group_.listed);
  Raw walks;
  for (PointWalk* walk : begun_) walks.add(walk);
  all_->kernels->walk_facets(&group_, walks.data(), walks.size());
  const int wanted = tuned::kChosenColumns * all_->n;
  for (const PointWalk* walk : begun_) {
    if (!walk->arrived()) continue;
    if (walk->walk().chosen > wanted) share_ = std::min(share_ + 0.01F, kMostShare);
    if (walk->walk().chosen < wanted) share_ = std::max(share_ - 0.01F, kLeastShare);
  }
}

// Over more, where the cone of those near by does not hold x.
void FacetWalker::walk_farther() {
  const bool all = block_count_ * kSingleLanes <= PointWalk::kRoom;
  group_.listed = static_cast<int>(block_count_);
  group_.share_of_highest = all ? -std::numeric_limits<float>::infinity() : tuned::kFirstShare;
  for (PointWalk* walk : begun_) {
    FacetWalk* raw = &walk->walk();
    if (!walk->arrived()) {
      fill_blocks(block_count_);
      all_->kernels->walk_facets(&group_, &raw, 1);
    }
    (walk->arrived() && walk->prepare_pass() ? arrived_ : idle_).push_back(walk);
  }
  begun_.clear();
}

// y = a w + v, and y·p <= a (w·p) + |v| as |p| <= 1: blocks behind cannot reach y's plane.
std::ptrdiff_t FacetWalker::blocks_in_reach(const FacetWalk& walk) const {
  const Eigen::Map<const Eigen::VectorXd> y(walk.dual, all_->n);
  const double a = y.dot(normal_) / normal_.squaredNorm();
  if (!(a > 0)) return block_count_;
  const double across = (y - a * normal_).norm();
  const double least = (1 - across - kSlack * (1 + y.norm() + across)) / a;
  return std::partition_point(tops_.begin(), tops_.end(), [=](double top) { return top >= least; }) -
         tops_.begin();
}

// One pass for all that have arrived. Points beyond a plane join the others of its walk.
void FacetWalker::look_beyond() {
  std::ptrdiff_t reached = 0;
  Raw walks;
  for (PointWalk* walk : arrived_) {
    const std::ptrdiff_t in_reach = blocks_in_reach(walk->walk());
    if (walk->integers_suffice()) {
      reached = std::max(reached, in_reach);
      walks.add(walk);
    } else {
      fill_blocks(in_reach);
      walk->find_in_single(group_, in_reach);
    }
  }
  reached = (reached + 1) / 2 * 2;
  fill_rounded(reached);
  all_->kernels->find_beyond(&group_, reached, walks.data(), walks.size());
  std::erase_if(arrived_, [&](PointWalk* walk) {
    walk->read_pass(group_);
    if (walk->go_on(group_)) {
      if (walk->arrived() && walk->prepare_pass()) return false;
    } else if (walk->answer()) {
      known_.add(walk->walk());
    }
    idle_.push_back(walk);
    return true;
  });
}

void FacetWalker::solve(std::span<const WalkQuestion> questions) {
  for (std::size_t next = 0; next < questions.size() || !arrived_.empty();) {
    for (; next < questions.size() && !idle_.empty(); ++next) {
      if (next + kWalksTogether < questions.size()) __builtin_prefetch(questions[next + kWalksTogether].x);
      if (!idle_.back()->begin(questions[next])) continue;
      begun_.push_back(idle_.back());
      idle_.pop_back();
    }
    walk();
    walk_farther();
    look_beyond();
  }
}

}  // namespace raygauge
