// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/distance/working_set.h"

#include <algorithm>

namespace raygauge {
namespace {

constexpr std::ptrdiff_t kLanes = PointSet::kLanes;

// SplitMix64: which block of a stratum is taken. Fixed, so that a solve is reproducible.
std::uint64_t scramble(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

}  // namespace

double* WorkingSet::grow_to(std::ptrdiff_t size) {
  const std::ptrdiff_t blocks = (size + kLanes - 1) / kLanes;
  const auto needed = static_cast<std::size_t>(blocks * n_ * kLanes);
  if (needed > copy_.capacity()) copy_.reserve(std::max(needed, 2 * copy_.capacity()));
  const auto slots = static_cast<std::size_t>(blocks * kLanes);
  if (slots > index_.capacity()) index_.reserve(std::max(slots, 2 * index_.capacity()));
  blocks_ = copy_.data();
  return copy_.data();
}

void WorkingSet::take_all(const PointSet& S, const double* factor, bool trivial) {
  n_ = S.dimension();
  size_ = set_size_ = S.size();
  complete_ = true;
  if (trivial) {
    blocks_ = S.data();
    return;
  }
  double* copy = grow_to(size_);
  for (std::ptrdiff_t b = 0; b < S.block_count(); ++b) {
    for (int k = 0; k < n_; ++k) {
      const std::ptrdiff_t offset = (b * n_ + k) * kLanes;
      for (int lane = 0; lane < kLanes; ++lane) copy[offset + lane] = factor[k] * S.data()[offset + lane];
    }
  }
}

void WorkingSet::take_sample(const PointSet& S, const double* factor, bool trivial, std::ptrdiff_t blocks) {
  if (blocks >= S.block_count()) {
    take_all(S, factor, trivial);
    return;
  }
  n_ = S.dimension();
  size_ = blocks * kLanes;
  set_size_ = S.size();
  complete_ = false;
  double* copy = grow_to(size_);
  for (std::ptrdiff_t s = 0; s < blocks; ++s) {
    const std::ptrdiff_t first = s * S.block_count() / blocks;
    const std::ptrdiff_t width = (s + 1) * S.block_count() / blocks - first;
    const auto jump = static_cast<std::ptrdiff_t>(scramble(static_cast<std::uint64_t>(s)) %
                                                  static_cast<std::uint64_t>(width));
    const std::ptrdiff_t b = first + jump;
    for (int k = 0; k < n_; ++k) {
      const double* from = S.data() + (b * n_ + k) * kLanes;
      double* to = copy + (s * n_ + k) * kLanes;
      for (int lane = 0; lane < kLanes; ++lane) to[lane] = factor[k] * from[lane];
    }
    for (int lane = 0; lane < kLanes; ++lane) {
      index_[static_cast<std::size_t>(s * kLanes + lane)] = std::min(b * kLanes + lane, set_size_ - 1);
    }
  }
}

void WorkingSet::place(std::ptrdiff_t position, const double* point, std::ptrdiff_t stride,
                       const double* factor) {
  double* slot = copy_.data() + (position / kLanes) * n_ * kLanes + position % kLanes;
  // A new block starts with all its lanes equal, so that the unused ones never win.
  const std::ptrdiff_t lanes = position % kLanes == 0 ? kLanes : 1;
  for (int k = 0; k < n_; ++k) {
    const double value = (factor != nullptr ? factor[k] : 1.0) * point[k * stride];
    for (std::ptrdiff_t lane = 0; lane < lanes; ++lane) slot[k * kLanes + lane] = value;
  }
}

void WorkingSet::add(const PointSet& S, const double* factor, std::int64_t index) {
  grow_to(size_ + 1);
  const double* point = S.data() + (index / kLanes) * n_ * kLanes + index % kLanes;
  place(size_, point, kLanes, factor);
  index_[static_cast<std::size_t>(size_++)] = index;
}

void WorkingSet::clear(int n) {
  n_ = n;
  size_ = set_size_ = 0;
  complete_ = false;
  grow_to(kLanes);
}

void WorkingSet::add(const double* point) {
  grow_to(size_ + 1);
  place(size_, point, 1, nullptr);
  index_[static_cast<std::size_t>(size_)] = size_;
  ++size_;
}

void WorkingSet::copy_point(std::ptrdiff_t i, double* out) const noexcept {
  const double* slot = blocks_ + (i / kLanes) * n_ * kLanes + i % kLanes;
  for (int k = 0; k < n_; ++k) out[k] = slot[k * kLanes];
}

}  // namespace raygauge
