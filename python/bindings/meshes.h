// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

namespace raygauge::python {

void bind_meshes(pybind11::module_& module);

}  // namespace raygauge::python
