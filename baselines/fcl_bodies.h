// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <string>

#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// A convex body as FCL, the Flexible Collision Library, has it: made once, shared by queries.
class FclBody {
 public:
  /// The body of a set that RigidBody::of() takes; empty for others.
  static std::optional<FclBody> of(const ConvexSet& S);

 private:
  friend class FclQuery;
  struct Shape;
  explicit FclBody(std::shared_ptr<const Shape> shape) : shape_(std::move(shape)) {}
  std::shared_ptr<const Shape> shape_;
};

/// FCL's two narrow-phase solvers: libccd's GJK and EPA, and its own.
enum class FclSolver : std::uint8_t { libccd, indep };

/// Queries of one pair, called as FCL's users call them. A call may throw what FCL throws (std::exception).
class FclQuery {
 public:
  /// `tolerance` is what FCL's iterations stop at; its own default is 1e-6.
  FclQuery(FclBody first, FclBody second, FclSolver solver, double tolerance = 1e-6);
  ~FclQuery();
  FclQuery(FclQuery&&) noexcept;

  /// Where the bodies stand in the queries that follow.
  void place(const Eigen::Isometry3d& first, const Eigen::Isometry3d& second);

  /// The distance that FCL answers: zero or less where it finds the bodies to meet.
  double distance(bool closest_points);

  /// Of the last distance with closest points: from the one on the first body to the one on the second.
  Eigen::Vector3d between_closest_points() const;

  bool collide();

  /// The depth of the one contact that FCL answers with; 0 where it finds the bodies apart.
  double penetration();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// "0.7.0", of the library that is linked.
std::string fcl_library_version();

}  // namespace raygauge
