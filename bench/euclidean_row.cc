// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// The Euclidean distance of two point sets beside LIBSVM.
#include <algorithm>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <vector>

#include "bench/ratio_rows.h"
#include "bench/ratio_summary.h"
#include "bench/timed_medians.h"
#include "engine/sweep/order_statistics.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/operations.h"

namespace raygauge::bench {
namespace {

constexpr double kTolerance = 1e-6;

// ObjectDistanceSolver with its default method.
class ObjectDistanceMethod final : public SolveMethod {
 public:
  void load(const Instance& instance) override { instance_ = instance; }
  void solve(const SolveRequest& /*the defaults*/) override {
    const auto& sets = dynamic_cast<const MinkowskiDifference&>(*instance_.A);
    result_ = &solver_.solve(*sets.A1(), *sets.A2(), *instance_.Q).distance;
  }
  DistanceResult result() override { return *result_; }

 private:
  ObjectDistanceSolver solver_;
  Instance instance_;
  const DistanceResult* result_ = nullptr;
};

Instance euclidean_instance(const Variant& variant, int n, int N, int repetition) {
  Instance sets = make_instance(variant, n, N, repetition);
  sets.A = std::make_shared<MinkowskiDifference>(sets.A, sets.Q);
  sets.Q = std::make_shared<Ball>(Vector::Zero(n), 1.0);
  return sets;
}

struct EuclideanCell {
  double ours = 0, libsvm = 0, libsvm_loose = 0;  // median seconds
  double loose_error = 0;                         // the greatest relative error of the third
  int certified = 0;
  int agreed = 0;
};

EuclideanCell measure(const Variant& variant, int n, int N, int instances, Clock clock) {
  ObjectDistanceMethod ours;
  const auto libsvm = make_method("libsvm_smo", {});
  const auto loose = make_method("libsvm_smo", {{"eps", 1e-3}});
  SolveMethod* methods[] = {&ours, libsvm.get(), loose.get()};
  std::vector<double> seconds[3];
  EuclideanCell cell;
  for (int repetition = 0; repetition < instances; ++repetition) {
    const Instance instance = euclidean_instance(variant, n, N, repetition);
    for (int turn = 0; turn < 3; ++turn) {
      const int m = (turn + repetition) % 3;
      methods[m]->load(instance);
      seconds[m].push_back(cold_solve_seconds(*methods[m], clock));
    }
    const DistanceResult truth = ours.result();
    const DistanceResult claim = libsvm->result();
    cell.certified +=
        truth.status == DistanceStatus::optimal && truth.upper - truth.lower <= kTolerance * truth.upper;
    cell.agreed += claim.lower <= truth.upper && truth.lower <= claim.upper;
    cell.loose_error = std::max(cell.loose_error, loose->result().distance / truth.distance - 1);
  }
  cell.ours = sample_median(seconds[0]);
  cell.libsvm = sample_median(seconds[1]);
  cell.libsvm_loose = sample_median(seconds[2]);
  return cell;
}

}  // namespace

void print_euclidean(const Variant& variant, const Effort& effort) {
  if (!has_method("libsvm_smo")) throw std::runtime_error("this build has no LIBSVM to compare with");
  const Clock clock = effort.processor_time ? Clock::processor : Clock::wall;
  Summary summary("default / libsvm");
  Summary loose("  eps = 1e-3");
  for (const int n : {3, 10, 50, 100, 200}) {
    std::vector<int> counts = {2 * n, 200, 500, 2000};
    if (effort.quick) counts = {2 * n, 2000};
    for (const int N : counts) {
      if (N < 2 * n || (N == 200 && n == 100)) continue;
      const EuclideanCell cell = measure(variant, n, N, effort.instances, clock);
      std::printf(
          "n = %3d  N = %4d  default %9.4g ms  libsvm %9.4g ms  ratio %.4f   eps = 1e-3 %9.4g ms (off by "
          "%.1g)  "
          "certified %d, agreed %d of %d\n",
          n, N, 1e3 * cell.ours, 1e3 * cell.libsvm, cell.ours / cell.libsvm, 1e3 * cell.libsvm_loose,
          cell.loose_error, cell.certified, cell.agreed, effort.instances);
      std::fflush(stdout);
      summary.add(cell.ours / cell.libsvm, n, N);
      loose.add(cell.ours / cell.libsvm_loose, n, N);
    }
  }
  summary.print();
  loose.print();
}

}  // namespace raygauge::bench
