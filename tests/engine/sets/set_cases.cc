// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "tests/engine/sets/set_cases.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/convex_set.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/p_norm_ball.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/polytopes.h"
#include "raygauge/sets/truncated_cone.h"
#include "tests/linear_algebra.h"

namespace raygauge {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double uniform(double from, double to, Random& random) {
  return std::uniform_real_distribution<double>(from, to)(random);
}

Vector gaussian(int n, Random& random) { return gaussian_points(n, 1, random); }
Vector on_sphere(int n, Random& random) { return sphere_points(n, 1, random); }

double p_norm(const Vector& x, double p) {
  const double largest = x.cwiseAbs().maxCoeff();
  if (largest == 0 || p == kInfinity) return largest;
  return largest * std::pow((x.cwiseAbs() / largest).array().pow(p).sum(), 1 / p);
}

SetCase ball(int n, double radius, Random& random) {
  const Vector c = gaussian(n, random);
  return {"ball", std::make_shared<Ball>(c, radius),
          [=](Random& r) -> Vector { return c + radius * on_sphere(n, r); },
          [=](const Vector& x) { return (x - c).norm() - radius; }};
}

SetCase ellipsoid(int n, Random& random) {
  const Vector c = gaussian(n, random);
  const Eigen::MatrixXd L = gaussian_points(n, n, random) + 2 * Eigen::MatrixXd::Identity(n, n);
  return {"ellipsoid", std::make_shared<Ellipsoid>(c, L),
          [=](Random& r) -> Vector { return c + L * on_sphere(n, r); },
          [=](const Vector& x) { return solution(L, x - c).norm() - 1; }};
}

SetCase flat_ellipsoid(int n, Random& random) {
  const Vector c = gaussian(n, random), a = gaussian(n, random);
  return {"flat_ellipsoid", std::make_shared<Ellipsoid>(c, a),
          [=](Random& r) -> Vector { return c + uniform(-1, 1, r) * a; },
          [=](const Vector& x) {
            const double t = std::clamp(a.dot(x - c) / a.squaredNorm(), -1.0, 1.0);
            return (x - c - t * a).norm();
          }};
}

SetCase box(int n, bool flat, Random& random) {
  const Vector c = gaussian(n, random);
  Vector h = gaussian(n, random).cwiseAbs();
  if (flat) h[n - 1] = 0;
  const Vector lower = c - h, upper = c + h;
  return {"box", std::make_shared<Box>(lower, upper),
          [=](Random& r) -> Vector {
            return lower +
                   (upper - lower).cwiseProduct(Vector::NullaryExpr(n, [&] { return uniform(0, 1, r); }));
          },
          [=](const Vector& x) { return std::max((lower - x).maxCoeff(), (x - upper).maxCoeff()); }};
}

SetCase simplex(int n, Random& random) {
  const Vector o = gaussian(n, random), a = gaussian(n, random);
  return {"simplex", std::make_shared<Simplex>(o, a),
          [=](Random& r) -> Vector {
            Vector weights = gaussian(n + 1, r).cwiseAbs();
            weights /= weights.sum();
            return o + a.cwiseProduct(weights.head(n));
          },
          [=](const Vector& x) {
            const Vector weights = (x - o).cwiseQuotient(a);
            return std::max(weights.sum() - 1, -weights.minCoeff());
          }};
}

// The distance of x to the segment from p to q, and the share of q in the nearest point.
double segment_distance(const Vector& x, const Vector& p, const Vector& q) {
  const Vector edge = q - p;
  const double length = edge.squaredNorm();
  const double t = length > 0 ? std::clamp(edge.dot(x - p) / length, 0.0, 1.0) : 0.0;
  return (x - p - t * edge).norm();
}

SetCase capsule(const std::string& name, int n, double length, double radius, Random& random) {
  const Vector p = gaussian(n, random);
  const Vector q = p + length * on_sphere(n, random);
  return {name, std::make_shared<Capsule>(p, q, radius),
          [=](Random& r) -> Vector { return p + uniform(0, 1, r) * (q - p) + radius * on_sphere(n, r); },
          [=](const Vector& x) { return segment_distance(x, p, q) - radius; }};
}

// A body of revolution about the segment from p to q whose radius goes from r_p to r_q along it.
SetCase frustum(const std::string& name, const std::shared_ptr<const ConvexSet>& set, const Vector& p,
                const Vector& q, double r_p, double r_q) {
  const Vector a = (q - p).normalized();
  const double length = (q - p).norm();
  return {name, set,
          [=](Random& r) -> Vector {
            const double t = uniform(0, 1, r);
            Vector v = gaussian(static_cast<int>(p.size()), r);
            v -= a.dot(v) * a;
            if (p.size() > 1) v.normalize();
            return p + t * (q - p) + ((1 - t) * r_p + t * r_q) * v;
          },
          [=](const Vector& x) {
            const double z = a.dot(x - p);
            const double rho = (x - p - z * a).norm();
            return std::max({-z, z - length, rho - r_p - (r_q - r_p) * z / length});
          }};
}

SetCase truncated_cone(const std::string& name, int n, double r_b, double r_t, Random& random) {
  const Vector p = gaussian(n, random), q = p + 2 * on_sphere(n, random);
  return frustum(name, std::make_shared<TruncatedCone>(p, r_b, q, r_t), p, q, r_b, r_t);
}

SetCase cylinder(int n, Random& random) {
  const Vector p = gaussian(n, random), q = p + 2 * on_sphere(n, random);
  return frustum("cylinder", std::make_shared<Cylinder>(p, q, 0.7), p, q, 0.7, 0.7);
}

SetCase p_norm_ball(int n, double p, Random& random) {
  const Vector c = gaussian(n, random);
  const Vector w = gaussian(n, random).cwiseAbs() + Vector::Constant(n, 0.1);
  std::string name = p == kInfinity ? "p_norm_ball_infinity" : "p_norm_ball_" + std::to_string(p);
  std::replace(name.begin(), name.end(), '.', '_');
  return {name, std::make_shared<PNormBall>(c, w, p),
          [=](Random& r) -> Vector {
            const Vector z = gaussian(n, r);
            return c + w.cwiseProduct(z / p_norm(z, p));
          },
          [=](const Vector& x) { return p_norm((x - c).cwiseQuotient(w), p) - 1; }};
}

SetCase affine_image(int n, Random& random) {
  const SetCase inner = truncated_cone("", n, 1, 0.5, random);
  const Eigen::MatrixXd M = gaussian_points(n, n, random) + 2 * Eigen::MatrixXd::Identity(n, n);
  const Vector t = gaussian(n, random);
  return {"affine_image", std::make_shared<AffineImage>(inner.set, M, t),
          [=](Random& r) -> Vector { return M * inner.sample(r) + t; },
          [=](const Vector& x) { return inner.excess(solution(M, x - t)); }};
}

SetCase rigid_image(int n, Random& random) {
  const SetCase inner = box(n, false, random);
  const Eigen::MatrixXd R = random_rotation(n, random);
  const Vector t = gaussian(n, random);
  return {"rigid_image", AffineImage::rigid(inner.set, R, t),
          [=](Random& r) -> Vector { return R * inner.sample(r) + t; },
          [=](const Vector& x) { return inner.excess(R.transpose() * (x - t)); }};
}

// A box and a ball: {x : the distance of x to the box is <= r}.
SetCase rounded_box(bool difference, int n, Random& random) {
  const SetCase core = box(n, false, random);
  const auto& corners = dynamic_cast<const Box&>(*core.set);
  const Vector lower = corners.lower(), upper = corners.upper(), c = gaussian(n, random);
  const double sign = difference ? -1 : 1;
  const auto other = std::make_shared<Ball>(c, 0.5);
  std::shared_ptr<const ConvexSet> set;
  if (difference) {
    set = std::make_shared<MinkowskiDifference>(core.set, other);
  } else {
    set = std::make_shared<MinkowskiSum>(core.set, other);
  }
  return {difference ? "minkowski_difference" : "minkowski_sum", set,
          [=](Random& r) -> Vector { return core.sample(r) + sign * c + 0.5 * on_sphere(n, r); },
          [=](const Vector& x) {
            const Vector y = x - sign * c;
            return (y - y.cwiseMax(lower).cwiseMin(upper)).norm() - 0.5;
          }};
}

// Two balls of one radius: a capsule.
SetCase union_hull(int n, Random& random) {
  const Vector p = gaussian(n, random), q = gaussian(n, random);
  const std::vector<std::shared_ptr<const ConvexSet>> ends = {std::make_shared<Ball>(p, 0.5),
                                                              std::make_shared<Ball>(q, 0.5)};
  return {"union_hull", std::make_shared<UnionHull>(ends),
          [=](Random& r) -> Vector { return p + uniform(0, 1, r) * (q - p) + 0.5 * on_sphere(n, r); },
          [=](const Vector& x) { return segment_distance(x, p, q) - 0.5; }};
}

// The simplex and the parallelepiped-like bodies of 2n + 3 planes that all touch a ball, off the origin.
SetCase h_polytope(int n, Random& random) {
  const Vector c = gaussian(n, random);
  Eigen::MatrixXd G(2 * n + 3, n);
  G << Eigen::MatrixXd::Identity(n, n), -Eigen::MatrixXd::Identity(n, n),
      gaussian_points(n, 3, random).transpose();
  const Vector g = G * c + G.rowwise().norm();
  return {"h_polytope", std::make_shared<HPolytope>(G, g),
          [=](Random& r) -> Vector {
            const Vector direction = on_sphere(n, r);
            return c + direction / (G * direction).cwiseQuotient(G.rowwise().norm()).maxCoeff();
          },
          [=](const Vector& x) { return ((G * x - g).array() / G.rowwise().norm().array()).maxCoeff(); }};
}

// n generators, so that the coefficients of a point are unique.
SetCase zonotope(int n, Random& random) {
  const Vector c = gaussian(n, random);
  const Eigen::MatrixXd G = gaussian_points(n, n, random) + 2 * Eigen::MatrixXd::Identity(n, n);
  return {"zonotope", std::make_shared<Zonotope>(c, G),
          [=](Random& r) -> Vector {
            const Vector direction = on_sphere(n, r);
            return c + G * direction / direction.lpNorm<Eigen::Infinity>();
          },
          [=](const Vector& x) { return solution(G, x - c).lpNorm<Eigen::Infinity>() - 1; }};
}

SetCase own_mapping(int n, Random& random) {
  const Vector c = gaussian(n, random);
  const auto mapping = [c](const double* u, double* point) {
    const Vector direction = Vector::Map(u, c.size()).stableNormalized();
    Vector::Map(point, c.size()) = c + direction;
  };
  return {"support_mapping_set", std::make_shared<SupportMappingSet>(c, mapping),
          [=](Random& r) -> Vector { return c + on_sphere(n, r); },
          [=](const Vector& x) { return (x - c).norm() - 1; }};
}

}  // namespace

