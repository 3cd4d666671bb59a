// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/results.h"

#include <cstdio>
#include <string_view>

#include "results/run/run_writer.h"

namespace raygauge {
namespace {

/// A basic string of TOML.
std::string toml_string(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f) {
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned>(byte));
      quoted += escape;
    } else {
      if (c == '"' || c == '\\') quoted += '\\';
      quoted += c;
    }
  }
  return quoted + '"';
}

Experiment with_text(Experiment experiment) {
  if (experiment.text.empty()) {
    experiment.text =
        "# run by a program, with components of its own\nname = " + toml_string(experiment.name) +
        "\ndescription = " + toml_string(experiment.description) + "\n";
  }
  return experiment;
}

}  // namespace

ResultsWriter::ResultsWriter(const std::string& path, const Experiment& experiment, RunMode mode) {
  validate(experiment);
  const int threads = sweep_threads(experiment, grid_of(experiment).size());
  writer_ = std::make_unique<RunWriter>(path, with_text(experiment), mode,
                                        describe_session(experiment, threads, {}));
}

ResultsWriter::~ResultsWriter() = default;
ResultsWriter::ResultsWriter(ResultsWriter&&) noexcept = default;
ResultsWriter& ResultsWriter::operator=(ResultsWriter&&) noexcept = default;

const std::set<std::uint64_t>& ResultsWriter::done() const noexcept { return writer_->done(); }

void ResultsWriter::store(const CellResult& cell) { writer_->store(cell); }

void ResultsWriter::finish(const Calibration& calibration) { writer_->finish(calibration); }

}  // namespace raygauge
