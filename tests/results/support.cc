// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "tests/results/support.h"

#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): mkdtemp is POSIX

#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "results/run/identity.h"
#include "results/schema/schema.h"

namespace raygauge::testing {
namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
  std::string name = (fs::temp_directory_path() / "raygauge-test-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

Experiment small_experiment(int cell_count, int repetitions) {
  Experiment experiment;
  experiment.text = "name = \"small\"  # with a µ\n";
  experiment.seed = 18446744073709551615U;
  experiment.repetitions = repetitions;
  experiment.n = {3};
  experiment.N.clear();
  for (int i = 0; i < cell_count; ++i) experiment.N.push_back(100 + i);
  experiment.generators = {GeneratorSpec{{"example2", "example2", {{"separation", 1.5}}}}};
  experiment.methods = {{"column_generation", "column_generation", {}},
                        {"glpk", "GLPK, \"primal\"", {{"presolve", true}}}};
  return experiment;
}

CellResult cell_result(const Experiment& experiment, std::uint64_t cell) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  CellResult result{cell, {}};
  for (auto method = experiment.methods.rbegin(); method != experiment.methods.rend(); ++method) {
    for (int repetition = 0; repetition < experiment.repetitions; ++repetition) {
      const double x = static_cast<double>(cell) + 1.0 / (3 + repetition);
      Record record;
      record.cell = cell;
      record.generator = "example2";
      record.generator_parameters = "separation=1.5";
      record.method = method->label;
      record.method_parameters = to_string(method->parameters);
      record.method_name = method->name;
      record.role = method->name == "glpk" ? Role::baseline : Role::engine;
      record.exact_distance_rounding = 0x1p-45;
      record.hardness_label = "1/δ";
      record.hardness = 1e9;
      record.n = 3;
      record.N = experiment.N.at(cell);
      record.tolerance = 1e-6;
      record.seed = experiment.seed;
      record.repetition = repetition;
      record.seconds = x / 7;
      record.inner_repetitions = 5;
      record.load_seconds = std::numeric_limits<double>::denorm_min();
      record.distance = repetition == 1 ? kInfinity : x;
      record.lower = repetition == 2 ? kNan : x;
      record.upper = repetition == 2 ? -kNan : x;
      record.exact_distance = -0.0;
      record.status = repetition == 1 ? DistanceStatus::unreachable : DistanceStatus::optimal;
      record.agrees = repetition != 2;
      record.counters = {1, 2, 3, 4, std::numeric_limits<std::int64_t>::max(), 6, 7};
      record.host = "host";
      record.thread = 1;
      record.concurrency = 2;
      record.started_at = x;
      result.records.push_back(record);
    }
  }
  return result;
}

Session sample_session() {
  Session session;
  session.build = {"0.2.0", "0123456789abcdef", true, "GNU 12.2.0", "-O3 -DNDEBUG", "Release"};
  session.machine = {"A processor",         2,          49152,     2 << 20, 0,
                     std::int64_t{8} << 30, "An OS 12", "Linux 6", "host"};
  session.threads = 2;
  session.timing = "parallel";
  session.started_at = "2026-01-31T12:00:00Z";
  session.finished_at = "2026-01-31T12:00:07Z";
  session.versions = {{"Eigen", "3.4.0"}, {"GLPK", "5.0"}};
  session.calibration = {2,
                         {{"column_generation", 1e-5, 1.1e-5, 1.1}, {"GLPK, \"primal\"", 2e-3, 2e-3, 1.0}}};
  return session;
}

ResultsFile sample_results(const Experiment& experiment) {
  ResultsFile results;
  results.provenance = {
      experiment.text, experiment_identity(experiment), experiment.N.size(), {sample_session()}};
  for (std::uint64_t cell = 0; cell < experiment.N.size(); ++cell) {
    const CellResult stored = cell_result(experiment, cell);
    for (int repetition = 0; repetition < experiment.repetitions; ++repetition) {
      for (const ComponentSpec& method : experiment.methods) {
        for (const Record& record : stored.records) {
          if (record.repetition == repetition && record.method == method.label) {
            results.records.push_back(record);
            if (std::isnan(record.upper)) results.records.back().upper = record.lower;
          }
        }
      }
    }
  }
  return results;
}

std::string fingerprint(const Record& record) {
  std::string text;
  for (const Column<Record>& column : record_columns()) {
    if (column.name == "session") continue;
    const Value value = column.get(record);
    text += column.name + "=";
    if (const auto* real = std::get_if<double>(&value)) {
      text += std::to_string(std::bit_cast<std::uint64_t>(*real));
    } else if (const auto* string = std::get_if<std::string>(&value)) {
      text += *string;
    } else {
      text += std::visit(
          [](const auto& number) {
            if constexpr (std::is_integral_v<std::decay_t<decltype(number)>>) return std::to_string(number);
            return std::string();
          },
          value);
    }
    text += ";";
  }
  return text;
}

std::vector<std::string> fingerprints(const std::vector<Record>& records) {
  std::vector<std::string> result(records.size());
  std::transform(records.begin(), records.end(), result.begin(), fingerprint);
  return result;
}

std::string read_bytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_bytes(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

std::vector<std::string> entries_of(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code missing;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, missing)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace raygauge::testing
