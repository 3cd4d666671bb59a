// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace raygauge {

/// Rows of a basis are padded to whole cache lines.
constexpr int kRowPadding = 8;
constexpr int padded_rows(int m) { return (m + kRowPadding - 1) / kRowPadding * kRowPadding; }

/// Bases of more rows collect their changes (BasisView).
constexpr bool many_rows(int m) { return padded_rows(m) > 3 * kRowPadding; }
constexpr int kMostPending = 16;

/// A basis of m columns for  min c·x, Σ_i x_i col_i = b, x >= 0, with its explicit inverse R = B⁻¹. Plain
/// views into a workspace, so that the vector kernels (compiled once per instruction set) share no code with
/// the rest of the library.
///
/// All matrices are column-major with leading dimension P = padded_rows(m); padding rows are zero.
///
/// Of many rows the inverse is R - G ρᵀ: basis changes are collected, kMostPending of them, and then
/// subtracted from R by one product of matrices, which is a pass over R where each change would be one. Every
/// kernel that reads R subtracts them first.
struct BasisView {
  int m = 0;
  int P = 0;
  double* R = nullptr;            ///< (m + 1) columns: R and then x = R b, updated together
  double* B = nullptr;            ///< m columns: the basic columns themselves
  double* y = nullptr;            ///< m duals, yᵀ = c_Bᵀ R, padded
  double* cost = nullptr;         ///< m costs c_B, padded
  std::int64_t* id = nullptr;     ///< m identities, meaning chosen by the caller
  double* w = nullptr;            ///< scratch, P
  double* columns = nullptr;      ///< scratch, 19 P: three columns and two blocks of points
  double* scratch = nullptr;      ///< 3 P, for the certificate
  double* changes = nullptr;      ///< G, kMostPending columns; with many_rows(m) only
  double* change_rows = nullptr;  ///< ρ, as many
  int pending = 0;                ///< basis changes that R lacks
  double objective = 0;           ///< c_B·x
  std::int64_t pivots = 0;

  double* x() const { return R + static_cast<std::ptrdiff_t>(m) * P; }
};

/// Points to be priced, scaled for the solver: in the blocked layout of PointSet, and rounded to single
/// precision in blocks of 16 (nullptr: not to be had). Single precision only ever chooses a column; nothing
/// is concluded from it.
struct PricedPoints {
  const double* blocks = nullptr;
  std::ptrdiff_t block_count = 0;
  const float* single_blocks = nullptr;
  std::ptrdiff_t single_block_count = 0;
  std::ptrdiff_t size = 0;  ///< points; the lanes beyond, as many as fill the last block, repeat the last one
};

/// The best point of every lane of a pass, by their positions among the priced points.
struct LaneList {
  static constexpr int kMost = 16;
  int count = 0;  ///< 16 after a pass in single precision, 8 after one in double, 0: no pass
  std::int64_t index[kMost] = {};
  std::int64_t best = 0;  ///< the best of them
};

/// How a run of the simplex loop over priced points ended.
enum class LoopEnd : std::uint8_t {
  optimal,    ///< no column prices out
  gap,        ///< the bounds over the priced points are within the tolerance
  unbounded,  ///< a column without a positive pivot: the basis has lost its meaning numerically
  stalled,    ///< no progress for long; the caller switches to Bland's rule
  pivot_limit,
};

/// Parameters of a simplex loop over priced points; see Kernels::simplex_loop.
struct SimplexLoop {
  PricedPoints A;
  PricedPoints Q;
  double gap_tolerance =
      0;  ///< stop when objective + h_A/h_Q <= gap_tolerance * objective and no artificial is left
  double cost_tolerance =
      1e-12;           ///< a column prices out if its reduced cost is below -cost_tolerance * its scale
  double noise_A = 0;  ///< times Σ|y_k|: what rounding may make of the reduced cost of a point of A
  double noise_Q = 0;
  std::int64_t pivot_limit = 0;  ///< on BasisView::pivots
  double cost_of_Q = 1;          ///< 0 in phase 1, where only artificial columns cost
  int artificials = 0;           ///< basic artificial columns (in/out)
  bool bland = false;
  /// In: columns to begin with, before the first pass, found along a guess of the normal; none where the
  /// count is 0, and forgotten after one use.
  LaneList first_A;
  LaneList first_Q;
  double h_A = 0;  ///< out, at LoopEnd::optimal and gap: h_A(u) and h_Q(-u) of the priced points at the duals
  double h_Q = 0;
  std::int64_t points_priced = 0;  ///< out, added to
  std::int64_t pricings = 0;       ///< out, added to
};

/// Identities of basic columns in the simplex: points of A are 2i, points of Q are 2j + 1, artificials
/// negative.
constexpr std::int64_t id_of_A(std::ptrdiff_t i) { return 2 * static_cast<std::int64_t>(i); }
constexpr std::int64_t id_of_Q(std::ptrdiff_t j) { return 2 * static_cast<std::int64_t>(j) + 1; }
constexpr bool is_from_Q(std::int64_t id) { return id >= 0 && id % 2 == 1; }
constexpr bool is_artificial(std::int64_t id) { return id < 0; }

/// Result of bringing one column into the basis.
enum class PivotResult : std::uint8_t { ok, no_pivot };

}  // namespace raygauge
