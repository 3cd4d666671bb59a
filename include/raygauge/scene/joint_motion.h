// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "raygauge/numerics/dense.h"
#include "raygauge/queries/gradient.h"
#include "raygauge/scene/motion.h"

namespace raygauge {

enum class JointKind : std::uint8_t { fixed, revolute, prismatic };

/// A link of a robot and the joint that it hangs on: its frame is that of the parent, moved by `origin`, then
/// turned about, or shifted along, `axis` by q = scale * (joint value) + offset.
struct TreeLink {
  int parent = -1;  ///< a link before this one; -1: the base
  Placement origin;
  JointKind kind = JointKind::fixed;
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  ///< of unit length
  int joint = -1;                                   ///< whose value it is; -1 of a fixed one
  double scale = 1;                                 ///< of a joint that mimics another
  double offset = 0;
};

/// The links of a robot, parents first.
struct KinematicTree {
  std::vector<TreeLink> links;
};

/// Joint values over time, linear between the times.
struct JointTrajectory {
  std::vector<double> times;  ///< rising
  DenseMatrix values;         ///< one row a joint, one column a time
};

/// The motion of one link of a robot whose joints follow a trajectory (forward kinematics).
class LinkMotion final : public Motion {
 public:
  /// Throws InvalidParameterError for a link that does not exist, a parent after its child, an axis not of
  /// unit length, fewer than two times, times that do not rise, or a joint without values. Also throws
  /// NonFiniteError, or what make_placement throws of an origin. `above`: a link that this one hangs on, in
  /// whose frame it is then seen, moved by `base`; -1: in that of the scene.
  LinkMotion(std::shared_ptr<const KinematicTree> tree, std::shared_ptr<const JointTrajectory> trajectory,
             Placement base, int link, int above = -1);

  /// The same motion, or one that stands still where no joint of it ever moves.
  static MotionPointer make(std::shared_ptr<const KinematicTree> tree,
                            std::shared_ptr<const JointTrajectory> trajectory, Placement base, int link,
                            int above = -1);

  /// The last link that carries both, possibly one of the two; -1 where there is none, or where they are not
  /// links of one robot.
  static int common_link(const LinkMotion& one, const LinkMotion& other);

  /// The motion of this link in the frame of the link `above`, which carries it.
  MotionPointer seen_from(int above) const;

  /// The twists of the link at t, about its own origin, per unit rate of each joint: see joint_twists().
  std::vector<Twist> joint_twists(double t) const;

  /// The motion of another link of the same robot.
  MotionPointer of_link(int link) const;

 private:
  /// The joints between the base and the link, the base's first, where they are at one moment.
  struct Chain {
    std::vector<Placement> frames;      ///< of each link
    std::vector<Eigen::Vector3d> axes;  ///< in the space of the scene
  };

  void take_path(int link, int above);
  void check() const;
  void measure();
  bool moves() const;
  std::size_t piece_of(double t) const;
  double value(const TreeLink& link, double t) const;
  double largest_value(const TreeLink& link) const;
  double rate(const TreeLink& link, std::size_t piece) const;
  double fastest(std::size_t piece) const;
  Chain chain_at(double t) const;
  Placement do_at(double t) const override;
  MotionBound do_bound(double from, double to) const override;
  PlacementError do_error_at(double) const override { return error_; }
  double do_next_break(double t) const override;
  bool do_is_static() const noexcept override { return false; }

  std::shared_ptr<const KinematicTree> tree_;
  std::shared_ptr<const JointTrajectory> trajectory_;
  Placement base_;
  std::vector<int> numbers_;    ///< of the links from the base to the link itself
  std::vector<TreeLink> path_;  ///< these
  std::vector<double> reach_;   ///< of each: no farther is the link's origin from that joint's, ever
  PlacementError error_;        ///< at any time
};

/// Two bodies seen from a third one that carries both: carrier(t) a(t) and carrier(t) b(t) are where they
/// are.
struct SharedRide {
  MotionPointer carrier, a, b;
};

/// The carrier of two links of one robot that a moving link carries; nothing for other motions.
std::optional<SharedRide> shared_ride(const Motion& a, const Motion& b);

// Derivatives along the joints of a robot: those by pose (PoseGradient) times the twists of the bodies.

/// The twists of a body on a link, one for each joint: how it moves while the value of that joint rises by 1
/// per second and the others stay. With o the body's origin, a the axis of a joint in the world and p a point
/// on it,
///
///     revolute: (a × (o - p), a),      prismatic: (a, 0),
///
/// times `scale` of a joint that mimics another; 0 of joints that do not carry the link. `base`: where the
/// robot stands; `origin`: where the frame of the body is on the link. Throws what LinkMotion throws.
std::vector<Twist> joint_twists(const std::shared_ptr<const KinematicTree>& tree, std::span<const double> q,
                                int link, const Placement& base = Placement::identity(3),
                                const Placement& origin = Placement::identity(3));

/// d/dq: body_1 · twists_1[j] + body_2 · twists_2[j] for each joint j, where the poses of the answer are
/// those at q. A body that is not on the robot has no twists: an empty span. Where the gradient is not
/// unique, one of them; of GradientKind::none nothing. Throws DimensionMismatchError for different numbers of
/// twists.
Vector joint_gradient(const PoseGradient& gradient, std::span<const Twist> twists_1,
                      std::span<const Twist> twists_2);

/// PoseGradient::along() while the joints move at the rates dq: also where the gradient is not unique. Throws
/// DimensionMismatchError unless there is a rate for each twist.
double derivative_along_joints(const PoseGradient& gradient, std::span<const Twist> twists_1,
                               std::span<const Twist> twists_2, std::span<const double> dq);

}  // namespace raygauge
