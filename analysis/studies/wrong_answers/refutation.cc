// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/wrong_answers/refutation.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/affine_image.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/minkowski_difference.h"
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

DistanceOptions precise() {
  DistanceOptions options;
  options.tolerance = 1e-9;
  return options;
}

/// Closest points of the two bodies; where they meet, of both shrunk until they no longer do: then the point
/// between them is common to the two.
std::optional<std::pair<Vector, Vector>> close_points(const Body& A1, const Body& A2) {
  const Ball unit(Vector::Zero(A1->dimension()), 1.0);
  ObjectDistanceSolver solver(precise());
  double factor = kShrink;  // hulls have weights for inner points only
  GrowthDistanceSolver growth;
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

std::optional<Refutation> by_normal(const Body& A1, const Body& A2, BodyPieces first, BodyPieces second) {
  ObjectDistanceSolver solver(precise());
  const Ball unit(Vector::Zero(A1->dimension()), 1.0);
  const Vector u = -solver.solve(*A1, *A2, unit).distance.normal;
  if (u.size() == 0 || !(u.norm() > 0)) return std::nullopt;
  const double least = (-second.support(-u) - first.support(u)) / u.norm();
  return Refutation{std::move(first), std::move(second), SeparatingNormal{u}, least};
}

std::optional<Refutation> by_points(const Body& A1, const Body& A2, BodyPieces first, BodyPieces second) {
  const auto points = close_points(A1, A2);
  if (!points) return std::nullopt;
  auto one = point_near(*A1, points->first);
  auto two = point_near(*A2, points->second);
  if (!one || !two) return std::nullopt;
  const double most = (two->in(second)-one->in(first)).norm();
  return Refutation{std::move(first), std::move(second), ClosePoints{std::move(*one), std::move(*two)}, most};
}

}  // namespace

std::optional<Refutation> refute(const Instance& instance, double answer, double slack) {
  const auto* difference = dynamic_cast<const MinkowskiDifference*>(instance.A.get());
  if (difference == nullptr) return std::nullopt;
  const Body& A1 = difference->A1();
  const Body& A2 = difference->A2();
  const std::optional<BodyPieces> first = pieces_of(*A1), second = pieces_of(*A2);
  if (!first || !second) return std::nullopt;
  std::optional<Refutation> found = by_normal(A1, A2, *first, *second);
  if (found && found->distance > answer + slack) return found;
  found = by_points(A1, A2, *first, *second);
  return found && found->distance < answer - slack ? found : std::nullopt;
}

}  // namespace raygauge
