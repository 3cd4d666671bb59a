// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "python/bindings/batch_operands.h"

namespace raygauge::python {

namespace py = pybind11;

/// The answers of a batch, a NumPy array each.
struct DistanceBatch {
  py::array_t<double> distance, lower, upper;
  py::array_t<std::int8_t> status_code;
  py::array_t<double> normal;             // NaN where a problem has none
  py::object contact_point = py::none();  // or an array
  py::array_t<std::int64_t> pivots;
  std::span<double> contacts;  // the memory of contact_point

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
    contacts = numbers_of(points);
    contact_point = std::move(points);
  }

  /// Where PairBatch writes them: the arrays' memory.
  BatchAnswers answers() {
    BatchAnswers answers;
    answers.distance = numbers_of(distance);
    answers.lower = numbers_of(lower);
    answers.upper = numbers_of(upper);
    answers.status = statuses(status_code);
    answers.normal = numbers_of(normal);
    answers.contact_points = contacts;
    answers.pivots = numbers_of(pivots);
    return answers;
  }
};

/// Adds the class Distances.
void bind_distance_batch(py::module_& module);

}  // namespace raygauge::python
