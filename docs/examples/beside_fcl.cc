// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// A program that asks FCL and libccd, and what its calls become with raygauge. It ends with status 0 if both
// answer the same. docs/beside.md.
#include <ccd/ccd.h>
#include <ccd/vec3.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/narrowphase/distance.h>
#include <raygauge/raygauge.h>

#include <cmath>
#include <cstdio>

namespace {

using Eigen::Vector3d;

// [bodies] FCL, Coal and Drake give full sides and lengths, MuJoCo halves; all centre their bodies.
raygauge::Box box_of_sides(const Vector3d& sides) { return {-sides / 2, sides / 2}; }
raygauge::Box box_of_half_sides(const Vector3d& halves) { return {-halves, halves}; }
raygauge::Capsule capsule_along_z(double radius, double length) {
  return {Vector3d(0, 0, -length / 2), Vector3d(0, 0, length / 2), radius};
}
// [bodies end]

Eigen::Isometry3d at(double x, double angle) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translate(Vector3d(x, 0.2, -0.1));
  pose.rotate(Eigen::AngleAxisd(angle, Vector3d(1, 2, 3).normalized()));
  return pose;
}

// [fcl]
double by_fcl(const Eigen::Isometry3d& tf1, const Eigen::Isometry3d& tf2) {
  const fcl::Boxd box(1, 2, 3);
  const fcl::Capsuled capsule(0.25, 2);
  fcl::DistanceRequestd request;
  request.enable_nearest_points = true;
  fcl::DistanceResultd result;
  return fcl::distance(&box, tf1, &capsule, tf2, request, result);  // -1 where they meet
}
// [fcl end]

// [raygauge]
double by_raygauge(const Eigen::Isometry3d& tf1, const Eigen::Isometry3d& tf2) {
  const raygauge::Box box = box_of_sides({1, 2, 3});
  const raygauge::Capsule capsule = capsule_along_z(0.25, 2);
  const raygauge::Ball metric(Vector3d::Zero(), 1);  // Euclidean
  raygauge::ObjectDistanceSolver solver;             // keep it: it reuses its memory
  const raygauge::ObjectDistance& r =
      solver.solve({box, tf1}, {capsule, tf2}, metric,
                   raygauge::ObjectEffects::depth | raygauge::ObjectEffects::closest_points);
  return r.signed_distance();  // minus the depth where they meet; r.closest_point_1, r.distance.lower, ...
}
// [raygauge end]

// [libccd]
void support_of_box(const void* object, const ccd_vec3_t* u, ccd_vec3_t* point) {
  const double x = *static_cast<const double*>(object);  // the centre; sides 2
  ccdVec3Set(point, x + (u->v[0] > 0 ? 1 : -1), u->v[1] > 0 ? 1 : -1, u->v[2] > 0 ? 1 : -1);
}
void center_of_box(const void* object, ccd_vec3_t* center) {
  ccdVec3Set(center, *static_cast<const double*>(object), 0, 0);
}
double depth_by_libccd(double x1, double x2) {
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = ccd.support2 = support_of_box;
  ccd.center1 = ccd.center2 = center_of_box;
  ccd.max_iterations = 100;
  ccd.mpr_tolerance = 1e-9;
  ccd_real_t depth = 0;
  ccd_vec3_t direction, position;
  return ccdMPRPenetration(&x1, &x2, &ccd, &depth, &direction, &position) == 0 ? depth : -1;
}

// The support function stays; the set keeps it.
raygauge::SupportMappingSet same_box(double x) {
  return {Vector3d(x, 0, 0), [x](const double* u, double* point) {
            const ccd_vec3_t direction = {{u[0], u[1], u[2]}};
            ccd_vec3_t found;
            support_of_box(&x, &direction, &found);
            for (int k = 0; k < 3; ++k) point[k] = found.v[k];
          }};
}
double depth_by_raygauge(double x1, double x2) {
  raygauge::ObjectDistanceSolver solver;
  const raygauge::Ball metric(Vector3d::Zero(), 1);
  return solver.solve(same_box(x1), same_box(x2), metric, raygauge::ObjectEffects::depth).depth.depth;
}
// [libccd end]

bool same(const char* what, double theirs, double ours, double tolerance) {
  std::printf("%-24s theirs %.9f, raygauge %.9f\n", what, theirs, ours);
  return std::fabs(theirs - ours) <= tolerance;
}

}  // namespace

int main() {
  bool right = same("FCL, distance", by_fcl(at(0, 0.3), at(3, 1)), by_raygauge(at(0, 0.3), at(3, 1)), 1e-4);
  right &= by_fcl(at(0, 0.3), at(0.5, 1)) < 0 && by_raygauge(at(0, 0.3), at(0.5, 1)) < 0;
  right &= same("libccd, depth", depth_by_libccd(0, 1.5), depth_by_raygauge(0, 1.5), 1e-5);
  right &= box_of_half_sides({0.5, 1, 1.5}).upper() == box_of_sides({1, 2, 3}).upper();  // MuJoCo, FCL
  return right ? 0 : 1;
}
