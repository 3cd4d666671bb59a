// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/newton/power_steps.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/sets/capability_queries.h"

namespace raygauge {
namespace {

// A step that makes a coordinate this much smaller takes it to the face across u_k = 0.
constexpr double kAtFace = 1e-6;

// A step away from that face is too short if ln |s_k - c_k| rises by less than this: many of them would be
// needed.
constexpr double kCreeping = 1;

constexpr double kFarthest = 4;  // of a coordinate of what was a unit vector

// Where points hardly answer to u, the slope at one u tells little of the next.
constexpr double kSteepest = 2;

// u (1 + a d/u)^(1/a), for a = 0 its limit. The factor need not be more precise than a double.
template <class Real>
Real along_power(Real u, Real d, double a) {
  const auto relative = static_cast<double>(d / u);
  const double change = a * relative;
  double logarithm = relative;
  if (a > 0) logarithm = (change > -1 ? std::log1p(change) : std::log(-1 - change)) / a;
  return u * std::copysign(std::exp(logarithm), 1 + change);
}

// The way from u > 0 back to the greater `before`, for a smaller share a part of it in equal ratios: there
// may be a hundred powers of ten between them. The root, because the first trial is rarely too far.
template <class Real>
Real way_back(Real u, Real before, double share) {
  const Real from = std::max(u, Real{std::numeric_limits<double>::min()});
  return from * std::exp(std::cbrt(share) * std::log(static_cast<double>(before / from)));
}

}  // namespace

template <class Real>
bool PowerSteps<Real>::Side::bind(const ConvexSet& S, double u_sign) {
  const auto n = static_cast<std::size_t>(S.dimension());
  for (auto* buffer : {&center, &extent, &direction, &reach, &change}) buffer->reserve(n);
  set = &S;
  sign = u_sign;
  unconditional = is_unconditional(S, extent.data());
  if (unconditional) S.center_unchecked(center.data());
  std::fill_n(direction.data(), n, 1.0);
  in_part = !unconditional && S.symmetry() != nullptr &&
            S.symmetry()->summands(direction.data(), reach.data(), change.data());
  return S.structure() == SupportStructure::smooth || S.structure() == SupportStructure::point;
}

template <class Real>
void PowerSteps<Real>::Side::look_along(const Real* u, int n) {
  if (!in_part) return;
  for (int k = 0; k < n; ++k) direction[static_cast<std::size_t>(k)] = sign * static_cast<double>(u[k]);
  in_part = set->symmetry()->summands(direction.data(), reach.data(), change.data());
}

template <class Real>
bool PowerSteps<Real>::bind(const ConvexSet& A, const ConvexSet& Q) {
  n_ = A.dimension();
  meeting_ = 0;
  exponent_.reserve(static_cast<std::size_t>(n_));
  meets_.reserve(static_cast<std::size_t>(n_));
  before_.reserve(static_cast<std::size_t>(n_));
  std::fill_n(before_.data(), n_, Real{0});
  if (!A_.bind(A, 1.0) || !Q_.bind(Q, -1.0)) return false;
  return A_.unconditional || A_.in_part || Q_.unconditional || Q_.in_part;
}

// Any other set has a face of one point there, where the tangent leads; its points answer in a straight line.
template <class Real>
typename PowerSteps<Real>::Coordinate PowerSteps<Real>::coordinate(const Side& side, Real s_k, Real change,
                                                                   std::size_t k) const {
  if (side.in_part) {
    const Real of_others = std::max(elementary::fabs(change) - side.change[k], Real{0});
    return {s_k - change, 0, side.reach[k] + of_others};
  }
  if (!side.unconditional) return {s_k - change, 0, elementary::fabs(change)};
  return {side.center[k], side.extent[k], elementary::fabs(s_k - side.center[k])};
}

template <class Real>
void PowerSteps<Real>::move_contact_along_faces(const Real* u, Real ratio, Real shift,
                                                const double* shift_direction, PieceList<Real>& A,
                                                PieceList<Real>& Q) {
  Real* x = A.point(A.best);
  Real* y = Q.point(Q.best);
  meeting_ = 0;
  A_.look_along(u, n_);
  Q_.look_along(u, n_);
  for (std::size_t k = 0; k < static_cast<std::size_t>(n_); ++k) {
    const std::size_t diagonal = k * static_cast<std::size_t>(n_) + k;
    const Real change_A = A.hessian(A.best)[diagonal] * u[k], change_Q = -Q.hessian(Q.best)[diagonal] * u[k];
    const Coordinate of_A = coordinate(A_, x[k], change_A, k);
    const Coordinate of_Q = coordinate(Q_, y[k], change_Q, k);
    const Real change = elementary::fabs(change_A - ratio * change_Q);
    const auto exponent = static_cast<double>(change / (of_A.reach + ratio * of_Q.reach));
    exponent_[k] = exponent > 0 ? std::min(exponent, kSteepest) : 0.0;  // and for what is not a number

    if (elementary::fabs(u[k]) > kAtFace * before_[k]) before_[k] = 0;
    const Real move = shift * shift_direction[k];
    const Real low = std::max(of_A.middle - of_A.extent - move, ratio * (of_Q.middle - of_Q.extent));
    const Real high = std::min(of_A.middle + of_A.extent - move, ratio * (of_Q.middle + of_Q.extent));
    meets_[k] = low <= high ? 1 : 0;
    meeting_ += meets_[k];
    if (meets_[k] == 0 || u[k] != 0 || A.count + Q.count > 2) continue;
    const Real common = (low + high) / 2;
    if (A_.unconditional) x[k] = common + move;
    if (Q_.unconditional) y[k] = common / ratio;
  }
}

template <class Real>
void PowerSteps<Real>::advance(const Real* u, const Real* step, Real share, bool flat, Real* next) {
  for (std::size_t k = 0; k < static_cast<std::size_t>(n_); ++k) {
    next[k] = flat && meets_[k] != 0 ? Real{0} : advance(u[k], share * step[k], share, k);
    const Real length = elementary::fabs(u[k]);
    if (before_[k] == 0 && elementary::fabs(next[k]) < kAtFace * length) before_[k] = length;
  }
}

// Where the power of a step is out of bounds the step is straight, unless that would creep along the face.
template <class Real>
Real PowerSteps<Real>::advance(Real u_k, Real d, Real share, std::size_t k) const {
  const Real straight = u_k + d;
  if (u_k == 0) return straight;
  const Real moved = along_power(u_k, d, exponent_[k]);
  if (elementary::fabs(moved) < kFarthest) return moved;
  const double answer = exponent_[k] * std::log(std::fabs(static_cast<double>(straight / u_k)));
  const bool creeps = 0 < answer && answer < kCreeping && elementary::fabs(straight) < kAtFace * before_[k];
  if (!creeps) return straight;
  const Real back = way_back(elementary::fabs(u_k), before_[k], static_cast<double>(share));
  return moved < 0 ? -back : back;
}

template class PowerSteps<double>;
template class PowerSteps<Quad>;

}  // namespace raygauge
