// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/wrong_answers/refutation.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "analysis/studies/wrong_answers/surface_around.h"
#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {
namespace {

using Body = std::shared_ptr<const ConvexSet>;

/// A factor by which touching bodies are shrunk, so that their closest points are strictly inside of the
/// bodies.
constexpr double kShrink = 1 - 1e-8;

/// A growth distance below which the centres are as good as one point, and inside of both bodies.
constexpr double kOneCenter = 1e-9;

Body shrunk(const Body& S, double factor) {
  const Eigen::Index n = S->dimension();
  const Eigen::MatrixXd M = factor * Eigen::MatrixXd::Identity(n, n);
  return std::make_shared<AffineImage>(S, M, (1 - factor) * S->center());
}

DistanceOptions precise(DistanceMethod method = DistanceMethod::automatic) {
  DistanceOptions options;
  options.tolerance = 1e-9;
  options.method = method;
  return options;
}

/// Closest points of the two bodies; where they meet, of both shrunk until they no longer do: then the point
/// between them is common to the two.
std::optional<std::pair<Vector, Vector>> close_points(const Body& A1, const Body& A2) {
  const Ball unit(Vector::Zero(A1->dimension()), 1.0);
  ObjectDistanceSolver solver(precise());
  double factor = kShrink;  // hulls have weights for inner points only
  GrowthDistanceSolver growth(precise(DistanceMethod::newton));
  const DistanceResult& grown = growth.solve_about_centers(*A1, *A2);
  if (grown.upper < kOneCenter) {
    const Vector between = 0.5 * (A1->center() + A2->center());
    return std::pair(between, between);
  }
  if (grown.upper < 1) factor = grown.lower * kShrink;
  const ObjectDistance& found =
      solver.solve(*shrunk(A1, factor), *shrunk(A2, factor), unit, ObjectEffects::closest_points);
  if (found.closest_point_1.size() == 0) return std::nullopt;
  std::pair points(found.closest_point_1, found.closest_point_2);
  if (grown.upper < 1) points.first = points.second = 0.5 * (points.first + points.second);
  return points;
}

/// Both bodies, as sets and as readers have them, and an answer about them.
struct Claim {
  const Body &A1, &A2;
  const BodyPieces &first, &second;
  double answer, slack;

  bool is_below(double bound) const { return answer + slack < bound; }
  bool is_above(double bound) const { return answer - slack > bound; }

  /// h_D(-u)/|u| of D = A2 - A1: the bodies are at least minus that apart, and at most that deep.
  double reach(const Vector& u) const { return (second.support(-u) + first.support(u)) / u.norm(); }

