// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

namespace raygauge::python {

/// Adds what plans paths to the module: of a robot among obstacles, and of the [plan] of a scene file.
void bind_planning(pybind11::module_& module);

}  // namespace raygauge::python
