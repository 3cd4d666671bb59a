// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// A robot in URDF: what is accepted has a link for each of its tree.
#include "scene/input/robot_file.h"
#include "tests/fuzz/harness.h"
#include "tests/fuzz/scratch_file.h"

namespace raygauge::fuzz {

void check_robot_file(std::string_view input) {
  static const ScratchFile file(".urdf");
  file.write(input);
  expect_success_or_error([&] {
    const cli::Robot robot = cli::read_robot(file.path(), {{}, true});
    require(!robot.links.empty(), "an accepted robot has links");
    require(robot.links.size() <= input.size(), "links take bytes");
  });
}

}  // namespace raygauge::fuzz
