// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "bench/workload.h"

namespace raygauge::bench {

/// How much is measured.
struct Effort {
  bool quick = false;           ///< fewer cells
  int instances = 20;           ///< per cell
  bool processor_time = false;  ///< of the rows high, degenerate, shapes, euclidean, instead of wall time
  std::vector<int> dimensions;  ///< of the rows `high` and `degenerate`; none: their own
  /// Of the row `degenerate`; none: all.
  std::vector<std::string> families;
  std::vector<int> points;     ///< of the row `degenerate`; none: its own
  std::vector<double> limits;  ///< seconds a solve of the row `degenerate`; none: a minute, with competitors
};

/// Each prints one row of the table of speed targets to standard output: its cells, geometric mean and worst
/// cell. LP: the best of the LP solvers' medians. Pass: one streaming read of both sets.
void print_grid(const Variant& variant,
                const Effort& effort);  ///< column_generation / LP, zheng_yamane / LP; Table III
void print_large(const Variant& variant,
                 const Effort& effort);  ///< column_generation / pass; N = 2e4, 2e5, 1e6
void print_n50(const Variant& variant, const Effort& effort);  ///< column_generation / pass; n = 50, N = 2e4
/// column_generation / LP and zheng_yamane / LP at n = 20 … 500, N = 3 n, 10 n, 100 n (to 2·10^4), and N = n
/// + 2, 1.5 n, 2 n. `quick`: to n = 100, without 100 n.
void print_high(const Variant& variant, const Effort& effort);
/// Share of solves proven to 1e-6, 1e-9 and 1e-12 at n = 20 … 200, N = n + 2 … 10 n.
void print_certified(const Variant& variant, const Effort& effort);
/// The Euclidean distance of two point sets: default method / libsvm_smo; n = 3 … 200, N = 2 n … 2000.
void print_euclidean(const Variant& variant, const Effort& effort);
/// Boxes to n = 12 and cross-polytopes to n = 500: both methods / LP. Ellipsoids, p-norm balls and sums of
/// both to n = 200: time of newton. Instances of its own, whatever the variant.
void print_shapes(const Variant& variant, const Effort& effort);
/// Planted integer instances with degenerate optima at n = 50 … 500, N = n + 2 … 2 n: how many are proven,
/// and column_generation / Clp one by one. Instances of its own, whatever the variant.
void print_degenerate(const Variant& variant, const Effort& effort);
void print_n100(const Variant& variant, const Effort& effort);  ///< column_generation / LP; n = 100, N = 1e4
void print_memory(const Variant& variant,
                  const Effort& effort);  ///< the solver's heap / the points; N = 1e6, n = 10
void print_threads(const Variant& variant,
                   const Effort& effort);  ///< one solve by one thread / by two; N = 2e5, 1e6
void print_growth(const Variant& variant, const Effort& effort);  ///< exponents of N and n, 95 % confidence

}  // namespace raygauge::bench
