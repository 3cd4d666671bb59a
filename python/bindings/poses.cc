// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "python/bindings/poses.h"

#include <string>

#include "python/bindings/bindings.h"
#include "raygauge/exceptions.h"

namespace raygauge::python {

RigidParts parts_of_rows(const double* matrix, int n, const char* name) {
  using Homogeneous = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Eigen::Map<const Homogeneous> T(matrix, n + 1, n + 1);
  if (!T.row(n).head(n).isZero(0) || T(n, n) != 1) {
    throw InvalidParameterError(std::string(name) +
                                ": the last row of a homogeneous matrix is to be 0 ... 0 1");
  }
  return {T.topLeftCorner(n, n), T.col(n).head(n)};
}

Pose pose_of_rows(const double* matrix, int n, const char* name) {
  const RigidParts parts = parts_of_rows(matrix, n, name);
  return {parts.rotation, parts.translation};
}

void warn_of_replaced_rotation() {
  const char* text = "a pose's matrix is a rotation to 6 to 11 digits only; the nearest rotation is used";
  if (PyErr_WarnEx(PyExc_UserWarning, text, 1) != 0) throw py::error_already_set();
}

std::optional<Pose> as_pose(py::handle object, int n, const char* name) {
  if (object.is_none()) return std::nullopt;
  const auto matrix = as_doubles(object, name);
  if (matrix.ndim() != 2 || matrix.shape(0) != n + 1 || matrix.shape(1) != n + 1) {
    throw DimensionMismatchError(std::string(name) + ": a homogeneous matrix of shape (" +
                                 std::to_string(n + 1) + ", " + std::to_string(n + 1) + ") is needed, got " +
                                 described(object));
  }
  Pose pose = pose_of_rows(matrix.data(), n, name);
  if (pose.replaced() > 0) warn_of_replaced_rotation();
  return pose;
}

WarmStart* as_warm_start(py::handle object) {
  if (object.is_none()) return nullptr;
  if (!py::isinstance<WarmStart>(object)) {
    throw InvalidParameterError("warm: a WarmStart or None is needed, got " + described(object));
  }
  return object.cast<WarmStart*>();
}

void bind_poses(py::module_& module) {
  py::class_<WarmStart>(
      module, "WarmStart",
      R"(What one query leaves for the next one of the same pair: keep one a pair, hand it to each query.

It is a hint and never trusted: answers are certified as without it. For one thread at a time.

>>> warm, Q = rg.WarmStart(), rg.Ball([0, 0, 0])
>>> A = [[2, 0, 0], [3, 1, 0], [3, -1, 0], [3, 0, 1]]
>>> cold = rg.distance(A, Q, method="newton", warm=warm)
>>> round(rg.distance(A, Q, method="newton", warm=warm).distance, 6)
2.0
)")
      .def(py::init<>())
      .def("clear", &WarmStart::clear, "Forgets the pair.");
}

}  // namespace raygauge::python
