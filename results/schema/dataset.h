// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace raygauge {

/// A dataset in an HDF5 file, written FILE:/DATASET.
struct DatasetReference {
  std::string file;
  std::string dataset;
};

/// Splits "points.h5:/group/A"; nothing if `text` is not of that form.
std::optional<DatasetReference> parse_dataset_reference(const std::string& text);

/// The datasets of numbers with two dimensions in an HDF5 file, as "/group/A", in alphabetical order; links
/// to other places are not followed. Throws ResultsError.
std::vector<std::string> point_datasets(const std::string& file);

/// The points that are the rows of a two-dimensional dataset of numbers, N × n in the file, as the columns of
/// the result (n × N, ready for PointSet). Throws ResultsError for a file or dataset that is missing, of
/// another rank or not numeric, EmptySetError for one without rows or columns, and NonFiniteError for a NaN
/// or an infinity (row and column counted from 0). A dataset that takes less room in the file than its
/// numbers do, compressed or never written, may have at most `most_packed_bytes` of them.
Eigen::MatrixXd read_points(const DatasetReference& reference,
                            std::uint64_t most_packed_bytes = std::numeric_limits<std::uint64_t>::max());

}  // namespace raygauge
