// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Points as a cloud, in each format that clouds come in: what is accepted has finite points, no more of them
// than bytes where the format packs nothing, and reaches as far as they and their balls do.
#include <cmath>
#include <utility>

#include "cli/input/mesh_object_file.h"
#include "cli/input/point_source.h"
#include "tests/fuzz/harness.h"
#include "tests/fuzz/scratch_file.h"

namespace raygauge::fuzz {

void check_cloud_file(std::string_view input) {
  constexpr double kRadius = 0.5;
  using File = std::pair<ScratchFile, std::string>;  // and the dataset in it
  static const File files[] = {File(".pcd", ""), File(".ply", ""), File(".csv", ""), File(".h5", ":/A")};
  for (const auto& [file, dataset] : files) {
    file.write(input);
    const std::string source = file.path() + dataset;
    expect_success_or_error([&] {
      const auto cloud = cli::read_cloud(source, kRadius);
      const Eigen::MatrixXd points = cli::read_point_source(source);
      require(points.rows() == 3 && points.cols() > 0 && points.allFinite(), "accepted points are finite");
      require(!dataset.empty() || static_cast<std::size_t>(points.cols()) <= input.size(),
              "points take bytes");
      const double top = points.row(2).maxCoeff() + kRadius;
      require(std::fabs(cloud->support_function(Vector::Unit(3, 2)) - top) <= 1e-12 * std::fabs(top) + 1e-12,
              "a cloud ends where its balls do");
    });
  }
}

}  // namespace raygauge::fuzz
