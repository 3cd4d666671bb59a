// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <pybind11/pybind11.h>

#include "python/bindings/bindings.h"
#include "raygauge/exceptions.h"

namespace raygauge::python {

namespace py = pybind11;

namespace {

template <class Exception>
py::object add(py::module_& module, const char* name, const py::object& base, const char* doc) {
  auto type = py::register_exception<Exception>(module, name, base);
  type.doc() = doc;
  type.attr("__module__") = "raygauge";
  return type;
}

}  // namespace

void bind_errors(py::module_& module) {
  const auto value_error = py::reinterpret_borrow<py::object>(PyExc_ValueError);
  const py::object error = add<Error>(module, "Error", value_error,
                                      "Base of every exception of raygauge: a mistake of the caller.");
  add<DimensionMismatchError>(module, "DimensionMismatchError", error,
                              "Two objects that must live in the same R^n do not.");
  add<NonFiniteError>(module, "NonFiniteError", error,
                      "A NaN or an infinity where a finite number is needed.");
  add<EmptySetError>(module, "EmptySetError", error, "A set without a single point.");
  add<InvalidParameterError>(module, "InvalidParameterError", error,
                             "A parameter of the wrong type or outside its range.");
  add<UnknownNameError>(module, "UnknownNameError", error,
                        "A name that nothing is registered under; the message lists the known ones.");
}

}  // namespace raygauge::python
