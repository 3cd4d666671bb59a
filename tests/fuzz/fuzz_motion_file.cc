// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// A file of poses, in space and in the plane, or of joint values: what is accepted is a motion whose poses
// are rotations and finite.
#include "scene/input/motion_file.h"
#include "tests/fuzz/harness.h"
#include "tests/fuzz/scratch_file.h"

namespace raygauge::fuzz {

void check_motion_file(std::string_view input) {
  static const ScratchFile file(".motion.csv");
  file.write(input);
  for (const int n : {2, 3}) {
    expect_success_or_error([&] {
      const MotionPointer motion = cli::read_pose_file(file.path(), n);
      require(motion->start() < motion->stop(), "an accepted motion takes time");
      for (const double t : {motion->start(), motion->stop()}) {
        const Placement at = motion->at(t);
        require(at.t.allFinite() && at.R.allFinite(), "accepted poses are finite");
        require((at.R.transpose() * at.R).isIdentity(1e-9), "accepted poses have rotations");
      }
    });
  }
  expect_success_or_error([&] {
    const auto joints = cli::read_joint_file(file.path(), {"j", "k"}, {{"f", "is fixed"}});
    require(joints->values.allFinite(), "accepted joint values are finite");
    require(joints->values.cols() == static_cast<Eigen::Index>(joints->times.size()), "a time has values");
    for (std::size_t i = 1; i < joints->times.size(); ++i)
      require(joints->times[i - 1] < joints->times[i], "accepted times rise");
  });
}

}  // namespace raygauge::fuzz
