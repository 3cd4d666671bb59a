// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "python/bindings/bindings.h"
#include "python/bindings/grasps.h"

PYBIND11_MODULE(_raygauge, module) {
  module.doc() = "The compiled part of raygauge; import raygauge instead.";
  module.attr("__version__") = RAYGAUGE_VERSION;
  raygauge::python::bind_errors(module);
  raygauge::python::bind_sets(module);
  raygauge::python::bind_poses(module);
  raygauge::python::bind_results(module);
  raygauge::python::bind_contacts(module);
  raygauge::python::bind_grasps(module);
  raygauge::python::bind_queries(module);
  raygauge::python::bind_batches(module);
  raygauge::python::bind_object_batches(module);
  raygauge::python::bind_separation_batches(module);
  raygauge::python::bind_scenes(module);
  raygauge::python::bind_simulations(module);
  raygauge::python::bind_edges(module);
}
