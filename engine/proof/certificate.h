// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "engine/kernels/kernel.h"
#include "engine/proof/bounds.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {

/// A support value together with a proven bound on its rounding error: |h_S(u) - value| <= error.
template <class Real>
struct BasicSupportValue {
  Real value = 0;
  double error = 0;
  Real above() const noexcept { return value + error; }
};

using SupportValue = BasicSupportValue<double>;
using QuadSupportValue = BasicSupportValue<Quad>;

/// The share of a support value that rounding may hide before a longer evaluation is worth its pass over the
/// set.
inline constexpr double kResolution = 0x1p-40;

/// The same for a solve that need not close its gap below `tolerance`: a sixteenth of it.
inline double resolution_for(double tolerance) noexcept {
  return tolerance > 16 * kResolution ? tolerance / 16 : kResolution;
}

inline bool well_resolved(double value, double error, double resolution = kResolution) noexcept {
  return error <= resolution * (value < 0 ? -value : value);
}

/// Bound on the rounding error of any u·p, p in S, summed in any order with or without fused multiply-add:
/// γ_n Σ_k |u_k| max_i |p_ik|, γ_n = n ε / (1 - n ε), itself rounded up.
double dot_error(const PointSet& S, const double* u);

/// h_S(u) with its error bound; one pass over S. Where rounding hides more than `resolution` of the value,
/// the points that may attain the maximum are evaluated again in double-double arithmetic.
SupportValue support_value(const Kernels& kernels, const PointSet& S, const double* u,
                           std::ptrdiff_t* index = nullptr, double resolution = kResolution);

/// The same at u + u_low, a direction in twice the precision, by double-double arithmetic from the start.
SupportValue support_value_twofold(const Kernels& kernels, const PointSet& S, const double* u,
                                   const double* u_low, std::ptrdiff_t* index = nullptr);

/// Weak duality, equation (10): d_Q(A) >= -h_A(u) / h_Q(-u) wherever h_A(u) < 0, rounded down. 0 where h_A(u)
/// < 0 is not certain; +infinity where moreover h_Q(-u) <= 0 is certain (u is a Farkas direction).
double lower_bound(const SupportValue& h_A, const SupportValue& h_Q) noexcept;

/// The same in quadruple precision (Real = Quad).
template <class Real>
double lower_bound(const BasicSupportValue<Real>& h_A, const BasicSupportValue<Real>& h_Q) noexcept;

/// The nearest double not above resp. not below x >= 0.
double rounded_down(Quad x) noexcept;
double rounded_up(Quad x) noexcept;

}  // namespace raygauge
