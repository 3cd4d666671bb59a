// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// A file of points in HDF5, by the bytes, asked for its dataset /A.
#include "results/dataset.h"
#include "tests/fuzz/harness.h"
#include "tests/fuzz/scratch_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace raygauge;
  static const fuzz::ScratchFile file(".h5");
  file.write(fuzz::as_text(data, size));
  fuzz::expect_success_or_error([&] {
    const Eigen::MatrixXd points = read_points({file.path(), "/A"});
    fuzz::require(points.size() > 0 && points.allFinite(), "accepted points are finite and not empty");
  });
  return 0;
}