Eigen::MatrixXd random_rotation(int n, Random& random) {
  Eigen::MatrixXd R = orthogonal_factor(gaussian_points(n, n, random));
  if (determinant(R) < 0) R.col(0) *= -1;
  return R;
}

std::vector<SetCase> set_cases() {
  Random random(4);
  std::vector<SetCase> all;
  for (const int n : {1, 2, 3, 5, 10}) {
    const std::vector<SetCase> sets = {ball(n, 1.5, random),
                                       ellipsoid(n, random),
                                       flat_ellipsoid(n, random),
                                       box(n, false, random),
                                       simplex(n, random),
                                       h_polytope(n, random),
                                       zonotope(n, random),
                                       capsule("capsule", n, 2, 0.5, random),
                                       capsule("capsule_radius_is_half_length", n, 2, 1, random),
                                       capsule("capsule_without_length", n, 0, 1, random),
                                       capsule("segment", n, 2, 0, random),
                                       truncated_cone("truncated_cone", n, 1, 0.4, random),
                                       truncated_cone("inverted_cone", n, 0.2, 1, random),
                                       truncated_cone("cone", n, 1, 0, random),
                                       truncated_cone("cone_as_cylinder", n, 1, 1, random),
                                       cylinder(n, random),
                                       p_norm_ball(n, 1, random),
                                       p_norm_ball(n, 1.000001, random),
                                       p_norm_ball(n, 1.5, random),
                                       p_norm_ball(n, 2, random),
                                       p_norm_ball(n, 3, random),
                                       p_norm_ball(n, 1e6, random),
                                       p_norm_ball(n, kInfinity, random),
                                       affine_image(n, random),
                                       rigid_image(n, random),
                                       rounded_box(false, n, random),
                                       rounded_box(true, n, random),
                                       union_hull(n, random),
                                       own_mapping(n, random)};
    for (SetCase tested : sets) {
      tested.name += "_n" + std::to_string(n);
      all.push_back(tested);
    }
  }
  SetCase point = ball(3, 0, random), plate = box(3, true, random);
  point.name = "ball_without_radius";
  plate.name = "flat_box";
  all.push_back(point);
  all.push_back(plate);
  return all;
}

}  // namespace raygauge
