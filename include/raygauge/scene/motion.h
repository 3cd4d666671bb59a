// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "raygauge/numerics/dense.h"
#include "raygauge/queries/gradient.h"
#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// The most dimensions a scene may have: 2 and 3 for bodies that move, 6 for wrenches.
inline constexpr int kMostSceneDimensions = 6;

/// Vectors and matrices of at most six rows, which need no heap.
using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostSceneDimensions, 1>;
using SmallMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostSceneDimensions, kMostSceneDimensions>;

/// x ↦ R x + t: where a body stands, R its rotation and t the place of its origin.
struct Placement {
  SmallMatrix R;
  SmallVector t;
  double defect = kUnchecked;  ///< Pose::defect of a pose with this R and t, where one was made

  static constexpr double kUnchecked = -1;

  static Placement identity(int n);

  int dimension() const noexcept { return static_cast<int>(t.size()); }

  /// R u, and Rᵀ u.
  SmallVector turned(const SmallVector& u) const;
  SmallVector turned_back(const SmallVector& u) const;

  /// The placement that applies first `inner`, then this.
  Placement operator*(const Placement& inner) const;
};

/// The placement with this R and t, R replaced by nearest_rotation() and made orthonormal. Throws
/// DimensionMismatchError, NonFiniteError, or InvalidParameterError where nearest_rotation() does.
Placement make_placement(const Eigen::Ref<const Eigen::MatrixXd>& R, const ConstVectorRef& t);

/// The rotation of 3-space by |r| radians about r.
SmallMatrix rotation_about(const Eigen::Vector3d& r);

/// The rotation of the plane by `angle` radians.
SmallMatrix plane_rotation(double angle);

/// What is proven of a motion over an interval of time: at every moment of it
///
///     |velocity of the body's origin - velocity| <= velocity_error,
///     |angular velocity - spin| <= spin_error        (in the plane spin = (0, 0, ω)),
///
/// `velocity` and `spin` themselves being rounded by at most 1e-14 of their lengths. Both errors are
/// +infinity where nothing is proven; no number here is NaN.
struct MotionBound {
  SmallVector velocity;
  double velocity_error = 0;
  Eigen::Vector3d spin = Eigen::Vector3d::Zero();
  double spin_error = 0;

  /// The bound of a motion of which nothing is known: both errors are infinite.
  static MotionBound unknown(int n);

  /// An upper bound on u·velocity over all points within `reach` of the origin, rounded up; negative if all
  /// of them move against u.
  double speed_along(const SmallVector& u, double reach) const;

  /// velocity + spin × arm, the velocity of the point at `arm` from the body's origin, up to the errors.
  SmallVector velocity_of(const SmallVector& arm) const;

  /// |spin × u|: how fast u turns in the frame of the body, up to the error.
  double turning(const SmallVector& u) const;

  /// An upper bound on the speed of such points in any direction, rounded up.
  double speed(double reach) const;
};

/// How far the placement that a motion computes may be from that of the exact motion:
///
///     |t' - t| <= place,      ‖R' - R‖ <= turn  in the spectral norm.
///
/// The error is a sum over the terms of which the placement is computed, never a share of the result: terms
/// cancel where a body comes to rest or a chain of links folds back. +infinity where nothing is proven, never
/// NaN.
struct PlacementError {
  double place = 0;
  double turn = 0;

  /// A bound on the error of all points within `reach` of the body's origin.
  double of_points(double reach) const { return turn > 0 ? place + turn * reach : place; }
};

/// t ↦ placement of a body, continuous. Immutable; shared between bodies and threads.
class Motion {
 public:
  virtual ~Motion() = default;
  Motion(const Motion&) = delete;
  Motion& operator=(const Motion&) = delete;

  int dimension() const noexcept { return dimension_; }

  /// The interval of times for which the motion is known.
  double start() const noexcept { return start_; }
  double stop() const noexcept { return stop_; }

  /// The placement at t. Throws InvalidParameterError outside [start, stop].
  Placement at(double t) const;

  /// Bounds that hold over [from, to], which must lie within one piece: no break in its interior.
  MotionBound bound(double from, double to) const;

  /// A bound on the error of at(t).
  PlacementError error_at(double t) const;

  /// Whether it is proven that the body keeps its rotation over [from, to].
  bool keeps_rotation(double from, double to) const;

  /// The end of the piece that begins at, or holds, t: where velocities may jump. +infinity after the last.
  double next_break(double t) const { return do_next_break(t); }

  /// True where the body never moves.
  bool is_static() const noexcept { return do_is_static(); }

 protected:
  explicit Motion(int dimension, double start = -std::numeric_limits<double>::infinity(),
                  double stop = std::numeric_limits<double>::infinity())
      : dimension_(dimension), start_(start), stop_(stop) {}

 private:
  virtual Placement do_at(double t) const = 0;
  virtual MotionBound do_bound(double from, double to) const = 0;
  virtual PlacementError do_error_at(double t) const = 0;
  virtual double do_next_break(double t) const;
  virtual bool do_is_static() const noexcept { return false; }

  int dimension_;
  double start_;
  double stop_;
};

using MotionPointer = std::shared_ptr<const Motion>;

/// A body that stands still.
class StaticMotion final : public Motion {
 public:
  explicit StaticMotion(Placement where) : Motion(where.dimension()), where_(std::move(where)) {}

 private:
  Placement do_at(double) const override { return where_; }
  MotionBound do_bound(double, double) const override;
  PlacementError do_error_at(double) const override { return {}; }
  bool do_is_static() const noexcept override { return true; }

  Placement where_;
};

/// Placements at given times; between two of them the origin moves along the straight line at constant speed,
/// and the body turns about a fixed axis at constant speed, the shorter way (slerp).
class KeyframeMotion final : public Motion {
 public:
  /// Times must rise and be finite, two of them at least; rotations in 2 and 3 dimensions only. Throws
  /// InvalidParameterError, NonFiniteError or DimensionMismatchError.
  KeyframeMotion(std::vector<double> times, std::vector<Placement> frames);

 private:
  void add_piece(const Placement& first, const Placement& last);
  std::size_t piece_of(double t) const;
  Placement do_at(double t) const override;
  MotionBound do_bound(double from, double to) const override;
  PlacementError do_error_at(double t) const override { return errors_[piece_of(t)]; }
  double do_next_break(double t) const override;

  std::vector<double> times_;
  std::vector<Placement> frames_;
  std::vector<Eigen::Vector3d> turns_;  ///< of each piece, the rotation vector in the space of the scene
  std::vector<PlacementError> errors_;  ///< of each piece
};

/// A body that turns at a constant angular velocity ω (in the plane (0, 0, ω)) while its origin moves with
/// velocity v + a (t - t0): uniform motion, and a free fall. t0 is `start`.
class TwistMotion final : public Motion {
 public:
  struct Rates {
    SmallVector velocity;
    SmallVector acceleration;
    Eigen::Vector3d spin = Eigen::Vector3d::Zero();
  };

  /// Throws InvalidParameterError (spin in the plane not along the third axis, spin above 3 dimensions, start
  /// not finite), DimensionMismatchError or NonFiniteError.
  TwistMotion(Placement first, Rates rates, double start,
              double stop = std::numeric_limits<double>::infinity());

 private:
  Placement do_at(double t) const override;
  MotionBound do_bound(double from, double to) const override;
  PlacementError do_error_at(double t) const override;

  Placement first_;
  Rates rates_;
  enum class Path : std::uint8_t { none, straight, curved } path_ = Path::none;  ///< of the origin
};

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
