// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

// raygauge::ompl: proven motions for the planners of OMPL. Two lines of a program:
//
//     auto checkers = std::make_shared<raygauge::EdgeCheckers>(robot, obstacles);
//     raygauge::set_proven_validity(space_information, checkers);
//
// Header alone; nothing else of raygauge includes it. The CMake package has it as the component `ompl`.
#if __cplusplus < 201709L && (!defined(_MSVC_LANG) || _MSVC_LANG < 202002L)
#error "raygauge needs C++20: compile with -std=c++20"
#else
#include <ompl/base/MotionValidator.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateValidityChecker.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "raygauge/exceptions.h"
#include "raygauge/scene/edge_checker.h"

namespace raygauge {

/// One EdgeChecker for each thread, made when the thread first needs it. OMPL uses several threads at once.
/// Obstacles must stand still, because planners do not know time. The objects outlive the planners that use
/// them.
class EdgeCheckers {
 public:
  /// Throws what EdgeChecker throws.
  explicit EdgeCheckers(RobotModel robot, std::vector<Body> obstacles = {}, const EdgeOptions& options = {})
      : robot_(std::move(robot)), obstacles_(std::move(obstacles)), options_(options) {
    mine();
  }

  /// The checker of the calling thread.
  EdgeChecker& mine() {
    const std::lock_guard lock(mutex_);
    std::unique_ptr<EdgeChecker>& own = checkers_[std::this_thread::get_id()];
    if (own == nullptr) own = std::make_unique<EdgeChecker>(robot_, obstacles_, options_);
    return *own;
  }

  int joints() const noexcept { return robot_.joints; }

  /// How many verdicts were `undecided`; such edges and states count as not valid.
  std::int64_t undecided() const noexcept { return undecided_; }

  /// Whether the verdict is `free`, counted.
  bool is_free(const EdgeResult& result) {
    if (result.outcome == EdgeOutcome::undecided) ++undecided_;
    return result.outcome == EdgeOutcome::free;
  }

 private:
  RobotModel robot_;
  std::vector<Body> obstacles_;
  EdgeOptions options_;
  std::mutex mutex_;
  std::map<std::thread::id, std::unique_ptr<EdgeChecker> > checkers_;
  std::atomic<std::int64_t> undecided_{0};
};

namespace ompl_detail {

/// The joint values of a state of RealVectorStateSpace.
inline std::span<const double> values_of(const ompl::base::State* state, int joints) {
  return {state->as<ompl::base::RealVectorStateSpace::StateType>()->values, static_cast<std::size_t>(joints)};
}

/// Throws InvalidParameterError unless a state has one number for each joint of the robot.
inline void check_space(const ompl::base::SpaceInformation& space, int joints) {
  const auto* vectors = dynamic_cast<const ompl::base::RealVectorStateSpace*>(space.getStateSpace().get());
  if (vectors != nullptr && static_cast<int>(vectors->getDimension()) == joints) return;
  throw InvalidParameterError("ompl: the state space must be a RealVectorStateSpace of " +
                              std::to_string(joints) + " dimensions, one for each joint");
}

}  // namespace ompl_detail

/// A state is valid within the bounds of the space, where no pair of bodies is in contact (EdgeChecker).
class ProvenStateValidity final : public ompl::base::StateValidityChecker {
 public:
  /// Throws InvalidParameterError for another space than a RealVectorStateSpace of the robot's joints.
  ProvenStateValidity(const ompl::base::SpaceInformationPtr& space, std::shared_ptr<EdgeCheckers> checkers)
      : StateValidityChecker(space), checkers_(std::move(checkers)) {
    ompl_detail::check_space(*space, checkers_->joints());
  }

  bool isValid(const ompl::base::State* state) const override {
    if (!si_->satisfiesBounds(state)) return false;
    const auto q = ompl_detail::values_of(state, checkers_->joints());
    return checkers_->is_free(checkers_->mine().configuration(q));
  }

 private:
  std::shared_ptr<EdgeCheckers> checkers_;
};

/// A motion is valid where it is proven to be without contact at every time of the straight line.
class ProvenMotionValidity final : public ompl::base::MotionValidator {
 public:
  /// Throws InvalidParameterError for another space than a RealVectorStateSpace of the robot's joints.
  ProvenMotionValidity(const ompl::base::SpaceInformationPtr& space, std::shared_ptr<EdgeCheckers> checkers)
      : MotionValidator(space), checkers_(std::move(checkers)) {
    ompl_detail::check_space(*space, checkers_->joints());
  }

  bool checkMotion(const ompl::base::State* s1, const ompl::base::State* s2) const override {
    return counted(prove(s1, s2, 1));
  }

  /// `last_valid`: a state up to which the motion is proven, and its share of the way; s1 and 0 where no part
  /// of it is.
  bool checkMotion(const ompl::base::State* s1, const ompl::base::State* s2,
                   std::pair<ompl::base::State*, double>& last_valid) const override {
    if (counted(prove(s1, s2, 1))) return true;
    double valid = 0, contact = 1;
    for (int k = 0; k < kHalvings; ++k) {
      const double middle = (valid + contact) / 2;
      (prove(s1, s2, middle) ? valid : contact) = middle;
    }
    last_valid.second = valid;
    if (last_valid.first != nullptr) si_->getStateSpace()->interpolate(s1, s2, valid, last_valid.first);
    return false;
  }

 private:
  static constexpr int kHalvings = 8;

  /// The line from s1 over `share` of the way to s2, which must be within the bounds.
  bool prove(const ompl::base::State* s1, const ompl::base::State* s2, double share) const {
    if (!si_->satisfiesBounds(s2)) return false;
    const auto q1 = ompl_detail::values_of(s1, checkers_->joints());
    const auto q2 = ompl_detail::values_of(s2, checkers_->joints());
    if (share == 1) return checkers_->is_free(checkers_->mine().edge(q1, q2));
    std::vector<double> end(q2.begin(), q2.end());
    for (std::size_t i = 0; i < end.size(); ++i) end[i] = q1[i] + share * (q2[i] - q1[i]);
    return checkers_->is_free(checkers_->mine().edge(q1, end));
  }

  bool counted(bool is_valid) const {
    std::atomic_ref<unsigned int>(is_valid ? valid_ : invalid_).fetch_add(1, std::memory_order_relaxed);
    return is_valid;
  }

  std::shared_ptr<EdgeCheckers> checkers_;
};

/// Sets both for the planners of `space`.
inline void set_proven_validity(const ompl::base::SpaceInformationPtr& space,
                                const std::shared_ptr<EdgeCheckers>& checkers) {
  space->setStateValidityChecker(std::make_shared<ProvenStateValidity>(space, checkers));
  space->setMotionValidator(std::make_shared<ProvenMotionValidity>(space, checkers));
}

}  // namespace raygauge
#endif
