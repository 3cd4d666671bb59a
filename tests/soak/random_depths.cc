// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "tests/soak/random_depths.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/numerics/number_text.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/point_set.h"
#include "tests/soak/random_set.h"

namespace raygauge::soak {
namespace {

using Real = long double;
using Long = Eigen::Matrix<Real, 3, 1>;
using LongPoints = Eigen::Matrix<Real, 3, Eigen::Dynamic>;

constexpr double kTolerance = 1e-6;
constexpr Real kError = 1e-14;  // of a height, relative to the size of bodies and of the way between

// A body, where it is, and the points of a polytope.
struct Body {
  RandomSet shape;
  Eigen::MatrixXd points, R;
  Vector t;
  double size = 0;

  int n() const { return shape.set->dimension(); }

  // h(u), as far as the set's own support point is one.
  Real height(const Long& u) const {
    const int dimension = n();
    Eigen::Matrix<Real, Eigen::Dynamic, 1> v = R.cast<Real>().transpose() * u.head(dimension);
    const Vector rounded = v.cast<double>();
    Vector point(dimension);
    shape.set->support_unchecked(rounded.data(), point.data());
    return v.dot(point.cast<Real>()) + u.head(dimension).dot(t.cast<Real>());
  }

  Vector face_point(const Vector& u) const { return R * shape.set->support_mapping(R.transpose() * u); }

