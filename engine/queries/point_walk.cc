// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/point_walk.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

constexpr int kLanes = PointSet::kSingleLanes;
constexpr int kRow = WalkedPoints::kRow;
constexpr int kAdded = 32;                // points that a pass adds to the columns
constexpr double kLeastLength = 0x1p-60;  // of x, and the most is its inverse: squares are single numbers
constexpr double kSingleRoundoff = 0x1p-24;
constexpr double kMostLost = 0.01;  // of products, by rounding
constexpr double kLeastSize = 0.5;  // Σ|y_k| max|p_k|, which is 1 and more, as y·p is of the basic points

}  // namespace

PointWalk::PointWalk(const WalkedPoints& points) : all_(&points) {
  const auto n = static_cast<std::size_t>(points.n);
  constexpr std::size_t kColumns = (kRoom + kPasses * kAdded + 2 * kLanes) / 32 * 32 + kLanes;
  small_.reserve((n + 3) * kRow);
  doubles_.reserve(std::size_t{4} * kRow);
  numbers_.reserve(std::size_t{2} * kRow + kMostFound);
  columns_.reserve(kColumns * n + kLanes);
  for (AlignedBuffer<float>* scratch : {&costs_, &along_}) scratch->reserve(kColumns);
  places_.reserve(kColumns + kLanes);
  std::fill_n(small_.data(), (n + 3) * kRow, 0.0F);
  std::fill_n(doubles_.data(), std::size_t{4} * kRow, 0.0);
  walk_.R = small_.data();
  walk_.y = walk_.R + n * kRow;
  walk_.x = walk_.y + kRow;
  walk_.target = walk_.x + kRow;
  walk_.id = numbers_.data();
  walk_.rounded = walk_.id + kRow;
  walk_.found = walk_.rounded + kRow;
  walk_.wanted = doubles_.data();
  walk_.share = doubles_.data() + kRow;
  walk_.rest = walk_.share + kRow;
  walk_.dual = walk_.rest + kRow;
  walk_.columns = columns_.data();
  walk_.stride = static_cast<std::ptrdiff_t>(kColumns);
  walk_.place = places_.data();
  walk_.cost = costs_.data();
  walk_.along = along_.data();
}

bool PointWalk::begin(const WalkQuestion& question) {
  question_ = question;
  *question_.answer = {};
  passes_ = 0;
  double largest = 0;
  for (int k = 0; k < all_->n; ++k) {
    double& scaled = doubles_[static_cast<std::size_t>(k)];
    scaled = question.x[k] * all_->factor;
    walk_.target[k] = static_cast<float>(scaled);
    largest = std::max(largest, std::fabs(scaled));
  }
  return largest >= kLeastLength && largest <= 1 / kLeastLength;
}

bool PointWalk::prepare_pass() {
  const int n = all_->n;
  double size = 0;
  for (int k = 0; k < n; ++k) size += std::fabs(walk_.dual[k]) * all_->magnitude[k];
  size *= 1 + 2 * (n + 1) * kUnitRoundoff;
  lost_ = 1.01 * (n + 4) * kSingleRoundoff * size + 0x1p-100;
  error_ = 1.01 * (n + 2) * kUnitRoundoff * size + kUnderflow;
  support_ = kInfinity;
  beyond_.clear();
  if (!(lost_ < kMostLost && size > kLeastSize)) return false;
  round_normal();
  return true;
}

// Y = s y + b and P = c p + a with |a_k|, |b_k| <= 1/2, so that Y·P differs from s c (y·p) by at most
// (c Σ|p_k| + s Σ|y_k| + n/2) / 2, and Σ|p_k| <= √n as |p| <= 1. With |Y| below 2^15 sums stay below 2^30.
void PointWalk::round_normal() {
  const int n = all_->n;
  const Eigen::Map<const Eigen::VectorXd> y(walk_.dual, n);
  const double s = std::ldexp(1.0, 13 - std::ilogb(y.norm()));
  const double* of_pair = walk_.dual;  // zeros beyond n
  for (int k = 0; k < kRow / 2; ++k, of_pair += 2) walk_.rounded[k] = pair_of(s * of_pair[0], s * of_pair[1]);
  const double error = 0.51 * (WalkedPoints::kScale * std::sqrt(n) + s * y.lpNorm<1>() + n);
  const double one = s * WalkedPoints::kScale;
  integers_suffice_ = error < kMostLost * one;
  if (integers_suffice_) walk_.threshold = static_cast<std::int32_t>(std::floor(one - error) - 1);
}

void PointWalk::find_in_single(const FacetWalkPoints& group, std::ptrdiff_t block_count) {
  std::array<std::int64_t, kMostFound> index{};
  std::array<double, kMostFound> value{};
  const double threshold = 1 - 3 * lost_;
  Collection found{index.data(), value.data(), kMostFound, 0, threshold};
  all_->kernels->collect_single(group.blocks, 0, block_count, all_->n, walk_.y, &found);
  const bool whole = found.threshold == threshold;
  walk_.found_count = whole ? static_cast<int>(found.count) : kMostFound + 1;
  for (std::ptrdiff_t i = 0; whole && i < found.count; ++i)
    walk_.found[i] = static_cast<std::int32_t>(index[static_cast<std::size_t>(i)]);
}

void PointWalk::read_pass(const FacetWalkPoints& group) {
  if (walk_.found_count > kMostFound) return;
  support_ = 1;
  for (int c = 0; c < walk_.found_count; ++c) {
    const std::int32_t place = walk_.found[c];
    if (place >= all_->S->size()) continue;
    const double* point = group.points + static_cast<std::ptrdiff_t>(group.order[place]) * kRow;
    double product = 0;
    for (int k = 0; k < all_->n; ++k) product += point[k] * walk_.dual[k];
    support_ = std::max(support_, product + error_);
    if (product > 1 + all_->tolerance / 8 && std::ssize(beyond_) < kAdded) beyond_.push_back(place);
  }
}

bool PointWalk::go_on(const FacetWalkPoints& group) {
  if (beyond_.empty() || ++passes_ == kPasses) return false;
  all_->kernels->add_to_walk(&group, &walk_, beyond_.data(), static_cast<int>(std::ssize(beyond_)));
  return true;
}

// x = Σ β_i p_i + r, gauge(r) <= Σ |r_k| axis_gauge_k, and y·x / max y·p.
WalkAnswer PointWalk::bounds() const {
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

bool PointWalk::answer() const {
  *question_.answer = bounds();
  for (int k = 0; question_.normal != nullptr && k < all_->n; ++k)
    question_.normal[k] = -walk_.dual[k] / support_ * all_->factor;
  return question_.answer->closed;
}

}  // namespace raygauge
