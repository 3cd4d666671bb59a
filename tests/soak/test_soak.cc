// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// The soak's own judgement: its variants keep the distance that it claims, and its checks see what is false.
#include <gtest/gtest.h>

#include <boost/multiprecision/gmp.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "baselines/exact_verify.h"
#include "generators/registry.h"
#include "raygauge/queries/solver.h"
#include "tests/soak/certificate_check.h"
#include "tests/soak/overlaps.h"
#include "tests/soak/placed_bodies.h"
#include "tests/soak/posed_bodies.h"
#include "tests/soak/random_depths.h"
#include "tests/soak/random_edges.h"
#include "tests/soak/random_meshes.h"
#include "tests/soak/random_motions.h"
#include "tests/soak/random_scenes.h"
#include "tests/soak/random_simulations.h"
#include "tests/soak/run.h"
#include "tests/soak/set_pairs.h"
#include "tests/soak/used_solvers.h"
#include "tests/soak/variant.h"

namespace raygauge::test_soak {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

GeneratorRegistry all_generators() {
  GeneratorRegistry registry("generator");
  register_generators(registry);
  return registry;
}

soak::Truth truth(double d) {
  const auto status = d == 0          ? DistanceStatus::contains_origin
                      : std::isinf(d) ? DistanceStatus::unreachable
                                      : DistanceStatus::optimal;
  return {status, {d, d, d}};
}

DistanceResult claim(DistanceStatus status, double lower, double distance, double upper) {
  DistanceResult result;
  result.status = status;
  result.lower = lower;
  result.distance = distance;
  result.upper = upper;
  return result;
}

TEST(SoakVariant, KeepsTheDistanceThatItClaims) {
  const GeneratorRegistry registry = all_generators();
  const auto names = soak::point_set_generators(registry);
  ASSERT_GE(names.size(), 24u);
  soak::Variant variant;
  for (int base = 0; base < 150; ++base) {
    const InstanceKey key{4, 1, 0, base};
    RandomStream shape(key, "test_soak", RandomPurpose::shape);
    RandomStream stream(key, "test_soak", RandomPurpose::order);
    const soak::ProvenInstance proven = soak::draw_proven_instance(registry, names, shape);
    if (proven.A.rows() > 6) continue;
    for (int repetition = 0; repetition < 3; ++repetition) {
      variant.make(proven, stream);
      SCOPED_TRACE(proven.label + ", base " + std::to_string(base));
      const ExactLpResult exact = solve_exact_lp(PointSet(variant.A()), PointSet(variant.Q()));
      ASSERT_EQ(exact.status, proven.truth.status);
      if (exact.status != DistanceStatus::unreachable) {
        ASSERT_EQ(exact.value, scaled_rational(proven.truth.value, variant.shift()));
      }
    }
  }
}

TEST(SoakVariant, ChangesTheInstance) {
  const GeneratorRegistry registry = all_generators();
  const InstanceKey key{5, 1, 0, 0};
  RandomStream shape(key, "test_soak", RandomPurpose::shape);
  RandomStream stream(key, "test_soak", RandomPurpose::order);
  const soak::ProvenInstance proven = soak::draw_proven_instance(registry, {"example2"}, shape);
  soak::Variant first, second;
  first.make(proven, stream);
  second.make(proven, stream);
  const bool same_A = first.A().size() == second.A().size() && first.A() == second.A();
  const bool same_Q = first.Q().size() == second.Q().size() && first.Q() == second.Q();
  EXPECT_FALSE(same_A && same_Q);
}

TEST(SoakFalsehood, AcceptsWhatHolds) {
  constexpr double kTolerance = 1e-6;
  EXPECT_EQ(soak::falsehood(claim(DistanceStatus::optimal, 2, 2, 2), truth(2), kTolerance), "");
  EXPECT_EQ(soak::falsehood(claim(DistanceStatus::precision_limit, 1, 1, kInfinity), truth(2), kTolerance),
            "");
  EXPECT_EQ(soak::falsehood(claim(DistanceStatus::contains_origin, 0, 0, 0), truth(0), kTolerance), "");
  EXPECT_EQ(soak::falsehood(claim(DistanceStatus::unreachable, kInfinity, kInfinity, kInfinity),
                            truth(kInfinity), kTolerance),
            "");
}

TEST(SoakFalsehood, SeesBoundsThatMissTheTruthByOneDouble) {
  constexpr double kTolerance = 1e-6;
  const double above = std::nextafter(2.0, 3.0), below = std::nextafter(2.0, 1.0);
  EXPECT_EQ(soak::falsehood(claim(DistanceStatus::optimal, above, above, above), truth(2), kTolerance),
            "lower > d");
  EXPECT_EQ(soak::falsehood(claim(DistanceStatus::optimal, below, below, below), truth(2), kTolerance),
            "upper < d");
  EXPECT_NE(soak::falsehood(claim(DistanceStatus::optimal, above, above, below), truth(2), kTolerance), "");
  EXPECT_NE(soak::falsehood(claim(DistanceStatus::optimal, NAN, 2, 2), truth(2), kTolerance), "");
}

TEST(SoakFalsehood, SeesStatusesThatAreNotEarned) {
  constexpr double kTolerance = 1e-6;
  EXPECT_NE(soak::falsehood(claim(DistanceStatus::optimal, 1, 2, 3), truth(2), kTolerance), "");
  EXPECT_NE(soak::falsehood(claim(DistanceStatus::contains_origin, 0, 0, 0), truth(1e-300), kTolerance), "");
  EXPECT_NE(soak::falsehood(claim(DistanceStatus::unreachable, kInfinity, kInfinity, kInfinity), truth(2),
                            kTolerance),
            "");
  EXPECT_NE(soak::falsehood(claim(DistanceStatus::optimal, 1, 3, 2), truth(1.5), 0.5), "");
}

TEST(SoakDualValue, EnclosesTheBoundOfTheNormal) {
  Eigen::MatrixXd A(2, 2), Q(2, 4);
  A << 3, 4, 1, 7;
  Q << 1, -1, 0, 0, 0, 0, 1, -1;
  const Vector u = (Vector(2) << -1, -0.5).finished();  // h_A(u) = -3.5, h_Q(-u) = 1
  const soak::DualValue dual = soak::dual_value(A, Q, u);
  ASSERT_TRUE(dual.known);
  EXPECT_LE(dual.below, 3.5);
  EXPECT_GE(dual.above, 3.5);
  EXPECT_LT(dual.above - dual.below, 1e-14);
  EXPECT_FALSE(soak::dual_value(A, Q, -u).known);
}

TEST(SoakRun, DoesTheSolvesAskedForOnAnyNumberOfThreads) {
  soak::RunOptions options;
  options.solves = 3000;
  options.seed = 7;
  const auto counted = [&](int threads) {
    options.threads = threads;
    return soak::run(
        options, [] { return false; }, [](const soak::Progress&) {});
  };
  const soak::RunResult one = counted(1), three = counted(3);
  EXPECT_FALSE(one.violation.has_value());
  EXPECT_GE(one.progress.tally.total().solves, options.solves);
  EXPECT_GE(three.progress.tally.total().solves, options.solves);
  EXPECT_FALSE(three.violation.has_value());
}

// u·a = Σ u_k a_k in which each of the last terms takes away what the ones before have left: twice the
// precision is not enough then, and the enclosure must say so.
TEST(SoakDualValue, EnclosesWhatCancelsTwice) {
  using Rational = boost::multiprecision::mpq_rational;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0.5, 1);
  for (int trial = 0; trial < 500; ++trial) {
    Eigen::MatrixXd A =
        Eigen::MatrixXd::NullaryExpr(5, 1, [&](Eigen::Index, Eigen::Index) { return uniform(random); });
    A(0, 0) = -std::ldexp(uniform(random), -trial % 40);
    Vector u = Vector::Ones(5);
    u[1] = std::ldexp(uniform(random), 60 + trial % 60);
    Rational sum = Rational(u[0]) * Rational(A(0, 0)) + Rational(u[1]) * Rational(A(1, 0));
    for (int k = 2; k < 5; ++k) {
      u[k] = -(sum / Rational(A(k, 0))).convert_to<double>();
      sum += Rational(u[k]) * Rational(A(k, 0));
    }
    const Eigen::MatrixXd Q = -Eigen::MatrixXd::Identity(5, 1);  // h_Q(-u) = u_1 = 1
    const soak::DualValue dual = soak::dual_value(A, Q, u);
    if (!dual.known) continue;
    EXPECT_LE(Rational(dual.below), -sum) << trial;
    EXPECT_GE(Rational(dual.above), -sum) << trial;
  }
}

