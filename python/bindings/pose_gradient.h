// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include "raygauge/queries/gradient.h"

namespace raygauge::python {

/// A gradient by pose in R^2 or R^3, as Python sees it: twists are arrays of 3 or 6 numbers.
struct PoseGradientOf {
  PoseGradient gradient;
  int n = 3;
};

/// As a member of a result is pickled, and back.
pybind11::tuple packed_gradient(const PoseGradient& gradient);
PoseGradient unpacked_gradient(const pybind11::object& state);

}  // namespace raygauge::python
