// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// A file of points in HDF5, by the bytes, asked for its dataset /A.
#include "results/schema/dataset.h"
#include "tests/fuzz/harness.h"
#include "tests/fuzz/scratch_file.h"

namespace raygauge::fuzz {

void check_dataset(std::string_view input) {
  static const ScratchFile file(".h5");
  file.write(input);
  expect_success_or_error([&] {
    const Eigen::MatrixXd points = read_points({file.path(), "/A"});
    require(points.size() > 0 && points.allFinite(), "accepted points are finite and not empty");
  });
}

}  // namespace raygauge::fuzz
