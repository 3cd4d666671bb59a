// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/minkowski_view.h"

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

// Coordinate k of a - b.
template <class Real = double>
Real shift(const ShiftedSum& sum, int k) noexcept {
  if (sum.a.high == nullptr) return Real{0};
  const Real low_a = sum.a.low != nullptr ? sum.a.low[k] : 0.0;
  const Real low_b = sum.b.low != nullptr ? sum.b.low[k] : 0.0;
  return (Real{sum.a.high[k]} - sum.b.high[k]) + (low_a - low_b);
}

bool is_shifted(const ShiftedSum& sum) noexcept {
  for (int k = 0; sum.a.high != nullptr && k < sum.S->dimension(); ++k) {
    if (shift(sum, k) != 0) return true;
  }
  return false;
}

bool is_shifted_by_doubles(const ShiftedSum& sum) noexcept {
  const auto is_zero = [&sum](const double* low) {
    return low == nullptr || std::all_of(low, low + sum.S->dimension(), [](double x) { return x == 0; });
  };
  return is_zero(sum.a.low) && is_zero(sum.b.low);
}

// Whether the sum is S, because T and the shift are the origin.
bool is_first_alone(const ShiftedSum& sum) {
  if (!is_shifted_by_doubles(sum)) return false;
  return sum.sign > 0 ? is_point_moved_to_origin(*sum.T, sum.a.high, sum.b.high)
                      : is_point_moved_to_origin(*sum.T, sum.b.high, sum.a.high);
}

// Whether it is ±T likewise.
bool is_second_alone(const ShiftedSum& sum) {
  return is_shifted_by_doubles(sum) && is_point_moved_to_origin(*sum.S, sum.a.high, sum.b.high);
}

// The gauge of ±T at x, that of T at ±x.
template <class Ask, class Real>
auto ask_second(const ShiftedSum& sum, const Ask& ask, const Real* x, Real* normal) {
  const int n = sum.T->dimension();
  BasicScratch<Real> turned(n);
  for (int k = 0; k < n; ++k) turned.data()[k] = sum.sign * x[k];
  const auto answer = ask(*sum.T, turned.data(), normal);
  for (int k = 0; k < n; ++k) normal[k] *= sum.sign;
  return answer;
}

// The sum of the unit normals: the common one where S and T are homothetic.
template <class Real>
void add_normals(int n, Real* normal, Real* of_T) {
  normalize(normal, n, normal);
  normalize(of_T, n, of_T);
  for (int k = 0; k < n; ++k) normal[k] += of_T[k];
}

}  // namespace

double MinkowskiView::do_support(const double* u, double* point) const {
  Scratch of_T(dimension());
  return support_with_part(u, point, of_T.data());
}

double MinkowskiView::support_with_part(const double* u, double* point, double* of_T) const {
  double value = sum_support(*sum_.S, *sum_.T, sum_.sign, u, point, of_T);
  for (int k = 0; sum_.a.high != nullptr && k < dimension(); ++k) {
    value += u[k] * shift(sum_, k);
    point[k] += shift(sum_, k);
  }
  return value;
}

void MinkowskiView::do_center(double* point) const {
  sum_center(*sum_.S, *sum_.T, sum_.sign, point);
  for (int k = 0; sum_.a.high != nullptr && k < dimension(); ++k) point[k] += shift(sum_, k);
}

void MinkowskiView::do_magnitude(double* magnitude) const {
  sum_magnitude(*sum_.S, *sum_.T, magnitude);
  for (int k = 0; sum_.a.high != nullptr && k < dimension(); ++k) {
    magnitude[k] += 2 * (std::fabs(sum_.a.high[k]) + std::fabs(sum_.b.high[k]));
  }
}

