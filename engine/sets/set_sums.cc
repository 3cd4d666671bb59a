// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/set_sums.h"

#include <algorithm>
#include <cmath>

#include "engine/numerics/floating_point.h"
#include "engine/numerics/vector_kernels.h"
#include "engine/sets/capability_queries.h"

namespace raygauge {
namespace {

// Entry by entry, in place: every value of the operands is read before its slot is written.
template <class Real>
void add_arrays(Real* base, int stride, int size, int first, int second, double sign) {
  Real a[SupportPieces::kCapacity], b[SupportPieces::kCapacity];
  for (int e = 0; e < size; ++e) {
    Real* entry = base + e;
    for (int i = 0; i < first; ++i) a[i] = entry[std::ptrdiff_t{i} * stride];
    for (int j = 0; j < second; ++j) b[j] = sign * entry[std::ptrdiff_t{first + j} * stride];
    for (int i = 0; i < first; ++i) {
      for (int j = 0; j < second; ++j) entry[std::ptrdiff_t{i * second + j} * stride] = a[i] + b[j];
    }
  }
}

// The extents of an operand; those of a point are 0, less what its computed place is off by.
bool operand_extents(const ConvexSet& S, double* extent) {
  if (is_unconditional(S, extent)) return true;
  if (S.structure() != SupportStructure::point) return false;
  const int n = S.dimension();
  Scratch center(n);
  S.center_unchecked(center.data());
  S.magnitude_unchecked(extent);
  for (int k = 0; k < n; ++k) {
    const bool exact = extent[k] == std::fabs(center.data()[k]);
    extent[k] = exact ? 0.0 : -ConvexSet::rounding_error(n) * extent[k];
  }
  return true;
}

}  // namespace

template <class Real>
void add_pieces(BasicSupportPieces<Real>& first, const BasicSupportPieces<Real>& second, double sign,
                int capacity) {
  const int m = first.count;
  const int l = second.count;
  if (m < 1 || l < 1 || m * l > capacity) {
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
  if (!operand_extents(S, extent) || !operand_extents(T, of_T.data())) return false;
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
  support_pieces(S, u, pieces, SupportPieces::kCapacity - capacity);
  BasicSupportPieces<Real> second = pieces.rest(pieces.count);
  support_pieces(T, towards.data(), second, SupportPieces::kCapacity - capacity + pieces.count);
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

}  // namespace raygauge
