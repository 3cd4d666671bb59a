// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "python/bindings/arrays.h"

#include <limits>
#include <string>

#include "raygauge/exceptions.h"
#include "raygauge/sets/point_set.h"

namespace raygauge::python {
namespace {

using Doubles = py::array_t<double, py::array::c_style>;

/// Whether entries of this dtype are real numbers; objects are asked for theirs one by one.
bool holds_numbers(const py::array& array) {
  const char kind = array.dtype().kind();
  return kind == 'f' || kind == 'i' || kind == 'u' || kind == 'b' || kind == 'O';
}

[[noreturn]] void refuse(py::handle object, const char* name, const std::string& wanted) {
  throw InvalidParameterError(std::string(name) + ": " + wanted + " is needed, got " + described(object));
}

/// NumPy's own errors (a ragged list, an object that is no number) in the words of ours; want of memory, and
/// a signal that arrived meanwhile, stay what they are.
template <class Convert>
auto translated(py::handle object, const char* name, Convert convert) {
  try {
    return convert();
  } catch (const py::error_already_set& error) {
    if (error.matches(PyExc_ValueError) || error.matches(PyExc_TypeError) ||
        error.matches(PyExc_OverflowError)) {
      refuse(object, name, "an array of real numbers");
    }
    throw;
  }
}

/// Whether an entry is masked; those of lists are looked at one by one.
bool has_masked_entries(py::handle object) {
  if (PyList_Check(object.ptr()) || PyTuple_Check(object.ptr())) {
    for (const py::handle member : object) {
      if (has_masked_entries(member)) return true;
    }
    return false;
  }
  if (!py::isinstance<py::array>(object)) return false;
  const py::module_ ma = py::module_::import("numpy.ma");
  return ma.attr("is_masked")(object).cast<bool>();
}

Doubles converted(py::handle object, const char* name) {
  if (has_masked_entries(object))
    throw InvalidParameterError(std::string(name) + ": " + described(object) +
                                ", has masked entries: leave these points out, or fill them (.filled)");
  const auto array = translated(object, name, [&] {
    return py::reinterpret_steal<py::array>(py::module_::import("numpy").attr("asarray")(object).release());
  });
  if (!holds_numbers(array)) refuse(array, name, "an array of real numbers");
  return translated(object, name, [&] {
    return py::reinterpret_steal<Doubles>(
        py::module_::import("numpy")
            .attr("require")(array, py::dtype::of<double>(), py::make_tuple("C", "A"))
            .release());
  });
}

std::string shape_text(const py::array& array) {
  return py::str(py::tuple(array.attr("shape"))).cast<std::string>();
}

}  // namespace

std::string described(py::handle object) {
  if (py::isinstance<py::array>(object)) {
    const auto array = py::reinterpret_borrow<py::array>(object);
    return "an array of " + py::str(array.dtype()).cast<std::string>() + ", shape " + shape_text(array);
  }
  return "an object of type " + std::string(Py_TYPE(object.ptr())->tp_name);
}

Doubles as_doubles(py::handle object, const char* name) {
  if (Doubles::check_(object) && Py_TYPE(object.ptr()) == py::detail::npy_api::get().PyArray_Type_) {
    auto array = py::reinterpret_borrow<Doubles>(object);
    if ((array.flags() & py::detail::npy_api::NPY_ARRAY_ALIGNED_) != 0) return array;
  }
  return converted(object, name);
}

int as_dimension(py::ssize_t size, const char* name) {
  if (size > std::numeric_limits<int>::max()) {
    throw InvalidParameterError(std::string(name) + ": " + std::to_string(size) +
                                " coordinates are more than a dimension can be");
  }
  return static_cast<int>(size);
}

Vector as_vector(py::handle object, const char* name) {
  const Doubles array = as_doubles(object, name);
  if (array.ndim() != 1) refuse(array, name, "an array of shape (n,)");
  return Eigen::Map<const Eigen::VectorXd>(array.data(), as_dimension(array.shape(0), name));
}

Eigen::MatrixXd as_matrix(py::handle object, const char* name) {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Doubles array = as_doubles(object, name);
  if (array.ndim() != 2) refuse(array, name, "an array of two axes");
  return Eigen::Map<const RowMajor>(array.data(), as_dimension(array.shape(0), name),
                                    as_dimension(array.shape(1), name));
}

SetPointer point_set_of_rows(const double* rows, std::ptrdiff_t count, int dimension) {
  return std::make_shared<PointSet>(Eigen::Map<const Eigen::MatrixXd>(rows, dimension, count));
}

SetPointer as_set(py::handle object, const char* name) {
  if (!py::isinstance<py::array>(object)) {
    py::detail::make_caster<std::shared_ptr<ConvexSet>> set;
    if (!object.is_none() && set.load(object, false))
      return py::detail::cast_op<std::shared_ptr<ConvexSet>&>(set);
  }
  const Doubles array = as_doubles(object, name);
  if (array.ndim() != 1 && array.ndim() != 2) {
    refuse(array, name, "a set or an array of points of shape (N, n)");
  }
  const py::ssize_t count = array.ndim() == 1 ? 1 : array.shape(0);
  return point_set_of_rows(array.data(), count, as_dimension(array.shape(array.ndim() - 1), name));
}

py::array_t<double> readonly_array(const Vector& vector) {
  py::array_t<double> array(vector.size(), vector.data());
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

}  // namespace raygauge::python
