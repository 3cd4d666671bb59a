// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <memory>
#include <string>

#include "raygauge/exceptions.h"
#include "raygauge/sets/convex_set.h"

namespace raygauge::python {

namespace py = pybind11;

using SetPointer = std::shared_ptr<const ConvexSet>;

inline bool is_anything(PyObject* /*object*/) { return true; }

// Arguments, as signatures name them; what they hold is checked by the functions below, in words of ours.
// NOLINTBEGIN(readability-identifier-naming)
struct ArrayLike : py::object {
  PYBIND11_OBJECT_DEFAULT(ArrayLike, py::object, is_anything)
};
struct SetLike : py::object {
  PYBIND11_OBJECT_DEFAULT(SetLike, py::object, is_anything)
};
struct SetsLike : py::object {
  PYBIND11_OBJECT_DEFAULT(SetsLike, py::object, is_anything)
};
struct PoseLike : py::object {
  PYBIND11_OBJECT_DEFAULT(PoseLike, py::object, is_anything)
};
struct WarmStartLike : py::object {
  PYBIND11_OBJECT_DEFAULT(WarmStartLike, py::object, is_anything)
};
// NOLINTEND(readability-identifier-naming)

/// A Python object as doubles in C order: the object itself where it is such an array already, so that
/// nothing is copied, else a copy. `name` is the parameter's in messages. Throws InvalidParameterError for
/// what is no array of real numbers, and for masked entries: as numbers they would lose their mask.
py::array_t<double, py::array::c_style> as_doubles(py::handle object, const char* name);

/// A vector of R^n from an array (n,).
Vector as_vector(py::handle object, const char* name);

/// A matrix from an array (rows, columns).
Eigen::MatrixXd as_matrix(py::handle object, const char* name);

/// `size` as a dimension. Throws InvalidParameterError beyond the range of int.
int as_dimension(py::ssize_t size, const char* name);

/// The hull of the rows of an array (N, n) in C order, which are read in place.
SetPointer point_set_of_rows(const double* rows, std::ptrdiff_t count, int dimension);

/// A set, or the hull of the points of an array (N, n), of the one point of an array (n,). Throws
/// InvalidParameterError or what PointSet throws, with the name of the parameter.
SetPointer as_set(py::handle object, const char* name);

/// A copy as a NumPy array that cannot be written to.
py::array_t<double> readonly_array(const Vector& vector);

/// The type's name and, of an array, its dtype and shape: "an array of <U3, shape (2, 3)".
std::string described(py::handle object);

/// What stands under `key`, as a T. Throws InvalidParameterError where it is none.
template <class T>
T value_of(const py::dict& given, const char* key) {
  const py::object value = given[key];
  try {
    return value.cast<T>();
  } catch (const py::cast_error& /*error*/) {
    throw InvalidParameterError(std::string(key) + " cannot be " + py::repr(value).cast<std::string>());
  }
}

}  // namespace raygauge::python

namespace pybind11::detail {

template <>
struct handle_type_name<raygauge::python::ArrayLike> {
  static constexpr auto name = const_name("ArrayLike");
};
template <>
struct handle_type_name<raygauge::python::SetLike> {
  static constexpr auto name = const_name("ConvexSet | ArrayLike");
};
template <>
struct handle_type_name<raygauge::python::SetsLike> {
  static constexpr auto name = const_name("ConvexSet | ArrayLike | Sequence[ConvexSet | ArrayLike]");
};
template <>
struct handle_type_name<raygauge::python::PoseLike> {
  static constexpr auto name = const_name("ArrayLike | None");
};
template <>
struct handle_type_name<raygauge::python::WarmStartLike> {
  static constexpr auto name = const_name("WarmStart | None");
};

}  // namespace pybind11::detail
