// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/bodies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sweep/method.h"

namespace raygauge::test_bodies {
namespace {

const std::string kKinds[] = {"ball", "box", "capsule", "cone", "cylinder", "ellipsoid", "hull", "needle"};
const std::string kPlaces[] = {"apart", "near", "grazing", "parallel", "far", "slight", "overlap", "deep"};

Instance make(const std::string& one, const std::string& two, const std::string& place, double scale = 1,
              int seed = 1, int n = 3, const std::string& quantity = "distance", int repetition = 0) {
  const Component<Generator> component = bodies_generator();
  const Parameters parameters = complete(
      "generator 'bodies'", component.parameters,
      {{"kind_1", one}, {"kind_2", two}, {"place", place}, {"scale", scale}, {"quantity", quantity}});
  InstanceKey key;
  key.seed = static_cast<std::uint64_t>(seed);
  key.n = n;
  key.N = 12;
  key.repetition = repetition;
  return component.make(parameters)->generate(key);
}

const DistanceResult& distance_of(const Instance& instance, ObjectDistanceSolver& solver) {
  const auto& difference = dynamic_cast<const MinkowskiDifference&>(*instance.A);
  return solver.solve(*difference.A1(), *difference.A2(), *instance.Q).distance;
}

TEST(Bodies, AreAsFarApartAsPlantedWhateverTheirKindsAndSize) {
  DistanceOptions options;
  options.tolerance = 1e-7;
  ObjectDistanceSolver solver(options);
  for (const std::string& one : kKinds) {
    for (const std::string& two : kKinds) {
      for (const double scale : {1.0, 1e-6, 1e6}) {
        for (const auto& [place, gap] : {std::pair{"apart", 1.0},
                                         {"near", 1e-3},
                                         {"grazing", 1e-6},
                                         {"parallel", 1e-3},
                                         {"far", 1e-3}}) {
          const Instance instance = make(one, two, place, scale);
          ASSERT_TRUE(instance.exact_distance.has_value());
          EXPECT_DOUBLE_EQ(*instance.exact_distance, gap * scale);
          const double error = instance.exact_distance_rounding * *instance.exact_distance;
          const DistanceResult& found = distance_of(instance, solver);
          EXPECT_LE(found.lower, *instance.exact_distance + error) << one << ' ' << two << ' ' << place;
          EXPECT_GE(found.upper, *instance.exact_distance - error) << one << ' ' << two << ' ' << place;
          if (place == std::string("far")) continue;
          EXPECT_EQ(found.status, DistanceStatus::optimal);
        }
      }
    }
  }
}

TEST(Bodies, OfAnyKindAreOfEachByTurns) {
  const auto reach = [](const Instance& instance) {
    const Vector u = Vector::LinSpaced(3, -0.3, 1);
    Vector point(3);
    return instance.A->support_unchecked(u.data(), point.data());
  };
  const auto of = [&](const std::string& one, const std::string& two, int repetition) {
    return reach(make(one, two, "near", 1, 1, 3, "distance", repetition));
  };
  for (int i = 0; i < 70; ++i) {
    const std::string &by_turns = kKinds[i % 8], &slower = kKinds[i / 8 % 8];
    EXPECT_EQ(of("any", "box", i), of(by_turns, "box", i)) << i;
    EXPECT_EQ(of("box", "any", i), of("box", by_turns, i)) << i;
    EXPECT_EQ(of("any", "any", i), of(by_turns, slower, i)) << i;
  }
}

TEST(Bodies, LiveInEveryDimensionFromThePlaneOn) {
  ObjectDistanceSolver solver;
  for (const int n : {2, 5, 20}) {
    for (const std::string& kind : kKinds) {
      const Instance instance = make(kind, "ellipsoid", "apart", 1, 3, n);
      const DistanceResult& found = distance_of(instance, solver);
      EXPECT_LE(found.lower, 1 + 1e-13) << kind << n;
      EXPECT_GE(found.upper, 1 - 1e-13) << kind << n;
    }
  }
}

TEST(Bodies, OverlapWithInnerPointsInCommon) {
  ObjectDistanceSolver solver;
  for (const std::string& one : kKinds) {
    for (const std::string& two : kKinds) {
      for (int seed = 1; seed <= 5; ++seed) {
        const Instance instance = make(one, two, "overlap", 1, seed);
        EXPECT_EQ(instance.exact_distance, 0.0);
        const auto& difference = dynamic_cast<const MinkowskiDifference&>(*instance.A);
        const ObjectDistance& found =
            solver.solve(*difference.A1(), *difference.A2(), *instance.Q, ObjectEffects::depth);
        EXPECT_GT(found.depth.lower, 0.001) << one << ' ' << two;
      }
    }
  }
}

TEST(Bodies, OverlapByAThousandthAtMostWhereTheyOverlapSlightly) {
  ObjectDistanceSolver solver;
  for (const std::string& one : kKinds) {
    for (const std::string& two : kKinds) {
      const Instance instance = make(one, two, "slight");
      EXPECT_EQ(instance.exact_distance, 0.0);
      const auto& difference = dynamic_cast<const MinkowskiDifference&>(*instance.A);
      const ObjectDistance& found =
          solver.solve(*difference.A1(), *difference.A2(), *instance.Q, ObjectEffects::depth);
      EXPECT_GT(found.depth.upper, 0) << one << ' ' << two;
      EXPECT_LE(found.depth.lower, 1e-3) << one << ' ' << two;
    }
  }
}

DistanceResult answer_of(const Instance& instance) {
  MethodRegistry registry("method");
  register_engine_methods(registry);
  const auto method = registry.make("object_distance", {});
  EXPECT_TRUE(method->answers(instance.quantity));
  method->load(instance);
  method->solve({});
  return method->result();
}

TEST(Bodies, HaveThePlantedDepthGrowthAndSeparation) {
  int depths = 0;
  for (const std::string& one : kKinds) {
    for (const std::string& two : kKinds) {
      for (const std::string& place : kPlaces) {
        for (const std::string quantity : {"depth", "separated", "growth"}) {
          const Instance instance = make(one, two, place, 50, 2, 3, quantity);
          const DistanceResult found = answer_of(instance);
          const bool planted = instance.exact_distance.has_value();
          EXPECT_TRUE(planted || quantity == "depth");
          if (!planted) continue;
          depths += quantity == "depth" && *instance.exact_distance > 0;
          const double truth = *instance.exact_distance, slack = instance.exact_distance_rounding * truth;
          EXPECT_LE(found.lower, truth + slack) << one << ' ' << two << ' ' << place << ' ' << quantity;
          EXPECT_GE(found.upper, truth - slack) << one << ' ' << two << ' ' << place << ' ' << quantity;
          if (place == "far") continue;
          EXPECT_LE(found.upper - found.lower, 2e-6 * std::max(found.upper, 1.0));
        }
      }
    }
  }
  EXPECT_EQ(depths, 64 - 25 + 2) << "slight ones of rounded bodies, and two balls";
}

}  // namespace
}  // namespace raygauge::test_bodies
