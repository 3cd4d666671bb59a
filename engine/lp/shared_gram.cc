// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/shared_gram.h"

#include <algorithm>
#include <cmath>

#include "raygauge/sets/point_set.h"

namespace raygauge {
namespace {

// Points that a thread copies at a time: two blocks at least, whose lanes are turned together.
constexpr int kCopied = 2 * static_cast<int>(PointSet::kLanes);
constexpr int kBadStride = 128;
constexpr int kCleared = 64;  // columns that a thread clears at a time
// Operations for a coordinate that is copied, in those of products.
constexpr double kCopying = 8;

}  // namespace

void SharedGram::begin(int n, const Kernels& kernels, const Helpers& helpers) {
  n_ = n;
  kernels_ = &kernels;
  helpers_ = helpers;
  rows_ = gram_rows(n) % kBadStride == 0 ? gram_rows(n) + kRowPadding : gram_rows(n);
  const int columns = gram_columns(n);
  matrix_.reserve(static_cast<std::size_t>(rows_) * static_cast<std::size_t>(columns));
  panels_.reserve(static_cast<std::size_t>(gram_rows(n)) * kGramPoints);
  helpers_.run((columns + kCleared - 1) / kCleared, static_cast<double>(rows_) * columns, [&](int chunk) {
    const int first = chunk * kCleared;
    const std::ptrdiff_t count = std::min(columns - first, kCleared);
    std::fill_n(matrix_.data() + std::ptrdiff_t{first} * rows_, count * rows_, 0.0);
  });
}

void SharedGram::add(const PricedPoints& points, const double* weight, bool single) {
  chosen_.clear();
  for (std::ptrdiff_t i = 0; i < points.block_count * PointSet::kLanes; ++i) {
    if (weight[i] > 0) chosen_.push_back({i, std::sqrt(weight[i])});
  }
  const std::ptrdiff_t count = std::ssize(chosen_);
  for (std::ptrdiff_t first = 0; first < count; first += kGramPoints) {
    const auto depth = static_cast<int>(std::min<std::ptrdiff_t>(kGramPoints, count - first));
    add_batch(points.blocks, chosen_.data() + first, depth, single);
  }
}

void SharedGram::add_batch(const double* blocks, const GramPoint* points, int count, bool single) {
  const int copies = (count + kCopied - 1) / kCopied;
  helpers_.run(copies, kCopying * count * n_, [&](int copy) {
    const int last = std::min(count, (copy + 1) * kCopied);
    kernels_->pack_points(blocks, n_, points, copy * kCopied, last, single, panels_.data());
  });
  add_panels(n_, count, single, 1.0, matrix_.data());
}

// Stripes far down are long: they come first, so that no thread begins one last.
void SharedGram::add_panels(int n, int depth, bool single, double sign, double* M) {
  const int stripes = gram_stripes(n);
  helpers_.run(stripes, 0.5 * depth * n * n, [&](int chunk) {
    const int first = (stripes - 1 - chunk) * kGramStripe;
    const GramPart part = {depth, n, first, first + kGramStripe, rows()};
    kernels_->add_panels(panels_.data(), part, single, sign, M);
  });
}

bool SharedGram::factor() {
  const std::ptrdiff_t ld = rows();
  double* M = matrix_.data();
  for (int first = 0; first < n_; first += kCholeskyColumns) {
    const int last = std::min(n_, first + kCholeskyColumns);
    if (!kernels_->factor_columns(M, ld, n_, first, last)) return false;
    if (last == n_) break;
    kernels_->pack_columns(M + first * ld + last, ld, last - first, n_ - last, panels_.data());
    add_panels(n_ - last, last - first, false, -1.0, M + last * ld + last);
  }
  return true;
}

}  // namespace raygauge
