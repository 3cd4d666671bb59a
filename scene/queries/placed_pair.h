// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>

#include "engine/queries/half_space_query.h"
#include "engine/queries/spatial_solve.h"
#include "engine/sets/posed_view.h"
#include "raygauge/scene/scene.h"
#include "raygauge/sets/pose.h"

namespace raygauge {

/// One convex part of each of two bodies, by number.
struct PartNumbers {
  int a = 0, b = 0;
};

/// A body where it stands, as solvers take it.
class PlacedBody {
 public:
  explicit PlacedBody(int dimension) : pose_(dimension) {}

  /// The body of what follows, which must outlive its use; and where it stands from now on.
  void bind(const Body& body) noexcept { body_ = &body; }
  void place(const Placement& at);

  const Body& body() const noexcept { return *body_; }
  const Placement& at() const noexcept { return at_; }
  const BodyPart& part(int number) const { return body_->parts[static_cast<std::size_t>(number)]; }
  const ConvexSet& set(int number) const { return *part(number).set; }

  /// Its placement as numbers, which are checked once a place: by check(); and a part of it in its pose.
  PoseNumbers numbers() const noexcept { return {at_.R.data(), at_.t.data(), at_.defect}; }
  void check();
  Posed posed(int number);

 private:
  const Body* body_ = nullptr;
  Placement at_;
  Pose pose_;  // the same, where posed_
  bool posed_ = false;
};

/// Two bodies where they stand and the metric between them, with the bounds on their distance that need no
/// solve.
class PlacedPair {
 public:
  explicit PlacedPair(int dimension);

  /// The pair and the metric of what follows; all must outlive their use.
  void bind(const Body& a, const Body& b, const SceneMetric& metric);

  /// Where they stand from now on. `metric_at` is the placement of the body that the metric follows, if any.
  void place(const Placement& a, const Placement& b, const Placement* metric_at);

  int dimension() const noexcept { return dimension_; }
  PlacedBody& a() noexcept { return a_; }
  PlacedBody& b() noexcept { return b_; }
  const PlacedBody& a() const noexcept { return a_; }
  const PlacedBody& b() const noexcept { return b_; }
  bool euclidean() const noexcept { return metric_->euclidean(); }

  /// The unit ball of the distance, where it stands.
  const ConvexSet& unit_ball() const noexcept { return euclidean() ? *ball_ : *Q_; }

  /// Whether one of the parts is a mesh, which no plane need touch.
  bool is_mesh(PartNumbers parts) const noexcept;

  /// Checks where they stand, unless that was done before: PlacedBody::numbers() may be taken then.
  void check_placements();

  /// A certified lower bound on the distance from the bounding balls of the whole bodies, whose middles are
  /// given; it falls by at most ball_rate() times the way of these.
  double ball_bound(const double* center_a, const double* center_b) const;
  double ball_rate() const noexcept { return 1 / outer_radius_; }

  /// The same for two parts where they stand, and for balls around some of the parts of each body.
  double part_ball_bound(PartNumbers parts) const;
  double bound_of_balls(const BoundingBall& ball_a, const BoundingBall& ball_b) const;

  /// A certified lower bound on the distance of two parts from planes across u; 0 where they prove nothing.
  /// Of a half-space from its own plane, whatever u is; of meshes there is none.
  double plane_bound(PartNumbers parts, const SmallVector& u);

  /// That bound falls by at most so much times the distance that points of both bodies move. Useless under a
  /// metric that follows a body.
  double plane_rate(const SmallVector& u) const;

  /// The Euclidean distance between two planes across the unit vector u that touch the bodies, body b on the
  /// side away from u: a lower bound on their distance, not above 0 where they may overlap. `arm_a` and
  /// `arm_b`: where the planes touch, from the origins of the bodies. For bodies of one part each.
  double apart_along(const SmallVector& u, SmallVector& arm_a, SmallVector& arm_b);

 private:
  double depth_along(PartNumbers parts, const SmallVector& u, SmallVector& point_a,
                     SmallVector& point_b) const;
  double apart_from_plane(const SmallVector& u, SmallVector& arm_a, SmallVector& arm_b);

  int dimension_;
  PlacedBody a_, b_;
  const SceneMetric* metric_ = nullptr;
  std::shared_ptr<const ConvexSet> ball_;
  bool bounded_ = true;        ///< neither body is a half-space
  HalfSpaceQuery half_space_;  ///< where one is
  Pose pose_Q_;
  std::optional<PosedView> Q_;
  double outer_radius_ = 1;  ///< of Q about the origin
  SmallVector magnitude_Q_;
};

}  // namespace raygauge