  Refutation by(std::variant<SeparatingNormal, ClosePoints, SurfaceAround> proof, double proven) const {
    return {first, second, std::move(proof), proven, A1->center(), A2->center()};
  }
};

std::optional<ClosePoints> points_of_bodies(const Claim& claim, const Vector& first, const Vector& second) {
  auto one = point_near(*claim.A1, first);
  auto two = point_near(*claim.A2, second);
  if (!one || !two) return std::nullopt;
  return ClosePoints{std::move(*one), std::move(*two)};
}

std::optional<Refutation> too_near(const Claim& claim) {
  ObjectDistanceSolver solver(precise());
  const Ball unit(Vector::Zero(claim.A1->dimension()), 1.0);
  const Vector u = -solver.solve(*claim.A1, *claim.A2, unit).distance.normal;
  if (u.size() == 0 || !(u.norm() > 0) || !claim.is_below(-claim.reach(u))) return std::nullopt;
  return claim.by(SeparatingNormal{u}, -claim.reach(u));
}

std::optional<Refutation> too_far(const Claim& claim) {
  const auto points = close_points(claim.A1, claim.A2);
  if (!points) return std::nullopt;
  auto close = points_of_bodies(claim, points->first, points->second);
  if (!close) return std::nullopt;
  const double most = (close->second.in(claim.second) - close->first.in(claim.first)).norm();
  if (!claim.is_above(most)) return std::nullopt;
  return claim.by(std::move(*close), most);
}

std::optional<Refutation> of_distance(const Claim& claim) {
  auto found = too_near(claim);
  return found ? found : too_far(claim);
}

/// The claim 0 or 1 is refuted as the distance 0, or as one above the slack.
std::optional<Refutation> of_separation(Claim claim) {
  if (claim.answer == 0) return too_near(claim);
  claim.answer = 2 * claim.slack;
  return too_far(claim);
}

std::optional<Refutation> of_depth(const Claim& claim) {
  ObjectDistanceSolver solver(precise());
  const Ball unit(Vector::Zero(claim.A1->dimension()), 1.0);
  const ObjectDistance& found = solver.solve(*claim.A1, *claim.A2, unit, ObjectEffects::depth);
  const Vector u = found.depth.evaluations > 0 ? -found.depth.normal : -found.distance.normal;
  if (u.size() > 0 && u.norm() > 0) {
    const double most = std::max(claim.reach(u), 0.0);
    if (claim.is_above(most)) return claim.by(SeparatingNormal{u}, most);
  }
  if (!(found.depth.evaluations > 0) || !claim.is_below(found.depth.lower)) return std::nullopt;
  auto surface = surface_around(*claim.A1, *claim.A2, claim.answer + claim.slack);
  if (!surface) return std::nullopt;
  return claim.by(std::move(*surface), claim.answer + claim.slack);
}

/// The bound σ >= u·c/(h_D(-u) + u·c) of the growth distance σ, with c from centre to centre.
double growth_by_normal(const Claim& claim, const Vector& u) {
  const double between = u.dot(claim.A2->center() - claim.A1->center()) / u.norm();
  return between / (claim.reach(u) + between);
}

std::optional<Refutation> of_growth(const Claim& claim) {
  // Bodies that are scaled by a little less do not meet, and a point between them is inside of both once they
  // are scaled by a little more, even of bodies that are 1e3 times as long as they are thick.
  constexpr double kLess = 1 - 1e-9, kMore = 1 + 8e-7;
  GrowthDistanceSolver solver(precise(DistanceMethod::newton));
  const DistanceResult growth = solver.solve_about_centers(*claim.A1, *claim.A2);
  for (const double sign : {1.0, -1.0}) {
    const Vector u = sign * growth.normal;
    if (u.size() == 0 || !(u.norm() > 0)) continue;
    const double least = growth_by_normal(claim, u);
    if (claim.is_below(least)) return claim.by(SeparatingNormal{u}, least);
  }
  const double most = growth.lower * kLess * kMore;
  if (!claim.is_above(most)) return std::nullopt;
  ObjectDistanceSolver between(precise());
  const Ball unit(Vector::Zero(claim.A1->dimension()), 1.0);
  const double factor = growth.lower * kLess;
  const ObjectDistance& near = between.solve(*shrunk(claim.A1, factor), *shrunk(claim.A2, factor), unit,
                                             ObjectEffects::closest_points);
  if (near.closest_point_1.size() == 0) return std::nullopt;
  const Vector common = 0.5 * (near.closest_point_1 + near.closest_point_2);
  const auto unscaled = [&](const Vector& c) { return Vector(c + (common - c) / most); };
  auto points = points_of_bodies(claim, unscaled(claim.A1->center()), unscaled(claim.A2->center()));
  if (!points) return std::nullopt;
  return claim.by(std::move(*points), most);
}

}  // namespace

std::optional<Refutation> refute(const Instance& instance, double answer, double slack) {
  const auto* difference = dynamic_cast<const MinkowskiDifference*>(instance.A.get());
  if (difference == nullptr) return std::nullopt;
  const Body& A1 = difference->A1();
  const Body& A2 = difference->A2();
  const std::optional<BodyPieces> first = pieces_of(*A1), second = pieces_of(*A2);
  if (!first || !second) return std::nullopt;
  const Claim claim{A1, A2, *first, *second, answer, slack};
  switch (instance.quantity) {
    case Quantity::distance:
      break;
    case Quantity::separated:
      return of_separation(claim);
    case Quantity::depth:
      return of_depth(claim);
    case Quantity::growth:
      return of_growth(claim);
  }
  return of_distance(claim);
}

}  // namespace raygauge
