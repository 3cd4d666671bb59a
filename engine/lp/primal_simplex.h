// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/kernels/kernel.h"
#include "engine/lp/axis_points.h"
#include "engine/lp/basis.h"
#include "engine/lp/column_pool.h"
#include "engine/lp/weighted_points.h"
#include "engine/numerics/aligned_buffer.h"
#include "engine/numerics/stopwatch.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {

/// The linear program of Example 2 over two finite sets of points,
///
///     minimize Σβ_j   subject to   Σα_i a_i - Σβ_j q_j = 0,   Σα_i = 1,   α, β >= 0,
///
/// solved by a primal simplex whose basis has n + 1 columns. Its duals (u, t) are the normal of the
/// separating hyperplane and -h_A(u); pricing is one support query of A along u and one of Q along -u.
///
/// The start needs no first phase: artificial columns ±e_k complete the first basis, at costs that put the
/// first normal where a guess wants it. In the dual they are bounds |u_k| <= cost; where one of them is
/// active at the end it is raised, and only if that does not help does a first phase decide whether any
/// multiple of Q reaches A.
class PrimalSimplex {
 public:
  enum class End : std::uint8_t {
    solved,   ///< no point prices out, or the gap over the priced points is small enough
    bounded,  ///< the same, but a bound |u_k| <= cost of an artificial column is active: raise_bounds() if no
              ///< further point prices out
    unreachable,  ///< no multiple of the priced points of Q meets those of A: the duals are a Farkas
                  ///< direction
    failed,       ///< rounding defeated every repair
    stalled,      ///< many basis changes without a gain, unless be_patient(): the optimum is degenerate
    pivot_limit,
    time_limit,
  };

  /// `gap_tolerance`: a solve may stop when its relative gap over the priced points is below. `max_pivots` as
  /// in DistanceOptions::max_iterations. `impatient`: until be_patient() a solve may end as End::stalled.
  void begin(int n, double gap_tolerance, std::int64_t max_pivots, const Kernels& kernels,
             bool impatient = false);

  /// From now on Bland's rule leads out of what would end as End::stalled.
  void be_patient() noexcept { impatient_ = false; }

  /// First basis from a guess of the normal's direction (n doubles, the largest ±1) and of its relative
  /// error, which sets the first bounds on the dual. Neither changes the answer; good ones save basis
  /// changes. The points are not kept. With a `frame` that brings Q (scaled as it is) into isotropic
  /// position, the artificial columns are ±F e_k instead, and the bounds |F_k · u| <= cost: of a needle,
  /// bounds on the coordinates would say nothing about the one direction that matters.
  /// Points of Q on the axes (`axes`, looked for over all of Q) take the place of artificial columns.
  struct Frame {
    const double* F;        // n x n, column-major
    const double* inverse;  // F⁻¹
  };
  void start(const ColumnPool& A, const ColumnPool& Q, const double* guess, double guess_error,
             const Frame* frame = nullptr, const AxisPoints* axes = nullptr);

  /// First basis of these n + 1 columns; where weights are negative, of those that some dual simplex steps
  /// lead to. False where there is none: start() then.
  bool start_from(const ColumnPool& A, const ColumnPool& Q, std::span<const std::int64_t> ids,
                  const Stopwatch& stopwatch);

  /// Continues from the basis at hand. Working sets may have grown since, but not changed.
  End solve(const ColumnPool& A, const ColumnPool& Q, const Stopwatch& stopwatch);

  /// The same, but after End::solved the duals are those that the points were last priced at, and priced_A()
  /// and priced_Q() their support values. refresh_duals() makes them as good as the inverse can.
  End optimise(const ColumnPool& A, const ColumnPool& Q, const Stopwatch& stopwatch);
  double priced_A() const noexcept { return loop_.h_A; }  ///< h_A(u)
  double priced_Q() const noexcept { return loop_.h_Q; }  ///< h_Q(-u)
  void refresh_duals() { basis_.refresh_duals(); }

  /// After End::bounded: lifts the active bounds on the dual, or turns to the first phase when that has been
  /// tried often.
  void raise_bounds();

  /// After End::unreachable: the basic points of Q lie in the plane of the Farkas direction, up to rounding,
  /// which proves nothing. The next solves look for a direction that leaves all of Q strictly behind, by a
  /// margin; they end unreachable again, with it if there is one. False when that was tried before.
  bool separate();

  /// A fresh inverse, and from now on a stop at the optimal vertex only. False when nothing is left to try.
  bool repair();

  /// Repairs are counted from zero again: call when points were added.
  void allow_repairs() noexcept { repairs_ = 0; }

  /// Σβ of the exact basic solution, rounded up, where that solution is proven feasible; +infinity otherwise.
  double proven_upper();

