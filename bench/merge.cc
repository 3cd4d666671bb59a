// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// raygauge_merge_speed: how fast results files of one experiment are joined, and in how much memory.
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "raygauge/sweep/method.h"
#include "results/merge/merge_parts.h"
#include "results/run/results_file.h"

namespace raygauge {
namespace {

namespace fs = std::filesystem;

constexpr int kRepetitions = 25;
constexpr const char* kMethods[] = {"column_generation", "zheng_yamane", "glpk_primal", "glpk_dual"};
constexpr const char* kParameters[] = {
    "instruction_set=best max_iterations=1000 stop_rule=relative_gap threads=1 witness=0",
    "max_iterations=1000 safe=1 stop_rule=relative_gap", "presolve=0 pricing=steepest scaling=1",
    "presolve=0 pricing=steepest scaling=1"};

/// A record of many digits, as a run has them: nothing that compresses better than measurements do.
Record record_of(std::uint64_t cell, int repetition, int method, std::mt19937_64& bits) {
  std::uniform_real_distribution<double> uniform;
  Record record;
  record.cell = cell;
  record.generator = "example2";
  record.generator_parameters = "separation=1.5 spread=0.25";
  record.method = kMethods[method];
  record.method_parameters = kParameters[method];
  record.n = 3 + static_cast<int>(cell % 8);
  record.N = 200 * (1 + static_cast<int>(cell / 8 % 10));
  record.tolerance = 1e-6;
  record.repetition = repetition;
  record.seconds = 1e-5 * (1 + uniform(bits));
  record.inner_repetitions = 10 + static_cast<int>(bits() % 30);
  record.load_seconds = 1e-6 * (1 + uniform(bits));
  record.distance = 1 + uniform(bits);
  record.lower = record.distance * (1 - 1e-7 * uniform(bits));
  record.upper = record.distance;
  record.exact_distance = record.distance;
  record.counters.outer_iterations = 4 + static_cast<int>(bits() % 4);
  record.counters.ray_iterations = 10 + static_cast<int>(bits() % 32);
  record.counters.pivots = record.counters.ray_iterations;
  record.counters.points_priced = static_cast<int>(bits() % 4096);
  record.thread = static_cast<int>(bits() % 2);
  record.concurrency = 2;
  record.started_at = 1000 * uniform(bits);
  return record;
}

fs::path write_part(const fs::path& folder, int part, int parts, int cells) {
  std::mt19937_64 bits(static_cast<std::uint64_t>(part));
  ResultsFile results;
  for (int i = 0; i < cells; ++i) {
    const auto cell = static_cast<std::uint64_t>(i) * parts + part;  // every shard has some of every region
    for (int repetition = 0; repetition < kRepetitions; ++repetition) {
      for (int method = 0; method < 4; ++method) {
        results.records.push_back(record_of(cell, repetition, method, bits));
      }
    }
  }
  results.provenance.identity = "repetitions = " + std::to_string(kRepetitions) + "\n";
  results.provenance.cell_count = static_cast<std::uint64_t>(cells) * static_cast<std::uint64_t>(parts);
  results.provenance.sessions.resize(1);
  const fs::path path = folder / ("part-" + std::to_string(part) + ".h5");
  if (!fs::exists(path)) write_results(path.string(), results);
  return path;
}

double cpu_seconds() {
  struct rusage usage {};
  ::getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * time.tv_usec;
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

int run(const fs::path& folder, int parts, int records) {
  fs::create_directories(folder);
  std::vector<fs::path> paths;
  for (int i = 0; i < parts; ++i) paths.push_back(write_part(folder, i, parts, records / (4 * kRepetitions)));
  const fs::path target = folder / "merged.h5";
  fs::remove(target);
  const double cpu = cpu_seconds();
  const SteadyClock::time_point start = SteadyClock::now();
  const MergeSummary summary = merge_parts(paths, target);
  const double wall = seconds_since(start);
  const auto count = static_cast<double>(summary.records);
  std::printf(
      "%.0f records of %d parts: %.2f s wall, %.2f s of processor time: %.3g records/s, %.3g per processor "
      "second\n",
      count, parts, wall, cpu_seconds() - cpu, count / wall, count / (cpu_seconds() - cpu));
  return 0;
}

}  // namespace
}  // namespace raygauge

int main(int argc, char** argv) {
  CLI::App app(
      "How fast parts of one experiment are merged. Parts that the folder has are taken as they are.");
  std::string folder;
  int parts = 1000;
  int records = 10000;
  app.add_option("folder", folder, "Folder for the parts and the merged file")->required();
  app.add_option("--parts", parts, "Files")->capture_default_str();
  app.add_option("--records", records, "Records of each")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  return raygauge::run(folder, parts, records);
}
