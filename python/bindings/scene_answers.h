// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "raygauge/scene/scene.h"

namespace raygauge::python {

/// The columns of a scene's answers, on so many threads; an interrupt ends it. With the lock held.
pybind11::dict scene_columns(const Scene& scene, int threads);

/// What each query will compute and what not, and why: lines.
std::vector<std::vector<std::string>> scene_lines(const Scene& scene);

}  // namespace raygauge::python
