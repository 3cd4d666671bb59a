// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// A sweep with a generator of one's own and no file: balls of radius 1 around points at distance 3 from the
// origin, measured by the unit ball. The distance is 2 whatever the dimension.
#include <raygauge/raygauge.h>
#include <raygauge/sweep.h>

#include <cmath>
#include <cstdio>
#include <memory>

namespace {

class DistantBalls final : public raygauge::Generator {
 public:
  raygauge::Instance generate(const raygauge::InstanceKey& key) const override {
    const Eigen::VectorXd center = 3 * Eigen::VectorXd::Unit(key.n, key.repetition % key.n);
    const Eigen::VectorXd origin = Eigen::VectorXd::Zero(key.n);
    return {std::make_shared<raygauge::Ball>(center, 1.0), std::make_shared<raygauge::Ball>(origin, 1.0),
            2.0};
  }
};

// Takes each finished cell; a results file would be another sink.
class Check final : public raygauge::RecordSink {
 public:
  void store(const raygauge::CellResult& cell) override {
    for (const raygauge::Record& record : cell.records) {
      ++records;
      if (!(std::abs(record.distance - 2) <= 1e-6)) ++wrong;
    }
  }
  int records = 0, wrong = 0;
};

}  // namespace

int main() {
  raygauge::GeneratorRegistry generators("generator");
  generators.add({"distant_balls", "unit balls at distance 3", {}, [](const raygauge::Parameters&) {
                    return std::make_unique<DistantBalls>();
                  }});
  raygauge::MethodRegistry methods("method");
  raygauge::register_engine_methods(methods);

  raygauge::Experiment experiment;
  experiment.n = {2, 3, 10};
  experiment.repetitions = 6;
  experiment.min_repetitions = 6;
  experiment.threads = 1;
  raygauge::GeneratorSpec balls;
  balls.name = "distant_balls";
  experiment.generators = {balls};
  experiment.methods = {{"newton", "newton", {}}, {"zheng_yamane", "zheng_yamane", {}}};

  Check check;
  raygauge::run_sweep(experiment, generators, methods, check);
  std::printf("%d records, %d wrong\n", check.records, check.wrong);
  return check.wrong == 0 ? 0 : 1;
}
