// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/object_pair.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/numerics/vector_kernels.h"
#include "engine/sets/parameters.h"

namespace raygauge {

ObjectPair::ObjectPair(const ConvexSet& A2, const ConvexSet& A1, bool keeps_parts)
    : MinkowskiView({.S = &A2, .T = &A1, .sign = -1.0, .keeps_parts = keeps_parts}) {
  check_dimension("object distance", "A1", A1.dimension(), dimension());
}

void SupportPairs::begin(const ObjectPair& pair) {
  pair_ = &pair;
  n_ = pair.dimension();
  count_ = 0;
}

template <class Real>
void SupportPairs::add(const Real* difference, const Real* a1) {
  const auto size = static_cast<std::size_t>(n_);
  const auto needed = static_cast<std::size_t>(count_ + 1) * 2 * size;
  if (needed > pairs_.capacity()) pairs_.reserve(2 * needed);
  double* pair = pairs_.data() + static_cast<std::size_t>(count_++) * 2 * size;
  for (int k = 0; k < n_; ++k) {
    pair[k] = static_cast<double>(difference[k]);
    pair[n_ + k] = static_cast<double>(a1[k]);
  }
}

double SupportPairs::support(const double* u, double* point) {
  Scratch a1(n_);
  const double value = pair_->support_with_part(u, point, a1.data());
  add(point, a1.data());
  return value;
}

template <class Real>
void SupportPairs::pieces(const Real* u, BasicSupportPieces<Real>& pieces) {
  pieces.count = 0;
  if (pair_->smooth() == nullptr) return;
  BasicScratch<Real> a1(SupportPieces::kCapacity * n_);
  const int count = pair_->pieces_with_parts(u, pieces, SupportPieces::kCapacity, a1.data());
  for (int i = 0; i < pieces.count; ++i) add(pieces.point(i), a1.data() + std::ptrdiff_t{i % count} * n_);
}

template <class Real>
void SupportPairs::facet_point(const Real* normal, const Real* target, Real* point) {
  BasicScratch<Real> a1(n_);
  if (pair_->facet_point_with_part(normal, target, point, a1.data())) add(point, a1.data());
}

template void SupportPairs::pieces(const double*, SupportPieces&);
template void SupportPairs::pieces(const Quad*, QuadSupportPieces&);
template void SupportPairs::facet_point(const double*, const double*, double*);
template void SupportPairs::facet_point(const Quad*, const Quad*, Quad*);

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

}  // namespace raygauge
