// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// The passes over all points, which threads share: in single precision at first, then over the points as they
// are.
#include <algorithm>

#include "engine/lp/interior_point.h"

namespace raygauge {
namespace {

constexpr std::ptrdiff_t kLanes = PointSet::kLanes;

// Of a slack in single precision, what stays of it at least.
constexpr double kKeptSlack = 0.1;
// Of a pass that threads share: a chunk has so many coordinates.
constexpr double kChunkNumbers = 1 << 15;
constexpr std::ptrdiff_t kMostChunks = 32;

}  // namespace

void InteriorPoint::reserve_passes() {
  scratch_.reserve(kMostChunks * (kLanes + 1) * static_cast<std::size_t>(padded_rows(n_)));
}

// work(chunk, first, count) for the chunks of the blocks of one side, in the precision that is read; their
// number.
template <class Work>
int InteriorPoint::share(const Side& side, const Work& work) {
  const PricedPoints& points = side.points;
  const std::ptrdiff_t blocks = reads_single(side) ? points.single_block_count : points.block_count;
  const double numbers = static_cast<double>(points.block_count) * n_ * kLanes;
  const auto wanted = static_cast<std::ptrdiff_t>(numbers / kChunkNumbers);
  const auto chunks = static_cast<int>(std::clamp<std::ptrdiff_t>(wanted, 1, kMostChunks));
  helpers_.run(chunks, numbers, [&](int chunk) {
    const std::ptrdiff_t first = blocks * chunk / chunks;
    work(chunk, first, blocks * (chunk + 1) / chunks - first);
  });
  return chunks;
}

// u·p for every point.
// NOLINTNEXTLINE(readability-non-const-parameter): the kernel writes the products
void InteriorPoint::price(Side& side, const double* u, double* products) {
  share(side, [&](int /*chunk*/, std::ptrdiff_t first, std::ptrdiff_t count) {
    if (reads_single(side)) {
      const float* blocks = side.points.single_blocks + first * n_ * PointSet::kSingleLanes;
      kernels_->products_single(blocks, count, n_, u, products + first * PointSet::kSingleLanes);
    } else {
      const double* blocks = side.points.blocks + first * n_ * kLanes;
      kernels_->products(blocks, count, n_, u, products + first * kLanes);
    }
  });
}

// s = c - Aᵀy.
void InteriorPoint::slacks(Side& side, double cost) {
  price(side, y_.data(), side.s.data());
  const double t = side.last * y_[static_cast<std::size_t>(n_)];
  for (std::ptrdiff_t i = 0; i < side.count; ++i) {
    double& s = side.s[static_cast<std::size_t>(i)];
    s = cost - side.sign * s - t;
  }
}

// How far below what is to stay of them, kept in ds, the slacks are: at most so much of `share(slack)`.
template <class Share>
double InteriorPoint::lack(const Side& side, const Share& share) {
  double largest = 0;
  for (std::ptrdiff_t i = 0; i < side.points.size; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double least = kKeptSlack * std::min(side.ds[at], 1.0);
    largest = std::max(largest, (least - side.s[at]) / share(side.s[at]));
  }
  return largest;
}

// From here on of the points as they are. Where those leave too little of a slack, u becomes shorter and t
// less.
void InteriorPoint::leave_single() {
  if (!single_) return;
  const bool rounded = reads_single(A_) || reads_single(Q_);
  single_ = false;
  if (!rounded) return;
  for (Side* side : {&A_, &Q_}) std::copy_n(side->s.data(), side->points.size, side->ds.data());
  slacks(Q_, 1.0);
  const double shrink = lack(Q_, [](double slack) { return 1 - std::min(slack, 0.5); });
  for (int k = 0; k <= n_; ++k) y_[static_cast<std::size_t>(k)] *= 1 - shrink;
  if (shrink > 0) slacks(Q_, 1.0);
  slacks(A_, 0.0);
  const double drop = lack(A_, [](double /*slack*/) { return 1.0; });
  y_[static_cast<std::size_t>(n_)] -= drop;
  for (std::ptrdiff_t i = 0; i < A_.points.size; ++i) A_.s[static_cast<std::size_t>(i)] += drop;
}

// sum += Σ weight_i p_i.
void InteriorPoint::add_weighted(const Side& side, double* sum) {
  const double* weight = side.weight.data();
  if (std::all_of(weight, weight + side.count, [](double w) { return w == 0; })) return;
  const std::ptrdiff_t stride = (kLanes + 1) * padded_rows(n_);
  const int chunks = share(side, [&](int chunk, std::ptrdiff_t first, std::ptrdiff_t count) {
    double* scratch = scratch_.data() + chunk * stride;
    double* part = scratch + stride - padded_rows(n_);
    std::fill_n(part, n_, 0.0);
    if (reads_single(side)) {
      kernels_->add_weighted_single(side.points.single_blocks + first * n_ * PointSet::kSingleLanes, count,
                                    n_, weight + first * PointSet::kSingleLanes, scratch, part);
    } else {
      kernels_->add_weighted(side.points.blocks + first * n_ * kLanes, count, n_, weight + first * kLanes,
                             scratch, part);
    }
  });
  for (int chunk = 0; chunk < chunks; ++chunk) {
    const double* part = scratch_.data() + (chunk + 1) * stride - padded_rows(n_);
    for (int k = 0; k < n_; ++k) sum[k] += part[k];
  }
}

}  // namespace raygauge
