// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/rotation_note.h"

#include <atomic>
#include <cstdio>

#include "raygauge/sets/pose.h"

namespace raygauge::cli {

Eigen::MatrixXd rotation_with_note(const std::string& place, const Eigen::MatrixXd& R) {
  static std::atomic_flag said = ATOMIC_FLAG_INIT;
  const NearestRotation nearest = nearest_rotation(place, R);
  if (nearest.off > 0 && !said.test_and_set()) {
    std::fprintf(stderr, "note: %s: the matrix is a rotation to %.2g only; the nearest rotation is used\n",
                 place.c_str(), nearest.off);
  }
  return nearest.R;
}

}  // namespace raygauge::cli
