// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/scene/motion.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "raygauge/exceptions.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/ellipsoid.h"

namespace raygauge::test_joint_gradient {
namespace {

using V = Eigen::Vector3d;
constexpr auto kWanted = ObjectEffects::depth | ObjectEffects::pose_gradient;
constexpr double kStep = 1e-5, kRounding = 1e-9;

const Ball& euclidean() {
  static const Ball kBall(Vector::Zero(3), 1.0);
  return kBall;
}

DistanceOptions options() {
  DistanceOptions exact;
  exact.tolerance = 1e-12;
  return exact;
}

// Seven links in a row: five revolute joints about axes askew, one that slides, one that mimics joint 1.
std::shared_ptr<const KinematicTree> arm() {
  auto tree = std::make_shared<KinematicTree>();
  for (int i = 0; i < 7; ++i) {
    TreeLink link;
    link.parent = i - 1;
    link.origin = make_placement(Eigen::AngleAxisd(0.3 * i, V(1, i, 2).normalized()).toRotationMatrix(),
                                 V(0.1, 0, 0.3));
    link.kind = i == 3 ? JointKind::prismatic : JointKind::revolute;
    link.axis = V(1, 2 - i, 0.5 * i).normalized();
    link.joint = i == 6 ? 1 : i;
    link.scale = i == 6 ? -0.5 : 1;
    tree->links.push_back(link);
  }
  return tree;
}

// Where a body is whose frame is at `origin` on the link, by forward kinematics.
Pose pose_at(const std::shared_ptr<const KinematicTree>& tree, const Eigen::VectorXd& q, int link,
             const Placement& origin) {
  JointTrajectory still;
  still.times = {0, 1};
  still.values = q.replicate(1, 2);
  const Placement place =
      LinkMotion(tree, std::make_shared<const JointTrajectory>(still), Placement::identity(3), link).at(0) *
      origin;
  return {Eigen::MatrixXd(place.R), Vector(place.t)};
}

std::span<const double> numbers(const Eigen::VectorXd& q) {
  return {q.data(), static_cast<std::size_t>(q.size())};
}

struct OnLink {
  std::shared_ptr<const ConvexSet> shape;
  int link;
  Placement origin;
};

// Two bodies of the arm, or one and what stands.
struct Pair {
  std::shared_ptr<const KinematicTree> tree = arm();
  OnLink one, two;
  ObjectDistanceSolver solver{options()};

