// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// Shapes beyond random point sets: boxes and cross-polytopes beside the LP solvers, smooth sets by newton.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/ratio_rows.h"
#include "bench/ratio_summary.h"
#include "bench/timed_medians.h"
#include "engine/sweep/order_statistics.h"
#include "raygauge/queries/solver.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/p_norm_ball.h"

namespace raygauge::bench {
namespace {

using Random = std::mt19937_64;
using Set = std::shared_ptr<const ConvexSet>;

Eigen::VectorXd uniform(int n, double least, double most, Random& random) {
  std::uniform_real_distribution<double> distribution(least, most);
  return Eigen::VectorXd::NullaryExpr(n, [&] { return distribution(random); });
}

// Of length `distance`.
Eigen::VectorXd place(int n, double distance, Random& random) {
  return distance * uniform(n, -1, 1, random).normalized();
}

Eigen::MatrixXd box_vertices(const Eigen::VectorXd& half) {
  const auto n = static_cast<int>(half.size());
  return Eigen::MatrixXd::NullaryExpr(n, Eigen::Index{1} << n, [&](Eigen::Index k, Eigen::Index i) {
    return (i >> k) % 2 == 0 ? -half[k] : half[k];
  });
}

Eigen::MatrixXd cross_polytope_vertices(int n) {
  Eigen::MatrixXd vertices(n, 2 * n);
  vertices << Eigen::MatrixXd::Identity(n, n), -Eigen::MatrixXd::Identity(n, n);
  return vertices;
}

// Boxes of half-edges 0.1 … 1 against the cube.
Instance boxes(int n, Random& random) {
  Eigen::MatrixXd a = box_vertices(uniform(n, 0.1, 1, random));
  a.colwise() += place(n, 3 * std::sqrt(n), random);
  Instance instance;
  instance.A = std::make_shared<PointSet>(a);
  instance.Q = std::make_shared<PointSet>(box_vertices(Eigen::VectorXd::Ones(n)));
  return instance;
}

// Two cross-polytopes; a rotation would make them general point sets.
Instance cross_polytopes(int n, Random& random) {
  Eigen::MatrixXd a = cross_polytope_vertices(n);
  a.colwise() += place(n, 3, random);
  Instance instance;
  instance.A = std::make_shared<PointSet>(a);
  instance.Q = std::make_shared<PointSet>(cross_polytope_vertices(n));
  return instance;
}

Set ellipsoid(int n, const Eigen::VectorXd& center, Random& random) {
  const Eigen::MatrixXd factor = Eigen::MatrixXd::NullaryExpr(
      n, n, [&] { return std::normal_distribution<double>()(random) / std::sqrt(n); });
  return std::make_shared<Ellipsoid>(center, factor + Eigen::MatrixXd::Identity(n, n));
}

Set p_norm_ball(int n, const Eigen::VectorXd& center, double p, Random& random) {
  return std::make_shared<PNormBall>(center, uniform(n, 0.5, 2, random), p);
}

Instance ellipsoids(int n, Random& random) {
  Instance instance;
  instance.A = ellipsoid(n, place(n, 9, random), random);
  instance.Q = ellipsoid(n, Eigen::VectorXd::Zero(n), random);
  return instance;
}

Instance p_norm_balls(int n, Random& random) {
  Instance instance;
  instance.A = p_norm_ball(n, place(n, 9, random), 3, random);
  instance.Q = p_norm_ball(n, Eigen::VectorXd::Zero(n), 1.5, random);
  return instance;
}

Instance sums(int n, Random& random) {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(n);
  Instance instance;
  instance.A = std::make_shared<MinkowskiSum>(ellipsoid(n, place(n, 16, random), random),
                                              p_norm_ball(n, zero, 3, random));
  instance.Q = std::make_shared<MinkowskiSum>(ellipsoid(n, zero, random), p_norm_ball(n, zero, 3, random));
  return instance;
}

struct Shape {
  const char* name;
  Instance (*make)(int n, Random& random);
  std::vector<int> dimensions;
};

// Median seconds of each method, taking turns.
std::vector<double> medians(const Shape& shape, int n, const std::vector<std::string>& names,
                            const Effort& effort) {
  const Clock clock = effort.processor_time ? Clock::processor : Clock::wall;
  std::vector<std::unique_ptr<SolveMethod>> methods;
  for (const std::string& name : names) methods.push_back(make_method(name));
  std::vector<std::vector<double>> seconds(names.size());
  Random random(static_cast<unsigned>(n));
  for (int repetition = 0; repetition < effort.instances; ++repetition) {
    const Instance instance = shape.make(n, random);
    for (std::size_t turn = 0; turn < names.size(); ++turn) {
      const std::size_t m = (turn + static_cast<std::size_t>(repetition)) % names.size();
      methods[m]->load(instance);
      seconds[m].push_back(cold_solve_seconds(*methods[m], clock));
    }
  }
  std::vector<double> result;
  for (auto& of_method : seconds) result.push_back(sample_median(of_method));
  return result;
}

void print_polytopes(const Effort& effort) {
  const Shape shapes[] = {{"boxes", boxes, {3, 5, 8, 10, 12}},
                          {"cross-polytopes", cross_polytopes, {10, 50, 100, 200, 500}}};
  std::vector<std::string> names = {"column_generation", "zheng_yamane"};
  for (const std::string& lp : lp_methods()) names.push_back(lp);
  if (names.size() == 2) throw std::runtime_error("this build has no LP solver to compare with");
  Summary generation("column_generation / best LP");
  Summary published("zheng_yamane / best LP");
  for (const Shape& shape : shapes) {
    for (const int n : shape.dimensions) {
      if (effort.quick && n > 100) continue;
      const std::vector<double> seconds = medians(shape, n, names, effort);
      const auto best = std::min_element(seconds.begin() + 2, seconds.end());
      const int N = shape.make == boxes ? 1 << n : 2 * n;
      std::printf("%-16s n = %3d, N = %4d: column_generation %.4g ms, zheng_yamane %.4g ms, %s %.4g ms\n",
                  shape.name, n, N, 1e3 * seconds[0], 1e3 * seconds[1],
                  names[static_cast<std::size_t>(best - seconds.begin())].c_str(), 1e3 * *best);
      std::fflush(stdout);
      generation.add(seconds[0] / *best, n, N);
      published.add(seconds[1] / *best, n, N);
    }
  }
  generation.print();
  published.print();
}

void print_smooth(const Effort& effort) {
  const std::vector<int> dimensions = {3, 10, 50, 100, 200};
  const Shape shapes[] = {{"ellipsoids", ellipsoids, dimensions},
                          {"p-norm balls", p_norm_balls, dimensions},
                          {"sums of both", sums, dimensions}};
  DistanceOptions options;
  options.tolerance = 1e-6;
  options.method = DistanceMethod::newton;
  DistanceSolver solver(options);
  for (const Shape& shape : shapes) {
    for (const int n : shape.dimensions) {
      std::vector<double> seconds;
      std::vector<double> queries;
      int certified = 0;
      Random random(static_cast<unsigned>(n));
      for (int repetition = 0; repetition < effort.instances; ++repetition) {
        const Instance instance = shape.make(n, random);
        solver.solve(*instance.A, *instance.Q);
        seconds.push_back(seconds_of([&] { solver.solve(*instance.A, *instance.Q); }));
        const DistanceResult& result = solver.solve(*instance.A, *instance.Q);
        certified += result.status == DistanceStatus::optimal ? 1 : 0;
        queries.push_back(static_cast<double>(result.counters.support_queries));
      }
      std::printf("%-16s n = %3d: newton %.4g ms, %.0f support queries, certified %d of %d\n", shape.name, n,
                  1e3 * sample_median(seconds), sample_median(queries), certified, effort.instances);
      std::fflush(stdout);
    }
  }
}

}  // namespace

void print_shapes(const Variant& /*its own instances*/, const Effort& effort) {
  print_polytopes(effort);
  print_smooth(effort);
}

}  // namespace raygauge::bench
