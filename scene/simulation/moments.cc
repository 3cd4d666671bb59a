// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/simulation.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "engine/numerics/decompositions.h"
#include "engine/sets/hull_3d.h"
#include "raygauge/exceptions.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/p_norm_ball.h"
#include "raygauge/sets/truncated_cone.h"
#include "scene/simulation/known_points.h"

namespace raygauge {
namespace {

constexpr double kPi = std::numbers::pi;

// {c + L z : |z| <= 1}.
Moments of_ellipsoid(const Eigen::VectorXd& center, const Eigen::MatrixXd& shape, double determinant) {
  const double n = static_cast<double>(center.size());
  const double V = determinant * (n == 2 ? kPi : 4 * kPi / 3);
  return {V, center, V / (n + 2) * shape};
}

Moments of_box(const Box& S) {
  const Eigen::VectorXd edge = S.upper() - S.lower();
  const double V = edge.prod();
  return {V, S.lower() + edge / 2, V / 12 * Eigen::MatrixXd(edge.array().square().matrix().asDiagonal())};
}

// Dirichlet: over x >= 0 with Σ x_k^p <= 1,  ∫ Π x_k^(α_k - 1) dx = Π (Γ(α_k/p)/p) / Γ(1 + Σ α_k/p).
Moments of_p_norm_ball(const PNormBall& S) {
  const Eigen::VectorXd axes = S.semi_axes();
  const double n = static_cast<double>(axes.size()), p = S.p();
  double volume = std::pow(2, n), square = std::pow(2, n) / 3;
  if (std::isfinite(p)) {
    const double one = std::lgamma(1 / p) - std::log(p / 2), three = std::lgamma(3 / p) - std::log(p / 2);
    volume = std::exp(n * one - std::lgamma(1 + n / p));
    square = std::exp((n - 1) * one + three - std::lgamma(1 + (n + 2) / p));
  }
  const double product = axes.prod();
  return {product * volume, S.center(),
          product * square * Eigen::MatrixXd(axes.array().square().matrix().asDiagonal())};
}

// Of a body of revolution about the unit vector `axis`: ∫ along the axis, ∫ across it, about the centre.
Moments about_axis(double V, const Eigen::VectorXd& center, const Eigen::VectorXd& axis, double along,
                   double across) {
  const Eigen::Index n = center.size();
  const Eigen::MatrixXd projector = axis * axis.transpose();
  return {V, center, along * projector + across * (Eigen::MatrixXd::Identity(n, n) - projector)};
}

// A cylinder of length l and two halves of a ball, whose centre is l/2 away.
Moments of_capsule(const Capsule& S) {
  const Eigen::VectorXd way = S.q() - S.p();
  const double l = way.norm(), r = S.radius();
  Eigen::VectorXd axis = Eigen::VectorXd::Unit(way.size(), 0);
  if (l > 0) axis = way / l;
  const Eigen::VectorXd center = S.p() + way / 2;
  if (way.size() == 2) {
    const double rod = 2 * r * l, disc = kPi * r * r;
    return about_axis(rod + disc, center, axis,
                      rod * l * l / 12 + disc * (r * r / 4 + l * l / 4) + l * r * r * r * 4 / 3,
                      rod * r * r / 3 + disc * r * r / 4);
  }
  const double rod = kPi * r * r * l, ball = 4 * kPi / 3 * r * r * r;
  return about_axis(rod + ball, center, axis,
                    rod * l * l / 12 + ball * (r * r / 5 + l * l / 4) + l * kPi * std::pow(r, 4) / 2,
                    rod * r * r / 4 + ball * r * r / 5);
}

// The radius is linear along the axis, from b to t over the height h.
Moments of_frustum(const Frustum& S) {
  const Eigen::VectorXd way = S.top() - S.base();
  const double h = way.norm(), b = S.base_radius(), t = S.top_radius();
  const bool plane = way.size() == 2;
  double V = kPi * h / 3 * (b * b + b * t + t * t);
  double first = kPi * h * h / 12 * (b * b + 2 * b * t + 3 * t * t);
  double second = kPi * h * h * h / 30 * (b * b + 3 * b * t + 6 * t * t);
  double across =
      kPi * h / 20 * (std::pow(b, 4) + b * b * b * t + b * b * t * t + b * t * t * t + std::pow(t, 4));
  if (plane) {
    V = h * (b + t);
    first = h * h / 3 * (b + 2 * t);
    second = h * h * h / 6 * (b + 3 * t);
    across = h / 6 * (b * b * b + b * b * t + b * t * t + t * t * t);
  }
  const double place = first / V;
  return about_axis(V, S.base() + place / h * way, way / h, second - V * place * place, across);
}

// A simplex between the middle of the points and a facet v of the hull: with s = Σ v_i and d = det v,
// ∫ dx = d/n!,  ∫ x dx = d s/(n + 1)!,  ∫ x xᵀ dx = d (Σ v_i v_iᵀ + s sᵀ)/(n + 2)!.
std::optional<Moments> of_points(const Eigen::MatrixXd& points) {
  if (points.cols() == 0) return std::nullopt;
  const Eigen::Index n = points.rows();
  const Eigen::VectorXd middle = points.rowwise().mean();
  const Eigen::MatrixXd facets = surface_simplices(points.colwise() - middle);
  double V = 0;
  Eigen::VectorXd first = Eigen::VectorXd::Zero(n);
  Eigen::MatrixXd second = Eigen::MatrixXd::Zero(n, n);
  const double factor = n == 2 ? 0.5 : 1.0 / 6;
  for (Eigen::Index f = 0; f + n <= facets.cols(); f += n) {
    const Eigen::MatrixXd v = facets.middleCols(f, n);
    const Eigen::VectorXd s = v.rowwise().sum();
    const double part = lu_determinant(v) * factor;
    V += part;
    first += part / static_cast<double>(n + 1) * s;
    second += part / static_cast<double>((n + 1) * (n + 2)) * (v * v.transpose() + s * s.transpose());
  }
  if (!(V > 0)) return Moments{0, middle, Eigen::MatrixXd::Zero(n, n)};
  const Eigen::VectorXd c = first / V;
  return Moments{V, middle + c, second - V * c * c.transpose()};
}

std::optional<Moments> find_moments(const ConvexSet& S) {
  if (const auto* ball = dynamic_cast<const Ball*>(&S)) {
    const double r = ball->radius();
    const Eigen::Index n = S.dimension();
    return of_ellipsoid(S.center(), r * r * Eigen::MatrixXd::Identity(n, n), std::pow(r, n));
  }
  if (const auto* ellipsoid = dynamic_cast<const Ellipsoid*>(&S)) {
    const Eigen::MatrixXd L = ellipsoid->factor();
    const Eigen::VectorXd axes = right_singular(L).values;
    return of_ellipsoid(S.center(), L * L.transpose(), axes.size() < L.rows() ? 0.0 : axes.prod());
  }
  if (const auto* ball = dynamic_cast<const PNormBall*>(&S)) return of_p_norm_ball(*ball);
  if (const auto* box = dynamic_cast<const Box*>(&S)) return of_box(*box);
  if (const auto* capsule = dynamic_cast<const Capsule*>(&S)) return of_capsule(*capsule);
  if (const auto* frustum = dynamic_cast<const Frustum*>(&S)) return of_frustum(*frustum);
  if (const auto* image = dynamic_cast<const AffineImage*>(&S)) {
    const std::optional<Moments> inner = find_moments(*image->S());
    if (!inner) return std::nullopt;
    const Eigen::MatrixXd M = image->M();
    const double size = std::fabs(lu_determinant(M));
    return Moments{size * inner->measure, M * inner->center + Eigen::VectorXd(image->t()),
                   size * M * inner->covariance * M.transpose()};
  }
  return of_points(known_points(S));
}

}  // namespace

Eigen::Matrix3d Moments::inertia() const {
  if (covariance.rows() == 2) return Eigen::Vector3d(0, 0, covariance.trace()).asDiagonal();
  return covariance.trace() * Eigen::Matrix3d::Identity() - Eigen::Matrix3d(covariance);
}

Moments moments_of(const ConvexSet& S) {
  const int n = S.dimension();
  if (n != 2 && n != 3)
    throw InvalidParameterError("mass: a body of R^" + std::to_string(n) +
                                " has none; give it in 2 or 3 dimensions");
  const std::optional<Moments> found = find_moments(S);
  if (!found)
    throw InvalidParameterError("mass: no moments are known of this shape; use parts or a hull of points");
  if (found->measure > 0 && std::isfinite(found->covariance.sum())) return *found;
  if (n == 3 && !has_hull_3d() && found->measure == 0 && known_points(S).cols() > 4)
    throw InvalidParameterError(
        "mass: hulls of points need Qhull (apt-get install libqhull-dev, and build again)");
  throw InvalidParameterError("mass: the shape has no volume, or one that is not finite");
}

Moments moments_of(const std::vector<std::shared_ptr<const ConvexSet>>& parts) {
  if (parts.size() == 1) return moments_of(*parts.front());
  std::vector<Moments> all;
  double V = 0;
  for (const auto& part : parts) {
    all.push_back(moments_of(*part));
    V += all.back().measure;
  }
  Moments sum = all.front();
  sum.center.setZero();
  for (const Moments& one : all) sum.center += one.measure / V * one.center;
  sum.covariance.setZero();
  for (const Moments& one : all) {
    const SmallVector away = one.center - sum.center;
    sum.covariance += one.covariance + one.measure * away * away.transpose();
  }
  sum.measure = V;
  return sum;
}

}  // namespace raygauge
