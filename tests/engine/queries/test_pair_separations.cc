// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// PairBatch::separations: the outcomes of single tests, and proofs that hold in quadruple precision or
// exactly.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include "engine/kernels/kernel.h"
#include "engine/kernels/separation_lanes.h"
#include "engine/queries/separation_bins.h"
#include "raygauge/exceptions.h"
#include "raygauge/queries/object_distance.h"
#include "tests/engine/instruction_sets.h"
#include "tests/engine/queries/primitive_pairs.h"
#include "tests/engine/random_poses.h"

namespace raygauge::test_pair_separations {
namespace {

using Eigen::Vector3d;
using testing::gaussian;
using testing::Random;
using Kind = Primitive::Kind;

DistanceOptions options_for(int threads, InstructionSet isa = InstructionSet::automatic) {
  DistanceOptions options;
  options.method = DistanceMethod::newton;
  options.threads = threads;
  options.instruction_set = isa;
  return options;
}

struct Answers {
  explicit Answers(std::size_t count) : outcome(count), normal(3 * count) {}
  SeparationAnswers spans() { return {outcome, normal}; }

  std::vector<Separation> outcome;
  std::vector<double> normal;
};

Pose random_pose(Random& random, double way) {
  const Vector3d v = gaussian(random);
  return {Eigen::Quaterniond(1, v.x(), v.y(), v.z()).normalized(), way * gaussian(random)};
}

bool has_ball(const Primitive& body) { return body.kind == Kind::ball || body.kind == Kind::capsule; }

// 1 to 33 points between p and q, one more than the vectors take; some in a plane or in a line, some twice.
Eigen::Matrix3Xd points_between(const Vector3d& p, const Vector3d& q, Random& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(1 + random() % 33));
  const auto flat = static_cast<Eigen::Index>(random() % 6);
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    Vector3d share(uniform(random), uniform(random), uniform(random));
    if (flat < 3) share[flat] = 0.5;
    if (flat == 0) share[1] = 0.5;
    points.col(i) = p + share.cwiseProduct(q - p);
    if (i > 0 && random() % 8 == 0) points.col(i) = points.col(i - 1);
  }
  return points;
}

// Of about `size`, and `thin` times as thin across its longest edge; not about the origin of its frame.
Primitive random_primitive(Random& random, double size, double thin) {
  std::uniform_real_distribution<double> uniform(0.2, 1);
  Primitive body;
  body.kind = static_cast<Kind>(random() % Primitive::kKinds);
  const Vector3d half = size * Vector3d(uniform(random), thin * uniform(random), thin * uniform(random));
  const Vector3d center = random() % 2 == 0 ? Vector3d::Zero() : Vector3d(size * gaussian(random));
  body.p = center - half;
  body.q = body.kind == Kind::ball ? body.p : Vector3d(center + half);
  body.points = points_between(body.p, body.q, random);
  body.radius = has_ball(body) ? size * thin * uniform(random) : 0;
  body.pose = random_pose(random, size);
  return body;
}

// Bodies of sizes 1e-6 … 1e6 and needles, at any distance; a third of the pairs in parallel poses, a quarter
// of them moved to where they touch.
PrimitivePairs random_pairs(int count) {
  Random random(7);
  const Ball metric(Vector3d::Zero(), 1);
  ObjectDistanceSolver solver(options_for(1));
  PrimitivePairs pairs;
  for (int i = 0; i < count; ++i) {
    const double size = std::pow(10.0, static_cast<double>(random() % 13) - 6);
    const double thin = i % 5 == 0 ? 1e-6 : 1;
    const Primitive one = random_primitive(random, size, thin);
    Primitive two = random_primitive(random, i % 7 == 0 ? 1e-3 * size : size, thin);
    if (i % 3 == 0) two.pose = Pose(one.pose.rotation(), two.pose.translation());
    if (i % 4 == 0) {
      const DistanceResult& r = solver.solve({*one.set(), one.pose}, {*two.set(), two.pose}, metric).distance;
      if (r.normal.size() == 3)
        two.pose = Pose(two.pose.rotation(), Vector(two.pose.translation() + r.upper * r.normal));
    }
    pairs.add(one, two);
  }
  return pairs;
}

