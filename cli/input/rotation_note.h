// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>

namespace raygauge::cli {

/// The rotation that a matrix of an input stands for, nearest_rotation(): where it has another than the
/// matrix, standard error says so, once in the life of the program. `place`: of the matrix. Throws what that
/// does.
Eigen::MatrixXd rotation_with_note(const std::string& place, const Eigen::MatrixXd& R);

}  // namespace raygauge::cli
