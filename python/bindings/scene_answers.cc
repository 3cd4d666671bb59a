// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "python/bindings/scene_answers.h"

#include <pybind11/numpy.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <mutex>
#include <string>
#include <variant>

#include "python/bindings/interrupt.h"
#include "python/bindings/thread_count.h"
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

using Records = std::vector<SceneRecord>;

template <class Number>
py::array column(const Records& records, int /*n*/, Number SceneRecord::*member) {
  py::array_t<Number> array(static_cast<py::ssize_t>(records.size()));
  std::transform(records.begin(), records.end(), array.mutable_data(),
                 [member](const SceneRecord& record) { return record.*member; });
  return array;
}

py::array column(const Records& records, int n, SmallVector SceneRecord::*member) {
  py::array_t<double> array({static_cast<py::ssize_t>(records.size()), static_cast<py::ssize_t>(n)});
  Eigen::Map<Eigen::MatrixXd> rows(array.mutable_data(), n, static_cast<Eigen::Index>(records.size()));
  rows.setConstant(SceneRecord::kNone);
  for (std::size_t i = 0; i < records.size(); ++i) {
    const SmallVector& vector = records[i].*member;
    if (vector.size() == n) rows.col(static_cast<Eigen::Index>(i)) = vector;
  }
  return array;
}

std::string text_of(SceneEffects kind) { return kind_text(kind); }
std::string text_of(SceneStatus status) { return std::string(to_string(status)); }
std::string text_of(SceneDecision decision) { return std::string(to_string(decision)); }

template <class Word>
py::array texts(const Records& records, Word SceneRecord::*member) {
  py::list names;
  for (const SceneRecord& record : records) names.append(py::str(text_of(record.*member)));
  return py::module_::import("numpy").attr("array")(names, "dtype"_a = py::str("U16"));
}

py::array column(const Records& r, int, SceneEffects SceneRecord::*m) { return texts(r, m); }
py::array column(const Records& r, int, SceneStatus SceneRecord::*m) { return texts(r, m); }
py::array column(const Records& r, int, SceneDecision SceneRecord::*m) { return texts(r, m); }

py::dict columns_of(const Records& records, int n) {
  py::dict columns;
  for (const SceneField& field : scene_fields()) {
    columns[py::str(std::string(field.name))] =
        std::visit([&](auto member) { return column(records, n, member); }, field.member);
  }
  return columns;
}

}  // namespace

py::dict scene_columns(const Scene& scene, int threads) {
  const ScenePlan plan = plan_scene(scene);
  const int team = batch_threads(threads);
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
