// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "python/bindings/distance_batch.h"

#include <pybind11/stl.h>

#include <string>

#include "python/bindings/batch_docs.h"
#include "python/bindings/results.h"
#include "raygauge/exceptions.h"
#include "raygauge/methods/result.h"

namespace raygauge::python {
namespace {

// NOLINTNEXTLINE(misc-unused-using-decls): clang-tidy 14 sees no use of a literal
using py::literals::operator""_a;

py::object status_texts(const DistanceBatch& batch) {
  const py::object names = py::module_::import("numpy").attr("array")(py::cast(status_names()));
  return names.attr("__getitem__")(batch.status_code);
}

/// Problem k as the answer of distance().
DistanceResult row(const DistanceBatch& batch, std::ptrdiff_t k) {
  const std::ptrdiff_t count = batch.distance.size();
  if (k < -count || k >= count) throw py::index_error("a batch of " + std::to_string(count) + " problems");
  if (k < 0) k += count;
  const auto vector = [k](const py::array_t<double>& rows) {
    const Eigen::Map<const Eigen::VectorXd> numbers(rows.data(k, 0), rows.shape(1));
    return numbers.hasNaN() ? Vector() : Vector(numbers);
  };
  DistanceResult result;
  result.distance = batch.distance.at(k);
  result.lower = batch.lower.at(k);
  result.upper = batch.upper.at(k);
  result.status = static_cast<DistanceStatus>(batch.status_code.at(k));
  result.normal = vector(batch.normal);
  if (!batch.contact_point.is_none()) result.contact_point = vector(batch.contact_point);
  result.counters.pivots = batch.pivots.at(k);
  return result;
}

/// The problems that a slice, a mask or an array of indices picks.
DistanceBatch rows(const DistanceBatch& batch, const py::object& index) {
  const auto picked = [&index](const py::object& array) { return array.attr("__getitem__")(index); };
  DistanceBatch part = batch;
  part.distance = picked(batch.distance);
  part.lower = picked(batch.lower);
  part.upper = picked(batch.upper);
  part.status_code = picked(batch.status_code);
  part.normal = picked(batch.normal);
  if (!batch.contact_point.is_none()) part.contact_point = picked(batch.contact_point);
  part.pivots = picked(batch.pivots);
  return part;
}

py::object to_dataframe(const DistanceBatch& batch) {
  py::dict columns;
  columns["distance"] = batch.distance;
  columns["lower"] = batch.lower;
  columns["upper"] = batch.upper;
  columns["status"] = status_texts(batch);
  columns["pivots"] = batch.pivots;
  const auto add = [&columns](const char* name, const py::object& points) {
    if (points.is_none()) return;
    const py::object coordinates = points.attr("T");
    for (std::size_t k = 0; k < py::len(coordinates); ++k)
      columns[py::str(std::string(name) + "_" + std::to_string(k))] = coordinates[py::int_(k)];
  };
  add("normal", batch.normal);
  add("contact_point", batch.contact_point);
  const py::object frame = py::module_::import("pandas").attr("DataFrame")(columns);
  return frame.attr("astype")(py::dict("status"_a = "category"));
}

py::tuple state_of(const DistanceBatch& b) {
  return py::make_tuple(b.distance, b.lower, b.upper, b.status_code, b.normal, b.contact_point, b.pivots);
}

DistanceBatch batch_of(const py::tuple& state) {
  if (state.size() != 7) throw InvalidParameterError("a pickle of another version of raygauge");
  DistanceBatch batch;
  batch.distance = py::object(state[0]);
  batch.lower = py::object(state[1]);
  batch.upper = py::object(state[2]);
  batch.status_code = py::object(state[3]);
  batch.normal = py::object(state[4]);
  batch.contact_point = py::object(state[5]);
  batch.pivots = py::object(state[6]);
  return batch;
}

}  // namespace

void bind_distance_batch(py::module_& module) {
  py::class_<DistanceBatch>(module, "Distances", kDistanceBatchDoc)
      .def_readonly("distance", &DistanceBatch::distance)
      .def_readonly("lower", &DistanceBatch::lower)
      .def_readonly("upper", &DistanceBatch::upper)
      .def_readonly("status_code", &DistanceBatch::status_code)
      .def_property_readonly("status", &status_texts)
      .def_readonly("normal", &DistanceBatch::normal)
      .def_readonly("contact_point", &DistanceBatch::contact_point)
      .def_readonly("pivots", &DistanceBatch::pivots)
      .def("__len__", [](const DistanceBatch& batch) { return batch.distance.size(); })
      .def("__getitem__", &row, "index"_a)
      .def("__getitem__", &rows, "index"_a)
      .def("__iter__",
           [](const py::object& self) {
             const py::object problems = py::module_::import("builtins").attr("range")(py::len(self));
             return py::module_::import("builtins").attr("map")(self.attr("__getitem__"), problems);
           })
      .def("to_dataframe", &to_dataframe, kToDataframeDoc)
      .def(py::pickle(&state_of, &batch_of))
      .def("__repr__", [](const DistanceBatch& batch) {
        return "<raygauge.Distances of " + std::to_string(batch.distance.size()) + " problems>";
      });
}

}  // namespace raygauge::python
