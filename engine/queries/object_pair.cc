// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/object_pair.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/numerics/vector_kernels.h"
#include "engine/sets/parameters.h"
#include "engine/sets/set_sums.h"
#include "raygauge/exceptions.h"

namespace raygauge {

void SupportPairs::add(const double* difference, const double* a1) {
  const auto size = static_cast<std::size_t>(n_);
  const auto needed = static_cast<std::size_t>(count_ + 1) * 2 * size;
  if (needed > pairs_.capacity()) pairs_.reserve(2 * needed);
  double* pair = pairs_.data() + static_cast<std::size_t>(count_++) * 2 * size;
  std::copy_n(difference, n_, pair);
  std::copy_n(a1, n_, pair + n_);
}

const double* SupportPairs::partner(const double* difference) const {
  const double* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (std::ptrdiff_t i = count_ - 1; i >= 0 && least > 0; --i) {
    const double* pair = pairs_.data() + 2 * i * n_;
    double away = 0;
    for (int k = 0; k < n_; ++k) away = std::max(away, std::fabs(pair[k] - difference[k]));
    if (away < least) {
      least = away;
      nearest = pair + n_;
    }
  }
  return nearest;
}

ObjectPair::ObjectPair(const ConvexSet& A2, const ConvexSet& A1, SupportPairs* pairs)
    : ConvexSet(A2.dimension()), A2_(A2), A1_(A1), pairs_(pairs) {
  check_dimension("object distance", "A1", A1.dimension(), dimension());
}

double ObjectPair::do_support(const double* u, double* point) const {
  Scratch a1(dimension());
  const double value = sum_support(A2_, A1_, -1.0, u, point, a1.data());
  if (pairs_ != nullptr) pairs_->add(point, a1.data());
  return value;
}

void ObjectPair::do_center(double* point) const { sum_center(A2_, A1_, -1.0, point); }

void ObjectPair::do_magnitude(double* magnitude) const { sum_magnitude(A2_, A1_, magnitude); }

SupportStructure ObjectPair::do_structure() const noexcept {
  return structure_of_sum(A2_.structure(), A1_.structure());
}

// Without extents: a point that was moved along a face would be in no recorded pair.
bool ObjectPair::do_is_unconditional(double* extent) const {
  return sum_is_unconditional(A2_, A1_, extent, false);
}

void ObjectPair::do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const {
  const int n = dimension();
  Scratch points_1(SupportPieces::kCapacity * n);
  const int count_1 = sum_pieces(A2_, A1_, -1.0, u, pieces, capacity, points_1.data());
  if (pairs_ == nullptr) return;
  for (int i = 0; i < pieces.count; ++i) {
    pairs_->add(pieces.point(i), points_1.data() + std::ptrdiff_t{i % count_1} * n);
  }
}

}  // namespace raygauge
