// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/point_source.h"

#include "cli/input/input_file.h"
#include "cli/input/mesh_file.h"
#include "cli/input/point_file.h"
#include "raygauge/exceptions.h"
#include "results/schema/dataset.h"

namespace raygauge::cli {

namespace {

Eigen::MatrixXd mesh_points(const std::string& source, Notes* notes) {
  const MeshFile mesh = read_mesh(source);
  if (notes != nullptr) add_note(hull_note(source, mesh), *notes);
  return distinct_vertices(mesh);
}

}  // namespace

Eigen::MatrixXd read_point_source(const std::string& source, const PointFormat& format, Notes* notes) {
  if (const auto reference = parse_dataset_reference(source))
    return read_points(*reference, compressed_input_limit());
  if (is_mesh_file(source)) return mesh_points(source, notes);
  if (source.ends_with(".h5") || source.ends_with(".hdf5")) {
    throw InvalidParameterError(source + ": name the dataset, as in " + source + ":/points");
  }
  return read_point_file(source, format);
}

}  // namespace raygauge::cli
