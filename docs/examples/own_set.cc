// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// A set of one's own needs its support mapping alone: a disc in space, as a class and as a function. The
// answer is known: the program ends with status 1 if it is off.
#include <raygauge/raygauge.h>

#include <cmath>
#include <cstdio>

namespace {

using Eigen::Vector3d;

/// The point of the disc that is farthest in direction u: centre + radius · (u without its part along the
/// normal). That part is taken out twice: where u is almost the normal, the first time leaves rounding
/// errors, and a support point has to be a point of the set.
Vector3d farthest(const Vector3d& centre, const Vector3d& normal, double radius, const Vector3d& u) {
  Vector3d in_plane = u - u.dot(normal) * normal;
  in_plane -= in_plane.dot(normal) * normal;
  const double length = in_plane.norm();
  if (length == 0) return centre;
  return centre + radius / length * in_plane;
}

/// {centre + x : x·normal = 0, |x| <= radius}, normal a unit vector.
class Disc final : public raygauge::ConvexSet {
 public:
  Disc(const Vector3d& centre, const Vector3d& normal, double radius)
      : ConvexSet(3), centre_(centre), normal_(normal), radius_(radius) {}

 private:
  /// Writes s(u), and returns h(u) = u·s(u). Called from several threads at once.
  double do_support(const double* u, double* point) const override {
    const Vector3d direction = Vector3d::Map(u);
    const Vector3d s = farthest(centre_, normal_, radius_, direction);
    Vector3d::Map(point) = s;
    return direction.dot(s);
  }
  /// A point deep inside.
  void do_center(double* point) const override { Vector3d::Map(point) = centre_; }

  Vector3d centre_;
  Vector3d normal_;
  double radius_;
};

}  // namespace

int main() {
  const Vector3d centre(3, 0, 0);
  const Vector3d normal = Vector3d(1, 0, 1).normalized();
  const double radius = 1;
  const raygauge::Ball Q(Vector3d::Zero(), 1.0);  // the Euclidean distance from the origin

  const Disc disc(centre, normal, radius);
  const raygauge::SupportMappingSet same(centre, [=](const double* u, double* point) {
    Vector3d::Map(point) = farthest(centre, normal, radius, Vector3d::Map(u));
  });

  raygauge::DistanceSolver solver;
  const double expected = std::sqrt(10 - 6 / std::sqrt(2.0));  // |centre + (-1, 0, 1)/√2|
  bool right = true;
  for (const raygauge::ConvexSet* A :
       {static_cast<const raygauge::ConvexSet*>(&disc), static_cast<const raygauge::ConvexSet*>(&same)}) {
    const raygauge::DistanceResult& r = solver.solve(*A, Q);
    std::printf("distance %.6f, certified to lie in [%.9f, %.9f]\n", r.distance, r.lower, r.upper);
    right &= std::abs(r.distance - expected) <= solver.options().tolerance * expected;
  }
  return right ? 0 : 1;
}