// A ball of S around its centre and one of T around ±(c - that centre), or a ball of one and a point of the
// other.
double MinkowskiView::do_inner_radius(const double* c) const {
  const int n = dimension();
  if (is_first_alone(sum_)) return sum_.S->inner_radius_unchecked(c);
  Scratch moved(n), of_S(n), of_T(n), rest(n);
  for (int k = 0; k < n; ++k) moved.data()[k] = c[k] - shift(sum_, k);
  sum_.S->center_unchecked(of_S.data());
  sum_.T->center_unchecked(of_T.data());
  double size = 0;
  for (int k = 0; k < n; ++k) {
    rest.data()[k] = sum_.sign * (moved.data()[k] - of_S.data()[k]);
    size += std::fabs(c[k]) + std::fabs(of_S.data()[k]) + std::fabs(of_T.data()[k]);
    if (sum_.a.high != nullptr) size += std::fabs(sum_.a.high[k]) + std::fabs(sum_.b.high[k]);
  }
  const double around_center = sum_.S->inner_radius_unchecked(of_S.data());
  const double around_rest = sum_.T->inner_radius_unchecked(rest.data());
  for (int k = 0; k < n; ++k) rest.data()[k] = moved.data()[k] - sum_.sign * of_T.data()[k];
  const double of_first = sum_.S->inner_radius_unchecked(rest.data());
  const double both = around_center > 0 && around_rest > 0 ? around_center + around_rest : 0.0;
  const double radius = std::max({both, around_rest, of_first});
  return radius > 0 ? proven_length(radius, radius + size, n) : 0.0;
}

bool MinkowskiView::has_flat_faces() const noexcept {
  return sum_.S->flat_faces() != nullptr || sum_.T->flat_faces() != nullptr;
}

bool MinkowskiView::has_gauge() const noexcept {
  const bool first = sum_.S->gauge() != nullptr, second = sum_.T->gauge() != nullptr;
  if (first && second && !is_shifted(sum_)) return true;
  return (first && is_first_alone(sum_)) || (second && is_second_alone(sum_));
}

bool MinkowskiView::has_symmetry() const noexcept {
  return sum_.S->symmetry() != nullptr || sum_.T->symmetry() != nullptr;
}

template <class Real>
int MinkowskiView::pieces_with_parts(const Real* u, BasicSupportPieces<Real>& pieces, int capacity,
                                     Real* of_T) const {
  const int count = sum_pieces(*sum_.S, *sum_.T, sum_.sign, u, pieces, capacity, of_T);
  for (int i = 0; i < pieces.count; ++i) {
    for (int k = 0; sum_.a.high != nullptr && k < dimension(); ++k) {
      const Real moved = shift<Real>(sum_, k);
      pieces.value[static_cast<std::size_t>(i)] += u[k] * moved;
      pieces.point(i)[k] += moved;
    }
  }
  return count;
}

// s + t with s on the face of S and t on that of T, each as near to what the other leaves as can be; a set
// that is not flat there has one point.
template <class Real>
bool MinkowskiView::facet_point_with_part(const Real* normal, const Real* target, Real* point,
                                          Real* of_T) const {
  const int n = dimension();
  BasicScratch<Real> u(n), s(n), rest(n);
  for (int k = 0; k < n; ++k) u.data()[k] = sum_.sign * normal[k];
  Real h_S = 0, h_T = 0;
  if (!find_support(*sum_.S, normal, s.data(), h_S) || !find_support(*sum_.T, u.data(), of_T, h_T))
    return false;
  const auto moved = [this](int k) { return shift<Real>(sum_, k); };
  for (int round = 0; round < kRounds; ++round) {
    for (int k = 0; k < n; ++k) rest.data()[k] = target[k] - moved(k) - sum_.sign * of_T[k];
    const bool flat_S = find_face_point(*sum_.S, normal, h_S, rest.data(), s.data());
    for (int k = 0; k < n; ++k) rest.data()[k] = sum_.sign * (target[k] - moved(k) - s.data()[k]);
    if (!find_face_point(*sum_.T, u.data(), h_T, rest.data(), of_T) || !flat_S) break;
  }
  for (int k = 0; k < n; ++k) point[k] = s.data()[k] + sum_.sign * of_T[k] + moved(k);
  return true;
}

template <class Real>
bool MinkowskiView::find_normal(const Real* u, const Real* v, Real* normal) const {
  const int n = dimension();
  if (facet_normal(*sum_.S, u, v, normal)) return true;
  BasicScratch<Real> from(n), to(n);
  for (int k = 0; k < n; ++k) {
    from.data()[k] = sum_.sign * u[k];
    to.data()[k] = sum_.sign * v[k];
  }
  if (!facet_normal(*sum_.T, from.data(), to.data(), normal)) return false;
  for (int k = 0; k < n; ++k) normal[k] *= sum_.sign;
  return true;
}

