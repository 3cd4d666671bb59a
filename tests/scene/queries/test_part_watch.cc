// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/queries/part_watch.h"

#include <gtest/gtest.h>

#include <memory>

#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "tests/scene/random_scenes.h"

namespace raygauge::test_part_watch {
namespace {

using namespace random_scenes;

constexpr double kError = 0.1;  // of the placement of a body that stands at the origin
constexpr double kCorner = 4 * kError;

class BlurredMotion final : public Motion {
 public:
  BlurredMotion() : Motion(3) {}

 private:
  Placement do_at(double) const override { return Placement::identity(3); }
  MotionBound do_bound(double, double) const override { return MotionBound::unknown(3); }
  PlacementError do_error_at(double) const override { return {kError, 0}; }
};

std::shared_ptr<const ConvexSet> box_at(const Eigen::Vector3d& center, double half) {
  const Eigen::Vector3d h = Eigen::Vector3d::Constant(half);
  return std::make_shared<Box>(center - h, center + h);
}

PartLook look_at(const Body& body) {
  const Body speck = make_body("speck", {std::make_shared<Ball>(Vector::Zero(3), 1e-3)},
                               std::make_shared<StaticMotion>(Placement::identity(3)));
  PairSolver solver(3);
  const SceneMetric euclidean;
  PartWatch watch(solver, speck, body, euclidean, nullptr);
  return watch.at(0);
}

TEST(PartWatch, ABodyMeetsHoweverItsPlacementIsRounded) {
  const PartLook look = look_at(make_body("box", {box_at({0, 0, 0}, 1)}, std::make_shared<BlurredMotion>()));
  EXPECT_TRUE(look.answer.intersecting());
  EXPECT_TRUE(look.meets);
}

// Each corner of the cross-polytope of shifts meets by another part; most shifts between them meet nothing.
TEST(PartWatch, PartsThatMeetOneShiftEachProveNothing) {
  std::vector<std::shared_ptr<const ConvexSet>> parts = {box_at({0, 0, 0}, 0.01)};
  for (int k = 0; k < 6; ++k) {
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    center[k / 2] = k % 2 == 0 ? kCorner : -kCorner;
    parts.push_back(box_at(center, 0.01));
  }
  const PartLook look = look_at(make_body("seven specks", parts, std::make_shared<BlurredMotion>()));
  EXPECT_TRUE(look.answer.intersecting());
  EXPECT_FALSE(look.meets);
}

}  // namespace
}  // namespace raygauge::test_part_watch
