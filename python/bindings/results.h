// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <vector>

#include "raygauge/methods/result.h"

namespace raygauge::python {

/// The member of raygauge.Status, a text as well, for a status of the engine's.
pybind11::object status_object(DistanceStatus status);

/// The names of the statuses, by their numbers.
std::vector<std::string> status_names();

/// The names of the outcomes of separation tests, by their numbers.
std::vector<std::string> outcome_names();

}  // namespace raygauge::python
