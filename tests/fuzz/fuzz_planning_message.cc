// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Messages of MoveIt in YAML, as a scene and as a request.
#include <cmath>

#include "scene/input/moveit_file.h"
#include "tests/fuzz/harness.h"
#include "tests/fuzz/scratch_file.h"

namespace raygauge::fuzz {

void check_planning_message(std::string_view input) {
  static const ScratchFile file(".yaml");
  file.write(input);
  expect_success_or_error([&] {
    const cli::MoveItScene scene = cli::read_moveit_scene(file.path());
    require(scene.obstacles.size() <= input.size(), "obstacles take bytes");
  });
  expect_success_or_error([&] {
    for (const auto& [joint, value] : cli::read_moveit_request(file.path()).goal)
      require(std::isfinite(value), "accepted joint values are finite");
  });
}

}  // namespace raygauge::fuzz
