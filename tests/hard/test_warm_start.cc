// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// A solver that has seen other pairs - of other sizes, other kinds of sets, with other ends - answers as one
// that has seen none: nothing of an earlier solve is part of a proof.
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <vector>

#include "raygauge/queries/solver.h"
#include "tests/engine/both_methods.h"
#include "tests/generators/points_of.h"
#include "tests/hard/hard_cases.h"

namespace raygauge::test_warm_start {
namespace {

/// Instances whose neighbours have next to nothing in common: a stride through all families and dimensions.
std::vector<Instance> a_wild_sequence() {
  constexpr int kLargestDimension = 8, kPoints = 40;
  constexpr std::size_t kStride = 37;  // prime to the number of instances
  std::vector<Instance> instances;
  for (const auto& cases : {hard_cases(), smooth_hard_cases()}) {
    for (const HardCase& tested : cases) {
      for (const int n : dimensions_of(tested, kLargestDimension)) {
        instances.push_back(generate(tested.generator, {7, n, kPoints, 0}, tested.parameters));
      }
    }
  }
  std::vector<Instance> sequence;
  for (std::size_t i = 0; i < instances.size(); ++i) {
    sequence.push_back(instances[i * kStride % instances.size()]);
  }
  return sequence;
}

class WarmStart : public BothMethods {};

TEST_P(WarmStart, FromAnyOtherPairAnswersAsAColdOne) {
  DistanceSolver used(options(1e-9));
  std::size_t i = 0;
  for (const Instance& instance : a_wild_sequence()) {
    SCOPED_TRACE("instance " + std::to_string(i++));
    const DistanceResult& warm = used.solve(*instance.A, *instance.Q);
    EXPECT_LE(warm.lower, std::nextafter(*instance.exact_distance, 2 * *instance.exact_distance));
    EXPECT_GE(warm.upper, std::nextafter(*instance.exact_distance, 0));
    expect_same_bits(warm, DistanceSolver(options(1e-9)).solve(*instance.A, *instance.Q));
  }
}

/// A set that breaks every promise: its support points and values are NaN.
class Poison final : public ConvexSet {
 public:
  explicit Poison(int n) : ConvexSet(n) {}

 private:
  double do_support(const double* /*u*/, double* point) const override {
    do_center(point);
    return std::numeric_limits<double>::quiet_NaN();
  }
  void do_center(double* point) const override {
    std::fill_n(point, dimension(), std::numeric_limits<double>::quiet_NaN());
  }
};

TEST_P(WarmStart, AfterASolveInterruptedOrPoisonedAnswersAsAColdOne) {
  const std::array poisoned = {generate("hard_moment_curve", {1, 8, 100, 0}),
                               generate("hard_capsule", {1, 8, 1, 0})};
  const std::array asked = {generate("hard_planted_ties", {1, 8, 60, 0}),
                            generate("hard_ellipsoid", {1, 8, 1, 0}),
                            generate("hard_truncated_cone", {1, 5, 1, 0})};
  DistanceSolver used;
  for (const Instance& instance : asked) {
    for (const Instance& other : poisoned) {
      DistanceOptions cut_short = options(1e-12);
      cut_short.max_iterations = 3;
      used.set_options(cut_short);
      used.solve(*other.A, *other.Q, Effects::witness);
      used.solve(Poison(8), *other.Q);
      used.solve(*other.A, Poison(8));
      used.set_options(options(1e-6));
      expect_same_bits(used.solve(*instance.A, *instance.Q),
                       DistanceSolver(options(1e-6)).solve(*instance.A, *instance.Q));
    }
  }
}

RAYGAUGE_BOTH_METHODS(WarmStart);
RAYGAUGE_NEWTON_TOO(WarmStart);

}  // namespace
}  // namespace raygauge::test_warm_start
