// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/wrong_answers/body_pieces.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "raygauge/queries/solver.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/truncated_cone.h"

namespace raygauge {
namespace {

constexpr int kMostBoxDimensions = 10;

Eigen::MatrixXd identity(Eigen::Index n) { return Eigen::MatrixXd::Identity(n, n); }

Eigen::MatrixXd columns(const Vector& p, const Vector& q) {
  Eigen::MatrixXd both(p.size(), 2);
  both << p, q;
  return both;
}

Vector pair_of(double first, double second) {
  Vector both(2);
  both << first, second;
  return both;
}

/// z with F z the part of x across the axis, for a radius.
Vector within_unit(const Vector& offset, double radius) {
  if (radius == 0) return Vector::Zero(offset.size());
  const Vector z = offset / radius;
  return z / std::max(1.0, z.norm());
}

/// Where x is along p to q, from 0 to 1.
double along(const Vector& x, const Vector& p, const Vector& q) {
  return std::clamp((x - p).dot(q - p) / (q - p).squaredNorm(), 0.0, 1.0);
}

/// Corner `corner` has the upper end in the coordinates whose bit is set.
Vector corner_of(const Box& box, unsigned corner) {
  Vector point = box.lower();
  for (Eigen::Index j = 0; j < point.size(); ++j)
    if ((corner >> static_cast<unsigned>(j) & 1U) != 0) point[j] = box.upper()[j];
  return point;
}

BodyPieces pieces_of_box(const Box& box) {
  const Eigen::Index n = box.lower().size();
  BodyPieces pieces{Eigen::MatrixXd(n, Eigen::Index{1} << n), {Eigen::MatrixXd::Zero(n, n)}};
  for (Eigen::Index corner = 0; corner < pieces.centers.cols(); ++corner)
    pieces.centers.col(corner) = corner_of(box, static_cast<unsigned>(corner));
  return pieces;
}

/// The weights of the corners are products: x is a combination of the two ends in each coordinate.
PointOfPieces point_of_box(const Box& box, const Vector& x) {
  const Eigen::Index n = x.size();
  PointOfPieces point{Vector::Ones(Eigen::Index{1} << n), Vector::Zero(n)};
  for (Eigen::Index j = 0; j < n; ++j) {
    const double edge = box.upper()[j] - box.lower()[j];
    const double part = edge > 0 ? std::clamp((x[j] - box.lower()[j]) / edge, 0.0, 1.0) : 0;
    for (Eigen::Index corner = 0; corner < point.weights.size(); ++corner)
      point.weights[corner] *= (corner >> j & 1) != 0 ? part : 1 - part;
  }
  return point;
}

BodyPieces pieces_of_frustum(const Frustum& body) {
  const Vector axis = (body.top() - body.base()).normalized();
  const Eigen::MatrixXd across = identity(axis.size()) - axis * axis.transpose();
  return {columns(body.base(), body.top()), {body.base_radius() * across, body.top_radius() * across}};
}

PointOfPieces point_of_frustum(const Frustum& body, const Vector& x) {
  const double part = along(x, body.base(), body.top());
  const double radius = (1 - part) * body.base_radius() + part * body.top_radius();
  const Vector on_axis = (1 - part) * body.base() + part * body.top();
  return {pair_of(1 - part, part), within_unit(x - on_axis, radius)};
}

PointOfPieces point_of_capsule(const Capsule& body, const Vector& x) {
  const double part = along(x, body.p(), body.q());
  const Vector on_axis = (1 - part) * body.p() + part * body.q();
  return {pair_of(1 - part, part), within_unit(x - on_axis, body.radius())};
}

/// The weights of the points that prove 0 in S - x; of a point of the set, to
/// rounding errors, that alone.
std::optional<PointOfPieces> point_of_hull(const PointSet& S, const Vector& x) {
  DenseMatrix moved = S.points();
  moved.colwise() -= x;
  const double rounding = 1e-15 * (x.norm() + S.points().cwiseAbs().maxCoeff());
  for (Eigen::Index i = 0; i < moved.cols(); ++i) {
    if (moved.col(i).norm() <= rounding)
      return PointOfPieces{Vector::Unit(S.size(), i), Vector::Zero(x.size())};
  }
  DistanceSolver solver;
  const DistanceResult& found = solver.solve(PointSet(moved), Ball(Vector::Zero(x.size()), 1.0));
  if (found.status != DistanceStatus::contains_origin || found.origin_weights.empty()) return std::nullopt;
  PointOfPieces point{Vector::Zero(S.size()), Vector::Zero(x.size())};
  for (const PointWeight& each : found.origin_weights) point.weights[each.index] = std::max(each.weight, 0.0);
  return point;
}

}  // namespace

double BodyPieces::support(const Vector& u) const {
  double most = -std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < centers.cols(); ++i) {
    const Eigen::MatrixXd& F = factors[factors.size() == 1 ? 0 : static_cast<std::size_t>(i)];
    most = std::max(most, centers.col(i).dot(u) + (F.transpose() * u).norm());
  }
  return most;
}

