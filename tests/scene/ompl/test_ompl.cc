// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/ompl.h"

#include <gtest/gtest.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>

#include <random>

#include "tests/scene/ompl/planar_arm.h"

namespace raygauge::test_ompl {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

constexpr double kBound = 2.6;

std::shared_ptr<ob::RealVectorStateSpace> joint_space() {
  auto space = std::make_shared<ob::RealVectorStateSpace>(2);
  space->setBounds(-kBound, kBound);
  return space;
}

ob::ScopedState<> state(const ob::StateSpacePtr& space, double a, double b) {
  ob::ScopedState<> made(space);
  made[0] = a;
  made[1] = b;
  return made;
}

class Ompl : public ::testing::Test {
 protected:
  Ompl() : checkers_(std::make_shared<EdgeCheckers>(planar_arm::robot(), planar_arm::ball())) {
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    set_proven_validity(information_, checkers_);
    information_->setup();
  }

  ob::StateSpacePtr space_ = joint_space();
  ob::SpaceInformationPtr information_ = std::make_shared<ob::SpaceInformation>(space_);
  std::shared_ptr<EdgeCheckers> checkers_;
};

TEST_F(Ompl, StatesAndMotionsAreValidWhereTheyAreProvenFree) {
  const auto beside = state(space_, -0.8, 0), through = state(space_, 0, 0), other = state(space_, 0.8, 0);
  EXPECT_TRUE(information_->isValid(beside.get()));
  EXPECT_FALSE(information_->isValid(through.get()));
  EXPECT_FALSE(information_->isValid(state(space_, kBound + 0.1, 0).get()));
  EXPECT_FALSE(information_->checkMotion(beside.get(), other.get()));  // though both ends are valid
  EXPECT_TRUE(information_->checkMotion(beside.get(), state(space_, -0.8, -2).get()));
  EXPECT_FALSE(information_->checkMotion(beside.get(), state(space_, -kBound - 0.1, 0).get()));
  EXPECT_EQ(information_->getMotionValidator()->getValidMotionCount(), 1U);
  EXPECT_EQ(information_->getMotionValidator()->getInvalidMotionCount(), 2U);
  EXPECT_EQ(checkers_->undecided(), 0);
}

// The outer rod's tip is at 2 and the ball at 1.6: they meet where 1.6 sin |a| = 0.35.
TEST_F(Ompl, TheLastValidStateIsProvenAndNearTheContact) {
  const auto from = state(space_, -0.8, 0), to = state(space_, 0.8, 0);
  ob::ScopedState<> last(space_);
  std::pair<ob::State*, double> valid{last.get(), 0.0};
  ASSERT_FALSE(information_->checkMotion(from.get(), to.get(), valid));
  const double first = (0.8 - std::asin(0.35 / 1.6)) / 1.6;
  EXPECT_LT(valid.second, first);
  EXPECT_GT(valid.second, first - 0.01);
  EXPECT_TRUE(information_->checkMotion(from.get(), last.get()));
}

TEST_F(Ompl, APlannersPathIsProven) {
  og::SimpleSetup setup(information_);
  setup.setStartAndGoalStates(state(space_, -0.8, 0), state(space_, 0.8, 0));
  setup.setPlanner(std::make_shared<og::RRTConnect>(information_));
  ASSERT_EQ(setup.solve(20.0), ob::PlannerStatus::EXACT_SOLUTION);
  setup.simplifySolution();
  EdgeChecker fresh(planar_arm::robot(), planar_arm::ball());
  const og::PathGeometric& path = setup.getSolutionPath();
  ASSERT_GE(path.getStateCount(), 3U);
  for (unsigned k = 0; k + 1 < path.getStateCount(); ++k) {
    const auto values = [&](unsigned i) {
      return std::span<const double>(path.getState(i)->as<ob::RealVectorStateSpace::StateType>()->values, 2);
    };
    EXPECT_EQ(fresh.edge(values(k), values(k + 1)).outcome, EdgeOutcome::free);
  }
}

TEST_F(Ompl, ThreadsHaveCheckersOfTheirOwn) {
  constexpr int kThreads = 4, kEdges = 400;
  std::vector<std::vector<bool>> verdicts(kThreads);
  std::vector<std::thread> threads;
  for (int thread = 0; thread < kThreads; ++thread) {
    threads.emplace_back([&, thread] {
      std::mt19937_64 random(3);
      std::uniform_real_distribution<double> uniform(-kBound, kBound);
      for (int k = 0; k < kEdges; ++k) {
        const auto one = state(space_, uniform(random), uniform(random));
        const auto other = state(space_, uniform(random), uniform(random));
        verdicts[static_cast<std::size_t>(thread)].push_back(
            information_->checkMotion(one.get(), other.get()));
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::vector<bool>& other : verdicts) EXPECT_EQ(other, verdicts.front());
  const auto valid = std::count(verdicts[0].begin(), verdicts[0].end(), true);
  EXPECT_GT(valid, kEdges / 10);
  EXPECT_LT(valid, kEdges);
  EXPECT_EQ(information_->getMotionValidator()->getCheckedMotionCount(),
            static_cast<unsigned>(kThreads * kEdges));
}

TEST_F(Ompl, ASpaceOfAnotherKindIsRefused) {
  const auto turning = std::make_shared<ob::SpaceInformation>(std::make_shared<ob::SE2StateSpace>());
  EXPECT_THROW(set_proven_validity(turning, checkers_), InvalidParameterError);
  const auto larger = std::make_shared<ob::SpaceInformation>(std::make_shared<ob::RealVectorStateSpace>(3));
  EXPECT_THROW(set_proven_validity(larger, checkers_), InvalidParameterError);
}

}  // namespace
}  // namespace raygauge::test_ompl
