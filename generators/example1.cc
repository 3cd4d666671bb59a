// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/example1.h"

#include <cmath>
#include <memory>

#include "generators/component.h"
#include "generators/random.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/truncated_cone.h"

namespace raygauge::example1 {
namespace {

constexpr const char* kName = "example1";
constexpr const char* kConeEllipsoid = "cone_ellipsoid";
constexpr const char* kEllipsoidCone = "ellipsoid_cone";
constexpr double kLeastSize = 0.5;
constexpr double kLargestSize = 1.5;

/// The bodies are built to touch, and the contact is rounded with them: twice the 2^-46 that
/// docs/generators.md states.
constexpr double kDistanceRounding = 0x1p-45;

double random_size(RandomStream& stream) {
  return kLeastSize + (kLargestSize - kLeastSize) * stream.uniform();
}

// Sums run in a fixed order, whatever instructions the machine has.
double dot(const double* x, const double* y, Eigen::Index n) {
  double sum = 0;
  for (Eigen::Index k = 0; k < n; ++k) sum += x[k] * y[k];
  return sum;
}

/// x + factor · y.
Vector plus(const Vector& x, double factor, const Vector& y) {
  Vector sum(x.size());
  for (Eigen::Index k = 0; k < x.size(); ++k) sum[k] = x[k] + factor * y[k];
  return sum;
}

Vector unit(const Vector& x) {
  const double length = std::sqrt(dot(x.data(), x.data(), x.size()));
  Vector result(x.size());
  for (Eigen::Index k = 0; k < x.size(); ++k) result[k] = x[k] / length;
  return result;
}

/// {L z : |z| <= 1}, about the origin.
Eigen::MatrixXd random_ellipsoid_factor(RandomStream& stream, int n) {
  Eigen::MatrixXd factor = stream.rotation(n);
  for (int j = 0; j < n; ++j) {
    const double semi_axis = random_size(stream);
    for (int k = 0; k < n; ++k) factor(k, j) *= semi_axis;
  }
  return factor;
}

/// s(u) = L z/|z|, z = Lᵀu.
Vector ellipsoid_point(const Eigen::MatrixXd& factor, const Vector& u) {
  const Eigen::Index n = u.size();
  Vector z(n), point = Vector::Zero(n);
  for (Eigen::Index j = 0; j < n; ++j) z[j] = dot(factor.col(j).data(), u.data(), n);
  z = unit(z);
  for (Eigen::Index j = 0; j < n; ++j) point = plus(point, z[j], factor.col(j));
  return point;
}

/// The cone about the middle of its axis: discs across `axis` at ∓height/2.
struct Cone {
  Vector axis;
  double height = 0;
  double base_radius = 0;
  double top_radius = 0;
};

Cone random_cone(RandomStream& stream, int n) {
  Cone cone;
  cone.base_radius = random_size(stream);
  cone.height = random_size(stream);
  cone.top_radius = cone.base_radius * stream.uniform();
  cone.axis = stream.unit_vector(n);
  return cone;
}

struct SurfacePoint {
  Vector point;
  Vector normal;  ///< outward
};

/// Where the ray from the cone's centre in the direction w (a unit vector) leaves it: through one of the
/// discs, or through the side |x_⊥| = (r_b + r_t)/2 - slope·(axis·x), slope = (r_b - r_t)/height.
SurfacePoint surface_point(const Cone& cone, const Vector& w) {
  const double along = dot(cone.axis.data(), w.data(), w.size());
  const Vector across = plus(w, -along, cone.axis);
  const double radial = std::sqrt(dot(across.data(), across.data(), across.size()));
  const double slope = (cone.base_radius - cone.top_radius) / cone.height;
  const double to_disc = cone.height / 2 / std::fabs(along);
  const double to_side = (cone.base_radius + cone.top_radius) / 2 / (radial + slope * along);
  const bool by_side = radial + slope * along > 0 && to_side < to_disc;
  const Vector origin = Vector::Zero(w.size());
  if (by_side) return {plus(origin, to_side, w), unit(plus(unit(across), slope, cone.axis))};
  return {plus(origin, to_disc, w), plus(origin, along > 0 ? 1.0 : -1.0, cone.axis)};
}

std::shared_ptr<ConvexSet> make_cone(const Vector& center, const Cone& cone, double scale) {
  const double half = scale * cone.height / 2;
  return std::make_shared<TruncatedCone>(plus(center, -half, cone.axis), scale * cone.base_radius,
                                         plus(center, half, cone.axis), scale * cone.top_radius);
}

std::shared_ptr<ConvexSet> make_ellipsoid(const Vector& center, Eigen::MatrixXd factor, double scale) {
  for (Eigen::Index i = 0; i < factor.size(); ++i) factor.data()[i] *= scale;
  return std::make_shared<Ellipsoid>(center, factor);
}

Instance generate(const InstanceKey& key, const Parameters& parameters) {
  RandomStream shapes(key, kName, RandomPurpose::shape);
  RandomStream placement(key, kName, RandomPurpose::placement);
  const Eigen::MatrixXd factor = random_ellipsoid_factor(shapes, key.n);
  const Cone cone = random_cone(shapes, key.n);
  const SurfacePoint contact = surface_point(cone, placement.unit_vector(key.n));
  const Vector origin = Vector::Zero(key.n);
  // From the cone's centre to the ellipsoid's.
  const Vector offset = plus(contact.point, -1, ellipsoid_point(factor, plus(origin, -1, contact.normal)));

  const double distance = real_parameter(parameters, "distance");
  const double scale = 1 / distance;
  if (string_parameter(parameters, "roles") == kConeEllipsoid) {
    return {make_cone(plus(origin, -1, offset), cone, 1), make_ellipsoid(origin, factor, scale), distance};
  }
  return {make_ellipsoid(offset, factor, 1), make_cone(origin, cone, scale), distance};
}

std::vector<ParameterInfo> parameters() {
  return {{"distance", 1.0, 1e-6, 1e6, "d_Q(A): 1 in contact, 2 separated, 0.5 penetrating", {}},
          {"roles",
           std::string(kConeEllipsoid),
           {},
           {},
           "which body is A, and which Q",
           {kConeEllipsoid, kEllipsoidCone}}};
}

}  // namespace
}  // namespace raygauge::example1

namespace raygauge {

Component<Generator> example1_generator() {
  return with_known_distance(
      generator_component(example1::kName,
                          "a truncated cone and an ellipsoid at a known distance (Example 1)",
                          example1::parameters(), example1::generate, 2),
      example1::kDistanceRounding);
}

}  // namespace raygauge
