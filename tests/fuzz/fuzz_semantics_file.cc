// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// An SRDF file of a robot: what is accepted names links and joints that the robot has.
#include <algorithm>

#include "scene/input/srdf_file.h"
#include "tests/fuzz/crew_file.h"
#include "tests/fuzz/harness.h"
#include "tests/fuzz/scratch_file.h"

namespace raygauge::fuzz {
void check_semantics_file(std::string_view input) {
  static const cli::Robot robot = cli::read_robot(CrewFile().path(), {{}, true});
  static const ScratchFile file(".srdf");
  file.write(input);
  expect_success_or_error([&] {
    const cli::RobotSemantics semantics = cli::read_srdf(file.path(), robot);
    const int links = static_cast<int>(robot.links.size());
    for (const cli::DisabledPair& pair : semantics.disabled)
      require(0 <= pair.link_a && pair.link_a < pair.link_b && pair.link_b < links, "pairs are of two links");
    for (const cli::JointGroup& group : semantics.groups) {
      require(group.joints.size() == robot.joints.size(), "a group knows of every joint whether it belongs");
      require(std::is_sorted(group.links.begin(), group.links.end()), "links of a group rise");
    }
  });
}

}  // namespace raygauge::fuzz
