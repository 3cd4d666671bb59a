// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// A PCD file as a cloud: what is accepted has finite points, no more of them than bytes, and reaches as far
// as they and their balls do.
#include <cmath>

#include "cli/input/mesh_file.h"
#include "cli/input/mesh_object_file.h"
#include "tests/fuzz/harness.h"
#include "tests/fuzz/scratch_file.h"

namespace raygauge::fuzz {

void check_cloud_file(std::string_view input) {
  constexpr double kRadius = 0.5;
  static const ScratchFile file(".pcd");
  file.write(input);
  expect_success_or_error([&] {
    const Eigen::MatrixXd points = cli::distinct_vertices(cli::read_mesh(file.path()));
    require(points.rows() == 3 && points.cols() > 0 && points.allFinite(), "accepted points are finite");
    require(static_cast<std::size_t>(points.cols()) <= input.size(), "points take bytes");
    const auto cloud = cli::read_cloud(file.path(), kRadius);
    const double top = points.row(2).maxCoeff() + kRadius;
    require(std::fabs(cloud->support_function(Vector::Unit(3, 2)) - top) <= 1e-12 * std::fabs(top) + 1e-12,
            "a cloud ends where its balls do");
  });
}

}  // namespace raygauge::fuzz