TEST(PairSeparations, AreThoseOfSingleTestsWithPlanesThatSeparate) {
  const PrimitivePairs pairs = random_pairs(6000);
  GrowthDistanceSolver alone(options_for(1));
  std::vector<Separation> expected;
  for (const PosedPair& pair : pairs.pairs)
    expected.push_back(alone.separation(pair.first, pair.second).outcome);
  for (const InstructionSet isa : instruction_sets_here()) {
    PairBatch batch(options_for(2, isa));
    Answers answers(pairs.size());
    batch.separations(pairs.pairs, answers.spans());
    std::size_t count[3] = {0, 0, 0};
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      ASSERT_EQ(answers.outcome[i], expected[i]) << i << ", " << to_string(isa);
      ++count[static_cast<std::size_t>(expected[i])];
      const double* u = &answers.normal[3 * i];
      if (expected[i] == Separation::separated) {
        EXPECT_TRUE(is_between(pairs.first[i], pairs.second[i], u)) << i << ", " << to_string(isa);
      } else {
        EXPECT_TRUE(std::isnan(u[0]) && std::isnan(u[1]) && std::isnan(u[2])) << i;
      }
    }
    EXPECT_GT(count[static_cast<std::size_t>(Separation::separated)], pairs.size() / 4);
    EXPECT_GT(count[static_cast<std::size_t>(Separation::intersecting)], pairs.size() / 4);
  }
}

// Of a box, and some points in it.
Eigen::Matrix3Xd corners_of(const Primitive& box, Random& random) {
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(8 + random() % 5));
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    for (Eigen::Index k = 0; k < 3; ++k)
      points(k, i) = i >= 8 ? 0.5 * (box.p[k] + box.q[k]) : (i >> k & 1) == 0 ? box.p[k] : box.q[k];
  }
  return points;
}

// A body along the axes, of quarters, which a pose turns by right angles: as an interval of each axis and a
// ball.
Primitive lattice_primitive(Random& random) {
  const auto quarter = [&](int most) {
    return 0.25 * static_cast<double>(random() % static_cast<unsigned>(most));
  };
  Primitive body;
  body.kind = static_cast<Kind>(random() % Primitive::kKinds);
  body.p = Vector3d(quarter(8), quarter(8), quarter(8));
  body.q = body.p;
  if (body.kind == Kind::box || body.kind == Kind::hull)
    body.q += Vector3d(quarter(6), quarter(6), quarter(6));
  if (body.kind == Kind::hull) body.points = corners_of(body, random);
  if (body.kind == Kind::capsule) body.q[static_cast<Eigen::Index>(random() % 3)] += quarter(6);
  body.radius = has_ball(body) ? quarter(5) : 0;
  constexpr int kTurns[3][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}};
  const int* turn = kTurns[random() % 3];
  Eigen::Matrix3d R = Eigen::Matrix3d::Zero();
  for (int k = 0; k < 3; ++k) R(k, turn[k]) = 1;
  body.pose = Pose(R, Vector3d(quarter(8), quarter(8), quarter(8)));
  return body;
}

// The square of the distance of the cores, exact: quarters are, and so are their squares.
double square_of_gap(const Primitive& one, const Primitive& two) {
  double square = 0;
  const Vector p1 = one.pose.apply(one.p), q1 = one.pose.apply(one.q), p2 = two.pose.apply(two.p),
               q2 = two.pose.apply(two.q);
  for (int k = 0; k < 3; ++k) {
    const double gap = std::max({0.0, p2[k] - q1[k], p1[k] - q2[k]});
    square += gap * gap;
  }
  return square;
}

