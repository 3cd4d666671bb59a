// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <cstdint>
#include <utility>

namespace raygauge::python {

namespace py = pybind11;

/// The answers of a batch, a NumPy array each.
struct DistanceBatch {
  py::array_t<double> distance, lower, upper;
  py::array_t<std::int8_t> status_code;
  py::array_t<double> normal;             // NaN where a problem has none
  py::object contact_point = py::none();  // or an array
  py::array_t<std::int64_t> pivots;
  double* contact_data = nullptr;

  DistanceBatch() = default;
  DistanceBatch(std::ptrdiff_t count, int n, bool witness)
      : distance(count),
        lower(count),
        upper(count),
        status_code(count),
        normal({count, static_cast<std::ptrdiff_t>(n)}),
        contact_point(py::none()),
        pivots(count) {
    if (!witness) return;
    py::array_t<double> points({count, static_cast<std::ptrdiff_t>(n)});
    contact_data = points.mutable_data();
    contact_point = std::move(points);
  }
};

/// Adds the class Distances.
void bind_distance_batch(py::module_& module);

}  // namespace raygauge::python