  LongPoints placed() const {
    LongPoints all = LongPoints::Zero(3, points.cols());
    all.topRows(n()) = (R.cast<Real>() * points.cast<Real>()).colwise() + t.cast<Real>();
    return all;
  }
};

Eigen::MatrixXd draw_cloud(RandomStream& stream, int n, double size) {
  const Eigen::Index N = stream.integer(n + 1, 7);
  const bool grid = stream.uniform() < 0.5;
  Eigen::MatrixXd cloud = Eigen::MatrixXd::NullaryExpr(n, N, [&](Eigen::Index, Eigen::Index) {
    return size * (grid ? static_cast<double>(stream.integer(-4, 4)) / 4 : stream.normal());
  });
  if (stream.uniform() < 0.2) cloud.row(n - 1) *= std::pow(10.0, -9 * stream.uniform());
  return cloud;
}

Body draw_body(RandomStream& stream, int n, double size, bool polytope) {
  Body body;
  if (polytope) {
    body.points = draw_cloud(stream, n, size);
    body.shape = {std::make_shared<PointSet>(body.points), "points"};
  } else {
    do {
      body.shape = draw_set(stream, Vector::Zero(n), size, 0);
    } while (body.shape.label == "p-ball");
  }
  Vector magnitude(n);
  body.shape.set->magnitude_unchecked(magnitude.data());
  body.size = magnitude.norm();
  body.t = Vector::Zero(n);
  return body;
}

void turn(RandomStream& stream, Body& body) {
  const int n = body.n();
  const double kind = stream.uniform();
  const double quarter = std::acos(-1.0) / 4;
  const double angle =
      kind < 0.4 ? quarter * static_cast<double>(stream.integer(0, 7)) : 6 * stream.uniform();
  body.R = Eigen::MatrixXd::Identity(n, n);
  if (kind < 0.2) return;
  if (n == 2) {
    body.R = Eigen::Rotation2Dd(angle).toRotationMatrix();
  } else {
    body.R = Eigen::AngleAxisd(angle, Eigen::Vector3d(draw_direction(stream, 3))).toRotationMatrix();
  }
}

// The second body, where the first one is at the origin; the direction that it was placed by.
Vector place(RandomStream& stream, const Body& first, Body& second) {
  const int n = first.n();
  const double size = std::min(first.size, second.size), kind = stream.uniform();
  Vector u = draw_direction(stream, n);
  u.normalize();
  if (kind < 0.3) {
    second.t = Vector::NullaryExpr(
        n, [&](Eigen::Index) { return size * static_cast<double>(stream.integer(-4, 4)) / 8; });
  } else if (kind < 0.5) {
    second.t = size * stream.uniform() * u;
  } else {
    const double depth = size * std::pow(10.0, -10 * stream.uniform());
    second.t = first.face_point(-u) - second.face_point(u) + depth * u;
  }
  return u;
}

Long lifted(const Vector& u) {
  Long v = Long::Zero();
  v.head(u.size()) = u.cast<Real>();
  return v;
}

Real height(const Body& first, const Body& second, const Long& u) {
  return (second.height(u) + first.height(-u)) / u.norm();
}

// Of all directions that are looked at.
Real least_height(RandomStream& stream, const Body& first, const Body& second, const Vector& placed,
                  const Vector& normal) {
  Real least = height(first, second, lifted(placed));
  for (int i = 0; i < 30; ++i)
    least = std::min(least, height(first, second, lifted(stream.unit_vector(first.n()))));
  if (normal.size() == 0) return least;
  Vector best = normal;
  Real lowest = height(first, second, lifted(best));
  double step = 0.1;
  for (int i = 0; i < 60; ++i) {
    const Vector u = (best.normalized() + step * stream.unit_vector(first.n())).normalized();
    const Real here = height(first, second, lifted(u));
    if (here < lowest) {
      lowest = here;
      best = u;
    } else {
      step *= 0.8;
    }
  }
  return std::min(least, lowest);
}

// Of the plane, points lie in z = 0 and normals of two points in it too.
Real depth_of_facets(const LongPoints& A, const LongPoints& B, int n) {
  Real least = std::numeric_limits<Real>::infinity();
  const auto look = [&](const Long& normal) {
    const Real size = normal.norm();
    if (!(size > 0)) return;
    for (const Long& u : {Long(normal / size), Long(-normal / size)})
      least = std::min(least, (u.transpose() * B).maxCoeff() - (u.transpose() * A).minCoeff());
  };
  const Long up(0, 0, 1);
  const auto edges = [&](const LongPoints& P, const auto& see) {
    for (Eigen::Index i = 1; i < P.cols(); ++i)
      for (Eigen::Index k = 0; k < i; ++k) see(Long(P.col(i) - P.col(k)));
  };
  const auto across = [&](const LongPoints& P, const LongPoints& R) {
    edges(P, [&](const Long& e) {
      if (n == 2) return look(e.cross(up));
      edges(R, [&](const Long& f) { look(e.cross(f)); });
    });
  };
  across(A, A);
  across(B, B);
  if (n == 3) across(A, B);
  return least;
}

std::string violation(const ObjectDepth& depth, Real least, Real of_normal, Real error) {
  std::string what;
  if (!(depth.lower >= 0 && depth.lower <= depth.upper)) what = "not 0 <= lower <= upper";
  const bool narrow = depth.upper - depth.lower <= kTolerance * depth.upper;
  if (depth.status == DistanceStatus::optimal && !narrow) what = "optimal, but wider than the tolerance";
  if (depth.lower > 0 && !(depth.lower <= least + error)) what = "a direction is lower";
  if (!(depth.upper >= of_normal - error)) what = "the normal does not prove the upper bound";
  if (what.empty()) return what;
  return what + ": [" + shortest_text(depth.lower) + ", " + shortest_text(depth.upper) + "], least height " +
         shortest_text(static_cast<double>(least)) + ", that of the normal " +
         shortest_text(static_cast<double>(of_normal));
}

DistanceOptions options() {
  DistanceOptions options;
  options.tolerance = kTolerance;
  options.time_limit = 1;
  return options;
}

}  // namespace

RandomDepths::RandomDepths(std::uint64_t seed) : seed_(seed), solver_(options()) {}

std::optional<std::string> RandomDepths::check(std::int64_t number) {
  RandomStream stream({seed_, 1, static_cast<int>(number >> 31), static_cast<int>(number & 0x7fffffff)},
                      "random_depths", RandomPurpose::shape);
  const int n = stream.uniform() < 0.8 ? 3 : 2;
  const double size =
      stream.uniform() < 0.7 ? 1.0 : std::ldexp(1.0, static_cast<int>(stream.integer(-40, 40)));
  const bool polytopes = stream.uniform() < 0.4;
  Body first = draw_body(stream, n, size, polytopes), second = draw_body(stream, n, size, polytopes);
  const Ball metric(Vector::Zero(n), 1.0);
  for (int i = 0; i < kPoses; ++i) {
    turn(stream, first);
    turn(stream, second);
    const Vector placed = place(stream, first, second);
    const Pose pose_1(first.R, first.t), pose_2(second.R, second.t);
    const bool cold = stream.uniform() < 0.5;
    const ObjectDistance& r = solver_.solve({*first.shape.set, pose_1}, {*second.shape.set, pose_2}, metric,
                                            ObjectEffects::depth, cold ? nullptr : &warm_);
    ++tally_.poses;
    if (r.depth.evaluations == 0) continue;
    ++tally_.depths;
    tally_.certified += r.depth.status == DistanceStatus::optimal ? 1 : 0;
    Real least = least_height(stream, first, second, placed, r.depth.normal);
    if (polytopes && n * first.points.cols() <= 21) {
      ++tally_.facets;
      least = std::min(least, depth_of_facets(first.placed(), second.placed(), n));
    }
    const Real error = kError * (first.size + second.size + second.t.norm());
    const std::string what = violation(r.depth, least, height(first, second, lifted(r.depth.normal)), error);
    if (what.empty()) continue;
    return first.shape.label + " and " + second.shape.label + " in R^" + std::to_string(n) + ", size " +
           shortest_text(size) + ", pair " + std::to_string(number) + ", pose " + std::to_string(i) + ": " +
           what;
  }
  return std::nullopt;
}

std::string to_string(const RandomDepthTally& tally) {
  return std::to_string(tally.poses) + " posed pairs, " + std::to_string(tally.depths) + " not apart, " +
         std::to_string(tally.certified) + " certified, " + std::to_string(tally.facets) +
         " against all facets\n";
}

}  // namespace raygauge::soak
