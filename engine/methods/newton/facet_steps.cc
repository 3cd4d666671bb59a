// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Steps of Newton at flat faces, whose normals are kinks of the support functions.
#include "engine/methods/newton/newton.h"
#include "engine/numerics/vector_kernels.h"

namespace raygauge {
namespace {

constexpr int kMostFacets = 6;         // normals of flat faces that one solve tries
constexpr double kSameNormal = 1e-14;  // of two flat faces: 1 - the cosine of their angle

constexpr int kProjections = 9;  // alternating, between two faces in search of a point of both

// rᵀ(Σ weight_i ∇²h_i)r over the active pieces.
template <class Real>
Real curvature_along(const PieceList<Real>& list, const Real* r) {
  if (!list.curved) return 0;
  Real sum = 0;
  for (int a = 0; a < list.active_count; ++a) {
    const int i = list.active[static_cast<std::size_t>(a)];
    const Real weight = list.weight[static_cast<std::size_t>(i)];
    for (int j = 0; j < list.n; ++j)
      sum += weight * r[j] * dot(list.hessian(i) + std::ptrdiff_t{j} * list.n, r, list.n);
  }
  return sum;
}

}  // namespace

// The normal of a flat face near the way, and at it the point of the face that is nearest to where the other
// set touches.
template <class Real>
bool Newton<Real>::try_facet(const Real* step) {
  if (growing_ || facets_tried_ >= kMostFacets) return false;
  Real* end = linear_.data();
  for (int k = 0; k < n_; ++k) end[k] = now_->u[static_cast<std::size_t>(k)] + step[k];
  const bool of_A = oracle_A_.facet_normal(now_->u.data(), end, next_->u.data());
  if (!of_A && !oracle_Q_.facet_normal(now_->u.data(), end, next_->u.data())) return false;
  ++facets_tried_;
  normalize(next_->u.data(), n_, next_->u.data());
  if (!evaluate(*next_) || !(next_->ratio > 0) || !accepts(*next_)) return false;
  const bool shared = of_A && shares_facet();
  if (shared) choose_facet_point_near_center();
  choose_facet_point(of_A);
  for (int i = 0; shared && i < kProjections; ++i) choose_facet_point(i % 2 != 0);
  keep(false);
  return true;
}

// The face of A or Q at next_->u keeps its point nearest to that of the other set.
template <class Real>
void Newton<Real>::choose_facet_point(bool of_A) {
  const PieceList<Real>& other = of_A ? next_->Q : next_->A;
  const Real scale = of_A ? next_->ratio : 1 / next_->ratio;
  const Real* touched = other.point(other.best);
  Real* target = linear_.data();
  for (int k = 0; k < n_; ++k) target[k] = scale * touched[k];
  if (of_A) {
    oracle_A_.replace_by_facet_point(next_->u.data(), target, next_->A);
  } else {
    oracle_Q_.replace_by_facet_point(next_->u.data(), target, next_->Q);
  }
}

// The face of Q keeps its point nearest to the centre of A, scaled: a beginning from which two discs meet at
// once.
template <class Real>
void Newton<Real>::choose_facet_point_near_center() {
  Real* target = linear_.data();
  for (int k = 0; k < n_; ++k) target[k] = center_[static_cast<std::size_t>(k)] / next_->ratio;
  oracle_Q_.replace_by_facet_point(next_->u.data(), target, next_->Q);
}

// Whether Q has a flat face at next_->u too, as a homothet of A has.
template <class Real>
bool Newton<Real>::shares_facet() {
  Real* normal = descent_.data();
  const Real* u = next_->u.data();
  if (!oracle_Q_.facet_normal(now_->u.data(), u, normal)) return false;
  normalize(normal, n_, normal);
  return dot(normal, u, n_) > 1 - kSameNormal;
}

// At the normal of a face φ has a kink that no Hessian describes, but r, with the point of the face nearest
// to the other set, is its subgradient of least length: -r leads down, as far as the curvature along it says.
template <class Real>
const Real* Newton<Real>::leave_facet() {
  const Real* r = residual_vector_.data();
  const Real curvature = curvature_along(now_->A, r) + now_->ratio * curvature_along(now_->Q, r);
  const Real length = curvature > 0 ? residual_ * residual_ / curvature : 1 / residual_;
  for (int k = 0; k < n_; ++k) descent_[static_cast<std::size_t>(k)] = -length * r[k];
  return descent_.data();
}

template bool Newton<double>::try_facet(const double*);
template bool Newton<Quad>::try_facet(const Quad*);
template const double* Newton<double>::leave_facet();
template const Quad* Newton<Quad>::leave_facet();

}  // namespace raygauge
