// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <utility>
#include <vector>

#include "raygauge/scene/scene.h"

namespace raygauge::python {

/// The body that a dictionary of raygauge.Scene describes; rates hold from `start` on.
Body body_of(const pybind11::dict& body, double start);

/// The scene that dictionaries of raygauge.Scene describe. Throws what check_scene() throws.
Scene scene_of(const pybind11::list& bodies, pybind11::handle instants,
               const std::vector<std::pair<int, int>>& ignored, const pybind11::list& queries);

/// The placement that a homogeneous matrix of R^n describes; None: the identity.
Placement placement(pybind11::handle object, int n);

}  // namespace raygauge::python