  const ObjectDistance& solve(const Eigen::VectorXd& q) {
    const Pose first = pose_at(tree, q, one.link, one.origin),
               second = two.link < 0 ? Pose(Eigen::MatrixXd(two.origin.R), Vector(two.origin.t))
                                     : pose_at(tree, q, two.link, two.origin);
    return solver.solve({*one.shape, first}, {*two.shape, second}, euclidean(), kWanted);
  }
  std::vector<Twist> twists(const Eigen::VectorXd& q, const OnLink& body) const {
    if (body.link < 0) return {};
    return joint_twists(tree, numbers(q), body.link, Placement::identity(3), body.origin);
  }
};

// The relative error of d/dq against central differences.
double error_of(Pair& pair, const Eigen::VectorXd& q) {
  const PoseGradient gradient = pair.solve(q).pose_gradient;
  EXPECT_EQ(gradient.kind, GradientKind::unique);
  const Vector slopes = joint_gradient(gradient, pair.twists(q, pair.one), pair.twists(q, pair.two));
  double off = 0;
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    const Eigen::VectorXd e = kStep * Eigen::VectorXd::Unit(q.size(), j);
    const double ahead = pair.solve(q + e).signed_distance(), behind = pair.solve(q - e).signed_distance();
    off = std::max(off, std::fabs((ahead - behind) / (2 * kStep) - slopes[j]));
  }
  return off / slopes.cwiseAbs().maxCoeff();
}

TEST(JointGradient, IsThatOfCentralDifferences) {
  const auto capsule = std::make_shared<Capsule>(V(0, 0, -0.2), V(0, 0, 0.3), 0.1);
  const auto box = std::make_shared<Box>(V(-0.2, -0.3, -0.1), V(0.2, 0.3, 0.4));
  const auto ellipsoid =
      std::make_shared<Ellipsoid>(V(0, 0, 0), Eigen::MatrixXd(V(0.3, 0.2, 0.1).asDiagonal()));
  const Placement beside = make_placement(Eigen::Matrix3d::Identity(), V(0.05, 0.1, 0.2)),
                  away = make_placement(Eigen::Matrix3d::Identity(), V(2, 0.5, 1)),
                  inside = make_placement(Eigen::Matrix3d::Identity(), V(0.2, 0.1, 0.9));
  std::vector<double> errors;
  for (int i = 0; i < 24; ++i) {
    const Eigen::VectorXd q = Eigen::VectorXd::NullaryExpr(
        6, [i](Eigen::Index j) { return std::sin(3.7 * i + 1.3 * static_cast<double>(j)); });
    Pair of_links{.one = {capsule, 6, beside}, .two = {box, 1, beside}};
    Pair of_standing{.one = {ellipsoid, 5, beside}, .two = {box, -1, i % 2 == 0 ? away : inside}};
    errors.push_back(error_of(of_links, q));
    errors.push_back(error_of(of_standing, q));
    EXPECT_LT(errors.back(), 1e-3);
  }
  std::nth_element(errors.begin(), errors.begin() + 24, errors.end());
  EXPECT_LT(errors[24], 1e-6);
}

// A plate on a joint, flat above a large one: whichever way it turns about its middle, an end comes nearer.
TEST(JointGradient, OfParallelFacesIsOneSided) {
  auto tree = std::make_shared<KinematicTree>();
  TreeLink hinge;
  hinge.origin = Placement::identity(3);
  hinge.kind = JointKind::revolute;
  hinge.axis = V::UnitY();
  hinge.joint = 0;
  tree->links.push_back(hinge);
  const std::vector<Twist> twists = joint_twists(tree, std::vector<double>{0.0}, 0);
  ObjectDistanceSolver solver(options());
  const Box plate(V(-0.5, -0.4, 0.1), V(0.75, 0.4, 0.2)), floor(V(-5, -5, -1), V(5, 5, 0));
  const PoseGradient g = solver.solve(plate, floor, euclidean(), kWanted).pose_gradient;
  ASSERT_EQ(g.kind, GradientKind::one_sided);
  EXPECT_NEAR(derivative_along_joints(g, twists, {}, std::vector<double>{1.0}), -0.75, kRounding);
  EXPECT_NEAR(derivative_along_joints(g, twists, {}, std::vector<double>{-1.0}), -0.5, kRounding);
}

TEST(JointGradient, OfJointsThatDoNotCarryTheLinkIsZero) {
  const std::vector<Twist> twists = joint_twists(arm(), std::vector<double>(6, 0.3), 2);
  ASSERT_EQ(twists.size(), 6U);
  for (std::size_t j = 3; j < 6; ++j) EXPECT_EQ(length(twists[j].linear) + length(twists[j].angular), 0);
  EXPECT_NEAR(length(twists[2].angular), 1, 1e-14);
  EXPECT_EQ(length(twists[2].linear), 0);
}

TEST(JointGradient, RefusesWhatDoesNotFit) {
  const std::vector<Twist> six(6), two(2);
  PoseGradient gradient;
  gradient.kind = GradientKind::unique;
  EXPECT_THROW(joint_gradient(gradient, six, two), DimensionMismatchError);
  EXPECT_THROW(derivative_along_joints(gradient, six, {}, std::vector<double>(3)), DimensionMismatchError);
  EXPECT_THROW(joint_twists(arm(), std::vector<double>(2), 6), InvalidParameterError);
  EXPECT_THROW(joint_twists(arm(), std::vector<double>(6), 7), InvalidParameterError);
  gradient.kind = GradientKind::none;
  EXPECT_EQ(joint_gradient(gradient, six, {}).size(), 0);
}

}  // namespace
}  // namespace raygauge::test_joint_gradient
