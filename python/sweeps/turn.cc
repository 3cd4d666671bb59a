// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "python/sweeps/turn.h"

#include "raygauge/exceptions.h"

namespace raygauge::python {

namespace py = pybind11;

void Interpreter::call(const py::object& component, const std::function<void()>& function) {
  const Turn turn(*this);
  std::string text;
  try {
    function();
    return;
  } catch (py::error_already_set& error) {
    const py::object exception = error.value();
    if (error.trace()) PyException_SetTraceback(exception.ptr(), error.trace().ptr());
    if (first_exception_.is_none()) first_exception_ = exception;
    text = describe_(component, exception).cast<std::string>();
  }
  throw Error(text);
}

}  // namespace raygauge::python
