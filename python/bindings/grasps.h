// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

namespace raygauge::python {

// Adds the quality of grasps to the module raygauge._raygauge.
void bind_grasps(pybind11::module_& module);

}  // namespace raygauge::python
