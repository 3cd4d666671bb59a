// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/minkowski_sum.h"

#include <algorithm>
#include <cmath>

#include "engine/numerics/floating_point.h"
#include "engine/numerics/vector_kernels.h"
#include "engine/sets/capability_queries.h"
#include "engine/sets/set_sums.h"

namespace raygauge {
namespace {

// Rounds in which the parts of a point on two flat faces approach a target. Any of them is on the faces.
constexpr int kRounds = 8;

// Whether S is one point, which the computed centre is without an error.
bool is_exact_point(const ConvexSet& S, double* center, double* magnitude) {
  if (S.structure() != SupportStructure::point) return false;
  S.center_unchecked(center);
  S.magnitude_unchecked(magnitude);
  for (int k = 0; k < S.dimension(); ++k) {
    if (magnitude[k] != std::fabs(center[k])) return false;
  }
  return true;
}

// Whether S is one point p with p = b and a = 0; with p = 0 where there are no a and b.
bool is_point_moved_to_origin(const ConvexSet& S, const double* a, const double* b) {
  const int n = S.dimension();
  Scratch center(n), magnitude(n);
  if (!is_exact_point(S, center.data(), magnitude.data())) return false;
  for (int k = 0; k < n; ++k) {
    if (center.data()[k] != (b != nullptr ? b[k] : 0.0)) return false;
    if (a != nullptr && a[k] != 0) return false;
  }
  return true;
}

// A support point of S at u, and h_S(u), the largest of its pieces; false where it has none.
template <class Real>
bool find_support(const ConvexSet& S, const Real* u, Real* point, Real& value) {
  const int n = S.dimension();
  BasicScratch<Real> points(SupportPieces::kCapacity * n), hessians(SupportPieces::kCapacity * n * n);
  BasicSupportPieces<Real> pieces;
  pieces.dimension = n;
  pieces.points = points.data();
  pieces.hessians = hessians.data();
  support_pieces(S, u, pieces);
  if (pieces.count == 0) return false;
  const auto best = std::max_element(pieces.value.begin(), pieces.value.begin() + pieces.count);
  value = *best;
  std::copy_n(pieces.point(static_cast<int>(best - pieces.value.begin())), n, point);
  return true;
}

template <>
bool find_support(const ConvexSet& S, const double* u, double* point, double& value) {
  value = S.support_unchecked(u, point);
  return true;
}

// The point of S on its flat face across u that is nearest to target; false if S has no such face.
template <class Real>
bool find_face_point(const ConvexSet& S, const Real* u, Real value, const Real* target, Real* point) {
  const int n = S.dimension();
  if (S.flat_faces() == nullptr) return false;
  BasicScratch<Real> on_face(n);
  Scratch magnitude(n);
  S.flat_faces()->point(u, target, on_face.data());
  S.magnitude_unchecked(magnitude.data());
  double error = 0;
  for (int k = 0; k < n; ++k) error += std::fabs(static_cast<double>(u[k])) * magnitude.data()[k];
  error *= 2 * ConvexSet::rounding_error<Real>(n);
  if (!(dot(u, on_face.data(), n) >= value - error)) return false;
  std::copy_n(on_face.data(), n, point);
  return true;
}

}  // namespace

bool MinkowskiView::is_shifted() const noexcept {
  for (int k = 0; a_ != nullptr && k < dimension(); ++k) {
    if (shift(k) != 0) return true;
  }
  return false;
}

bool MinkowskiView::is_shifted_by_doubles() const noexcept {
  const auto is_zero = [this](const double* low) {
    return low == nullptr || std::all_of(low, low + dimension(), [](double x) { return x == 0; });
  };
  return is_zero(a_low_) && is_zero(b_low_);
}

// Whether this is S, because T and the shift are the origin.
bool MinkowskiView::is_first_alone() const {
  if (!is_shifted_by_doubles()) return false;
  return sign_ > 0 ? is_point_moved_to_origin(*T_, a_, b_) : is_point_moved_to_origin(*T_, b_, a_);
}

// Whether this is ±T likewise.
bool MinkowskiView::is_second_alone() const {
  return is_shifted_by_doubles() && is_point_moved_to_origin(*S_, a_, b_);
}

double MinkowskiView::do_support(const double* u, double* point) const {
  Scratch of_T(dimension());
  return support_with_part(u, point, of_T.data());
}

double MinkowskiView::support_with_part(const double* u, double* point, double* of_T) const {
  double value = sum_support(*S_, *T_, sign_, u, point, of_T);
  for (int k = 0; a_ != nullptr && k < dimension(); ++k) {
    value += u[k] * shift(k);
    point[k] += shift(k);
  }
  return value;
}

void MinkowskiView::do_center(double* point) const {
  sum_center(*S_, *T_, sign_, point);
  for (int k = 0; a_ != nullptr && k < dimension(); ++k) point[k] += shift(k);
}

void MinkowskiView::do_magnitude(double* magnitude) const {
  sum_magnitude(*S_, *T_, magnitude);
  for (int k = 0; a_ != nullptr && k < dimension(); ++k) {
    magnitude[k] += 2 * (std::fabs(a_[k]) + std::fabs(b_[k]));
  }
}

// A ball of S around its centre and one of T around ±(c - that centre), or a ball of one and a point of the
// other.
double MinkowskiView::do_inner_radius(const double* c) const {
  const int n = dimension();
  if (is_first_alone()) return S_->inner_radius_unchecked(c);
  Scratch moved(n), of_S(n), of_T(n), rest(n);
  for (int k = 0; k < n; ++k) moved.data()[k] = c[k] - shift(k);
  S_->center_unchecked(of_S.data());
  T_->center_unchecked(of_T.data());
  double size = 0;
  for (int k = 0; k < n; ++k) {
    rest.data()[k] = sign_ * (moved.data()[k] - of_S.data()[k]);
    size += std::fabs(c[k]) + std::fabs(of_S.data()[k]) + std::fabs(of_T.data()[k]);
    if (a_ != nullptr) size += std::fabs(a_[k]) + std::fabs(b_[k]);
  }
  const double around_center = S_->inner_radius_unchecked(of_S.data());
  const double around_rest = T_->inner_radius_unchecked(rest.data());
  for (int k = 0; k < n; ++k) rest.data()[k] = moved.data()[k] - sign_ * of_T.data()[k];
  const double of_first = S_->inner_radius_unchecked(rest.data());
  const double both = around_center > 0 && around_rest > 0 ? around_center + around_rest : 0.0;
  const double radius = std::max({both, around_rest, of_first});
  return radius > 0 ? proven_length(radius, radius + size, n) : 0.0;
}

const SmoothSupport* MinkowskiView::do_smooth() const noexcept {
  return S_->smooth() != nullptr && T_->smooth() != nullptr ? this : nullptr;
}

const FlatFaces* MinkowskiView::do_flat_faces() const noexcept {
  return S_->flat_faces() != nullptr || T_->flat_faces() != nullptr ? this : nullptr;
}

const GaugeFormula* MinkowskiView::do_gauge_formula() const noexcept {
  const bool first = S_->gauge() != nullptr, second = T_->gauge() != nullptr;
  if (first && second && !is_shifted()) return this;
  return (first && is_first_alone()) || (second && is_second_alone()) ? this : nullptr;
}

const CoordinateSymmetry* MinkowskiView::do_symmetry() const noexcept {
  return S_->symmetry() != nullptr || T_->symmetry() != nullptr ? this : nullptr;
}

template <class Real>
int MinkowskiView::pieces_with_parts(const Real* u, BasicSupportPieces<Real>& pieces, int capacity,
                                     Real* of_T) const {
  const int count = sum_pieces(*S_, *T_, sign_, u, pieces, capacity, of_T);
  for (int i = 0; i < pieces.count; ++i) {
    for (int k = 0; a_ != nullptr && k < dimension(); ++k) {
      const Real moved = shift<Real>(k);
      pieces.value[static_cast<std::size_t>(i)] += u[k] * moved;
      pieces.point(i)[k] += moved;
    }
  }
  return count;
}

template int MinkowskiView::pieces_with_parts(const double*, SupportPieces&, int, double*) const;
template int MinkowskiView::pieces_with_parts(const Quad*, QuadSupportPieces&, int, Quad*) const;

void MinkowskiView::do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const {
  pieces_with_parts<double>(u, pieces, capacity, nullptr);
}

void MinkowskiView::do_quad_pieces(const Quad* u, QuadSupportPieces& pieces, int capacity) const {
  pieces_with_parts<Quad>(u, pieces, capacity, nullptr);
}

template <class Real>
bool MinkowskiView::find_facet_normal(const Real* u, const Real* v, Real* normal) const {
  const int n = dimension();
  if (facet_normal(*S_, u, v, normal)) return true;
  BasicScratch<Real> from(n), to(n);
  for (int k = 0; k < n; ++k) {
    from.data()[k] = sign_ * u[k];
    to.data()[k] = sign_ * v[k];
  }
  if (!facet_normal(*T_, from.data(), to.data(), normal)) return false;
  for (int k = 0; k < n; ++k) normal[k] *= sign_;
  return true;
}

// s + t with s on the face of S and t on that of T, each as near to what the other leaves as can be; a set
// that is not flat there has one point.
template <class Real>
bool MinkowskiView::facet_point_with_part(const Real* normal, const Real* target, Real* point,
                                          Real* of_T) const {
  const int n = dimension();
  BasicScratch<Real> u(n), s(n), rest(n);
  for (int k = 0; k < n; ++k) u.data()[k] = sign_ * normal[k];
  Real h_S = 0, h_T = 0;
  if (!find_support(*S_, normal, s.data(), h_S) || !find_support(*T_, u.data(), of_T, h_T)) return false;
  const auto moved = [this](int k) { return shift<Real>(k); };
  for (int round = 0; round < kRounds; ++round) {
    for (int k = 0; k < n; ++k) rest.data()[k] = target[k] - moved(k) - sign_ * of_T[k];
    const bool flat_S = find_face_point(*S_, normal, h_S, rest.data(), s.data());
    for (int k = 0; k < n; ++k) rest.data()[k] = sign_ * (target[k] - moved(k) - s.data()[k]);
    if (!find_face_point(*T_, u.data(), h_T, rest.data(), of_T) || !flat_S) break;
  }
  for (int k = 0; k < n; ++k) point[k] = s.data()[k] + sign_ * of_T[k] + moved(k);
  return true;
}

template bool MinkowskiView::facet_point_with_part(const double*, const double*, double*, double*) const;
template bool MinkowskiView::facet_point_with_part(const Quad*, const Quad*, Quad*, Quad*) const;

bool MinkowskiView::do_facet_normal(const double* u, const double* v, double* normal) const {
  return find_facet_normal(u, v, normal);
}

bool MinkowskiView::do_quad_facet_normal(const Quad* u, const Quad* v, Quad* normal) const {
  return find_facet_normal(u, v, normal);
}

void MinkowskiView::do_facet_point(const double* normal, const double* target, double* point) const {
  Scratch of_T(dimension());
  facet_point_with_part(normal, target, point, of_T.data());
}

void MinkowskiView::do_quad_facet_point(const Quad* normal, const Quad* target, Quad* point) const {
  BasicScratch<Quad> of_T(dimension());
  facet_point_with_part(normal, target, point, of_T.data());
}

// The gauge of ±T at x, that of T at ±x.
template <class Ask, class Real>
auto MinkowskiView::ask_second(const Ask& ask, const Real* x, Real* normal) const {
  const int n = dimension();
  BasicScratch<Real> turned(n);
  for (int k = 0; k < n; ++k) turned.data()[k] = sign_ * x[k];
  const auto answer = ask(*T_, turned.data(), normal);
  for (int k = 0; k < n; ++k) normal[k] *= sign_;
  return answer;
}

// x = λx + (1 - λ)x with λx in tS and (1 - λ)x in ±tT: t is least where λ g_S = (1 - λ) g_T.
double MinkowskiView::do_gauge(const double* x, double* normal) const {
  const int n = dimension();
  if (is_first_alone()) return gauge_bound(*S_, x, normal);
  if (is_second_alone()) return ask_second(gauge_bound, x, normal);
  Scratch of_T(n);
  const double g_S = gauge_bound(*S_, x, normal);
  const double g_T = ask_second(gauge_bound, x, of_T.data());
  if (!(g_S < kInfinity) || !(g_T < kInfinity)) return kInfinity;
  add_normals(normal, of_T.data());
  return g_S == 0 || g_T == 0 ? 0.0 : g_S * (g_T / (g_S + g_T)) * (1 + 8 * kUnitRoundoff) + kUnderflow;
}

bool MinkowskiView::do_quad_gauge_normal(const Quad* x, Quad* normal) const {
  if (is_first_alone()) return gauge_normal(*S_, x, normal);
  if (is_second_alone()) return ask_second(gauge_normal, x, normal);
  BasicScratch<Quad> of_T(dimension());
  if (!gauge_normal(*S_, x, normal) || !ask_second(gauge_normal, x, of_T.data())) return false;
  add_normals(normal, of_T.data());
  return true;
}

// The sum of the unit normals: the common one where S and T are homothetic.
template <class Real>
void MinkowskiView::add_normals(Real* normal, Real* of_T) const {
  const int n = dimension();
  normalize(normal, n, normal);
  normalize(of_T, n, of_T);
  for (int k = 0; k < n; ++k) normal[k] += of_T[k];
}

bool MinkowskiView::do_touches_origin(double* u) const {
  if (is_first_alone()) return raygauge::touches_origin(*S_, u);
  if (!is_second_alone() || !raygauge::touches_origin(*T_, u)) return false;
  for (int k = 0; k < dimension(); ++k) u[k] *= sign_;
  return true;
}

bool MinkowskiView::do_is_unconditional(double* extent) const {
  const int n = dimension();
  if (!sum_is_unconditional(*S_, *T_, extent, !keeps_parts())) return false;
  if (a_ == nullptr) return true;
  if (!is_shifted_by_doubles()) return false;
  // The centre of a shifted sum is computed as 0, which it is if each operand is seen from its own.
  Scratch of_S(n), of_T(n);
  S_->center_unchecked(of_S.data());
  T_->center_unchecked(of_T.data());
  const double* seen_from = sign_ < 0 ? a_ : nullptr;
  return seen_from != nullptr && std::equal(of_S.data(), of_S.data() + n, b_) &&
         std::equal(of_T.data(), of_T.data() + n, seen_from);
}

bool MinkowskiView::do_summands(const double* u, double* reach, double* change) const {
  const int n = dimension();
  Scratch along(n), part(n), change_of_part(n);
  std::fill_n(reach, n, 0.0);
  std::fill_n(change, n, 0.0);
  bool any = false;
  for (const ConvexSet* operand : {S_, T_}) {
    const double sign = operand == S_ ? 1.0 : sign_;
    for (int k = 0; k < n; ++k) along.data()[k] = sign * u[k];
    const CoordinateSymmetry* symmetry = operand->symmetry();
    if (symmetry == nullptr || !symmetry->summands(along.data(), part.data(), change_of_part.data()))
      continue;
    any = true;
    for (int k = 0; k < n; ++k) {
      reach[k] += part.data()[k];
      change[k] += change_of_part.data()[k];
    }
  }
  return any;
}

}  // namespace raygauge
