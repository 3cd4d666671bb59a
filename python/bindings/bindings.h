// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

namespace raygauge::python {

// Each adds its part to the module raygauge._raygauge.
void bind_errors(pybind11::module_& module);
void bind_sets(pybind11::module_& module);
void bind_poses(pybind11::module_& module);
void bind_results(pybind11::module_& module);
void bind_contacts(pybind11::module_& module);
void bind_queries(pybind11::module_& module);
void bind_scenes(pybind11::module_& module);
void bind_simulations(pybind11::module_& module);
void bind_edges(pybind11::module_& module);
void bind_batches(pybind11::module_& module);
void bind_object_batches(pybind11::module_& module);
void bind_separation_batches(pybind11::module_& module);

}  // namespace raygauge::python
