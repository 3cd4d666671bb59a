// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/set_sums.h"

#include <algorithm>
#include <cmath>

#include "engine/numerics/floating_point.h"
#include "engine/numerics/vector_kernels.h"

namespace raygauge {
namespace {

// Entry by entry, in place: every value of the operands is read before its slot is written.
template <class Real>
void add_arrays(Real* base, int stride, int size, int first, int second, double sign) {
  for (int e = 0; e < size; ++e) {
    Real a[2], b[SupportPieces::kCapacity];
    Real* entry = base + e;
    const int pairs_first = first == 2 && second == 2 ? 2 : 1;
    for (int i = 0; i < pairs_first; ++i) a[i] = entry[static_cast<std::ptrdiff_t>(i) * stride];
    if (pairs_first == 2) {
      for (int j = 0; j < 2; ++j) b[j] = sign * entry[static_cast<std::ptrdiff_t>(2 + j) * stride];
      for (int i = 0; i < 4; ++i) entry[static_cast<std::ptrdiff_t>(i) * stride] = a[i / 2] + b[i % 2];
    } else if (first == 1) {
      for (int j = 0; j < second; ++j) b[j] = sign * entry[static_cast<std::ptrdiff_t>(1 + j) * stride];
      for (int j = 0; j < second; ++j) entry[static_cast<std::ptrdiff_t>(j) * stride] = a[0] + b[j];
    } else {
      const Real only = sign * entry[static_cast<std::ptrdiff_t>(first) * stride];
      for (int i = 0; i < first; ++i) entry[static_cast<std::ptrdiff_t>(i) * stride] += only;
    }
  }
}

}  // namespace

template <class Real>
void add_pieces(BasicSupportPieces<Real>& first, const BasicSupportPieces<Real>& second, double sign,
                int capacity) {
  const int m = first.count;
  const int l = second.count;
  if (m < 1 || l < 1 || m * l > capacity || (m > 1 && l > 1 && m + l != 4)) {
    first.count = 0;
    return;
  }
  for (int j = 0; j < l; ++j) {
    first.value.data()[m + j] = second.value[static_cast<std::size_t>(j)];
  }
  const int n = first.dimension;
  add_arrays(first.value.data(), 1, 1, m, l, 1.0);
  add_arrays(first.points, n, n, m, l, sign);
  add_arrays(first.hessians, n * n, n * n, m, l, 1.0);
  first.count = m * l;
}

double sum_support(const ConvexSet& S, const ConvexSet& T, double sign, const double* u, double* point,
                   double* of_T) {
  const int n = S.dimension();
  Scratch towards(n);
  for (int k = 0; k < n; ++k) towards.data()[k] = sign * u[k];
  const double value = S.support_unchecked(u, point) + T.support_unchecked(towards.data(), of_T);
  for (int k = 0; k < n; ++k) point[k] += sign * of_T[k];
  return value;
}

void sum_center(const ConvexSet& S, const ConvexSet& T, double sign, double* point) {
  Scratch of_T(S.dimension());
  S.center_unchecked(point);
  T.center_unchecked(of_T.data());
  for (int k = 0; k < S.dimension(); ++k) point[k] += sign * of_T.data()[k];
}

void sum_magnitude(const ConvexSet& S, const ConvexSet& T, double* magnitude) {
  Scratch of_T(S.dimension());
  S.magnitude_unchecked(magnitude);
  T.magnitude_unchecked(of_T.data());
  for (int k = 0; k < S.dimension(); ++k) magnitude[k] += of_T.data()[k];
}

double rounding_of_sum(double a, double b) noexcept {
  return a == 0 || b == 0 ? 0.0 : 2 * kUnitRoundoff * (std::fabs(a) + std::fabs(b));
}

bool sum_is_unconditional(const ConvexSet& S, const ConvexSet& T, double* extent, bool with_faces) {
  const int n = S.dimension();
  Scratch of_T(n), c_S(n), c_T(n);
  if (!S.is_unconditional_unchecked(extent) || !T.is_unconditional_unchecked(of_T.data())) return false;
  S.center_unchecked(c_S.data());
  T.center_unchecked(c_T.data());
  for (int k = 0; k < n; ++k) {
    const double e_S = with_faces ? extent[k] : std::min(extent[k], 0.0);
    const double e_T = with_faces ? of_T.data()[k] : std::min(of_T.data()[k], 0.0);
    extent[k] = e_S + e_T - rounding_of_sum(e_S, e_T) - rounding_of_sum(c_S.data()[k], c_T.data()[k]);
  }
  return true;
}

template <class Real>
int sum_pieces(const ConvexSet& S, const ConvexSet& T, double sign, const Real* u,
               BasicSupportPieces<Real>& pieces, int capacity, Real* of_T) {
  const int n = S.dimension();
  BasicScratch<Real> towards(n);
  for (int k = 0; k < n; ++k) towards.data()[k] = sign * u[k];
  S.support_pieces_unchecked(u, pieces, SupportPieces::kCapacity - capacity);
  BasicSupportPieces<Real> second = pieces.rest(pieces.count);
  T.support_pieces_unchecked(towards.data(), second, SupportPieces::kCapacity - capacity + pieces.count);
  if (of_T != nullptr) std::copy_n(second.points, second.count * n, of_T);
  add_pieces(pieces, second, sign, capacity);
  return second.count;
}

template void add_pieces(SupportPieces&, const SupportPieces&, double, int);
template void add_pieces(QuadSupportPieces&, const QuadSupportPieces&, double, int);
template int sum_pieces(const ConvexSet&, const ConvexSet&, double, const double*, SupportPieces&, int,
                        double*);
template int sum_pieces(const ConvexSet&, const ConvexSet&, double, const Quad*, QuadSupportPieces&, int,
                        Quad*);

double sum_of_radii(double first, double second, const double* c, const double* part, int n) {
  if (!(first > 0) || !(second > 0)) return 0;
  double size = first + second;
  for (int k = 0; k < n; ++k) size += std::fabs(c[k]) + std::fabs(part[k]);
  return proven_length(first + second, size, n);
}

}  // namespace raygauge
