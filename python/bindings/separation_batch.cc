// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <atomic>
#include <limits>
#include <string>

#include "python/bindings/batch_docs.h"
#include "python/bindings/batch_operands.h"
#include "python/bindings/interrupt.h"
#include "python/bindings/results.h"
#include "python/bindings/thread_count.h"
#include "raygauge/queries/pair_batch.h"

namespace raygauge::python {
namespace {

// NOLINTNEXTLINE(misc-unused-using-decls): clang-tidy 14 sees no use of a literal
using py::literals::operator""_a;

/// The answers of a batch of separation tests, a NumPy array each.
struct SeparationBatch {
  py::array_t<std::int8_t> outcome_code;
  py::array_t<double> normal;

  SeparationBatch(std::ptrdiff_t count, int n)
      : outcome_code(count), normal({count, static_cast<std::ptrdiff_t>(n)}) {}

  /// Where PairBatch writes them: the arrays' memory.
  SeparationAnswers answers() {
    static_assert(sizeof(Separation) == 1);
    return {{reinterpret_cast<Separation*>(outcome_code.mutable_data()),
             static_cast<std::size_t>(outcome_code.size())},
            numbers_of(normal)};
  }
};

// NOLINTNEXTLINE(readability-function-size): a parameter a keyword of the Python function
SeparationBatch separations(const SetsLike& A1, const SetsLike& A2, double tolerance,
                            const std::string& method, const PoseLike& poses_1, const PoseLike& poses_2,
                            double time_limit, int threads) {
  const BatchSide first(A1, "A1", poses_1, "poses_1");
  const BatchSide second(A2, "A2", poses_2, "poses_2");
  const DistanceOptions options = options_of(method, tolerance, time_limit);
  const std::ptrdiff_t count = problem_count(first, second, "separation()");
  const int team = batch_threads(threads), n = first.operand.dimension();
  if (second.operand.dimension() != n) {
    throw DimensionMismatchError("A1 has n = " + std::to_string(n) +
                                 ", A2 has n = " + std::to_string(second.operand.dimension()));
  }
  SeparationBatch batch(count, n);
  const SeparationAnswers answers = batch.answers();
  BatchPairs pairs(first, second, team);
  PairBatch solvers(options, team);
  std::atomic<bool> stop = false;
  solvers.set_stop([&stop] { return stop.load(std::memory_order_relaxed); });
  run_interruptibly(
      stop, [&] { solvers.separations(static_cast<std::size_t>(count), pairs.source(), n, answers); });
  if (pairs.replaced()) warn_of_replaced_rotation();
  return batch;
}

py::object outcome_texts(const SeparationBatch& batch) {
  const py::object names = py::module_::import("numpy").attr("array")(py::cast(outcome_names()));
  return names.attr("__getitem__")(batch.outcome_code);
}

}  // namespace

void bind_separation_batches(py::module_& module) {
  py::class_<SeparationBatch>(module, "Separations", kSeparationBatchDoc)
      .def_property_readonly("outcome", &outcome_texts)
      .def_readonly("outcome_code", &SeparationBatch::outcome_code)
      .def_readonly("normal", &SeparationBatch::normal)
      .def("__len__", [](const SeparationBatch& batch) { return batch.outcome_code.size(); })
      .def("__repr__", [](const SeparationBatch& batch) {
        return "<raygauge.Separations of " + std::to_string(batch.outcome_code.size()) + " problems>";
      });
  module.def("separations", &separations, kSeparationsDoc, "A1"_a, "A2"_a,
             "tolerance"_a = DistanceOptions().tolerance, "method"_a = "newton", py::kw_only(),
             "poses_1"_a = py::none(), "poses_2"_a = py::none(),
             "time_limit"_a = std::numeric_limits<double>::infinity(), "threads"_a = 0);
}

}  // namespace raygauge::python