TEST(PairSeparations, AreRightOnALatticeWhereBodiesTouch) {
  Random random(11);
  PrimitivePairs pairs;
  for (int i = 0; i < 30000; ++i) pairs.add(lattice_primitive(random), lattice_primitive(random));
  GrowthDistanceSolver alone(options_for(1));
  int touching = 0;
  std::vector<bool> apart;
  std::vector<Separation> expected;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double square = square_of_gap(pairs.first[i], pairs.second[i]);
    const double radius = pairs.first[i].radius + pairs.second[i].radius;
    apart.push_back(square > radius * radius);
    touching += square == radius * radius ? 1 : 0;
    expected.push_back(alone.separation(pairs.pairs[i].first, pairs.pairs[i].second).outcome);
  }
  EXPECT_GT(touching, 500);
  for (const InstructionSet isa : instruction_sets_here()) {
    PairBatch batch(options_for(1, isa));
    Answers answers(pairs.size());
    batch.separations(pairs.pairs, answers.spans());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      EXPECT_NE(answers.outcome[i], apart[i] ? Separation::intersecting : Separation::separated) << i;
      ASSERT_EQ(answers.outcome[i], expected[i]) << i;
    }
  }
}

// What the lanes leave open is undecided.
std::vector<Separation> decided_in_lanes(const PrimitivePairs& pairs, InstructionSet isa) {
  std::vector<Separation> outcome(pairs.size(), Separation::undecided);
  SeparationBins bins(isa);
  bins.begin({outcome, {}});
  for (std::size_t i = 0; i < pairs.size(); ++i) bins.add(pairs.pairs[i], i);
  bins.finish();
  return outcome;
}

// Lanes alone: bodies that are a few rounding units apart, or in each other, or touch.
TEST(SeparationKernels, ProveNothingFalseNextToContact) {
  for (const InstructionSet isa : instruction_sets_here()) {
    const Kernels& kernels = kernels_for(isa);
    for (int exponent = -1074; exponent <= 1; ++exponent) {
      for (const double sign : {-1.0, 0.0, 1.0}) {
        const double gap = sign * std::ldexp(1.0, exponent), way = 2 + gap;  // exact, or rounded to 2
        SeparationLanes lanes{};
        for (int lane = 0; lane < SeparationLanes::kCount; ++lane) {
          for (std::size_t k = 0; k < 3; ++k) {
            lanes.rotation[0][4 * k][lane] = lanes.rotation[1][4 * k][lane] = 1;
            lanes.half[0][k][lane] = lanes.half[1][k][lane] = 1;
          }
          lanes.apart[lane % 3][lane] = lane < 4 ? way : -way;
        }
        const auto check = [&](const char* what) {
          if (!(way > 2)) {
            EXPECT_EQ(lanes.are_apart, 0U) << what << exponent << ", " << sign;
          }
          if (!(way <= 2)) {
            EXPECT_EQ(lanes.do_meet, 0U) << what << exponent << ", " << sign;
          }
          if (exponent >= -15 && sign != 0) {
            EXPECT_EQ(sign > 0 ? lanes.are_apart : lanes.do_meet, 0xffU) << what << exponent << ", " << sign;
          }
        };
        kernels.separate_boxes(&lanes);
        check("boxes ");
        for (int lane = 0; lane < SeparationLanes::kCount; ++lane) {
          for (int k = 0; k < 3; ++k) lanes.half[1][k][lane] = 0;
          lanes.radius[lane] = 1;
        }
        kernels.separate_box_from_capsule(&lanes);
        check("box, ball ");
        for (int lane = 0; lane < SeparationLanes::kCount; ++lane) {
          for (int k = 0; k < 3; ++k) lanes.half[0][k][lane] = 0;
          lanes.radius[lane] = 2;
        }
        kernels.separate_capsules(&lanes);
        check("balls ");
      }
    }
  }
}

