// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/friction_jam.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <cstdint>

#include "scene/simulation/friction_ladder.h"
#include "scene/simulation/friction_passes.h"
#include "tests/scene/simulation/small_islands.h"

namespace raygauge::test_friction_jam {
namespace {

// A ball in the plane that has rolled between a floor and a body that comes down on it, whose faces are 6
// degrees from each other: of simulation 651 of the soak test with seed 241.
FrictionIsland wedge(double mu) {
  constexpr double kMass = 378.786, kInertia = 40.4654, kRadius = 0.4622321477168616;
  const Eigen::Vector2d normals[] = {{-0.1090358560448052, -0.9940378172366364}, {0, 1}};
  const Eigen::Vector2d approach[] = {{-1.7967171446676837, 5.8488177359710329}, {0, 0}};
  FrictionIsland island;
  island.bodies = 1;
  for (int c = 0; c < 2; ++c) {
    IslandContact& one = island.contacts.emplace_back();
    const Eigen::Vector2d n = normals[c];
    one.a = 0;
    one.mu = mu;
    one.q.head<2>() = approach[c];
    one.A_a.col(0).head<2>() = n / std::sqrt(kMass);
    one.A_a.col(1).head<2>() = Eigen::Vector2d(-n[1], n[0]) / std::sqrt(kMass);
    one.A_a(5, 1) = -kRadius / std::sqrt(kInertia);
  }
  return island;
}

enum class Mode : std::uint8_t { open, sticks, slips, slips_back };
constexpr Mode kModes[] = {Mode::open, Mode::sticks, Mode::slips, Mode::slips_back};

// Whether impulses of two contacts in the plane that do so obey Coulomb's law.
bool is_solution(const FrictionIsland& island, const Mode (&modes)[2]) {
  Eigen::Matrix<double, 6, 4> A;
  Eigen::Vector4d q;
  for (Eigen::Index c = 0; c < 2; ++c) {
    A.middleCols<2>(2 * c) = island.contacts[static_cast<std::size_t>(c)].A_a.leftCols<2>();
    q.segment<2>(2 * c) = island.contacts[static_cast<std::size_t>(c)].q.head<2>();
  }
  const double mu = island.contacts[0].mu;
  const Eigen::Matrix4d W = A.transpose() * A;
  Eigen::Matrix4d rows = Eigen::Matrix4d::Identity();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (Eigen::Index c = 0; c < 2; ++c) {
    const Eigen::Index n = 2 * c, t = n + 1;
    const auto moves_with = [&](Eigen::Index k) {
      rows.row(k) = W.row(k);
      right[k] = -q[k];
    };
    if (modes[c] != Mode::open) moves_with(n);
    if (modes[c] == Mode::sticks) moves_with(t);
    if (modes[c] == Mode::slips) rows(t, n) = mu;
    if (modes[c] == Mode::slips_back) rows(t, n) = -mu;
  }
  const Eigen::FullPivLU<Eigen::Matrix4d> factors(rows);
  if (!factors.isInvertible()) return false;
  const Eigen::Vector4d r = factors.solve(right), u = W * r + q;
  for (Eigen::Index c = 0; c < 2; ++c) {
    constexpr double kRounding = 1e-9;
    const Eigen::Index n = 2 * c, t = n + 1;
    if (r[n] < -kRounding || u[n] < -kRounding) return false;
    if (modes[c] == Mode::sticks && std::fabs(r[t]) > mu * r[n] + kRounding) return false;
    if (modes[c] == Mode::slips && u[t] < -kRounding) return false;
    if (modes[c] == Mode::slips_back && u[t] > kRounding) return false;
  }
  return true;
}

bool has_solution(const FrictionIsland& island) {
  for (const Mode one : kModes) {
    for (const Mode two : kModes) {
      if (is_solution(island, {one, two})) return true;
    }
  }
  return false;
}

void expect_jam(const FrictionIsland& island, const Eigen::VectorXd& r) {
  Eigen::Matrix<double, 6, Eigen::Dynamic> sum = Eigen::MatrixXd::Zero(6, island.bodies);
  double work = 0;
  for (std::size_t c = 0; c < island.contacts.size(); ++c) {
    const IslandContact& contact = island.contacts[c];
    const Eigen::Vector3d here = r.segment<3>(3 * static_cast<Eigen::Index>(c));
    EXPECT_LE(here.tail<2>().norm(), contact.mu * here[0] + 1e-15);
    work += here.dot(contact.q);
    if (contact.a >= 0) sum.col(contact.a) += contact.A_a * here;
    if (contact.b >= 0) sum.col(contact.b) += contact.A_b * here;
  }
  EXPECT_LT(work, 0);
  EXPECT_LE(sum.norm() * island.size_of_q() * 1e4, r.squaredNorm() * std::sqrt(island.bound_of_W()));
}

TEST(FrictionJam, a_ball_in_a_wedge_that_closes_is_jammed_by_its_friction) {
  const FrictionIsland rough = wedge(0.371306);
  const auto jam = jam_of(rough);
  ASSERT_TRUE(jam);
  expect_jam(rough, *jam);
  EXPECT_FALSE(has_solution(rough));
  Eigen::VectorXd r = small_islands::zeros(rough);
  EXPECT_GT(solve_friction(rough, nullptr, r), kUnsolvable);

  // Half of the angle of the wedge is 3.1 degrees.
  const FrictionIsland smooth = wedge(0.05);
  EXPECT_FALSE(jam_of(smooth));
  EXPECT_TRUE(has_solution(smooth));
  r.setZero();
  EXPECT_LE(solve_friction(smooth, nullptr, r), kSolvedFriction);
}

// Among others that do not react and close in on it.
FrictionIsland one_body(int contacts, double mu, small_islands::Random& random) {
  FrictionIsland island = small_islands::heap(contacts, contacts, mu, random);
  island.bodies = 1;
  for (IslandContact& contact : island.contacts) contact.a = 0;
  return island;
}

double residual_without_friction(const FrictionIsland& island) {
  const FrictionProblem problem = island.dense();
  const auto normals = Eigen::seqN(0, static_cast<Eigen::Index>(island.contacts.size()), 3);
  const Eigen::MatrixXd W = problem.W(normals, normals);
  const Eigen::VectorXd q = problem.q(normals);
  return nonnegative_residual(W, q, nonnegative_solution(W, q));
}

// Of bodies without friction all or nothing is proven.
TEST(FrictionJam, without_friction_what_has_no_solution_is_jammed) {
  small_islands::Random random(3);
  int jammed = 0, solved = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const FrictionIsland island = one_body(4 + trial % 12, 0, random);
    const auto jam = jam_of(island);
    EXPECT_EQ(jam.has_value(), residual_without_friction(island) > kUnsolvable) << trial;
    (jam ? jammed : solved) += 1;
    if (jam) expect_jam(island, *jam);
  }
  EXPECT_GT(jammed, 20);
  EXPECT_GT(solved, 20);
}

// With friction what is not jammed is solved.
TEST(FrictionJam, with_friction_the_rest_is_solved) {
  small_islands::Random random(7);
  int jammed = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const FrictionIsland island = one_body(2 + trial % 4, 0.6, random);
    const auto jam = jam_of(island);
    jammed += jam ? 1 : 0;
    if (jam) {
      expect_jam(island, *jam);
      continue;
    }
    Eigen::VectorXd r = small_islands::zeros(island);
    EXPECT_LE(solve_friction(island, nullptr, r), kUnsolvable) << trial;
  }
  EXPECT_GT(jammed, 10);
  EXPECT_LT(jammed, 190);
}

}  // namespace
}  // namespace raygauge::test_friction_jam
