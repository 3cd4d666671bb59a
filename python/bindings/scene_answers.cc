// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "python/bindings/scene_answers.h"

#include <pybind11/numpy.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <limits>
#include <mutex>

#include "python/bindings/interrupt.h"
#include "python/bindings/workers.h"
#include "raygauge/scene/scene_run.h"

namespace raygauge::python {
namespace {

namespace py = pybind11;
// NOLINTNEXTLINE(misc-unused-using-decls): clang-tidy 14 sees no use of a literal
using py::literals::operator""_a;

/// The cells of a scene as they are done; in their order at the end.
class CellCollector final : public SceneSink {
 public:
  void store(const SceneCellResult& cell) override {
    const std::lock_guard lock(mutex_);
    cells_.push_back(cell);
  }
  std::vector<SceneRecord> records() {
    std::sort(cells_.begin(), cells_.end(), [](const auto& a, const auto& b) { return a.cell < b.cell; });
    std::vector<SceneRecord> all;
    for (const SceneCellResult& cell : cells_) {
      all.insert(all.end(), cell.records.begin(), cell.records.end());
    }
    return all;
  }

 private:
  std::mutex mutex_;
  std::vector<SceneCellResult> cells_;
};

template <class Value, class Get>
py::array_t<Value> column(const std::vector<SceneRecord>& records, Get get) {
  py::array_t<Value> array(static_cast<py::ssize_t>(records.size()));
  std::transform(records.begin(), records.end(), array.mutable_data(), get);
  return array;
}

template <class Get>
py::array_t<double> vectors(const std::vector<SceneRecord>& records, int n, Get get) {
  py::array_t<double> array({static_cast<py::ssize_t>(records.size()), static_cast<py::ssize_t>(n)});
  Eigen::Map<Eigen::MatrixXd> rows(array.mutable_data(), n, static_cast<Eigen::Index>(records.size()));
  rows.setConstant(SceneRecord::kNone);
  for (std::size_t i = 0; i < records.size(); ++i) {
    const SmallVector& vector = get(records[i]);
    if (vector.size() == n) rows.col(static_cast<Eigen::Index>(i)) = vector;
  }
  return array;
}

template <class Get>
py::array texts(const std::vector<SceneRecord>& records, Get get) {
  py::list names;
  for (const SceneRecord& record : records) names.append(py::str(std::string(to_string(get(record)))));
  return py::module_::import("numpy").attr("array")(names, "dtype"_a = py::str("U16"));
}

py::dict columns_of(const std::vector<SceneRecord>& records, int n) {
  using R = const SceneRecord&;
  py::dict c;
  c["query"] = column<std::int32_t>(records, [](R r) { return r.query; });
  c["body_a"] = column<std::int32_t>(records, [](R r) { return r.body_a; });
  c["body_b"] = column<std::int32_t>(records, [](R r) { return r.body_b; });
  c["kind"] = texts(records, [](R r) { return r.kind; });
  c["instant"] = column<std::int64_t>(records, [](R r) { return r.instant; });
  c["time"] = column<double>(records, [](R r) { return r.time; });
  c["time_lower"] = column<double>(records, [](R r) { return r.time_lower; });
  c["time_upper"] = column<double>(records, [](R r) { return r.time_upper; });
  c["status"] = texts(records, [](R r) { return r.status; });
  c["decided"] = texts(records, [](R r) { return r.decided; });
  c["distance"] = column<double>(records, [](R r) { return r.distance; });
  c["lower"] = column<double>(records, [](R r) { return r.lower; });
  c["upper"] = column<double>(records, [](R r) { return r.upper; });
  c["growth"] = column<double>(records, [](R r) { return r.growth; });
  c["growth_lower"] = column<double>(records, [](R r) { return r.growth_lower; });
  c["growth_upper"] = column<double>(records, [](R r) { return r.growth_upper; });
  c["point_a"] = vectors(records, n, [](R r) -> const SmallVector& { return r.point_a; });
  c["point_b"] = vectors(records, n, [](R r) -> const SmallVector& { return r.point_b; });
  c["gradient"] = vectors(records, n, [](R r) -> const SmallVector& { return r.gradient; });
  c["solves"] = column<std::int64_t>(records, [](R r) { return r.solves; });
  c["seconds"] = column<double>(records, [](R r) { return r.seconds; });
  return c;
}

}  // namespace

py::dict scene_columns(const Scene& scene, int threads) {
  const ScenePlan plan = plan_scene(scene);
  const int team = batch_threads(threads, std::numeric_limits<std::ptrdiff_t>::max() / 2);
  CellCollector cells;
  std::atomic<bool> stop = false;
  SceneHooks hooks;
  hooks.stop = [&] { return stop.load(); };
  run_interruptibly(stop, [&] { run_scene(scene, plan, team, {}, cells, hooks); });
  return columns_of(cells.records(), scene.dimension());
}

std::vector<std::vector<std::string>> scene_lines(const Scene& scene) {
  const ScenePlan plan = plan_scene(scene);
  std::vector<std::vector<std::string>> lines;
  for (std::size_t i = 0; i < scene.queries.size(); ++i) {
    lines.push_back(explain_query(scene, plan, static_cast<int>(i)));
  }
  return lines;
}

}  // namespace raygauge::python
