// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

namespace raygauge::python {

/// Adds what reads files of the user's to the module: sets, robots, scenes, by the program's own readers.
void bind_loading(pybind11::module_& module);

}  // namespace raygauge::python