// The same of hulls: two cubes by their corners.
TEST(SeparationKernels, ProveNothingFalseOfHullsNextToContact) {
  for (const InstructionSet isa : instruction_sets_here()) {
    for (int exponent = -1074; exponent <= 1; ++exponent) {
      for (const double sign : {-1.0, 0.0, 1.0}) {
        const double way = 2 + sign * std::ldexp(1.0, exponent);  // exact, or rounded to 2
        const auto lanes = std::make_unique<HullLanes>();
        lanes->count[0] = lanes->count[1] = 8;
        for (int lane = 0; lane < HullLanes::kCount; ++lane) {
          for (std::size_t k = 0; k < 3; ++k) {
            lanes->rotation[0][4 * k][lane] = lanes->rotation[1][4 * k][lane] = 1;
            for (std::size_t i = 0; i < 8; ++i)
              lanes->point[0][i][k][lane] = lanes->point[1][i][k][lane] = (i >> k & 1) == 0 ? -1 : 1;
          }
          lanes->extent[0][lane] = lanes->extent[1][lane] = 3;
          lanes->apart[lane % 3][lane] = lane < 4 ? way : -way;
        }
        kernels_for(isa).separate_hulls(lanes.get());
        if (!(way > 2)) {
          EXPECT_EQ(lanes->are_apart, 0U) << exponent << ", " << sign;
        }
        if (!(way < 2)) {
          EXPECT_EQ(lanes->do_meet, 0U) << exponent << ", " << sign;
        }
        if (exponent >= -15 && sign != 0) {
          EXPECT_EQ(sign > 0 ? lanes->are_apart : lanes->do_meet, 0xffU) << exponent << ", " << sign;
        }
        lanes->point[0][3][1][2] = std::nan("");
        lanes->extent[0][2] = std::nan("");
        lanes->apart[1][5] = 1e31;
        kernels_for(isa).separate_hulls(lanes.get());
        EXPECT_EQ((lanes->are_apart | lanes->do_meet) & 0x24U, 0U);
      }
    }
  }
}

// What the lanes leave open takes ten times as long: few pairs that are neither thin nor near contact do.
TEST(SeparationKernels, DecideNearlyAllPairsWithHulls) {
  const PrimitivePairs pairs = random_pairs(6000);
  for (const InstructionSet isa : instruction_sets_here()) {
    const std::vector<Separation> outcome = decided_in_lanes(pairs, isa);
    int open = 0, all = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const bool hull = pairs.first[i].kind == Kind::hull || pairs.second[i].kind == Kind::hull;
      if (!hull || i % 5 == 0 || i % 4 == 0) continue;
      if (pairs.first[i].points.cols() > 32 || pairs.second[i].points.cols() > 32) continue;
      ++all;
      open += outcome[i] == Separation::undecided ? 1 : 0;
    }
    EXPECT_GT(all, 1000);
    EXPECT_LT(open, all / 20) << to_string(isa);
  }
}

// Numbers out of their range, and none at all, prove nothing.
TEST(SeparationKernels, LeaveOpenWhatIsNotANumberOrOutOfRange) {
  for (const InstructionSet isa : instruction_sets_here()) {
    const Kernels& kernels = kernels_for(isa);
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1e200, 1e31}) {
      SeparationLanes lanes{};
      for (int lane = 0; lane < SeparationLanes::kCount; ++lane) {
        for (std::size_t k = 0; k < 3; ++k) {
          lanes.rotation[0][4 * k][lane] = lanes.rotation[1][4 * k][lane] = 1;
          lanes.half[0][k][lane] = lanes.half[1][k][lane] = 1;
        }
        lanes.apart[0][lane] = 5;
      }
      lanes.apart[1][2] = bad;
      lanes.half[0][2][3] = bad;
      lanes.center[1][0][5] = bad;
      kernels.separate_boxes(&lanes);
      EXPECT_EQ(lanes.are_apart, 0xffU & ~0x2cU);
      EXPECT_EQ(lanes.do_meet, 0U);
      kernels.separate_box_from_capsule(&lanes);
      EXPECT_EQ(lanes.are_apart, 0xffU & ~0x2cU);
      EXPECT_EQ(lanes.do_meet, 0U);
      kernels.separate_capsules(&lanes);
      EXPECT_EQ((lanes.are_apart | lanes.do_meet) & 0x2cU, 0U);
    }
  }
}

