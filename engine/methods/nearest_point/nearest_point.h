// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/column_generation/support_oracle.h"
#include "engine/methods/method.h"
#include "engine/methods/nearest_point/affine_basis.h"
#include "engine/numerics/aligned_buffer.h"

namespace raygauge {

/// The Euclidean distance from a polytope S - T (or S alone) to the origin, in units of a radius r:
///
///     d = min{|x| / r : x in S - T},     the distance in the gauge of Q = {x : |x| <= r},
///
/// by Wolfe's method of the nearest point (Finding the nearest point in a polytope, Math. Programming 11,
/// 1976) on the two hulls: weights α over points of S and β over points of T that are affinely independent,
/// |v| least for v = Σ α_i s_i - Σ β_j t_j. The point with the least s·v (the greatest t·v) enters, points of
/// negative weight leave. After a pass over the points several of the best may enter before the next one. No
/// points of Q are needed, and no linear programs.
///
/// Certificates: d <= |v| / r, and -h(u) / (r|u|) <= d at u = -v, h the support function of S - T (10).
class NearestPoint : public Method {
 public:
  /// Whether Q is a ball about the origin and A a polytope, or a difference S - T of two.
  static bool suits(const ConvexSet& A, const ConvexSet& Q);

  /// A = S - T, as far as A knows; T is nullptr for {0}.
  struct Difference {
    const ConvexSet* S;
    const ConvexSet* T;
  };
  static Difference difference(const ConvexSet& A);

  /// True if the solve was concluded: optimal, or a limit. Otherwise the caller has other means: the origin
  /// in S - T, or rounding, or not such sets.
  bool solve(const Problem& problem, DistanceResult& result) override;
  DistanceCounters counters() const override { return counters_; }

  /// The nearest points of S and of T of the last solve that was concluded with a positive distance.
  void nearest_points(double* of_S, double* of_T) const;

 private:
  struct Side {
    SupportOracle oracle;
    const PointSet* points = nullptr;  // where the set is one: passes keep a shortlist then
    double sign = 1;                   // of its points in v
    double best = 0;                   // sign u·p of the candidate
    double level = 0;                  // sign u·p of the points with weight
    AlignedBuffer<double> candidate;
    double violation() const noexcept { return best - level; }
  };

  void begin(const Difference& sets_of_A, const Problem& problem);
  bool choose_first_points(const double* start);
  DistanceStatus iterate(const Problem& problem);
  void price(bool pass);
  void turn();
  double gap() const noexcept;
  double noise() const noexcept;
  int most_violated() const noexcept;
  const double* point(int i) const noexcept { return points_.data() + std::ptrdiff_t{i} * n_; }
  bool add_candidate(int t);
  void remove(int i);
  bool step_towards_solution();
  bool enter(int t);
  bool enter_shortlisted();
  void prove();
  void bound_by_normal(bool twofold);
  void bound_by_length(double error);
  double combine_plainly();
  double combine_twofold();
  void report(DistanceStatus status, Effects effects, DistanceResult& result);

  const Kernels* kernels_ = nullptr;
  int n_ = 0;
  int sides_ = 1;
  int idle_ = 0;  // entries in a row that brought nothing
  Goal goal_;
  double radius_ = 1;
  double magnitude_ = 0;  // of the coordinates
  double square_ = 0;     // |v|²
  Bounds bounds_;
  Side side_[2];
  AffineBasis basis_;
  DistanceCounters counters_;
  AlignedBuffer<double> shift_;   // subtracted from the points of both sides in basis_
  AlignedBuffer<double> points_;  // those with weight, n numbers each
  AlignedBuffer<double> weights_, solution_;
  AlignedBuffer<double> v_, u_, shifted_, zero_;
  AlignedBuffer<double> normal_;   // the direction of the lower bound
  AlignedBuffer<double> nearest_;  // the nearest points of both sides
  AlignedBuffer<double> contact_;  // their difference
};

}  // namespace raygauge
