// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include "engine/numerics/stopwatch.h"

namespace raygauge {

/// Whether x = B⁻¹ e_m is exactly zero at some positions, where enclosures only say that it is small: B is an
/// m x m matrix of doubles by columns of ld entries. Rows times powers of two make it integer; then
/// x_i = det B_i / det B by Cramer's rule, |det B_i| <= Π_j |B_j| (Hadamard), and x ≡ Σ_k d_k p^k modulo p^K
/// comes digit by digit, by products with B⁻¹ mod p (J. D. Dixon, Exact solution of linear equations using
/// p-adic expansions, Numer. Math. 40, 1982). Digits that are all zero until p^K exceeds Hadamard's bound
/// prove x_i = 0. O(m³) operations on machine words for the inverse, and O(m²) for each of the K digits.
///
/// False where a digit is not zero, and where nothing is decided: integers of more than 62 bits, p divides
/// det B, or the stopwatch has expired.
bool weights_are_zero(const double* B, std::ptrdiff_t ld, int m, std::span<const int> positions,
                      const Stopwatch& stopwatch);

}  // namespace raygauge