  /// An upper bound from the basic solution even where its equations hold only up to a residual r: with
  /// gauge_Q(r) <= gauge_bound |r|∞ (GaugeBound),  d <= (Σβ + gauge_bound |r|∞) / Σα,  rounded up.
  double upper_with_residual(double gauge_bound) const;

  /// As proven_upper(), for points of which those known are within error_A resp. error_Q of, in each
  /// coordinate.
  double upper_of_moved_points(double error_A, double error_Q);

  /// Brings a point of a pool (identity as in id_of_A, id_of_Q) into the basis, whose reduced cost the caller
  /// knows. False if rounding leaves no pivot.
  bool enter(const ColumnPool& pool, std::int64_t id, double reduced_cost);

  /// For RefinedBasis.
  Basis& basis() noexcept { return basis_; }

  /// s such that for every |r|∞ <= s the point a + r, a the only basic point of A, lies in the cone of the
  /// basic points of Q, with weights of at most twice those of a. 0 where the basis is not of that form.
  double cone_radius();

  /// Σα_i a_i of the basic solution: an (approximate) point of A ∩ dQ.
  void contact_point(double* point) const;

  /// After proven_upper() found 0: the points of A that combine to the origin, as (position, weight).
  void origin_weights(std::vector<PointWeight>& weights) const;
  /// The a_i of that combination with their weights α_i.
  void points_of_A(WeightedPoints& points) const;

  /// Identities of the basic columns (see id_of_A), n + 1 of them; negative where artificial.
  const std::int64_t* basic_ids() const noexcept { return basis_.view().id; }

  const double* normal() const noexcept { return basis_.view().y; }  ///< u, n doubles
  double threshold_A() const noexcept;  ///< points of A with u·a above price out
  double threshold_Q() const noexcept;  ///< points of Q with -u·q above price out
  double objective() const noexcept { return basis_.view().objective; }

  /// How many artificial columns are basic: bounds on the normal that are active.
  int artificials() const noexcept { return loop_.artificials; }

  std::int64_t pivots() const noexcept { return basis_.view().pivots; }
  std::int64_t pricings() const noexcept { return loop_.pricings; }
  std::int64_t points_priced() const noexcept { return loop_.points_priced; }
  std::int64_t refactorisations() const noexcept { return refactorisations_; }

 private:
  // Phase 2 with bounded duals; phase 1; phase 1 with a margin, which is a negative cost of points of Q.
  enum class Stage : std::uint8_t { optimise, reach, separate };

  double price_guess(const PricedPoints& points, double sign, LaneList* lanes);
  void place_artificials(const double* a, const Frame* frame);
  void place_axis_points(const AxisPoints& axes);
  void set_artificial_costs(const double* guess, double guess_error, const Frame* frame);
  void form_column(const ColumnPool& pool, std::int64_t id);
  struct Entering {
    std::int64_t id = -1;  // none
    double ratio = std::numeric_limits<double>::infinity();
    double pivot = 0;
    double least_pivot = 0;
  };
  bool exchange(const ColumnPool& A, const ColumnPool& Q, int row);
  void look_for_entering(const ColumnPool& pool, const double* row, bool of_Q, Entering& best);
  void bind(const ColumnPool& A, const ColumnPool& Q);
  bool look_after_basis();
  bool gains(double before) const;
  double artificial_weight() const;
  double dual_length() const noexcept;  // Σ|y_k| over the coordinates
  void enter_stage(Stage stage);
  bool is_separated();
  double cost_of_Q(Stage stage) const noexcept;
  double norm_of_inverse() const;
  double enclosed_upper(bool refine);
  double exact_upper();

  static constexpr double kArtificialZero = 1e-13;  // weight of artificial columns that is rounding noise

  const Kernels* kernels_ = nullptr;
  int n_ = 0;
  Stage stage_ = Stage::optimise;
  int raises_ = 0;
  int separations_ = 0;
  bool impatient_ = false;
  int repairs_ = 0;
  int idle_looks_ = 0;
  double least_objective_ = 0;
  std::int64_t pivots_assessed_ = 0;
  std::int64_t max_pivots_ = 0;
  std::int64_t refactorisations_ = 0;
  Basis basis_;
  SimplexLoop loop_;
  double left_out_ = 0;  // weights up to this have no part in what proven_upper() proved
  AlignedBuffer<double> column_;
  AlignedBuffer<double> guess_;
  AlignedBuffer<double> white_;  // in the frame: n
  AlignedBuffer<float> single_;
};

/// Ends after which nothing more can be done.
bool is_final(PrimalSimplex::End end) noexcept;

}  // namespace raygauge
