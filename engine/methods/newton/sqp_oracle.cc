// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/newton/sqp_oracle.h"

#include <algorithm>
#include <cmath>

#include "engine/numerics/floating_point.h"
#include "engine/numerics/vector_kernels.h"
#include "engine/sets/object_pair.h"

namespace raygauge {
namespace {

// Vertices kept of a polytope: enough for a face of any dimension and as many that just left it.
int vertices_kept(int n) { return std::max(2 * n + 2, SupportPieces::kCapacity); }

}  // namespace

template <class Real>
bool SqpOracle<Real>::bind(const ConvexSet& S, double sign, const Kernels& kernels, SupportPairs* pairs) {
  const SupportStructure structure = S.structure();
  if (structure == SupportStructure::unknown) return false;
  set_ = &S;
  smooth_ = S.smooth();
  flat_faces_ = S.flat_faces();
  pairs_ = pairs;
  sign_ = sign;
  n_ = S.dimension();
  curved_ = structure != SupportStructure::polytope;
  const auto size = static_cast<std::size_t>(n_);
  direction_.reserve(size);
  other_.reserve(size);
  if (!curved_) {
    nearest_.reserve(size);
    vertex_.reserve(size);
    vertices_.bind(S, nullptr, kernels, pairs);
    coordinate_error_ = vertices_.coordinate_error();
    memory_.reserve(size * static_cast<std::size_t>(vertices_kept(n_)));
    remembered_ = next_ = 0;
    return true;
  }
  magnitude_.reserve(size);
  S.magnitude_unchecked(magnitude_.data());
  const double largest = *std::max_element(magnitude_.data(), magnitude_.data() + n_);
  coordinate_error_ = ConvexSet::rounding_error<Real>(n_) * largest + kUnderflow;
  return true;
}

template <class Real>
void SqpOracle<Real>::make_room(PieceList<Real>& list, int count) {
  const auto room = static_cast<std::size_t>(count);
  const auto size = static_cast<std::size_t>(n_);
  list.n = n_;
  list.curved = curved_;
  list.value.reserve(room);
  list.weight.reserve(room);
  list.active.reserve(room);
  list.points.reserve(room * size);
  if (curved_) list.hessians.reserve(room * size * size);
}

template <class Real>
bool SqpOracle<Real>::evaluate(const Real* u, PieceList<Real>& list) {
  if (curved_) {
    evaluate_smooth(u, list);
  } else {
    evaluate_polytope(u, list);
  }
  if (list.count == 0) return false;
  list.best = static_cast<int>(std::max_element(list.value.data(), list.value.data() + list.count) -
                               list.value.data());
  if (curved_) list.support.value = list.value[static_cast<std::size_t>(list.best)];
  return true;
}

template <class Real>
void SqpOracle<Real>::evaluate_smooth(const Real* u, PieceList<Real>& list) {
  make_room(list, SupportPieces::kCapacity);
  BasicSupportPieces<Real> pieces;
  pieces.dimension = n_;
  pieces.graded = graded_;
  pieces.points = list.points.data();
  pieces.hessians = list.hessians.data();
  double magnitude = 0;
  for (int k = 0; k < n_; ++k) {
    direction_[static_cast<std::size_t>(k)] = sign_ * u[k];
    magnitude += std::fabs(static_cast<double>(u[k])) * magnitude_[static_cast<std::size_t>(k)];
  }
  if (pairs_ != nullptr) {
    pairs_->pieces(direction_.data(), pieces);
  } else if (smooth_ != nullptr) {
    smooth_->pieces(direction_.data(), pieces);
  }
  list.count = pieces.count;
  std::copy_n(pieces.value.data(), pieces.count, list.value.data());
  list.support.error = ConvexSet::rounding_error<Real>(n_) * magnitude + kUnderflow;
}

// The vertex is that of the direction v nearest to u in double precision: h(u) <= h(v) + Σ|u_k - v_k| m_k.
template <class Real>
void SqpOracle<Real>::evaluate_polytope(const Real* u, PieceList<Real>& list) {
  make_room(list, vertices_kept(n_));
  double astray = 0;
  for (int k = 0; k < n_; ++k) {
    nearest_[static_cast<std::size_t>(k)] = static_cast<double>(u[k]);
    astray += std::fabs(static_cast<double>(u[k] - nearest_[static_cast<std::size_t>(k)]));
  }
  const SupportValue support = vertices_.verify(nearest_.data(), sign_, -kInfinity, vertex_.data());
  list.support.value = support.value;
  list.support.error = support.error + 2 * astray * vertices_.magnitude();
  remember(vertex_.data());
  list.count = remembered_;
  std::copy_n(memory_.data(), static_cast<std::ptrdiff_t>(remembered_) * n_, list.points.data());
  for (int i = 0; i < list.count; ++i) {
    list.value[static_cast<std::size_t>(i)] = sign_ * dot(u, list.point(i), n_);
  }
}

template <class Real>
void SqpOracle<Real>::remember(const double* vertex) {
  for (int i = 0; i < remembered_; ++i) {
    if (std::equal(vertex, vertex + n_, memory_.data() + std::ptrdiff_t{i} * n_)) return;
  }
  int slot = remembered_;
  if (remembered_ < vertices_kept(n_)) {
    ++remembered_;
  } else {
    slot = next_;
    next_ = (next_ + 1) % vertices_kept(n_);
  }
  std::copy_n(vertex, n_, memory_.data() + std::ptrdiff_t{slot} * n_);
}

template <class Real>
void SqpOracle<Real>::replace_by_facet_point(const Real* u, const Real* target, PieceList<Real>& list) {
  for (int k = 0; k < n_; ++k) direction_[static_cast<std::size_t>(k)] = sign_ * u[k];
  if (pairs_ != nullptr) {
    pairs_->facet_point(direction_.data(), target, list.points.data());
  } else {
    flat_faces_->point(direction_.data(), target, list.points.data());
  }
  std::fill_n(list.hessians.data(), static_cast<std::ptrdiff_t>(n_) * n_, Real{0});
  list.count = 1;
  list.best = 0;
  list.value[0] = list.support.value;
}

template <class Real>
bool SqpOracle<Real>::facet_normal(const Real* u, const Real* v, Real* normal) {
  if (!curved_) return false;
  for (int k = 0; k < n_; ++k) {
    direction_[static_cast<std::size_t>(k)] = sign_ * u[k];
    other_[static_cast<std::size_t>(k)] = sign_ * v[k];
  }
  if (flat_faces_ == nullptr || !flat_faces_->normal(direction_.data(), other_.data(), normal)) return false;
  for (int k = 0; k < n_; ++k) normal[k] *= sign_;
  return true;
}

template class SqpOracle<double>;
template class SqpOracle<Quad>;

}  // namespace raygauge
