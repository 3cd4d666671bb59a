// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "python/bindings/meshes.h"

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "engine/meshes/box_tree.h"
#include "python/bindings/arrays.h"
#include "python/bindings/set_docs.h"
#include "raygauge/exceptions.h"
#include "raygauge/meshes/mesh.h"

namespace raygauge::python {
namespace {

// NOLINTNEXTLINE(misc-unused-using-decls): clang-tidy 14 sees no use of a literal
using py::literals::operator""_a;

void check_columns(const char* name, py::ssize_t columns) {
  if (columns != 3)
    throw DimensionMismatchError(std::string(name) + " must have shape (any, 3), got " +
                                 std::to_string(columns) + " columns");
}

std::vector<MeshTriangle> triangles_of(py::handle object) {
  const Eigen::MatrixXd rows = as_matrix(object, "triangles");
  check_columns("triangles", rows.cols());
  std::vector<MeshTriangle> triangles(static_cast<std::size_t>(rows.rows()));
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      const double number = rows(i, k);
      if (number != std::floor(number) || std::fabs(number) > std::numeric_limits<std::int32_t>::max())
        throw InvalidParameterError("triangles[" + std::to_string(i) +
                                    "] names no vertex: " + std::to_string(number));
      triangles[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] = static_cast<std::int32_t>(number);
    }
  }
  return triangles;
}

std::shared_ptr<MeshObject> mesh_of(const ArrayLike& vertices, const ArrayLike& triangles, bool solid) {
  const Eigen::MatrixXd rows = as_matrix(vertices, "vertices");
  check_columns("vertices", rows.cols());
  return std::make_shared<MeshObject>(Mesh(Eigen::Matrix3Xd(rows.transpose()), triangles_of(triangles),
                                           solid ? MeshKind::solid : MeshKind::surface));
}

std::shared_ptr<MeshObject> cloud_of(const ArrayLike& points, double radius) {
  const Eigen::MatrixXd rows = as_matrix(points, "points");
  check_columns("points", rows.cols());
  return std::make_shared<MeshObject>(Mesh::cloud(Eigen::Matrix3Xd(rows.transpose()), radius));
}

bool is_solid(const MeshObject& object) { return object.mesh().kind() == MeshKind::solid; }

Eigen::MatrixXd points_of(const Mesh& cloud) {
  Eigen::MatrixXd rows(cloud.size(), 3);
  for (std::int32_t i = 0; i < cloud.size(); ++i) {
    const Vector3& p = cloud.tree().triangle(i).corner[0];
    rows.row(cloud.tree().number_of(i)) << p.x, p.y, p.z;
  }
  return rows;
}

/// The corners of all triangles in the order of the caller, three rows each.
py::array_t<double> corners_of(const Mesh& mesh) {
  py::array_t<double> rows({3 * mesh.size(), std::ptrdiff_t{3}});
  auto at = rows.mutable_unchecked<2>();
  for (std::int32_t i = 0; i < mesh.size(); ++i) {
    const std::ptrdiff_t first = 3 * std::ptrdiff_t{mesh.tree().number_of(i)};
    for (std::ptrdiff_t c = 0; c < 3; ++c) {
      const Vector3& p = mesh.tree().triangle(i).corner[c];
      at(first + c, 0) = p.x;
      at(first + c, 1) = p.y;
      at(first + c, 2) = p.z;
    }
  }
  return rows;
}

py::tuple made_again(const py::object& self) {
  const auto& object = self.cast<const MeshObject&>();
  if (object.mesh().kind() == MeshKind::cloud)
    return py::make_tuple(py::type::of(self).attr("cloud"),
                          py::make_tuple(points_of(object.mesh()), object.mesh().radius()));
  const std::ptrdiff_t size = object.mesh().size();
  py::array_t<std::int64_t> numbers({size, std::ptrdiff_t{3}});
  for (std::ptrdiff_t i = 0; i < 3 * size; ++i) numbers.mutable_data()[i] = i;
  return py::make_tuple(py::type::of(self),
                        py::make_tuple(corners_of(object.mesh()), numbers, is_solid(object)));
}

py::object from_file(const py::object& source, bool solid) {
  return py::module_::import("raygauge.loading").attr("load_mesh")(source, solid);
}

}  // namespace

void bind_meshes(py::module_& module) {
  py::class_<MeshObject, ConvexSet, std::shared_ptr<MeshObject>>(module, "Mesh", kMeshDoc)
      .def(py::init(&mesh_of), "vertices"_a, "triangles"_a, "solid"_a = false)
      .def_static("from_file", &from_file, "source"_a, "solid"_a = false, kMeshFromFileDoc)
      .def_static("cloud", &cloud_of, "points"_a, "radius"_a, kMeshCloudDoc)
      .def_property_readonly("radius", [](const MeshObject& object) { return object.mesh().radius(); })
      .def_property_readonly("solid", &is_solid)
      .def_property_readonly("size", [](const MeshObject& object) { return object.mesh().size(); })
      .def_property_readonly("volume", [](const MeshObject& object) { return object.mesh().volume(); })
      .def_property_readonly("memory", [](const MeshObject& object) { return object.mesh().memory(); })
      .def("__reduce__", &made_again);
}

}  // namespace raygauge::python
