// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// raygauge_simulated_results FILE.h5 CELLS: a results file of CELLS cells with simulated times, for tests of
// what reads results. 4 methods, 20 repetitions; n, N and tolerance vary; a few solves fail and a few times
// are outliers.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

#include "results/run/results_file.h"
#include "tests/analysis/records.h"
#include "tests/results/support.h"

namespace raygauge {
namespace {

constexpr int kRepetitions = 20;

struct SimulatedMethod {
  const char* name;
  double microseconds;  // at n = 3, N = 200
  double N_exponent;
  double n_exponent;
};

constexpr SimulatedMethod kMethods[] = {{"column_generation", 30, 0.6, 1.2},
                                        {"zheng_yamane", 120, 1.0, 1.5},
                                        {"glpk_primal", 900, 1.1, 0.9},
                                        {"glpk_dual", 700, 1.2, 1.0}};

Record simulated(const SimulatedMethod& method, const Record& cell, int repetition, std::mt19937_64& bits) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  Record record = cell;
  record.method = method.name;
  record = testing::with_facts(record);
  record.repetition = repetition;
  const double size = std::pow(cell.N / 200.0, method.N_exponent) * std::pow(cell.n / 3.0, method.n_exponent);
  const double digits = -std::log10(cell.tolerance);
  record.seconds = 1e-6 * method.microseconds * size * (1 + 0.05 * digits) * std::exp(0.1 * normal(bits));
  if (uniform(bits) < 0.01) record.seconds *= 3;
  record.load_seconds = 0.1 * record.seconds;
  record.exact_distance = 1 + uniform(bits);
  record.distance = record.exact_distance * (1 + 0.3 * cell.tolerance * uniform(bits));
  record.upper = record.distance;
  record.lower = record.distance * (1 - 0.5 * cell.tolerance);
  if (!std::string(method.name).starts_with("glpk")) {
    record.counters.outer_iterations = 2 + static_cast<int>(digits);
    record.counters.ray_iterations =
        record.counters.outer_iterations * (cell.n + static_cast<int>(3 * uniform(bits)));
  }
  if (uniform(bits) < 0.002) record.status = DistanceStatus::time_limit;
  record.started_at = 10 * uniform(bits);
  return record;
}

/// Cell `index`: n runs fastest, then N, then the tolerance.
Record simulated_cell(int index) {
  constexpr int kDimensions = 5;
  constexpr int kCounts = 10;
  Record cell = testing::record("", 3 + index % kDimensions, 200 * (1 + index / kDimensions % kCounts), 0, 1);
  cell.tolerance = std::pow(10.0, -1 - 0.5 * (index / (kDimensions * kCounts)));
  cell.cell = static_cast<std::uint64_t>(index);
  return cell;
}

ResultsFile simulated_file(int cells) {
  std::mt19937_64 bits(1);
  ResultsFile results;
  for (int index = 0; index < cells; ++index) {
    for (int repetition = 0; repetition < kRepetitions; ++repetition) {
      for (const SimulatedMethod& method : kMethods)
        results.records.push_back(simulated(method, simulated_cell(index), repetition, bits));
    }
  }
  results.provenance.cell_count = static_cast<std::uint64_t>(cells);
  results.provenance.experiment_text = "name = \"simulated\"  # <b>not markup</b> </script>\n";
  results.provenance.sessions = {testing::sample_session()};
  return results;
}

}  // namespace
}  // namespace raygauge

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: raygauge_simulated_results FILE.h5 CELLS\n");
    return 2;
  }
  raygauge::write_results(argv[1], raygauge::simulated_file(std::atoi(argv[2])));
  return 0;
}
