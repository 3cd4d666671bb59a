// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// The text of a point file: every matrix that is accepted is finite and nonempty, and says the same when
// written out and read again.
#include <cstdio>
#include <string>

#include "cli/input/point_file.h"
#include "tests/fuzz/harness.h"

namespace raygauge::fuzz::point_file {
namespace {

std::string written(const Eigen::MatrixXd& points) {
  std::string text;
  char number[32];
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    for (Eigen::Index k = 0; k < points.rows(); ++k) {
      std::snprintf(number, sizeof number, "%.17g", points(k, i));
      text.append(k == 0 ? "" : ",").append(number);
    }
    text.append("\n");
  }
  return text;
}

}  // namespace
}  // namespace raygauge::fuzz::point_file

namespace raygauge::fuzz {

void check_point_file(std::string_view input) {
  expect_success_or_error([&] {
    const Eigen::MatrixXd points = cli::parse_points(input, "input");
    require(points.rows() > 0 && points.cols() > 0, "accepted points are not empty");
    require(points.allFinite(), "accepted points are finite");
    const Eigen::MatrixXd again = cli::parse_points(point_file::written(points), "copy");
    require(again.rows() == points.rows() && again.cols() == points.cols() && again == points,
            "points written and read again are the same");
  });
}

}  // namespace raygauge::fuzz
