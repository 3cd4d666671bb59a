// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include "raygauge/simulation.h"

namespace raygauge::python {

/// A simulated scene: its states at the instants, contacts and steps as columns, the counters, and the
/// answers to its queries. An interrupt ends it. With the lock held.
pybind11::dict simulated_columns(const Scene& scene, const Dynamics& dynamics, int threads);

}  // namespace raygauge::python
