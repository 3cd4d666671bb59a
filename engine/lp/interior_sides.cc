// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/interior_sides.h"

#include <algorithm>

#include "raygauge/sets/point_set.h"

namespace raygauge {
namespace {

constexpr std::ptrdiff_t kLanes = PointSet::kLanes;

// Of a slack in single precision, what stays of it at least.
constexpr double kKeptSlack = 0.1;
// Of a pass that threads share: a chunk has so many coordinates.
constexpr double kChunkNumbers = 1 << 15;
constexpr std::ptrdiff_t kMostChunks = 32;

// How far below what is to stay of them, kept in ds, the slacks are: at most so much of `share(slack)`.
template <class Share>
double lack(const InteriorSide& side, const Share& share) {
  double largest = 0;
  for (std::size_t i = 0; i < side.size; ++i) {
    const double least = kKeptSlack * std::min(side.ds[i], 1.0);
    largest = std::max(largest, (least - side.s[i]) / share(side.s[i]));
  }
  return largest;
}

}  // namespace

void InteriorSide::bind(const PricedPoints& of, double sign_of_them) {
  points = of;
  size = static_cast<std::size_t>(of.size);
  lanes = static_cast<std::size_t>(
      of.single_blocks == nullptr ? of.block_count * kLanes : of.single_block_count * PointSet::kSingleLanes);
  sign = sign_of_them;
  last = is_A() ? 1.0 : 0.0;
  for (AlignedBuffer<double>* numbers : {&x, &s, &dx, &ds, &kept_dx, &kept_ds, &target, &weight})
    numbers->reserve(lanes);
}

void InteriorPasses::begin(int n, bool single, const Kernels& kernels) {
  n_ = n;
  single_ = single;
  kernels_ = &kernels;
  scratch_.reserve(kMostChunks * (kLanes + 1) * static_cast<std::size_t>(padded_rows(n)));
}

// work(chunk, first, count) for the chunks of the blocks of one side, in the precision that is read; their
// number.
template <class Work>
int InteriorPasses::share(const InteriorSide& side, const Work& work) const {
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

void InteriorPasses::price(const InteriorSide& side, const double* u, double* products) const {
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

void InteriorPasses::compute_slacks(InteriorSide& side, const double* y) const {
  price(side, y, side.s.data());
  const double cost = side.is_A() ? 0.0 : 1.0, t = side.last * y[n_];
  for (std::size_t i = 0; i < side.lanes; ++i) side.s[i] = cost - side.sign * side.s[i] - t;
}

void InteriorPasses::leave_single(InteriorSides& sides, double* y) {
  if (!single_) return;
  auto& [A, Q] = sides;
  const bool rounded = reads_single(A) || reads_single(Q);
  single_ = false;
  if (!rounded) return;
  for (InteriorSide& side : sides) std::copy_n(side.s.data(), side.size, side.ds.data());
  compute_slacks(Q, y);
  const double shrink = lack(Q, [](double slack) { return 1 - std::min(slack, 0.5); });
  for (int k = 0; k <= n_; ++k) y[k] *= 1 - shrink;
  if (shrink > 0) compute_slacks(Q, y);
  compute_slacks(A, y);
  const double drop = lack(A, [](double /*slack*/) { return 1.0; });
  y[n_] -= drop;
  for (std::size_t i = 0; i < A.size; ++i) A.s[i] += drop;
}

void InteriorPasses::add_weighted(const InteriorSide& side, double* sum) {
  const double* weight = side.weight.data();
  if (std::all_of(weight, weight + side.lanes, [](double w) { return w == 0; })) return;
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
