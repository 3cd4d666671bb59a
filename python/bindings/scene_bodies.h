// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include "raygauge/scene/body.h"

namespace raygauge::python {

/// The body that a dictionary of raygauge.Scene describes; rates hold from `start` on.
Body body_of(const pybind11::dict& body, double start);

/// The placement that a homogeneous matrix of R^n describes; None: the identity.
Placement placement(pybind11::handle object, int n);

}  // namespace raygauge::python
