// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "raygauge/scene/motion.h"
#include "raygauge/scene/scene.h"

namespace raygauge {

/// A rigid body on a link of a robot: one of its own shapes, or an object that it has grasped.
struct RobotBody {
  std::string name;
  int link = 0;
  std::vector<std::shared_ptr<const ConvexSet>> parts;  ///< in the frame of the body; also a MeshObject
  Placement origin = Placement::identity(3);            ///< where that frame is on the link
};

/// A robot as planners see it: links, the number of joint values of a configuration, and bodies.
struct RobotModel {
  KinematicTree tree;
  int joints = 0;
  Placement base = Placement::identity(3);
  std::vector<RobotBody> bodies;

  /// Pairs of bodies that are never tested, such as links that share a joint. A number from bodies.size() on
  /// is an obstacle: a grasped object may touch the table that it stands on.
  std::vector<std::pair<int, int>> ignored;
};

/// The pairs of bodies of one link, and of bodies whose links a joint joins, also over links without a body:
/// they touch by design. For a robot without grasped objects; the caller names the pairs of those.
std::vector<std::pair<int, int>> joined_bodies(const RobotModel& robot);

struct EdgeOptions {
  double margin = 0;                ///< free: every distance is more than this
  double contact = 1e-6;            ///< in contact: a distance is at most margin + contact
  std::int64_t max_looks = 20'000;  ///< pairs of parts solved for one edge; then it is undecided
  bool witness = false;             ///< of a contact: points and depth
};

enum class EdgeOutcome : std::uint8_t {
  free,       ///< no distance is ever `margin` or less, proven
  contact,    ///< at `time` a distance is at most margin + contact, proven
  undecided,  ///< neither is proven
};

/// The verdict about an edge, or about one configuration.
struct EdgeResult {
  EdgeOutcome outcome = EdgeOutcome::undecided;
  double time = std::numeric_limits<double>::quiet_NaN();  ///< of the contact, not always of the first one;
                                                           ///< undecided: near the undecided part
  int body_a = -1, body_b = -1;  ///< numbers: first the bodies of the robot, then the obstacles; -1: none
  int part_a = -1, part_b = -1;
  double lower = 0;  ///< of a contact: certified bounds on the distance of these parts
  double upper = std::numeric_limits<double>::infinity();

  /// Of a contact, where asked for: points of both parts, the closest ones, or those where the parts have to
  /// be pushed apart by `depth` (ObjectDepth), 0 where they do not overlap. Of a mesh or a cloud the points
  /// are those of its nearest piece, and `depth` is NaN where that overlaps.
  SmallVector point_a, point_b;
  double depth = std::numeric_limits<double>::quiet_NaN();

  std::int64_t looks = 0;        ///< pairs of parts solved
  std::int64_t plane_tests = 0;  ///< planes kept, and trees of meshes, tested over a time
  std::int64_t ball_tests = 0;   ///< pairs of bounding balls tested over a time
};

/// Proves that a robot moves without contact along a straight line of its joint space, or finds a contact.
///
/// Every point of a link follows a curve p(t), t in [t0, t1], T = t1 - t0, with
///
///     |p''| <= C = Σ_j |q̇_j| (|q̇_j| ρ_j + 2 Σ_(k>j) |q̇_k| ρ_k),      |p'| <= V = Σ_j |q̇_j| ρ_j,
///
/// the sums over the joints that carry it, from the base on; ρ_j is its greatest distance from joint j (1 for
/// a prismatic joint, which in C only counts as a k). So it stays within min(C T²/8, V T/2) of the chord
/// between its places at t0 and t1. Hence two bodies that planes across one u set apart by g0 at t0 and by g1
/// at t1 are apart in between, where (1-s) g0 + s g1 is more than 4 s (1-s) times the bounds of both.
/// Bounding balls are tested in the same way, over the whole edge first; then distances are solved in the
/// middle of intervals that are halved. A contact is proven by a distance at one time. Pairs of one robot are
/// seen from the last link that carries both. Of meshes and clouds, of links and of obstacles, that is proven
/// of boxes about many triangles or balls at once, then of single ones.
///
/// What is kept from one edge to the next (planes, warm starts, the pair in contact) saves time; every proof
/// is made anew. Where there are several contacts, which of them is found may depend on it. Use one checker
/// for each thread; a repeated edge() or configuration() allocates nothing if the motions of obstacles do
/// not.
class EdgeChecker {
 public:
  /// Obstacles stand or move (any Motion of R^3); pairs of obstacles are not tested. Throws
  /// InvalidParameterError for a link, a joint or a body that does not exist and for options out of range,
  /// what make_body() throws of parts, and DimensionMismatchError for bodies not of R^3.
  EdgeChecker(const RobotModel& robot, const std::vector<Body>& obstacles, const EdgeOptions& options = {});
  ~EdgeChecker();
  EdgeChecker(EdgeChecker&&) noexcept;
  EdgeChecker& operator=(EdgeChecker&&) noexcept;

  /// The line from q0 at time `from` to q1 at time `to`, while obstacles move as they do. Throws
  /// DimensionMismatchError, NonFiniteError, or InvalidParameterError unless from < to are times of all
  /// obstacles. The result lives until the next call.
  const EdgeResult& edge(std::span<const double> q0, std::span<const double> q1, double from = 0,
                         double to = 1);

  /// The same of one configuration at one time.
  const EdgeResult& configuration(std::span<const double> q, double time = 0);

  /// The edges of a path, one after the other up to the first that is not free: its verdict, or `free`. A
  /// path of one time is the configuration at that time. Throws what edge() throws, and InvalidParameterError
  /// for a trajectory without a time or with another number of columns.
  const EdgeResult& path(const JointTrajectory& trajectory);

  /// Forgets what is kept: the next answer has the bits that a new checker gives.
  void forget();

  int joints() const noexcept;
  int bodies() const noexcept;  ///< of the robot and obstacles

  /// The name of body i, numbered as in EdgeResult.
  const std::string& name(int i) const;

  const EdgeOptions& options() const noexcept;

 private:
  std::unique_ptr<class EdgeSearch> search_;
};

}  // namespace raygauge