TEST(Soak, FindsNothingFalseInAHundredThousandSolves) {
  soak::RunOptions options;
  options.solves = 100000;
  options.threads = 2;
  const soak::RunResult result = soak::run(
      options, [] { return false; }, [](const soak::Progress&) {});
  EXPECT_FALSE(result.violation) << result.violation->family << ": " << result.violation->what;
  EXPECT_GE(result.progress.tally.total().solves, options.solves);
}

TEST(Soak, FindsNoContradictionInTenThousandPairsOfSets) {
  soak::SetPairs pairs(1);
  for (int i = 0; i < 10000; ++i) {
    const auto violation = pairs.check(i);
    ASSERT_FALSE(violation) << *violation;
  }
  EXPECT_EQ(pairs.tally().pairs, 10000);
}

TEST(Soak, TimesOfImpactAreThoseOfBisectionsAndOfQuadruplePrecision) {
  soak::RandomMotions motions(1);
  for (std::int64_t i = 0; i < 300; ++i) {
    ASSERT_EQ(motions.check(i).value_or(""), "");
  }
  EXPECT_GT(motions.tally().contacts, 50);
  EXPECT_GT(motions.tally().free, 50);
  EXPECT_GT(motions.tally().grazing, 20);
  EXPECT_EQ(motions.tally().exact, 100);
  EXPECT_LT(motions.tally().exact_undecided, 60);  // half of them graze by less than poses can tell
}

