// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// A convex body of R^3 as collision libraries have it: a shape about the origin of its own frame. Capsules,
/// cylinders and cones stand along z, centred between their ends; the tip of a cone is above.
struct RigidBody {
  enum class Kind : std::uint8_t { ball, capsule, box, ellipsoid, cylinder, cone, frustum, hull };

  Kind kind = Kind::ball;
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();  ///< its own frame in that of the set
  double radius = 0;                                        ///< of balls, capsules, cylinders and cones
  double top_radius =
      0;  ///< of discs above: the radius of a cylinder, 0 of a cone, less than `radius` of a frustum
  double height = 0;                               ///< between the ends of a segment, discs, disc and tip
  Eigen::Vector3d half = Eigen::Vector3d::Zero();  ///< half edges of a box, semi-axes of an ellipsoid
  std::vector<Eigen::Vector3d> vertices;           ///< of a hull ...
  std::vector<int> triangles;  ///< ... and its faces, three vertices each, seen from outside

  /// A point of the body, in the frame of the set, that is farthest along u, not 0.
  Eigen::Vector3d support(const Eigen::Vector3d& u) const;

  /// A point well inside, in the frame of the set.
  Eigen::Vector3d inner_point() const;

  /// The body of a set of R^3: a ball, capsule, box, ellipsoid, cylinder, cone with a tip, the hull of
  /// points, or a rigid image of one. Empty for other sets: truncated cones, flat hulls, sets that are
  /// combined, and all hulls where the engine is built without Qhull.
  /// Frusta::taken: truncated cones too, for libraries that have them.
  enum class Frusta : bool { refused, taken };
  static std::optional<RigidBody> of(const ConvexSet& S, Frusta frusta = Frusta::refused);
};

/// "balls, capsules, …": what RigidBody::of() takes, for messages.
inline constexpr const char* kRigidBodies =
    "balls, capsules, boxes, ellipsoids, cylinders, cones and hulls that are not flat, of R^3";

}  // namespace raygauge
