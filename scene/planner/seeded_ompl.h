// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <ompl/base/Planner.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

#include <cstdint>
#include <memory>
#include <string>

namespace raygauge {

/// A planner or path simplifier of OMPL with random numbers of its own. OMPL seeds its objects in the order
/// in which all threads of the process make them; with these the same seed gives the same path.
template <class Base>
class Seeded final : public Base {
 public:
  Seeded(const ompl::base::SpaceInformationPtr& space, std::uint_fast32_t seed) : Base(space) {
    this->rng_.setLocalSeed(seed);
  }
};

/// So with the samples that a space draws.
inline void seed_samples(ompl::base::RealVectorStateSpace& space, std::uint_fast32_t seed) {
  class Sampler final : public ompl::base::RealVectorStateSampler {
   public:
    Sampler(const ompl::base::StateSpace* of, std::uint_fast32_t seed) : RealVectorStateSampler(of) {
      rng_.setLocalSeed(seed);
    }
  };
  space.setStateSamplerAllocator(
      [seed](const ompl::base::StateSpace* of) { return std::make_shared<Sampler>(of, seed); });
}

/// Steps in joint space of at most 1, where OMPL's default is a fifth of the extent of the space: long lines
/// take longer to prove and are free less often. On MotionBenchMaker's problems plans then take half the
/// time.
inline void shorten_steps(ompl::base::Planner& planner, const ompl::base::StateSpace& space) {
  constexpr double kLongest = 1, kDefaultShare = 0.2;
  if (kDefaultShare * space.getMaximumExtent() > kLongest)
    planner.params().setParam("range", std::to_string(kLongest));
}

}  // namespace raygauge