TEST(Soak, MeshesAreAsFarApartAsTheirNearestTriangles) {
  soak::RandomMeshes meshes(1);
  for (std::int64_t i = 0; i < 40; ++i) ASSERT_EQ(meshes.check(i).value_or(""), "");
  EXPECT_GT(meshes.tally().meeting, 200);
  EXPECT_GT(meshes.tally().inside, 10);
  EXPECT_GT(meshes.tally().touching, 2);
  EXPECT_GT(meshes.tally().certified, meshes.tally().poses * 9 / 10);
  EXPECT_GT(meshes.tally().contacts, 20);
  EXPECT_GT(meshes.tally().free, 20);
}

TEST(Soak, VerdictsOnEdgesHoldAtEveryMoment) {
  soak::RandomEdges edges(1);
  for (std::int64_t i = 0; i < 60; ++i) {
    ASSERT_EQ(edges.check(i).value_or(""), "");
  }
  EXPECT_GT(edges.tally().free, 100);
  EXPECT_GT(edges.tally().contact, 100);
  EXPECT_GT(edges.tally().grazing, 100);
  EXPECT_GT(edges.tally().samples, 1000);
  EXPECT_EQ(edges.tally().undecided, 0);
}

TEST(Soak, ScenesHaveTheAnswersOfBruteForce) {
  soak::RandomScenes scenes(1);
  for (std::int64_t i = 0; i < 20; ++i) {
    ASSERT_EQ(scenes.check(i).value_or(""), "");
  }
  EXPECT_GT(scenes.tally().records, 1000);
}

TEST(Soak, PosedBodiesHaveBoundsThatTheGeneralMethodsDoNotContradict) {
  soak::PosedBodies bodies(1);
  for (int i = 0; i < 1000; ++i) {
    const auto violation = bodies.check(i);
    ASSERT_FALSE(violation) << *violation;
  }
  EXPECT_GT(bodies.tally().certified, bodies.tally().frames);
}

