// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/lp/column_pool.h"
#include "engine/lp/common_ray.h"
#include "engine/lp/exact_simplex.h"
#include "engine/lp/gauge_bound.h"
#include "engine/lp/interior_point.h"
#include "engine/lp/optimal_face.h"
#include "engine/lp/primal_simplex.h"
#include "engine/lp/refined_basis.h"
#include "engine/lp/scaling.h"
#include "engine/lp/twofold_simplex.h"
#include "engine/lp/whitened_points.h"
#include "engine/numerics/aligned_buffer.h"
#include "engine/numerics/stopwatch.h"
#include "engine/proof/certificate.h"
#include "engine/threads/chunk_team.h"
#include "raygauge/methods/options.h"
#include "raygauge/methods/result.h"

namespace raygauge {

/// The method `column_generation` on a pair of point sets. Small sets are priced whole (PrimalSimplex). Of
/// large ones a sample is solved first; one pass over everything then collects the points that the sample's
/// normal leaves on the wrong side, and the next pass usually proves the answer (Clarkson's sampling;
/// "sifting").
class Sifting {
 public:
  void solve(const PointSet& A, const PointSet& Q, const DistanceOptions& options, const Stopwatch& stopwatch,
             Effects effects, DistanceResult& result);

  /// The same over some points only, given by their indices. `upper` is an upper bound on d_Q(A), `lower`
  /// belongs to the chosen points' normal and is a lower bound on d_Q(A) all the same.
  void solve_restricted(const PointSet& A, const PointSet& Q, std::span<const std::int64_t> index_A,
                        std::span<const std::int64_t> index_Q, const DistanceOptions& options,
                        const Stopwatch& stopwatch, DistanceResult& result);

  /// For measuring what proofs cost (bench/safety_cost.cc) and for nothing else: a solve that the simplex
  /// calls solved then ends there, with no bound known.
  void trust_simplex(bool trust) noexcept { trusts_simplex_ = trust; }

 private:
  void begin(const PointSet& A, const PointSet& Q, const DistanceOptions& options,
             const Stopwatch& stopwatch);
  void start();
  void start_inside();
  void start_at_normal();
  void begin_from_basis();
  bool may_be_proven_inside() const;
  bool is_separated();
  bool choose_frame();
  int least_for_interior() const;
  double guess_error() const;
  void turn_guess(double* v) const;
  void run(bool restricted, Effects effects, DistanceResult& result);
  enum class Next : std::uint8_t { conclude, again, done };
  Next leave_impasse(PrimalSimplex::End end, bool restricted, Effects effects, DistanceResult& result);
  double prove_upper(bool concluded);
  bool prepare_next(PrimalSimplex::End end, bool points_are_missing);
  bool certify_as_priced(Effects effects, DistanceResult& result);
  bool is_complete() const noexcept { return working_A_.is_complete() && working_Q_.is_complete(); }
  bool interior_may_help(PrimalSimplex::End end) const noexcept;
  void solve_inside(const double* guess);
  bool finish_inside(Effects effects, DistanceResult& result);
  double bound_inside(double lower);
  void collect_carriers(bool with_Q);
  double farthest_of_Q(const double* u);
  double widest_gap(const double* u);
  void note_inside(InteriorPoint::End end);
  bool certify_on_the_way(Effects effects, DistanceResult& result);
  bool certify_by_last_look(Effects effects, DistanceResult& result);
  bool certify_inside(Effects effects, DistanceResult& result);
  bool certify_ray(Effects effects, DistanceResult& result);
  void finish_with_ray(DistanceStatus status, double lower, Effects effects, DistanceResult& result);
  bool certify_carriers(double distance, Effects effects, DistanceResult& result);
  bool certify_zero(Effects effects, DistanceResult& result);
  double upper_of_face();
  bool collect_face(double least, bool with_Q = true);
  void find_origin_weights(std::vector<PointWeight>& weights);
  void round_weights_of_face(std::vector<PointWeight>& weights);
  void weights_of_face(std::vector<PointWeight>& weights) const;
  bool certify_by_plane(Effects effects, DistanceResult& result);
  bool certify_by_plane(double near, Effects effects, DistanceResult& result);
  bool is_beyond(const ColumnPool& pool, const std::vector<double>& u, const std::vector<double>& u_low,
                 double sign, const std::vector<double>& uncertain, const std::vector<bool>& left_out);
  std::vector<bool> collect_plane(const double* u, double near);
  const double* products_with(const ColumnPool& pool, const double* u);
  void conclude(double lower, double upper, Effects effects, DistanceResult& result);
  void finish_with_face(double lower, double upper, Effects effects, DistanceResult& result);
  bool certify_refined(PrimalSimplex::End end, Effects effects, DistanceResult& result);
  bool certify_twofold(Effects effects, DistanceResult& result);
  double refine_lower(const double* y, const double* y_low, std::int64_t* best_A, std::int64_t* best_Q);
  bool enter_refined(std::int64_t best_A, std::int64_t best_Q);
  bool bounds_mislead() const noexcept;
  double price_everything(bool roughly);
  bool price_or_separate(PrimalSimplex::End end, bool restricted, double& lower);
  double upper_despite_residual();
  struct Violators {
    Collection points;  // new ones above the threshold, and those as near below it as `reach`
    bool any = false;   // whether one is above
    double reach = 0;
  };
  SupportValue price_set(const PointSet& S, const ColumnPool& working, const double* direction,
                         double threshold, double resolution, Violators& violators);
  static bool drop_known(const ColumnPool& working, std::ptrdiff_t size, double threshold, Collection& found);
  void add_violators();
  void finish_short_of_tolerance(PrimalSimplex::End end, double lower, double upper, Effects effects,
                                 DistanceResult& result);
  void collect_basis();
  ExactSimplex::End finish_by_exact_simplex(double lower, Effects effects, DistanceResult& result);
  void finish(DistanceStatus status, double lower, double upper, Effects effects, DistanceResult& result);
  void finish_with_twofold(double lower, double upper, Effects effects, DistanceResult& result);
  void finish_exactly(DistanceStatus status, const RoundedRatio& distance, Effects effects,
                      DistanceResult& result);
  void record_work(DistanceResult& result);

