// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "python/sweeps/components.h"

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "baselines/certify.h"
#include "baselines/gauge_lp.h"
#include "python/bindings/arrays.h"
#include "raygauge/exceptions.h"
#include "raygauge/sets/point_set.h"

namespace raygauge::python {
namespace {

/// The parameters that an experiment may set: (name, default) in Python.
std::vector<ParameterInfo> parameters_of(const py::object& component) {
  std::vector<ParameterInfo> parameters;
  for (const py::handle entry : component.attr("parameters")) {
    const auto pair = py::reinterpret_borrow<py::tuple>(entry);
    const py::object value = pair[1];
    ParameterInfo info;
    info.name = pair[0].cast<std::string>();
    if (PyBool_Check(value.ptr())) {
      info.default_value = value.cast<bool>();
    } else if (PyLong_Check(value.ptr())) {
      info.default_value = value.cast<std::int64_t>();
    } else if (PyFloat_Check(value.ptr())) {
      info.default_value = value.cast<double>();
    } else {
      info.default_value = value.cast<std::string>();
    }
    parameters.push_back(std::move(info));
  }
  return parameters;
}

py::dict dict_of(const Parameters& parameters) {
  py::dict dict;
  for (const auto& [name, value] : parameters) {
    dict[py::str(name)] = std::visit([](const auto& held) -> py::object { return py::cast(held); }, value);
  }
  return dict;
}

/// A point set as a read-only array of shape (N, n); any other set as it is.
py::object object_of(const std::shared_ptr<const ConvexSet>& set) {
  const PointSet* points = as_point_set(*set);
  if (points == nullptr) return py::cast(std::const_pointer_cast<ConvexSet>(set));
  py::array_t<double> rows({points->size(), static_cast<std::ptrdiff_t>(points->dimension())});
  for (std::ptrdiff_t i = 0; i < points->size(); ++i) points->copy_point(i, rows.mutable_data(i, 0));
  py::detail::array_proxy(rows.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return rows;
}

DistanceStatus status_of(double distance, const py::object& given) {
  if (!given.is_none()) {
    const auto name = py::str(given).cast<std::string>();
    for (int code = 0; code <= static_cast<int>(DistanceStatus::time_limit); ++code) {
      if (name == to_string(static_cast<DistanceStatus>(code))) return static_cast<DistanceStatus>(code);
    }
    throw InvalidParameterError("a status '" + name + "' is not known");
  }
  if (std::isnan(distance)) return DistanceStatus::precision_limit;
  if (std::isinf(distance)) return DistanceStatus::unreachable;
  return distance == 0 ? DistanceStatus::contains_origin : DistanceStatus::optimal;
}

void take_points(const py::object& answer, const char* name, std::ptrdiff_t size, std::ptrdiff_t offset,
                 std::vector<std::ptrdiff_t>& basis) {
  for (const py::handle index : answer.attr(name)) {
    const auto i = py::int_(py::reinterpret_borrow<py::object>(index)).cast<std::ptrdiff_t>();
    if (i < 0 || i >= size) {
      throw InvalidParameterError(std::string(name) + ": no point has the number " + std::to_string(i));
    }
    basis.push_back(i + offset);
  }
}

LpAnswer lp_answer(const py::object& answer) {
  LpAnswer lp;
  lp.objective = answer.attr("distance").cast<double>();
  lp.status = status_of(lp.objective, answer.attr("status"));
  lp.pivots = answer.attr("pivots").cast<std::int64_t>();
  return lp;
}

/// The answer with bounds certified from what it brings, for point sets; NaN for other sets.
DistanceResult certified(const Instance& instance, const py::object& answer, const std::string& name) {
  LpAnswer lp = lp_answer(answer);
  if (as_point_set(*instance.A) == nullptr || as_point_set(*instance.Q) == nullptr) {
    DistanceResult result;
    result.status = lp.status;
    result.distance = lp.objective;
    result.counters.pivots = lp.pivots;
    return result;
  }
  const GaugeLp program(instance, name);
  if (const py::object u = answer.attr("u"); !u.is_none()) {
    lp.u = as_vector(u, "u");
    if (lp.u.size() != instance.A->dimension()) {
      throw DimensionMismatchError("u: " + std::to_string(instance.A->dimension()) +
                                   " numbers are needed, got " + std::to_string(lp.u.size()));
    }
  }
  take_points(answer, "points_A", program.A().size(), 0, lp.basis);
  take_points(answer, "points_Q", program.Q().size(), program.A().size(), lp.basis);
  return certified_result(program, lp);
}

/// What @rg.method has registered, behind the interface of a sweep.
class PythonMethod final : public SolveMethod {
 public:
  PythonMethod(Interpreter& interpreter, SharedObject component, SharedObject answer_of,
               const Parameters& parameters)
      : interpreter_(interpreter), component_(component), answer_of_(answer_of), name_(name_of(component)) {
    interpreter_.call(*component_, [&] {
      solver_.emplace(component_->attr("make")(dict_of(parameters)));
      solve_.emplace((*solver_)->attr("solve"));
    });
  }

  void load(const Instance& instance) override {
    interpreter_.call(*component_, [&] {
      (*solver_)->attr("load")(object_of(instance.A), object_of(instance.Q));
      instance_ = instance;
    });
  }

  void solve(const SolveRequest& request) override {
    interpreter_.call(*component_, [&] {
      const SteadyClock::time_point start = SteadyClock::now();
      answer_.emplace((**solve_)(request.tolerance, request.time_limit));
      late_ = seconds_since(start) > request.time_limit;
    });
  }

  DistanceResult result() override {
    DistanceResult result;
    interpreter_.call(*component_, [&] {
      if (!answer_) throw Error("method '" + name_ + "': result before solve");
      try {
        result = certified(instance_, (*answer_of_)(**answer_), name_);
      } catch (const Error& error) {
        throw Error("method '" + name_ + "': " + error.what());
      }
    });
    if (late_) result.status = DistanceStatus::time_limit;
    return result;
  }

 private:
  static std::string name_of(const SharedObject& component) {
    const py::gil_scoped_acquire lock;
    return component->attr("name").cast<std::string>();
  }

  Interpreter& interpreter_;
  SharedObject component_;
  SharedObject answer_of_;
  std::string name_;
  std::optional<SharedObject> solver_;
  std::optional<SharedObject> solve_;
  Instance instance_;
  std::optional<SharedObject> answer_;
  bool late_ = false;
};

/// What @rg.generator has registered.
class PythonGenerator final : public Generator {
 public:
  PythonGenerator(Interpreter& interpreter, SharedObject component, const Parameters& parameters)
      : interpreter_(interpreter), component_(component) {
    interpreter_.call(*component_, [&] { make_.emplace(component_->attr("make")(dict_of(parameters))); });
  }

  Instance generate(const InstanceKey& key) const override {
    Instance instance;
    interpreter_.call(*component_, [&] {
      const py::tuple made = (**make_)(key.seed, key.n, key.N, key.repetition);
      try {
        instance.A = as_set(made[0], "A");
        instance.Q = as_set(made[1], "Q");
      } catch (const Error& error) {
        throw Error("generator '" + component_->attr("name").cast<std::string>() + "': " + error.what());
      }
      if (const py::object exact = made[2]; !exact.is_none()) instance.exact_distance = exact.cast<double>();
    });
    return instance;
  }

 private:
  Interpreter& interpreter_;
  SharedObject component_;
  std::optional<SharedObject> make_;
};

}  // namespace

void add_python_method(MethodRegistry& registry, Interpreter& interpreter, py::object component,
                       const py::object& answer_of) {
  Component<SolveMethod> entry;
  entry.name = component.attr("name").cast<std::string>();
  entry.description = component.attr("description").cast<std::string>();
  entry.parameters = parameters_of(component);
  entry.make = [&interpreter, held = SharedObject(std::move(component)),
                answer = SharedObject(answer_of)](const Parameters& parameters) {
    return std::make_unique<PythonMethod>(interpreter, held, answer, parameters);
  };
  entry.role = Role::baseline;
  registry.add(std::move(entry));
}

void add_python_generator(GeneratorRegistry& registry, Interpreter& interpreter, py::object component) {
  Component<Generator> entry;
  entry.name = component.attr("name").cast<std::string>();
  entry.description = component.attr("description").cast<std::string>();
  entry.parameters = parameters_of(component);
  entry.make = [&interpreter, held = SharedObject(std::move(component))](const Parameters& parameters) {
    return std::make_unique<PythonGenerator>(interpreter, held, parameters);
  };
  registry.add(std::move(entry));
}

TimedSolve time_in_turn(Interpreter& interpreter, SolveMethod& method, const SolveRequest& request,
                        double min_seconds) {
  if (dynamic_cast<PythonMethod*>(&method) == nullptr) return time_solve(method, request, min_seconds);
  const Interpreter::Turn turn(interpreter);
  return time_solve(method, request, min_seconds);
}

}  // namespace raygauge::python