template <class Real>
void MinkowskiView::find_point(const Real* normal, const Real* target, Real* point) const {
  BasicScratch<Real> of_T(dimension());
  facet_point_with_part(normal, target, point, of_T.data());
}

// x = λx + (1 - λ)x with λx in tS and (1 - λ)x in ±tT: t is least where λ g_S = (1 - λ) g_T.
double MinkowskiView::do_gauge(const double* x, double* normal) const {
  const int n = dimension();
  if (is_first_alone(sum_)) return gauge_bound(*sum_.S, x, normal);
  if (is_second_alone(sum_)) return ask_second(sum_, gauge_bound, x, normal);
  Scratch of_T(n);
  const double g_S = gauge_bound(*sum_.S, x, normal);
  const double g_T = ask_second(sum_, gauge_bound, x, of_T.data());
  if (!(g_S < kInfinity) || !(g_T < kInfinity)) return kInfinity;
  add_normals(dimension(), normal, of_T.data());
  return g_S == 0 || g_T == 0 ? 0.0 : g_S * (g_T / (g_S + g_T)) * (1 + 8 * kUnitRoundoff) + kUnderflow;
}

bool MinkowskiView::do_quad_gauge_normal(const Quad* x, Quad* normal) const {
  if (is_first_alone(sum_)) return gauge_normal(*sum_.S, x, normal);
  if (is_second_alone(sum_)) return ask_second(sum_, gauge_normal, x, normal);
  BasicScratch<Quad> of_T(dimension());
  if (!gauge_normal(*sum_.S, x, normal) || !ask_second(sum_, gauge_normal, x, of_T.data())) return false;
  add_normals(dimension(), normal, of_T.data());
  return true;
}

bool MinkowskiView::do_touches_origin(double* u) const {
  if (is_first_alone(sum_)) return raygauge::touches_origin(*sum_.S, u);
  if (!is_second_alone(sum_) || !raygauge::touches_origin(*sum_.T, u)) return false;
  for (int k = 0; k < dimension(); ++k) u[k] *= sum_.sign;
  return true;
}

bool MinkowskiView::do_is_unconditional(double* extent) const {
  const int n = dimension();
  if (!sum_is_unconditional(*sum_.S, *sum_.T, extent, !sum_.keeps_parts)) return false;
  if (sum_.a.high == nullptr) return true;
  if (!is_shifted_by_doubles(sum_)) return false;
  // The centre of a shifted sum is computed as 0, which it is if each operand is seen from its own.
  Scratch of_S(n), of_T(n);
  sum_.S->center_unchecked(of_S.data());
  sum_.T->center_unchecked(of_T.data());
  const double* seen_from = sum_.sign < 0 ? sum_.a.high : nullptr;
  return seen_from != nullptr && std::equal(of_S.data(), of_S.data() + n, sum_.b.high) &&
         std::equal(of_T.data(), of_T.data() + n, seen_from);
}

bool MinkowskiView::do_summands(const double* u, double* reach, double* change) const {
  const int n = dimension();
  Scratch along(n), part(n), change_of_part(n);
  std::fill_n(reach, n, 0.0);
  std::fill_n(change, n, 0.0);
  bool any = false;
  for (const ConvexSet* operand : {sum_.S, sum_.T}) {
    const double sign = operand == sum_.S ? 1.0 : sum_.sign;
    for (int k = 0; k < n; ++k) along.data()[k] = sign * u[k];
    const auto* symmetry = operand->symmetry();
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

template int MinkowskiView::pieces_with_parts(const double*, SupportPieces&, int, double*) const;
template int MinkowskiView::pieces_with_parts(const Quad*, QuadSupportPieces&, int, Quad*) const;
template bool MinkowskiView::facet_point_with_part(const double*, const double*, double*, double*) const;
template bool MinkowskiView::facet_point_with_part(const Quad*, const Quad*, Quad*, Quad*) const;
template bool MinkowskiView::find_normal(const double*, const double*, double*) const;
template bool MinkowskiView::find_normal(const Quad*, const Quad*, Quad*) const;
template void MinkowskiView::find_point(const double*, const double*, double*) const;
template void MinkowskiView::find_point(const Quad*, const Quad*, Quad*) const;

}  // namespace raygauge