// Edges that are parallel, or nearly: boxes on a table, in the same direction, turned by all angles and by
// tiny ones.
TEST(SeparationKernels, DecideNearlyAllBoxesThatStandUpright) {
  Random random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  PrimitivePairs pairs;
  for (int i = 0; i < 6000; ++i) {
    Primitive one, two;
    one.p = two.p = Vector3d(-0.5, -0.4, -0.3);
    one.q = two.q = Vector3d(0.5, 0.4, 0.3);
    const double tiny = std::pow(10.0, -3 - 16 * std::fabs(uniform(random)));
    const double angle = i % 3 == 0 ? 0 : i % 3 == 1 ? 3 * uniform(random) : tiny;
    const double yaw = 3 * uniform(random);
    const auto turn = [](double by) { return Eigen::Quaterniond(Eigen::AngleAxisd(by, Vector3d::UnitZ())); };
    one.pose = Pose(turn(yaw), Vector3d::Zero());
    two.pose = Pose(turn(yaw + angle), Vector3d(uniform(random), uniform(random), 0.5 * uniform(random)));
    pairs.add(one, two);
  }
  GrowthDistanceSolver alone(options_for(1));
  for (const InstructionSet isa : instruction_sets_here()) {
    const std::vector<Separation> outcome = decided_in_lanes(pairs, isa);
    int open[3] = {0, 0, 0};
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      open[i % 3] += outcome[i] == Separation::undecided ? 1 : 0;
      if (outcome[i] != Separation::undecided) {
        EXPECT_EQ(outcome[i], alone.separation(pairs.pairs[i].first, pairs.pairs[i].second).outcome) << i;
      }
    }
    EXPECT_LE(open[0], 2) << to_string(isa);
    EXPECT_LE(open[1], 2) << to_string(isa);
    EXPECT_LE(open[2], 400) << to_string(isa);  // of 2000: between parallel and not
  }
}

// Square rods that cross at a small angle, edge over edge: only the axis across both edges may part them.
TEST(SeparationKernels, LookAcrossEdgesThatAreNearlyParallel) {
  constexpr double kHalf = 0.01;
  GrowthDistanceSolver alone(options_for(1));
  for (const InstructionSet isa : instruction_sets_here()) {
    SeparationBins bins(isa);
    for (int k = 2; k <= 40; ++k) {
      const double angle = std::pow(10.0, -0.3 * k);
      for (int i = 4; i < 36; ++i) {
        const double over = (i % 2 == 0 ? 1 : -1) * std::pow(10.0, -0.5 * i), share = 1 + over;
        Primitive one, two;
        one.p = two.p = Vector3d(-kHalf, -kHalf, -1);
        one.q = two.q = Vector3d(kHalf, kHalf, 1);
        const auto turned = [](double tilt) {
          return Eigen::Quaterniond(Eigen::AngleAxisd(tilt, Vector3d::UnitX()) *
                                    Eigen::AngleAxisd(0.25 * M_PI, Vector3d::UnitZ()));
        };
        one.pose = Pose(turned(0.5 * angle), Vector3d::Zero());
        two.pose = Pose(turned(-0.5 * angle), Vector3d(share * 2 * std::sqrt(2.0) * kHalf, 0, 0));
        PrimitivePairs pairs;
        pairs.add(one, two);
        Separation outcome = Separation::undecided;
        bins.begin({{&outcome, 1}, {}});
        bins.add(pairs.pairs[0], 0);
        bins.finish();
        EXPECT_TRUE(outcome != Separation::undecided || i > 4 || angle < 1e-3) << angle << ", " << over;
        if (outcome == Separation::undecided) continue;
        EXPECT_EQ(outcome, alone.separation(pairs.pairs[0].first, pairs.pairs[0].second).outcome)
            << angle << ", " << over;
      }
    }
  }
}

