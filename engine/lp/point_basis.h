// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/lp/basis.h"
#include "engine/lp/column_pool.h"
#include "engine/lp/weighted_points.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {

/// The basis of PrimalSimplex: its n + 1 columns are points of A, points of Q and artificial ones (identities
/// as in id_of_A, id_of_Q, negative where artificial). What its basic solution is, and what that proves.
class PointBasis : public Basis {
 public:
  /// The column of a point of a pool: padded_rows(n + 1) numbers.
  void form_column(const ColumnPool& pool, std::int64_t id, double* column) const;

  /// Σβ of the exact basic solution, rounded up, where that solution is proven feasible; +infinity otherwise.
  /// Where the error of the bound is small against the relative gap that is asked for, x stays as it is.
  double proven_upper(double gap_tolerance);

  /// An upper bound from the basic solution even where its equations hold only up to a residual r: with
  /// gauge_Q(r) <= gauge_bound |r|∞ (GaugeBound),  d <= (Σβ + gauge_bound |r|∞) / Σα,  rounded up.
  double upper_with_residual(double gauge_bound) const;

  /// As proven_upper(), for points of which those known are within error_A resp. error_Q of, in each
  /// coordinate.
  double upper_of_moved_points(double error_A, double error_Q);

  /// s such that for every |r|∞ <= s the point a + r, a the only basic point of A, lies in the cone of the
  /// basic points of Q, with weights of at most twice those of a. 0 where the basis is not of that form.
  double cone_radius();

  /// Σα_i a_i of the basic solution: an (approximate) point of A ∩ dQ.
  void contact_point(double* point) const;
  /// The a_i of that combination with their weights α_i.
  void points_of_A(WeightedPoints& points) const;
  /// After proven_upper() found 0: the points of A that combine to the origin, as (position, weight).
  void origin_weights(std::vector<PointWeight>& weights) const;

  bool has_artificial_weight() const;   ///< above rounding noise
  double dual_length() const noexcept;  ///< Σ|u_k|

 private:
  bool is_point_of_A(int i) const { return !is_artificial(view().id[i]) && !is_from_Q(view().id[i]); }
  double enclosed_upper(double gap_tolerance, bool refine);
  double exact_upper();

  double left_out_ = 0;  // weights up to this have no part in what proven_upper() proved
};

}  // namespace raygauge
