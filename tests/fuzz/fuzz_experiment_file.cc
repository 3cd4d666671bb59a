// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// An experiment in TOML: what is accepted has a grid whose cells lie within their documented ranges.
#include "cli/input/experiment_file.h"
#include "cli/input/registries.h"
#include "tests/fuzz/harness.h"
#include "tests/fuzz/scratch_file.h"

namespace raygauge::fuzz {

void check_experiment_file(std::string_view input) {
  static const GeneratorRegistry generators = cli::all_generators();
  static const MethodRegistry methods = cli::all_methods();
  static const ScratchFile file(".toml");
  file.write(input);
  expect_success_or_error([&] {
    const Experiment experiment = cli::read_experiment(file.path(), {}, generators, methods);
    validate(experiment);
    const std::vector<Cell> grid = grid_of(experiment);
    require(!grid.empty(), "an accepted experiment has cells");
    for (const Cell& cell : grid) {
      require(cell.n >= 1 && cell.N >= 1, "cells have n >= 1 and N >= 1");
      require(cell.tolerance > 0 && cell.tolerance < 1, "cells have a tolerance in (0, 1)");
    }
  });
}

}  // namespace raygauge::fuzz