TEST(PairSeparations, DependNeitherOnThreadsNorOnWhatTheBatchDidBefore) {
  const PrimitivePairs pairs = random_pairs(1500);
  PairBatch first(options_for(1));
  Answers expected(pairs.size());
  first.separations(pairs.pairs, expected.spans());
  for (const int threads : {1, 2, 5}) {
    PairBatch batch(options_for(1), threads);
    const auto source = [&](std::size_t i, int /*thread*/) { return pairs.pairs[i]; };
    for (int round = 0; round < 3; ++round) {
      Answers answers(pairs.size());
      if (round == 1) {
        batch.separations(pairs.size(), source, 3, answers.spans());
      } else {
        batch.separations(pairs.pairs, answers.spans());
      }
      EXPECT_EQ(answers.outcome, expected.outcome);
      for (std::size_t k = 0; k < answers.normal.size(); ++k) {
        if (!std::isnan(expected.normal[k])) {
          EXPECT_EQ(answers.normal[k], expected.normal[k]);
        }
      }
      batch.separations(std::span(pairs.pairs).first(5), {std::span(answers.outcome).first(5), {}});
    }
  }
}

// Hulls, bodies without a pose, bodies of the plane and methods that the vectors do not stand for.
TEST(PairSeparations, AreThoseOfSingleTestsForAllOtherSetsAndMethods) {
  Random random(5);
  Eigen::Matrix3Xd points(3, 40);
  for (double& x : points.reshaped()) x = 0.3 * gaussian(random).x();
  const PreparedSet hull(points);
  const Box box(Vector3d(-1, -0.5, -0.2), Vector3d(1, 0.5, 0.2));
  const Ball ball(Vector3d(1.1, 0, 0), 0.5), far(Vector3d(9, 0, 0), 0.5), disc(Eigen::Vector2d(3, 0), 1);
  const Box square(Eigen::Vector2d(-1, -1), Eigen::Vector2d(1, 1));
  const std::vector<PosedPair> pairs = {{hull, box}, {box, ball}, {far, box}, {ball, hull}, {far, hull}};
  for (const DistanceMethod method : {DistanceMethod::newton, DistanceMethod::zheng_yamane}) {
    DistanceOptions options = options_for(1);
    options.method = method;
    PairBatch batch(options);
    GrowthDistanceSolver alone(options);
    std::vector<Separation> outcome(pairs.size());
    batch.separations(pairs, {outcome, {}});
    for (std::size_t i = 0; i < pairs.size(); ++i)
      EXPECT_EQ(outcome[i], alone.separation(pairs[i].first, pairs[i].second).outcome) << i;
    const std::vector<PosedPair> flat = {{square, disc}, {disc, disc}};
    std::vector<double> normal(4);
    batch.separations(flat, {std::span(outcome).first(2), normal});
    EXPECT_EQ(outcome[0], Separation::separated);
    EXPECT_LT(normal[0], 0);
    EXPECT_EQ(outcome[1], Separation::intersecting);
  }
}

TEST(PairSeparations, RefuseArraysOfAnotherSizeAndBodiesOfOtherSpaces) {
  const Box box(Vector3d(-1, -1, -1), Vector3d(1, 1, 1)),
      square(Eigen::Vector2d(-1, -1), Eigen::Vector2d(1, 1));
  const std::vector<PosedPair> pairs = {{box, box}, {box, square}};
  PairBatch batch(options_for(1));
  std::vector<Separation> outcome(2);
  std::vector<double> few(5);
  EXPECT_THROW(batch.separations(pairs, {}), InvalidParameterError);
  EXPECT_THROW(batch.separations(pairs, {outcome, few}), InvalidParameterError);
  try {
    batch.separations(pairs, {outcome, {}});
    ADD_FAILURE() << "nothing was thrown";
  } catch (const DimensionMismatchError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("problem 1: ")) << error.what();
  }
  batch.separations({}, {});
}

TEST(PairSeparations, AreUndecidedAfterAStop) {
  const PrimitivePairs pairs = random_pairs(500);
  PairBatch batch(options_for(1), 2);
  batch.set_stop([] { return true; });
  Answers answers(pairs.size());
  std::fill(answers.outcome.begin(), answers.outcome.end(), Separation::separated);
  batch.separations(pairs.pairs, answers.spans());
  for (const Separation outcome : answers.outcome) EXPECT_EQ(outcome, Separation::undecided);
}

}  // namespace
}  // namespace raygauge::test_pair_separations
