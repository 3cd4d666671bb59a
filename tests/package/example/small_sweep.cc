// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// usage: small_sweep RESULTS.h5. A sweep with a generator of one's own: balls of radius 1 around points at
// distance 3 from the origin, measured by the unit ball. The distance is 2 whatever the dimension. The file
// is for `raygauge table` and the like; called again it finishes a sweep that was interrupted.
#include <raygauge/raygauge.h>
#include <raygauge/results.h>
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

// Looks at each finished cell before the file gets it.
class Check final : public raygauge::RecordSink {
 public:
  explicit Check(raygauge::ResultsWriter& file) : file_(file) {}
  void store(const raygauge::CellResult& cell) override {
    for (const raygauge::Record& record : cell.records) {
      ++records;
      if (!(std::abs(record.distance - 2) <= 1e-6)) ++wrong;
    }
    file_.store(cell);
  }
  int records = 0, wrong = 0;

 private:
  raygauge::ResultsWriter& file_;
};

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) throw raygauge::InvalidParameterError("usage: small_sweep RESULTS.h5");
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

  raygauge::ResultsWriter file(argv[1], experiment, raygauge::RunMode::resume);
  Check check(file);
  const raygauge::SweepSummary summary =
      raygauge::run_sweep(experiment, generators, methods, check, file.done());
  file.finish(summary.calibration);
  std::printf("%d records, %d wrong\n", check.records, check.wrong);
  return check.wrong == 0 ? 0 : 1;
} catch (const raygauge::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