Vector PointOfPieces::in(const BodyPieces& body) const {
  Vector point = Vector::Zero(z.size());
  for (Eigen::Index i = 0; i < weights.size(); ++i) {
    const Eigen::MatrixXd& F = body.factors[body.factors.size() == 1 ? 0 : static_cast<std::size_t>(i)];
    point += weights[i] / weights.sum() * (body.centers.col(i) + F * z);
  }
  return point;
}

std::optional<BodyPieces> pieces_of(const ConvexSet& S) {
  const Eigen::Index n = S.dimension();
  if (const auto* ball = dynamic_cast<const Ball*>(&S))
    return BodyPieces{ball->center(), {ball->radius() * identity(n)}};
  if (const auto* capsule = dynamic_cast<const Capsule*>(&S))
    return BodyPieces{columns(capsule->p(), capsule->q()), {capsule->radius() * identity(n)}};
  if (const auto* body = dynamic_cast<const Ellipsoid*>(&S))
    return BodyPieces{body->center(), {body->factor()}};
  if (const auto* body = dynamic_cast<const Frustum*>(&S)) return pieces_of_frustum(*body);
  if (const auto* points = dynamic_cast<const PointSet*>(&S))
    return BodyPieces{points->points(), {Eigen::MatrixXd::Zero(n, n)}};
  if (const auto* box = dynamic_cast<const Box*>(&S); box != nullptr && n <= kMostBoxDimensions)
    return pieces_of_box(*box);
  const auto* image = dynamic_cast<const AffineImage*>(&S);
  if (image == nullptr || image->M().rows() != image->M().cols()) return std::nullopt;
  std::optional<BodyPieces> pieces = pieces_of(*image->S());
  if (!pieces) return std::nullopt;
  pieces->centers = (image->M() * pieces->centers).colwise() + image->t();
  for (Eigen::MatrixXd& factor : pieces->factors) factor = image->M() * factor;
  return pieces;
}

std::optional<PointOfPieces> point_near(const ConvexSet& S, const Vector& x) {
  if (const auto* ball = dynamic_cast<const Ball*>(&S))
    return PointOfPieces{Vector::Ones(1), within_unit(x - ball->center(), ball->radius())};
  if (const auto* capsule = dynamic_cast<const Capsule*>(&S)) return point_of_capsule(*capsule, x);
  if (const auto* body = dynamic_cast<const Ellipsoid*>(&S))
    return PointOfPieces{Vector::Ones(1),
                         within_unit(body->factor().fullPivLu().solve(x - body->center()), 1)};
  if (const auto* body = dynamic_cast<const Frustum*>(&S)) return point_of_frustum(*body, x);
  if (const auto* points = dynamic_cast<const PointSet*>(&S)) return point_of_hull(*points, x);
  if (const auto* box = dynamic_cast<const Box*>(&S); box != nullptr && x.size() <= kMostBoxDimensions)
    return point_of_box(*box, x);
  const auto* image = dynamic_cast<const AffineImage*>(&S);
  if (image == nullptr || image->M().rows() != image->M().cols()) return std::nullopt;
  return point_near(*image->S(), image->M().fullPivLu().solve(x - image->t()));
}

}  // namespace raygauge
