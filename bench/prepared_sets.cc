// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// What does preparing a set of points of R^n cost, what does a prepared set spare support queries and solves,
// and after how many solves has it paid?
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>
#include <vector>

#include "bench/program.h"
#include "bench/timed_medians.h"
#include "raygauge/queries/solver.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/prepared_set.h"

namespace raygauge::bench {
namespace {

struct Settings {
  std::vector<int> dimensions = {2, 4, 6, 8, 10};
  std::vector<int> points = {20000, 100000};
  std::string kind = "sphere";
  int rounds = 101;
};

using Random = std::mt19937_64;

// N points of a kind about the origin.
Eigen::MatrixXd cloud(const std::string& kind, int n, int N, Random& random) {
  std::normal_distribution<double> normal;
  Eigen::MatrixXd points(n, N);
  for (double& x : points.reshaped()) x = normal(random);
  if (kind == "sphere") points.colwise().normalize();
  if (kind == "clusters") {
    points.colwise().normalize();
    for (int i = 50; i < N; ++i) points.col(i) = points.col(i % 50) + 0.05 * points.col(i);
  }
  if (kind == "needle") {
    points.colwise().normalize();
    points.row(n - 1) *= 1e4;
  }
  return points;
}

double median(std::vector<double> seconds) {
  const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
  std::nth_element(seconds.begin(), middle, seconds.end());
  return *middle;
}

// Medians of two calls that take turns.
struct Medians {
  double plain = 0, prepared = 0;
};

Medians in_turn(int rounds, const std::function<void()>& plain, const std::function<void()>& prepared) {
  std::vector<double> one, two;
  for (int round = 0; round < rounds; ++round) {
    one.push_back(seconds_of(plain));
    two.push_back(seconds_of(prepared));
  }
  return {median(one), median(two)};
}

// Seconds of one support query, of many along random directions.
Medians time_support(const Settings& settings, const ConvexSet& plain, const ConvexSet& prepared,
                     Random& random) {
  constexpr int kDirections = 64;
  std::normal_distribution<double> normal;
  Eigen::MatrixXd directions(plain.dimension(), kDirections);
  for (double& x : directions.reshaped()) x = normal(random);
  Vector point(plain.dimension());
  const auto ask = [&](const ConvexSet& S) {
    return [&] {
      for (int i = 0; i < kDirections; ++i) S.support_unchecked(directions.col(i).data(), point.data());
    };
  };
  const Medians medians = in_turn(settings.rounds, ask(plain), ask(prepared));
  return {medians.plain / kDirections, medians.prepared / kDirections};
}

void print_row(const Settings& settings, int n, int N) {
  Random random(static_cast<std::uint64_t>(n) * 1000003 + static_cast<std::uint64_t>(N));
  Eigen::MatrixXd A = cloud(settings.kind, n, N, random);
  const Eigen::MatrixXd Q = cloud(settings.kind, n, N, random);
  A.row(0).array() += settings.kind == "gaussian" ? 12 : 4;
  const PointSet plain_A(A), plain_Q(Q);
  std::unique_ptr<const PreparedSet> prepared_A, prepared_Q;
  const double plain_seconds = seconds_of([&] { PointSet{A}, PointSet{Q}; });
  const double seconds = seconds_of([&] {
    prepared_A = std::make_unique<PreparedSet>(A);
    prepared_Q = std::make_unique<PreparedSet>(Q);
  });
  const Medians support = time_support(settings, plain_A, *prepared_A, random);
  DistanceOptions options;
  options.method = DistanceMethod::column_generation;
  DistanceSolver one(options), two(options);
  const Medians solve = in_turn(
      settings.rounds, [&] { one.solve(plain_A, plain_Q); }, [&] { two.solve(*prepared_A, *prepared_Q); });
  const double gain = solve.plain - solve.prepared;
  std::printf("%3d %7d  %8.1f %8.1f  %8.2f %8.2f %6.2f  %8.1f %8.1f %6.2f", n, N, 1e3 * seconds,
              static_cast<double>(prepared_A->memory() + prepared_Q->memory()) * 1e-6, 1e6 * support.plain,
              1e6 * support.prepared, support.prepared / support.plain, 1e6 * solve.plain,
              1e6 * solve.prepared, solve.prepared / solve.plain);
  if (gain > 0.1 * solve.plain) {
    std::printf("  %8.0f\n", std::ceil((seconds - plain_seconds) / gain));
  } else {
    std::printf("  %8s\n", "never");
  }
}

void options(CLI::App& app, Settings& settings) {
  app.add_option("--dimensions", settings.dimensions, "n")->delimiter(',')->check(CLI::Range(2, 500));
  app.add_option("--points", settings.points, "N, of each set")
      ->delimiter(',')
      ->check(CLI::Range(1, 10000000));
  app.add_option("--kind", settings.kind, "how the points of both sets lie")
      ->check(CLI::IsMember({"sphere", "gaussian", "clusters", "needle"}));
  app.add_option("--rounds", settings.rounds, "calls that a median is of")->check(CLI::PositiveNumber);
}

void run(const Settings& settings) {
  std::printf(
      "%s: two sets of N points; preparing both, a support query, column_generation; plain, prepared, "
      "ratio\n",
      settings.kind.c_str());
  std::printf(
      "  n       N  prepare/ms     MB  support/us                 solve/us                 pays off after\n");
  for (const int n : settings.dimensions) {
    for (const int N : settings.points) print_row(settings, n, N);
  }
}

}  // namespace
}  // namespace raygauge::bench

int main(int argc, char** argv) {
  return raygauge::bench::run_with_options<raygauge::bench::Settings>(
      "raygauge_prepared_sets", "What do prepared sets of points of R^n cost and spare?",
      raygauge::bench::options, raygauge::bench::run, argc, argv);
}
