// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/schema/dataset.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "results/exceptions.h"
#include "results/hdf5/hdf5_library.h"
#include "results/schema/open_dataset.h"

namespace raygauge {
namespace {

/// Whether every group on the way to `dataset`, and itself, is there. (HDF5 only tells of the last step.)
bool exists(const H5::Group& root, const std::string& dataset) {
  for (std::size_t slash = dataset.find('/', 1); slash != std::string::npos;
       slash = dataset.find('/', slash + 1)) {
    const std::string parent = dataset.substr(0, slash);
    if (!root.nameExists(parent) || root.childObjType(parent) != H5O_TYPE_GROUP) return false;
  }
  return dataset.size() > 1 && root.nameExists(dataset);
}

void require_not_larger(const H5::DataSet& dataset, std::uint64_t most_packed_bytes,
                        const std::string& place) {
  const auto numbers = static_cast<double>(dataset.getSpace().getSimpleExtentNpoints());
  const double bytes = numbers * static_cast<double>(sizeof(double));
  const double stored_plain = numbers * static_cast<double>(dataset.getDataType().getSize());
  const bool packed = static_cast<double>(dataset.getStorageSize()) < stored_plain;
  if (!packed || most_packed_bytes == std::numeric_limits<std::uint64_t>::max() ||
      bytes <= static_cast<double>(most_packed_bytes))
    return;
  constexpr std::uint64_t kMebibyte = 1 << 20;
  throw ResultsError(place + ": compressed data of more than " +
                     std::to_string(most_packed_bytes / kMebibyte) + " MiB; --max-input sets another limit");
}

Eigen::MatrixXd read_matrix(const H5::DataSet& dataset, const std::string& place) {
  const H5::DataSpace space = dataset.getSpace();
  const int rank = space.getSimpleExtentNdims();
  if (rank != 2) {
    throw ResultsError(place + ": has " + std::to_string(rank) + " dimension" + (rank == 1 ? "" : "s") +
                       ", expected 2 (points × coordinates)");
  }
  std::array<hsize_t, 2> extent{};
  space.getSimpleExtentDims(extent.data());
  if (extent[0] == 0 || extent[1] == 0) throw EmptySetError(place + ": has no points");
  Eigen::MatrixXd points(static_cast<Eigen::Index>(extent[1]), static_cast<Eigen::Index>(extent[0]));
  dataset.read(points.data(), H5::PredType::NATIVE_DOUBLE);
  return points;
}

void require_finite(const Eigen::MatrixXd& points, const std::string& place) {
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    for (Eigen::Index k = 0; k < points.rows(); ++k) {
      const double value = points(k, i);
      if (std::isfinite(value)) continue;
      throw NonFiniteError(place + ": " + (std::isnan(value) ? "NaN" : "infinity") + " at row " +
                           std::to_string(i) + ", column " + std::to_string(k));
    }
  }
}

bool holds_points(const H5::DataSet& dataset) {
  const H5T_class_t type = dataset.getTypeClass();
  return (type == H5T_FLOAT || type == H5T_INTEGER) && dataset.getSpace().getSimpleExtentNdims() == 2;
}

herr_t note_dataset(hid_t /*root*/, const char* name, const H5O_info_t* info, void* names) {
  if (info->type == H5O_TYPE_DATASET)
    static_cast<std::vector<std::string>*>(names)->push_back("/" + std::string(name));
  return 0;
}

}  // namespace

H5::DataSet open_numeric(const H5::Group& root, const std::string& dataset, const std::string& place) {
  if (!exists(root, dataset)) throw ResultsError(place + ": no such dataset");
  if (root.childObjType(dataset) != H5O_TYPE_DATASET) throw ResultsError(place + ": not a dataset");
  H5::DataSet opened = root.openDataSet(dataset);
  const H5T_class_t type = opened.getTypeClass();
  if (type != H5T_FLOAT && type != H5T_INTEGER) throw ResultsError(place + ": not numeric");
  return opened;
}

std::vector<std::string> point_datasets(const std::string& file) {
  std::vector<std::string> names;
  hdf5::read_file(file, [&](H5::Group& root) {
    if (H5Ovisit2(root.getId(), H5_INDEX_NAME, H5_ITER_INC, note_dataset, &names, H5O_INFO_BASIC) < 0)
      throw ResultsError(file + ": its groups cannot be read");
    std::erase_if(names, [&](const std::string& name) { return !holds_points(root.openDataSet(name)); });
  });
  std::sort(names.begin(), names.end());
  return names;
}

std::optional<DatasetReference> parse_dataset_reference(const std::string& text) {
  const std::size_t colon = text.rfind(":/");
  if (colon == std::string::npos || colon == 0 || colon + 2 == text.size()) return std::nullopt;
  return DatasetReference{text.substr(0, colon), text.substr(colon + 1)};
}

Eigen::MatrixXd read_points(const DatasetReference& reference, std::uint64_t most_packed_bytes) {
  const std::string place = reference.file + ":" + reference.dataset;
  Eigen::MatrixXd points;
  hdf5::read_file(reference.file, [&](H5::Group& root) {
    const H5::DataSet dataset = open_numeric(root, reference.dataset, place);
    require_not_larger(dataset, most_packed_bytes, place);
    points = read_matrix(dataset, place);
  });
  require_finite(points, place);
  return points;
}

}  // namespace raygauge