TEST(Soak, PlacedBodiesHaveBoundsAboutTheirKnownDistance) {
  soak::PlacedBodies bodies(1);
  for (int i = 0; i < 100; ++i) {
    const auto violation = bodies.check(i);
    ASSERT_FALSE(violation) << *violation;
  }
  EXPECT_EQ(bodies.tally().poses, 100 * soak::PlacedBodies::kPoses);
  EXPECT_GT(bodies.tally().certified, bodies.tally().poses * 9 / 10);
}

// The last ones were once not proven, or gained energy.
TEST(Soak, SimulationsAreProvenAndGainNoEnergy) {
  soak::RandomSimulations simulations(1);
  for (const int number : {1, 2, 3, 4, 5, 6, 7, 8, 0, 37, 55, 80, 82, 83, 94, 113, 130, 164, 203, 329, 953})
    EXPECT_EQ(simulations.check(number), std::nullopt);
  // Two bodies whose one point leaves the other so slowly that turning goes deeper.
  EXPECT_EQ(soak::RandomSimulations(555).check(27), std::nullopt);
  // A deep pair, pushed apart the harder the shorter a substep was, turned a body into its neighbour ever
  // sooner.
  EXPECT_EQ(soak::RandomSimulations(1).check(3543), std::nullopt);
  // A substep that had to be a thousandth of the step.
  EXPECT_EQ(soak::RandomSimulations(1).check(7769), std::nullopt);
  // A deep pair, asked to be less deep half way, however short the substep was.
  EXPECT_EQ(soak::RandomSimulations(91).check(175), std::nullopt);
  EXPECT_EQ(soak::RandomSimulations(93).check(16), std::nullopt);
  // A ball between the floor and a body that comes down on it, which friction does not let out.
  soak::RandomSimulations jammed(241);
  EXPECT_EQ(jammed.check(651), std::nullopt);
  EXPECT_EQ(jammed.tally().jammed, 1);
  EXPECT_LE(jammed.tally().residual, 1e-8);
  // A body that rolls: a millionth of a step was proven each time, a hundredth can be.
  soak::RandomSimulations rolling(97);
  EXPECT_EQ(rolling.check(113), std::nullopt);
  EXPECT_LT(rolling.tally().cuts, 50000);
}

TEST(Soak, UsedSolversAnswerAsNewOnesDo) {
  soak::UsedSolvers solvers(1);
  for (int i = 0; i < 3000; ++i) {
    const auto violation = solvers.check(i);
    ASSERT_FALSE(violation) << *violation;
  }
  EXPECT_GT(solvers.tally().certified, 1500);
}

TEST(Soak, PolytopesOfQuartersThatOverlapAreNeverUndecided) {
  soak::Overlaps overlaps(1);
  for (int i = 0; i < 5000; ++i) {
    const auto violation = overlaps.check(i);
    ASSERT_FALSE(violation) << *violation;
  }
  EXPECT_GT(overlaps.tally().overlapping, 1500);
  EXPECT_GT(overlaps.tally().touching, 100);
}

// A cone and a capsule of size 3e-8: of two distances of their cores the second, finer one had the worse
// normal.
TEST(Soak, ADepthOnceFoundFalseIsTrue) { EXPECT_EQ(soak::RandomDepths(78).check(96), std::nullopt); }

TEST(Soak, RandomDepthsHaveBoundsThatNoDirectionContradicts) {
  soak::RandomDepths depths(1);
  for (int i = 0; i < 200; ++i) {
    const auto violation = depths.check(i);
    ASSERT_FALSE(violation) << *violation;
  }
  EXPECT_EQ(depths.tally().poses, 200 * soak::RandomDepths::kPoses);
  EXPECT_GT(depths.tally().certified, depths.tally().depths * 9 / 10);
  EXPECT_GT(depths.tally().facets, 0);
}

}  // namespace
}  // namespace raygauge::test_soak
