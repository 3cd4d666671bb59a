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

namespace raygauge {
namespace {

constexpr int kLanes = PointSet::kLanes, kSingleLanes = PointSet::kSingleLanes;
constexpr int kRow = WalkedPoints::kRow;
constexpr int kListed = 50;  // points that columns are chosen from, times n
constexpr int kChosen = 8;   // columns, times n
constexpr int kRoom = 1024;  // columns at most
constexpr float kFirstShare = 0.5F, kLeastShare = 0.2F, kMostShare = 0.9F;  // of the highest point along x
constexpr int kPasses = 8;                                                  // for one point
constexpr int kPivots = 12;                                                 // of a walk, times n
constexpr int kFound = 512;               // room for points that a pass finds near or beyond the plane
constexpr int kAdded = 32;                // of them to the columns
constexpr int kCandidates = 4;            // for a first basis, times n
constexpr double kInPlane = 1e-9;         // relative: points of a facet
constexpr double kIndependent = 1e-16;    // squared distance of a point from the space of others
constexpr double kLeastLength = 0x1p-60;  // of x, and the most is its inverse: squares are single numbers
constexpr double kSingleRoundoff = 0x1p-24;
constexpr double kSlack = 1e-9;  // for sums in double
constexpr int kBuckets = 64;

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
  if (at % kLanes == 0) std::fill_n(normals_.data() + at * n_, n_ * kLanes, 0.0);
  double* lane = normals_.data() + at / kLanes * n_ * kLanes + at % kLanes;
  for (int k = 0; k < n_; ++k) lane[static_cast<std::ptrdiff_t>(k) * kLanes] = walk.y[k];
}

void KnownFacets::load_best(const Kernels& kernels, const double* x, FacetWalk* walk) const {
  std::ptrdiff_t best = 0;
  kernels.price(normals_.data(), (count_ + kLanes - 1) / kLanes, n_, x, &best);
  best = std::min<std::ptrdiff_t>(best, count_ - 1);
  const float* from = inverses_.data() + best * (n_ + 1) * kRow;
  std::copy_n(from, n_ * kRow, walk->R);
  std::copy_n(from + static_cast<std::ptrdiff_t>(n_) * kRow, kRow, walk->y);
  std::copy_n(ids_.data() + best * n_, n_, walk->id);
}

FacetWalker::FacetWalker(const WalkedPoints& points)
    : all_(&points), block_count_(points.S->single_block_count()), found_(kFound), values_(kFound) {
  const auto n = static_cast<std::size_t>(points.n),
             lanes = static_cast<std::size_t>(block_count_) * kSingleLanes;
  walk_.room = kRoom;
  const auto columns =
      static_cast<std::size_t>(walk_.room + kPasses * kAdded + 2 * kSingleLanes) / 32 * 32 + kSingleLanes;
  small_.reserve((n + 3) * kRow);
  doubles_.reserve(std::size_t{4} * kRow);
  ids_.reserve(kRow);
  reach_.reserve(lanes);
  order_.reserve(lanes);
  blocks_.reserve(lanes * n);
  columns_.reserve(columns * n + kSingleLanes);
  for (AlignedBuffer<float>* scratch : {&costs_, &along_}) scratch->reserve(std::max(columns, lanes));
  places_.reserve(columns + kSingleLanes);
  std::fill_n(small_.data(), (n + 3) * kRow, 0.0F);
  std::fill_n(doubles_.data(), std::size_t{4} * kRow, 0.0);
  walk_.n = points.n;
  walk_.points = points.rows.data();
  walk_.order = order_.data();
  walk_.blocks = blocks_.data();
  walk_.pivot_limit = kPivots * points.n;
  walk_.R = small_.data();
  walk_.y = walk_.R + n * kRow;
  walk_.x = walk_.y + kRow;
  walk_.target = walk_.x + kRow;
  walk_.id = ids_.data();
  walk_.wanted = doubles_.data();
  walk_.share = doubles_.data() + kRow;
  walk_.rest = walk_.share + kRow;
  walk_.dual = walk_.rest + kRow;
  walk_.columns = columns_.data();
  walk_.stride = static_cast<std::ptrdiff_t>(columns);
  walk_.place = places_.data();
  walk_.cost = costs_.data();
  walk_.along = along_.data();
}

bool FacetWalker::begin(const Vector& facet_normal) {
  const int n = all_->n;
  normal_ = facet_normal.unaryExpr([&](double w) { return std::ldexp(w, -all_->exponent); });
  sort_points(facet_normal);
  const std::vector<std::int32_t> facet = points_in_plane();
  if (std::ssize(facet) < n) return false;
  Eigen::MatrixXd B(n, n);
  for (int i = 0; i < n; ++i) B.col(i) = point_at(facet[static_cast<std::size_t>(i)]);
  const Eigen::MatrixXd R = lu_inverse(B);
  if (!R.allFinite()) return false;
  for (int k = 0; k < n; ++k) {
    for (int i = 0; i < n; ++i) walk_.R[k * kRow + i] = static_cast<float>(R(i, k));
    walk_.y[k] = static_cast<float>(R.col(k).sum());
    walk_.id[k] = facet[static_cast<std::size_t>(k)];
  }
  share_ = kFirstShare;
  known_.clear(n);
  known_.add(walk_);
  return true;
}

// By w·p in buckets, the highest first.
void FacetWalker::sort_points(const Vector& facet_normal) {
  const auto n = static_cast<std::ptrdiff_t>(all_->n);
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
  std::fill_n(blocks_.data() + (block_count_ - 1) * n * kSingleLanes, n * kSingleLanes, 0.0F);
  tops_.assign(static_cast<std::size_t>(block_count_), -kInfinity);
  for (std::ptrdiff_t place = 0; place < S.size(); ++place) {
    const std::ptrdiff_t i = order_[static_cast<std::size_t>(place)], b = place / kSingleLanes;
    const double* row = all_->rows.data() + i * kRow;
    float* lane = blocks_.data() + b * n * kSingleLanes + place % kSingleLanes;
    for (std::ptrdiff_t k = 0; k < n; ++k) lane[k * kSingleLanes] = static_cast<float>(row[k]);
    double& top = tops_[static_cast<std::size_t>(b)];
    top = std::max(top, reach_[static_cast<std::size_t>(i)]);
  }
  for (std::size_t b = tops_.size() - 1; b > 0; --b) tops_[b - 1] = std::max(tops_[b - 1], tops_[b]);
}

// The places of n independent points in the plane; fewer where there are no n.
std::vector<std::int32_t> FacetWalker::points_in_plane() const {
  const int n = all_->n;
  double highest = -kInfinity;
  const std::ptrdiff_t near = std::min<std::ptrdiff_t>(all_->S->size(), walk_.room);
  const auto reach = [&](std::ptrdiff_t place) {
    return reach_[static_cast<std::size_t>(order_[static_cast<std::size_t>(place)])];
  };
  for (std::ptrdiff_t place = 0; place < near; ++place) highest = std::max(highest, reach(place));
  std::vector<std::int32_t> places, chosen;
  for (std::ptrdiff_t place = 0; place < near && std::ssize(places) < std::ptrdiff_t{kCandidates} * n;
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

// Over points near by, or over more where their cone does not hold x.
WalkEnd FacetWalker::walk() {
  const auto over = [&](std::ptrdiff_t blocks, float share) {
    known_.load_best(*all_->kernels, walk_.wanted, &walk_);
    walk_.listed = static_cast<int>(std::min(blocks, block_count_));
    walk_.share_of_highest = share;
    return all_->kernels->walk_facets(&walk_);
  };
  const WalkEnd end = over(kListed * all_->n / kSingleLanes, share_);
  if (end == WalkEnd::arrived) {
    adapt_share();
    return end;
  }
  const bool all = block_count_ * kSingleLanes <= kRoom;
  return over(block_count_, all ? -std::numeric_limits<float>::infinity() : kFirstShare);
}

void FacetWalker::adapt_share() {
  const int wanted = kChosen * all_->n;
  if (walk_.chosen > wanted) share_ = std::min(share_ + 0.01F, kMostShare);
  if (walk_.chosen < wanted) share_ = std::max(share_ - 0.01F, kLeastShare);
}

// y = a w + v, and y·p <= a (w·p) + |v| as |p| <= 1: blocks behind cannot reach y's plane.
std::ptrdiff_t FacetWalker::blocks_in_reach() const {
  const Eigen::Map<const Eigen::VectorXd> y(walk_.dual, all_->n);
  const double a = y.dot(normal_) / normal_.squaredNorm();
  if (!(a > 0)) return block_count_;
  const double across = (y - a * normal_).norm();
  const double least = (1 - across - kSlack * (1 + y.norm() + across)) / a;
  return std::partition_point(tops_.begin(), tops_.end(), [=](double top) { return top >= least; }) -
         tops_.begin();
}

// max y·p: points that single precision, whose errors are bounded by `lost`, cannot prove to be below 1 are
// evaluated in double. Those beyond 1 are noted.
void FacetWalker::bound_support() {
  const WalkedPoints& all = *all_;
  double size = 0;
  alignas(64) float u[kRow];
  for (int k = 0; k < all.n; ++k) {
    u[k] = static_cast<float>(walk_.dual[k]);
    size += std::fabs(walk_.dual[k]) * all.magnitude[k];
  }
  size *= 1 + 2 * (all.n + 1) * kUnitRoundoff;
  const double lost = 1.01 * (all.n + 4) * kSingleRoundoff * size + 0x1p-100;
  const double error = 1.01 * (all.n + 2) * kUnitRoundoff * size + kUnderflow;
  support_ = kInfinity;
  beyond_.clear();
  if (!(lost < 0.01)) return;
  const double threshold = 1 - 3 * lost;
  Collection collection{found_.data(), values_.data(), kFound, 0, threshold};
  all_->kernels->collect_single(blocks_.data(), 0, blocks_in_reach(), all.n, u, &collection);
  if (collection.threshold != threshold) return;
  support_ = 1;
  for (std::ptrdiff_t c = 0; c < collection.count; ++c) {
    const std::ptrdiff_t place = found_[static_cast<std::size_t>(c)];
    if (place >= all.S->size()) continue;
    const double product = point_at(place).dot(Eigen::Map<const Eigen::VectorXd>(walk_.dual, all.n));
    support_ = std::max(support_, product + error);
    if (product > 1 + all.tolerance / 8 && std::ssize(beyond_) < kAdded)
      beyond_.push_back(static_cast<std::int32_t>(place));
  }
}

// x = Σ β_i p_i + r, gauge(r) <= Σ |r_k| axis_gauge_k, and y·x / max y·p.
WalkAnswer FacetWalker::bounds() const {
  const WalkedPoints& all = *all_;
  const int n = all.n;
  double sum = 0, rest = 0, along = 0, size = 0;
  for (int i = 0; i < n; ++i) sum += walk_.share[i];
  sum *= 1 + 2 * n * kUnitRoundoff;
  for (int k = 0; k < n; ++k) {
    const double x = walk_.wanted[k], w = walk_.dual[k];
    const double error =
        1.01 * (n + 3) * kUnitRoundoff * (std::fabs(x) + sum * all.magnitude[k]) + kUnderflow;
    rest += (std::fabs(walk_.rest[k]) + error) * all.axis_gauge[k];
    along += w * x;
    size += std::fabs(w * x);
  }
  along -= 1.01 * (n + 3) * kUnitRoundoff * size + kUnderflow;
  WalkAnswer answer;
  answer.upper = (sum + rest * (1 + 2 * (n + 2) * kUnitRoundoff)) * (1 + 4 * kUnitRoundoff);
  answer.lower = along > 0 ? along / support_ * (1 - 4 * kUnitRoundoff) : 0;
  answer.closed = answer.upper - answer.lower <= all.tolerance * answer.upper && answer.upper < kInfinity &&
                  std::isnormal(answer.lower);
  return answer;
}

WalkAnswer FacetWalker::gauge(const double* x, double* normal) {
  const int n = all_->n;
  double largest = 0;
  for (int k = 0; k < n; ++k) {
    double& scaled = doubles_[static_cast<std::size_t>(k)];
    scaled = std::ldexp(x[k], all_->exponent);
    walk_.target[k] = static_cast<float>(scaled);
    largest = std::max(largest, std::fabs(scaled));
  }
  if (!(largest >= kLeastLength && largest <= 1 / kLeastLength)) return {};
  if (walk() != WalkEnd::arrived) return {};
  bound_support();
  for (int passes = 1; passes < kPasses && !beyond_.empty(); ++passes) {
    const auto count = static_cast<int>(std::ssize(beyond_));
    if (all_->kernels->add_to_walk(&walk_, beyond_.data(), count) != WalkEnd::arrived) return {};
    bound_support();
  }
  const WalkAnswer answer = bounds();
  if (answer.closed) known_.add(walk_);
  if (normal != nullptr) {
    for (int k = 0; k < n; ++k) normal[k] = std::ldexp(-walk_.dual[k] / support_, all_->exponent);
  }
  return answer;
}

}  // namespace raygauge
