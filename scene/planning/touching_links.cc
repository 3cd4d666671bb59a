// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/planning/touching_links.h"

#include <algorithm>
#include <utility>

#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/point_set.h"
#include "scene/planning/edge_pair.h"
#include "scene/planning/joint_box.h"
#include "scene/queries/placed_pair.h"

namespace raygauge {
namespace {

constexpr EdgePair kPair{0, 1};

// Joints whose corners are looked at: more are not between two links in practice.
constexpr std::size_t kMostShifts = 6;

class Touching {
 public:
  Touching(const RobotModel& robot, const std::vector<JointRange>& ranges, double contact)
      : ranges_(ranges),
        contact_(contact),
        chain_(robot.tree, robot.joints, robot.base),
        bodies_(edge_bodies(robot, {}, chain_)),
        stage_(chain_, bodies_),
        tests_(chain_, bodies_, stage_),
        between_(robot.tree, chain_, bodies_[0].link, bodies_[1].link),
        placed_(3) {
    for (const JointRange& range : ranges_) q_.push_back(range.lower + (range.upper - range.lower) / 2);
    for (int i = 0; i + 1 < static_cast<int>(bodies_[0].shapes.size()); ++i)
      for (int j = 0; j + 1 < static_cast<int>(bodies_[1].shapes.size()); ++j) parts_.push_back({i, j});
  }

  bool at_all_corners() {
    const std::vector<int>& joints = between_.joints();
    if (joints.size() > kMostShifts) return false;
    for (unsigned corner = 0; corner < 1U << joints.size() && !parts_.empty(); ++corner) {
      for (std::size_t k = 0; k < joints.size(); ++k) {
        const auto joint = static_cast<std::size_t>(joints[k]);
        q_[joint] = (corner >> k & 1U) != 0 ? ranges_[joint].upper : ranges_[joint].lower;
      }
      stand();
      std::erase_if(parts_, [&](PartNumbers parts) { return !(upper(parts) + slack(parts) <= contact_); });
    }
    return !parts_.empty();
  }

  /// `link` turns, with the one joint between the bodies.
  bool on_axis(int link) {
    stand();
    return std::any_of(parts_.begin(), parts_.end(),
                       [&](PartNumbers parts) { return axis_is_near(link, parts); });
  }

  bool run() {
    if (!between_.turns()) return at_all_corners();
    return between_.only_turning_link() >= 0 && on_axis(between_.only_turning_link());
  }

 private:
  void stand() {
    stage_.clear();
    chain_.follow(q_, q_, 0, 1);
    stage_.add(0);
    stage_.place(0, bodies_[0], bodies_[1], placed_);
  }

  double slack(PartNumbers parts) const {
    return tests_.slack(kPair, static_cast<std::size_t>(parts.a) + 1, static_cast<std::size_t>(parts.b) + 1,
                        0);
  }

  double upper(PartNumbers parts) {
    return solver_.solve(placed_.a().posed(parts.a), placed_.b().posed(parts.b), placed_.unit_ball())
        .distance.upper;
  }

  /// The sum of the distances of a point from both parts is convex along the axis: its least value is closed
  /// in on by the golden section.
  bool axis_is_near(int link, PartNumbers parts) {
    constexpr double kGolden = 0.6180339887498949;
    constexpr int kSteps = 80;
    const Frame& line = stage_.link(0, link);
    const Eigen::Vector3d axis = line.R * between_.only_axis();
    const PlacementError& error = chain_.error(link);
    bool near = false;
    const auto value = [&](double s) {
      const PointSet point(Eigen::MatrixXd(line.t + s * axis));
      const double both =
          solver_.solve(placed_.a().posed(parts.a), point, placed_.unit_ball()).distance.upper +
          solver_.solve(placed_.b().posed(parts.b), point, placed_.unit_ball()).distance.upper;
      const double loss = slack(parts) + 2 * error.of_points(std::fabs(s));
      near = near || both + loss <= contact_;
      return both;
    };
    double high = (stage_.at(0, bodies_[0]).t - line.t).norm() + bodies_[0].body.reach, low = -high;
    double left = high - kGolden * (high - low), right = low + kGolden * (high - low);
    double at_left = value(left), at_right = value(right);
    for (int step = 0; step < kSteps && !near; ++step) {
      if (at_left <= at_right) {
        high = std::exchange(right, left);
        at_right = at_left;
        left = high - kGolden * (high - low);
        at_left = value(left);
      } else {
        low = std::exchange(left, right);
        at_left = at_right;
        right = low + kGolden * (high - low);
        at_right = value(right);
      }
    }
    return near;
  }

  const std::vector<JointRange>& ranges_;
  double contact_;
  RobotChain chain_;
  std::vector<EdgeBody> bodies_;
  EdgeStage stage_;
  EdgeTests tests_;
  JointsBetween between_;
  PlacedPair placed_;
  ObjectDistanceSolver solver_;
  std::vector<PartNumbers> parts_;
  std::vector<double> q_;
};

}  // namespace

bool touch_everywhere(const RobotModel& robot, const std::vector<JointRange>& ranges, double contact) {
  return Touching(robot, ranges, contact).run();
}

}  // namespace raygauge
