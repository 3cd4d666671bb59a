// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/column_pool.h"

#include <algorithm>
#include <cmath>

#include "engine/lp/tuning.h"
#include "engine/numerics/splitmix64.h"

namespace raygauge {
namespace {

constexpr std::ptrdiff_t kLanes = PointSet::kLanes;

// Blocks in the sample of a large set. With s points sampled of N about nN/s are left on the wrong side of
// the sample's normal, so that sqrt(nN) points make both sets alike; the factor is measured.
//
// In many dimensions that would be fewer points than make a basis, or little more, which is another problem.
std::ptrdiff_t sample_blocks(const PointSet& S) {
  const double balanced = std::sqrt(static_cast<double>(S.dimension()) * static_cast<double>(S.size()));
  const auto sample = static_cast<std::ptrdiff_t>(balanced / (tuned::kSampleDivisor * kLanes));
  if (S.dimension() < tuned::kManyDimensionsOfSample) {
    const auto few = std::max<std::ptrdiff_t>(
        S.dimension() < 5 ? tuned::kLeastSampleInFew : tuned::kLeastSampleInMore, sample);
    return 2 * few >= S.block_count() ? S.block_count() : few;
  }
  const std::ptrdiff_t enough = std::max(sample, tuned::kSampleOverDimension * S.dimension() / kLanes);
  const bool is_small = S.size() * S.dimension() < tuned::kWorthSampling;
  return is_small || 2 * enough >= S.block_count() ? S.block_count() : enough;
}

// One of `size` things out of each of `strata`; fixed, so that a solve is reproducible.
std::ptrdiff_t drawn_from(std::ptrdiff_t stratum, std::ptrdiff_t strata, std::ptrdiff_t size) {
  const std::ptrdiff_t first = stratum * size / strata;
  const std::ptrdiff_t width = (stratum + 1) * size / strata - first;
  const std::uint64_t drawn = splitmix64(static_cast<std::uint64_t>(stratum)) >> 32U;
  return first + static_cast<std::ptrdiff_t>((drawn * static_cast<std::uint64_t>(width)) >> 32U);
}

}  // namespace

void ColumnPool::choose(const PointSet& S, const double* factor, bool trivial, bool in_single) {
  magnitude_ = 0;
  in_single_ = false;
  for (int k = 0; k < S.dimension(); ++k) {
    magnitude_ = std::max(magnitude_, factor[k] * S.coordinate_magnitude()[k]);
  }
  // Sets small enough to carry a single-precision copy are priced from the first-level cache.
  if (in_single && S.single_data() != nullptr) return take_all(S, factor, trivial, in_single);
  const std::ptrdiff_t sample = sample_blocks(S);
  if (sample >= S.block_count()) return take_all(S, factor, trivial, in_single);
  in_single_ = in_single && sample * kLanes * S.dimension() >= tuned::kWorthRounding;
  take_sample(S, factor, sample);
}

std::ptrdiff_t ColumnPool::growth(const PointSet& S) { return 16 * sample_blocks(S); }

void ColumnPool::grow_to(std::ptrdiff_t size) {
  const std::ptrdiff_t blocks = (size + kLanes - 1) / kLanes;
  const auto needed = static_cast<std::size_t>(blocks * n_ * kLanes);
  if (needed > copy_.capacity()) copy_.reserve(std::max(needed, 2 * copy_.capacity()));
  blocks_ = copy_.data();
  single_blocks_ = nullptr;
  if (!in_single_) return;
  const std::ptrdiff_t pairs = (size + PointSet::kSingleLanes - 1) / PointSet::kSingleLanes;
  const auto needed_single = static_cast<std::size_t>(pairs * n_ * PointSet::kSingleLanes);
  if (needed_single > single_copy_.capacity()) {
    single_copy_.reserve(std::max(needed_single, 2 * single_copy_.capacity()));
  }
  single_blocks_ = single_copy_.data();
}

// The point at `position`, found in its `slot` of copy_; the first of a block stands in for those to come.
void ColumnPool::place_single(std::ptrdiff_t position, const double* slot) {
  constexpr std::ptrdiff_t kWide = PointSet::kSingleLanes;
  float* to = single_copy_.data() + (position / kWide) * n_ * kWide + position % kWide;
  const std::ptrdiff_t lanes = position % kWide == 0 ? kWide : 1;
  for (int k = 0; k < n_; ++k) {
    const auto value = static_cast<float>(slot[k * kLanes]);
    for (std::ptrdiff_t lane = 0; lane < lanes; ++lane) to[k * kWide + lane] = value;
  }
}

PricedPoints ColumnPool::view() const noexcept {
  return {blocks_, (size_ + kLanes - 1) / kLanes, single_blocks_,
          (size_ + PointSet::kSingleLanes - 1) / PointSet::kSingleLanes, size_};
}

void ColumnPool::forget_marks(std::ptrdiff_t size) {
  marked_size_ = size;
  const auto words = static_cast<std::size_t>(size + 63) / 64;
  marks_.reserve(words);
  std::fill_n(marks_.data(), words, std::uint64_t{0});
}

void ColumnPool::mark(std::int64_t index) noexcept {
  marks_[static_cast<std::size_t>(index) / 64] |= std::uint64_t{1} << (index % 64);
}

// The lanes of a last block that no point fills are marked, too; no index is theirs.
void ColumnPool::mark_block(std::ptrdiff_t block) noexcept {
  constexpr std::uint64_t kAllLanes = (std::uint64_t{1} << kLanes) - 1;
  const std::ptrdiff_t first = block * kLanes;
  marks_[static_cast<std::size_t>(first) / 64] |= kAllLanes << (first % 64);
}

bool ColumnPool::holds(std::int64_t index) const noexcept {
  if (complete_) return true;
  if (index >= marked_size_) return false;
  return ((marks_[static_cast<std::size_t>(index) / 64] >> (index % 64)) & 1U) != 0;
}

void ColumnPool::take_all(const PointSet& S, const double* factor, bool trivial, bool in_single) {
  n_ = S.dimension();
  size_ = S.size();
  complete_ = true;
  if (trivial) {
    blocks_ = S.data();
    single_blocks_ = S.single_data();
    if (in_single && single_blocks_ == nullptr && n_ >= tuned::kManyDimensionsOfSample) round_all();
    return;
  }
  grow_to(size_);
  double* copy = copy_.data();
  for (std::ptrdiff_t b = 0; b < S.block_count(); ++b) {
    for (int k = 0; k < n_; ++k) {
      const std::ptrdiff_t offset = (b * n_ + k) * kLanes;
      for (int lane = 0; lane < kLanes; ++lane) copy[offset + lane] = factor[k] * S.data()[offset + lane];
    }
  }
  if (in_single && n_ >= tuned::kManyDimensionsOfSample) round_all();
}

// blocks_ in single precision: many pricings read them.
void ColumnPool::round_all() {
  constexpr std::ptrdiff_t kWide = PointSet::kSingleLanes;
  const std::ptrdiff_t blocks = (size_ + kLanes - 1) / kLanes;
  const std::ptrdiff_t pairs = (size_ + kWide - 1) / kWide;
  single_copy_.reserve(static_cast<std::size_t>(pairs * n_ * kWide));
  for (std::ptrdiff_t half = 0; half < 2 * pairs; ++half) {
    const std::ptrdiff_t from = std::min(half, blocks - 1);  // an odd number of blocks: the last one twice
    for (int k = 0; k < n_; ++k) {
      const double* source = blocks_ + (from * n_ + k) * kLanes;
      float* to = single_copy_.data() + ((half / 2) * n_ + k) * kWide + (half % 2) * kLanes;
      for (std::ptrdiff_t lane = 0; lane < kLanes; ++lane) to[lane] = static_cast<float>(source[lane]);
    }
  }
  single_blocks_ = single_copy_.data();
}

void ColumnPool::take_sample(const PointSet& S, const double* factor, std::ptrdiff_t blocks) {
  n_ = S.dimension();
  size_ = blocks * kLanes;
  complete_ = false;
  grow_to(size_);
  forget_marks(S.size());
  if (S.tree() != nullptr) {
    take_single_points(S, factor);
  } else {
    take_blocks(S, factor, blocks);
  }
  if (!in_single_) return;
  for (std::ptrdiff_t i = 0; i < size_; ++i)
    place_single(i, copy_.data() + (i / kLanes) * n_ * kLanes + i % kLanes);
}

void ColumnPool::take_blocks(const PointSet& S, const double* factor, std::ptrdiff_t blocks) {
  for (std::ptrdiff_t s = 0; s < blocks; ++s) {
    const std::ptrdiff_t b = drawn_from(s, blocks, S.block_count());
    mark_block(b);
    for (int k = 0; k < n_; ++k) {
      const double* from = S.data() + (b * n_ + k) * kLanes;
      double* to = copy_.data() + (s * n_ + k) * kLanes;
      for (int lane = 0; lane < kLanes; ++lane) to[lane] = factor[k] * from[lane];
    }
  }
}

// The points of a block stand close together in a tree of clusters.
void ColumnPool::take_single_points(const PointSet& S, const double* factor) {
  for (std::ptrdiff_t i = 0; i < size_; ++i) {
    const std::ptrdiff_t index = drawn_from(i, size_, S.size());
    mark(index);
    const double* from = S.data() + (index / kLanes) * n_ * kLanes + index % kLanes;
    double* to = copy_.data() + (i / kLanes) * n_ * kLanes + i % kLanes;
    for (int k = 0; k < n_; ++k) to[k * kLanes] = factor[k] * from[k * kLanes];
  }
}

void ColumnPool::place(std::ptrdiff_t position, const double* point, std::ptrdiff_t stride,
                       const double* factor) {
  double* slot = copy_.data() + (position / kLanes) * n_ * kLanes + position % kLanes;
  double largest = magnitude_;
  for (int k = 0; k < n_; ++k) {
    const double value = (factor != nullptr ? factor[k] : 1.0) * point[k * stride];
    slot[k * kLanes] = value;
    largest = std::max(largest, std::fabs(value));
  }
  magnitude_ = largest;
  // A new block starts with all its lanes equal, so that the unused ones never win.
  if (position % kLanes == 0) {
    for (int k = 0; k < n_; ++k) std::fill_n(slot + k * kLanes + 1, kLanes - 1, slot[k * kLanes]);
  }
  if (in_single_) place_single(position, slot);
}

bool ColumnPool::add(const PointSet& S, const double* factor, std::int64_t index) {
  if (marked_size_ != S.size()) forget_marks(S.size());
  if (holds(index)) return false;
  mark(index);
  grow_to(size_ + 1);
  const double* point = S.data() + (index / kLanes) * n_ * kLanes + index % kLanes;
  place(size_, point, kLanes, factor);
  ++size_;
  return true;
}

void ColumnPool::clear(int n) {
  n_ = n;
  size_ = 0;
  complete_ = false;
  marked_size_ = 0;
  in_single_ = false;
  magnitude_ = 0;
  grow_to(kLanes);
}

void ColumnPool::add(const double* point) {
  grow_to(size_ + 1);
  place(size_, point, 1, nullptr);
  ++size_;
  fill_up();
}

// While points are added the first of a block stands in for those to come.
void ColumnPool::fill_up() {
  if (complete_) return;
  const auto repeat_last = [this](auto* blocks, std::ptrdiff_t lanes) {
    const std::ptrdiff_t last = (size_ - 1) % lanes;
    auto* row = blocks + (size_ - 1) / lanes * n_ * lanes;
    for (int k = 0; k < n_; ++k, row += lanes) {
      for (std::ptrdiff_t lane = last + 1; lane < lanes; ++lane) row[lane] = row[last];
    }
  };
  repeat_last(copy_.data(), kLanes);
  if (in_single_) repeat_last(single_copy_.data(), std::ptrdiff_t{PointSet::kSingleLanes});
}

std::int64_t ColumnPool::index_in(const PointSet& S, const double* factor, std::ptrdiff_t i) const noexcept {
  if (complete_) return std::min<std::int64_t>(i, S.size() - 1);
  const double* slot = blocks_ + (i / kLanes) * n_ * kLanes + i % kLanes;
  for (std::ptrdiff_t j = 0; j < S.size(); ++j) {
    const double* p = S.data() + (j / kLanes) * n_ * kLanes + j % kLanes;
    int k = 0;
    while (k < n_ && factor[k] * p[k * kLanes] == slot[k * kLanes]) ++k;
    if (k == n_) return j;
  }
  return -1;
}

void ColumnPool::copy_point(std::ptrdiff_t i, double* out) const noexcept {
  const double* slot = blocks_ + (i / kLanes) * n_ * kLanes + i % kLanes;
  for (int k = 0; k < n_; ++k) out[k] = slot[k * kLanes];
}

}  // namespace raygauge
