// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "raygauge/sets/convex_set.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {

/// lower <= gauge_S(x) <= upper, both proven. The gauge is min{t >= 0 : x in tS}: +infinity where no multiple
/// of S contains x.
struct GaugeBounds {
  double lower = 0;
  double upper = 0;
};

/// The gauge of S at x, for every set. It comes from the set's own formula where it has one, and is otherwise
/// the distance of {x} in the gauge of S. Its relative gap is `tolerance` where the proof reaches it. Throws
/// DimensionMismatchError, NonFiniteError, or InvalidParameterError unless 0 < tolerance < 1.
GaugeBounds gauge(const ConvexSet& S, const ConstVectorRef& x, double tolerance = 1e-6);

/// Whether x lies in S, as far as it is proven.
enum class Membership : std::uint8_t {
  inside,
  outside,
  undecided,  ///< x is within about `tolerance` of the boundary, relative to its distance from
              ///< the centre
};

/// Computes the gauge about the centre c: x in S if and only if gauge_{S - c}(x - c) <= 1. Throws as
/// gauge().
Membership contains(const ConvexSet& S, const ConstVectorRef& x, double tolerance = 1e-6);

/// How many points are asked about at once.
struct PointsOptions {
  double tolerance = 1e-6;  ///< as of gauge() and contains()
  int threads = 1;          ///< 1 … kMostBatchThreads; the answers do not depend on it
  std::function<bool()>
      stop;  ///< asked often and by all threads; once true, the other points stay unanswered
};

/// gauge() of each column of X; [0, inf] of one that `stop` left out. Where X has 1024 columns and more, a
/// hull of 60 n to 65 536 points, n <= 16, is walked from facet to facet: the dual simplex starts from what
/// was found for a point near by. `normals`, if given, becomes n × K: of each point the normal of its
/// distance (DistanceResult::normal), of any length, NaN where there is none. Throws as gauge(), for a column
/// of X in the words of PairBatch.
std::vector<GaugeBounds> gauges(const ConvexSet& S, const Eigen::Ref<const Eigen::MatrixXd>& X,
                                const PointsOptions& options = {}, Eigen::MatrixXd* normals = nullptr);

/// Whether gauges() of K points of R^n may walk so.
bool gauges_walk(const ConvexSet& S, std::ptrdiff_t K) noexcept;

/// contains() of each column of X; `undecided` of one that `stop` left out. Of a point set S most points are
/// answered by what others proved. x is outside where an earlier point's normal w has w·x > h_S(w). It is
/// inside where Σ |x - c|_k max(gauge_{S-c}(e_k), gauge_{S-c}(-e_k)) <= 1. Throws as gauges().
std::vector<Membership> memberships(const ConvexSet& S, const Eigen::Ref<const Eigen::MatrixXd>& X,
                                    const PointsOptions& options = {});

/// Whether the origin lies in the interior of a gauge body Q, as a gauge needs (see ConvexSet), with what
/// proves that it does not.
struct OriginInInterior {
  enum class Answer : std::uint8_t {
    holds,     ///< proven: every point has a finite distance
    violated,  ///< proven: all of Q lies to one side of the origin, u·q >= 0 for u = direction
    unknown,   ///< the time limit was reached first
  };
  Answer answer = Answer::unknown;
  Vector direction;  ///< of `violated`, n doubles (rounded); otherwise empty
};

/// Decides 0 ∈ int conv{q_j}. First two linear programs (GaugeBound); if they prove nothing, the distances of
/// n + 3 points: two generic ones, e_1, …, e_n and -(e_1 + … + e_n), each scaled by the size of Q. All are
/// finite if and only if 0 is in the interior.
OriginInInterior origin_in_interior(const PointSet& Q,
                                    double time_limit = std::numeric_limits<double>::infinity());

}  // namespace raygauge
