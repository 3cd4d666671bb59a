// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "raygauge/sets/point_set.h"
#include "raygauge/sweep.h"

namespace raygauge::testing {

/// A = {a}, Q = {a/d} for a point a that depends on the key: d_Q(A) = d. Parameter `shift` is added to d.
class RayGenerator final : public Generator {
 public:
  explicit RayGenerator(double shift) : shift_(shift) {}

  Instance generate(const InstanceKey& key) const override {
    if (key.n > 90) throw InvalidParameterError("the family 'ray' ends at n = 90");
    const double d =
        shift_ + 1 + key.n + 0.001 * key.N + 0.1 * key.repetition + static_cast<double>(key.seed);
    const Eigen::MatrixXd a = Eigen::MatrixXd::Constant(key.n, 1, 1.0);
    return {std::make_shared<PointSet>(d * a), std::make_shared<PointSet>(a), d};
  }

 private:
  double shift_;
};

/// What the fake methods of one registry were asked to do.
struct CallLog {
  std::atomic<int> loads{0};
  std::atomic<int> solves{0};
};

/// Reads d off an instance of RayGenerator, `error` times off. Throws from the `throw_at`-th solve of the log
/// on.
class RayMethod final : public SolveMethod {
 public:
  RayMethod(const Parameters& parameters, CallLog& log) : parameters_(parameters), log_(log) {}

  void load(const Instance& instance) override {
    ++log_.loads;
    instance_ = &instance;
  }

  void solve(const SolveRequest& request) override {
    const std::int64_t solve = ++log_.solves;
    const std::int64_t throw_at = integer_parameter(parameters_, "throw_at");
    if (throw_at > 0 && solve >= throw_at) throw Error("the fake method broke down");
    if (const double busy = real_parameter(parameters_, "busy_seconds"); busy > 0) {
      std::this_thread::sleep_for(std::chrono::duration<double>(busy));
    }
    if (const double unit = real_parameter(parameters_, "busy_seconds_of_cost"); unit > 0) sleep(unit);
    const double d = instance_->A->center()(0) / instance_->Q->center()(0);
    result_.distance = d * (1 + real_parameter(parameters_, "error"));
    result_.lower = result_.distance * (1 - request.tolerance / 2);
    result_.upper = result_.distance;
    result_.status = DistanceStatus::optimal;
    result_.counters.pivots = instance_->A->dimension();
  }

  DistanceResult result() override { return result_; }

 private:
  /// For unit · (n N)^1.5 seconds, whatever the time limit. Repetition 0 of small_experiment has its N in its
  /// distance.
  void sleep(double unit) const {
    const int n = instance_->A->dimension();
    const double N = 1000 * (*instance_->exact_distance - n - 8.5);
    std::this_thread::sleep_for(std::chrono::duration<double>(unit * std::pow(n * N, 1.5)));
  }

  Parameters parameters_;
  CallLog& log_;
  const Instance* instance_ = nullptr;
  DistanceResult result_;
};

inline GeneratorRegistry fake_generators() {
  GeneratorRegistry registry("generator");
  registry.add(
      {"ray",
       "two points on one ray",
       {{"shift", 0.0, 0.0, 100.0, "added to the distance", {}}},
       [](const Parameters& p) { return std::make_unique<RayGenerator>(real_parameter(p, "shift")); }});
  return registry;
}

/// `log` outlives the registry and its methods.
inline MethodRegistry fake_methods(CallLog& log) {
  MethodRegistry registry("method");
  registry.add({"ray",
                "reads the distance off the ray",
                {{"error", 0.0, -1.0, 1.0, "relative error of the answer", {}},
                 {"busy_seconds", 0.0, 0.0, 1.0, "how long a solve takes", {}},
                 {"busy_seconds_of_cost", 0.0, 0.0, 1.0, "a solve takes this, times (n N)^1.5", {}},
                 {"throw_at", std::int64_t{0}, 0.0, 1e9, "first solve of the log that throws; 0: none", {}}},
                [&log](const Parameters& p) { return std::make_unique<RayMethod>(p, log); }});
  return registry;
}

/// Takes samples without a clock: one solve each, whose seconds are what `seconds` makes of its distance.
inline SolveTimer planted_times(std::function<double(double distance)> seconds) {
  return [seconds = std::move(seconds)](SolveMethod& method, const SolveRequest& request, double) {
    method.solve(request);
    return TimedSolve{seconds(method.result().distance), 1};
  };
}

/// Keeps cells in memory, by index; a cell stored twice counts twice.
class MemorySink final : public RecordSink {
 public:
  void store(const CellResult& cell) override {
    const std::lock_guard lock(mutex_);
    ++stored_[cell.cell];
    cells_[cell.cell] = cell;
    order_.push_back(cell.cell);
  }

  const std::map<std::uint64_t, CellResult>& cells() const { return cells_; }
  int times_stored(std::uint64_t cell) const { return stored_.at(cell); }
  const std::vector<std::uint64_t>& order() const { return order_; }

 private:
  std::mutex mutex_;
  std::map<std::uint64_t, CellResult> cells_;
  std::map<std::uint64_t, int> stored_;
  std::vector<std::uint64_t> order_;
};

/// 2 dimensions × 3 sizes × 2 tolerances, two methods that agree.
inline Experiment small_experiment() {
  Experiment experiment;
  experiment.n = {3, 4};
  experiment.N = {10, 20, 30};
  experiment.tolerance = {1e-3, 1e-6};
  experiment.repetitions = 4;
  experiment.seed = 7;
  experiment.generators = {GeneratorSpec{{"ray", "", {{"shift", 0.5}}}}};
  experiment.methods = {{"ray", "first", {}}, {"ray", "second", {}}};
  experiment.min_seconds = 0;
  return experiment;
}

}  // namespace raygauge::testing
