// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// What does a solve of smooth sets cost, by method and tolerance? Pairs of a truncated cone and an ellipsoid
// in R^3 that touch at a planted point of a disc, the nappe or a rim, the gauge body then scaled: distance 1,
// 2 or 1/2.
#include <benchmark/benchmark.h>

#include <Eigen/QR>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "raygauge/queries/solver.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/truncated_cone.h"

namespace raygauge::bench {
namespace {

constexpr int kPairs = 600;

struct Pair {
  std::shared_ptr<const ConvexSet> A, Q;
  double distance = 1;
};

class PairMaker {
 public:
  // `contact`: 0 the base disc, 1 the nappe, 2 the rim of the base, 3 that of the top.
  Pair make(bool cone_is_gauge, int contact, double distance) {
    const Vector a = normal().normalized();
    Vector t = normal();
    t = (t - t.dot(a) * a).normalized();
    const double height = uniform(0.5, 2), r_b = uniform(0.3, 1), r_t = r_b * uniform(0, 1),
                 share = uniform(0, 1);
    const Vector beside = (t * height + a * (r_b - r_t)).normalized();
    Vector p = r_b * t, u = (share * beside - (1 - share) * a).normalized();
    if (contact == 0) p = r_b * std::sqrt(share) * t, u = -a;
    if (contact == 1) p = share * height * a + (r_b + (r_t - r_b) * share) * t, u = beside;
    if (contact == 3) p = height * a + r_t * t, u = (share * beside + (1 - share) * a).normalized();
    Eigen::MatrixXd frame(3, 3);
    frame << normal(), normal(), normal();
    const Eigen::MatrixXd R = Eigen::HouseholderQR<Eigen::MatrixXd>(frame).householderQ();
    const Eigen::MatrixXd L =
        R * Vector3(uniform(0.3, 1.5), uniform(0.3, 1.5), uniform(0.3, 1.5)).asDiagonal();
    const Vector z = L.transpose() * -u;
    const Vector c = p - L * z / z.norm(), middle = 0.5 * height * a;
    const double s = 1 / distance;
    if (cone_is_gauge) {
      return {std::make_shared<Ellipsoid>(c - middle, L),
              std::make_shared<TruncatedCone>(-s * middle, s * r_b, s * middle, s * r_t), distance};
    }
    return {std::make_shared<TruncatedCone>(-c, r_b, height * a - c, r_t),
            std::make_shared<Ellipsoid>(Vector::Zero(3), s * L), distance};
  }

 private:
  using Vector3 = Eigen::Vector3d;
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Vector normal() {
    std::normal_distribution<double> component;
    const double x = component(random_), y = component(random_), z = component(random_);
    return Vector3(x, y, z);
  }
  std::mt19937_64 random_{7};
};

std::vector<Pair> make_pairs(bool cone_is_gauge) {
  PairMaker maker;
  std::vector<Pair> pairs;
  for (int i = 0; i < kPairs; ++i) {
    pairs.push_back(
        maker.make(cone_is_gauge, i % 4, std::array{1.0, 2.0, 0.5}[static_cast<std::size_t>(i % 3)]));
  }
  return pairs;
}

void smooth_solve(benchmark::State& state, const DistanceOptions& options, bool cone_is_gauge) {
  const std::vector<Pair> pairs = make_pairs(cone_is_gauge);
  DistanceSolver solver(options);
  double outer = 0, evaluations = 0, error = 0, unsolved = 0;
  for (const Pair& pair : pairs) {
    const DistanceResult& result = solver.solve(*pair.A, *pair.Q);
    outer += static_cast<double>(result.counters.outer_iterations) / kPairs;
    evaluations += static_cast<double>(result.counters.ray_iterations) / kPairs;
    error += std::fabs(result.distance - pair.distance) / kPairs;
    unsolved +=
        result.status != DistanceStatus::optimal && options.stop_rule == StopRule::certified_gap ? 1 : 0;
  }
  std::size_t next = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(solver.solve(*pairs[next].A, *pairs[next].Q).distance);
    next = (next + 1) % kPairs;
  }
  state.counters["K"] = outer;
  state.counters["N_rs"] = evaluations;
  state.counters["error"] = error;
  state.counters["unsolved"] = unsolved;
}

void register_method(const std::string& name, DistanceMethod method, StopRule rule) {
  for (const bool cone_is_gauge : {false, true}) {
    for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-12}) {
      DistanceOptions options;
      options.method = method;
      options.stop_rule = rule;
      options.tolerance = tolerance;
      char digits[16];
      std::snprintf(digits, sizeof digits, "%.0e", tolerance);
      const std::string title = "smooth_solve/" + name + (cone_is_gauge ? "/table2/" : "/table1/") + digits;
      benchmark::RegisterBenchmark(title.c_str(), smooth_solve, options, cone_is_gauge)
          ->Unit(benchmark::kMicrosecond);
    }
  }
}

const bool registered = [] {
  register_method("newton", DistanceMethod::newton, StopRule::certified_gap);
  register_method("column_generation", DistanceMethod::column_generation, StopRule::certified_gap);
  register_method("zheng_yamane", DistanceMethod::zheng_yamane, StopRule::certified_gap);
  register_method("published_sigma", DistanceMethod::zheng_yamane, StopRule::published_sigma);
  return true;
}();

}  // namespace
}  // namespace raygauge::bench