  // Dimensions from which on a simplex may stall for longer than the interior-point method takes.
  static constexpr int kLeastToStall = 16;

  const PointSet* A_ = nullptr;
  const PointSet* Q_ = nullptr;
  const Kernels* kernels_ = nullptr;
  int n_ = 0;
  double tolerance_ = 0;
  int threads_ = 1;
  ChunkTeam team_;
  bool trusts_simplex_ = false;
  bool pivots_are_limited_ = false;  // by the caller
  Scaling scaling_;
  ColumnPool working_A_;
  ColumnPool working_Q_;
  AxisPoints axes_;  // of working_Q_
  PrimalSimplex program_;
  RefinedBasis refined_;
  TwofoldSimplex twofold_;
  InteriorPoint interior_;
  WhitenedPoints whitened_;
  enum class InteriorState : std::uint8_t { untried, failed, paused, converged };
  InteriorState interior_state_ = InteriorState::untried;
  bool separated_ = false;     // by interior_, the working sets
  bool basis_is_due_ = false;  // program_ has not begun from the columns of interior_ yet
  CommonRay ray_;
  OptimalFace face_;
  bool by_face_ = false;                // whether that proved the last upper bound
  std::int64_t pivots_at_zero_ = -1;    // when certify_zero() tried last
  std::int64_t pivots_at_repair_ = -1;  // of a basis that is accurate now: its proofs failed
  std::vector<InteriorPoint::Carrier> carriers_;
  std::vector<double> farkas_;  // a direction that may leave Q behind; none: empty
  GaugeBound gauge_bound_;
  double gauge_per_residual_ = 0;  // of gauge_bound_; 0: not computed
  const Stopwatch* stopwatch_ = nullptr;
  DistanceCounters counters_;

  // The last resort, the points it may use (none given: all), and the basis it starts from.
  ExactSimplex exact_;
  std::span<const std::int64_t> chosen_A_;
  std::span<const std::int64_t> chosen_Q_;
  std::vector<std::int64_t> start_;

  // The last pricing of the whole sets, in scaled units, and what priced out.
  SupportValue h_A_;
  SupportValue h_Q_;
  Violators violators_A_;
  Violators violators_Q_;

  AlignedBuffer<double> direction_;      // u for A, then -u for Q, in the sets' own units: 2n
  AlignedBuffer<double> direction_low_;  // what these are short of, in twice the precision
  AlignedBuffer<double> frame_;          // n x n, and its inverse: see PrimalSimplex::Frame
  AlignedBuffer<double> inverse_frame_;
  AlignedBuffer<std::int64_t> collected_;
  AlignedBuffer<double> collected_value_;
};

}  // namespace raygauge
