// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include "engine/numerics/stopwatch.h"

namespace raygauge {

/// A matrix of doubles by columns of `ld` entries.
struct MatrixOfDoubles {
  const double* data = nullptr;
  std::ptrdiff_t ld = 0;
  int rows = 0;
  int columns = 0;
};

/// Whether the columns `chosen` are independent and span all columns of M, in exact arithmetic: what
/// enclosures, which only say that a residual is small, cannot tell. Rows times powers of two make M integer.
///
/// With rows R that make the minor of `chosen` regular modulo a prime p, another column c has the residual
/// s = c - M z, z = M_R⁻¹ c_R, and det M_R s_i is a minor of M of one row and column more: by Hadamard's
/// bound at most H = |c| Π_j |M_j|. z comes digit by digit as Σ_k d_k p^k, by products with M_R⁻¹ mod p (J.
/// D. Dixon, Exact solution of linear equations using p-adic expansions, Numer. Math. 40, 1982). Where s is
/// zero modulo p^K > H, it is zero. The same is asked of the rows beyond R where these are fewer than the
/// other columns. O(m r²) operations on machine words, and for each of these columns O(m r) for each of its K
/// digits.
///
/// False where a column does not depend on the chosen ones, and where nothing is decided: integers of more
/// than 62 bits, a minor that is zero modulo p, or the stopwatch has expired.
bool columns_span(const MatrixOfDoubles& M, std::span<const int> chosen, const Stopwatch& stopwatch);

}  // namespace raygauge
