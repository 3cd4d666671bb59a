// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "python/bindings/results.h"

#include <pybind11/stl.h>

#include <array>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/methods/counters.h"
#include "python/bindings/arrays.h"
#include "python/bindings/bindings.h"
#include "python/bindings/pose_gradient.h"
#include "python/bindings/result_docs.h"
#include "raygauge/exceptions.h"
#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/object_distance.h"

namespace raygauge::python {
namespace {

constexpr std::array kStatuses{DistanceStatus::optimal,         DistanceStatus::contains_origin,
                               DistanceStatus::unreachable,     DistanceStatus::precision_limit,
                               DistanceStatus::iteration_limit, DistanceStatus::time_limit};
constexpr std::array kOutcomeNames{"separated", "intersecting", "undecided"};

/// class NAME(enum.StrEnum), with a member for each name, whose value is the name.
py::object text_enum(py::module_& module, const char* name, const std::vector<std::string>& names,
                     const char* doc) {
  py::dict members;
  for (const std::string& member : names) members[py::str(member)] = member;
  py::object type =
      py::module_::import("enum").attr("StrEnum")(name, members, py::arg("module") = "raygauge");
  type.attr("__doc__") = doc;
  module.attr(name) = type;
  return type;
}

/// The members of an enumeration of ours, which live as long as the process.
std::vector<py::handle>& status_members() {
  static std::vector<py::handle> members;
  return members;
}
std::vector<py::handle>& outcome_members() {
  static std::vector<py::handle> members;
  return members;
}

void keep_members(const py::object& type, const std::vector<std::string>& names,
                  std::vector<py::handle>& members) {
  members.clear();
  for (const std::string& name : names) {
    members.push_back(type[py::str(name)].cast<py::object>().release());
  }
}

py::object array_or_none(const Vector& vector) {
  return vector.size() == 0 ? py::object(py::none()) : readonly_array(vector);
}

double gap_of(const DistanceResult& result) {
  return result.upper == result.lower ? 0 : result.upper - result.lower;
}

std::string number(double value) { return py::repr(py::float_(value)).cast<std::string>(); }

std::string repr_of(const DistanceResult& result, const char* type) {
  return std::string(type) + "(" + number(result.distance) + ", lower=" + number(result.lower) +
         ", upper=" + number(result.upper) + ", status='" + std::string(to_string(result.status)) + "')";
}

using Pairs = std::vector<std::pair<std::ptrdiff_t, double>>;

Pairs pairs_of(const std::vector<PointWeight>& points) {
  Pairs pairs;
  for (const PointWeight& point : points) pairs.emplace_back(point.index, point.weight);
  return pairs;
}

Pairs origin_weights(const DistanceResult& result) { return pairs_of(result.origin_weights); }

/// A member of a result as Python pickles it, and back.
template <class Member>
py::object packed(const Member& member) {
  if constexpr (std::is_same_v<Member, Vector>) {
    return readonly_array(member);
  } else if constexpr (std::is_enum_v<Member>) {
    return py::int_(static_cast<int>(member));
  } else if constexpr (std::is_same_v<Member, PoseGradient>) {
    return packed_gradient(member);
  } else if constexpr (std::is_same_v<Member, std::vector<PointWeight>>) {
    return py::cast(pairs_of(member));
  } else {
    return py::cast(member);
  }
}
template <class Member>
Member unpacked(const py::object& value) {
  if constexpr (std::is_same_v<Member, Vector>) {
    return as_vector(value, "a pickle");
  } else if constexpr (std::is_enum_v<Member>) {
    return static_cast<Member>(value.cast<int>());
  } else if constexpr (std::is_same_v<Member, PoseGradient>) {
    return unpacked_gradient(value);
  } else if constexpr (std::is_same_v<Member, std::vector<PointWeight>>) {
    Member weights;
    for (const auto& [index, weight] : value.cast<Pairs>()) weights.push_back({index, weight});
    return weights;
  } else {
    return value.cast<Member>();
  }
}

/// Pickling and copying: the values of these members, in their order.
template <class Result, class... Member>
void copied_by(py::class_<Result>& type, Member Result::*... members) {
  type.def(
      py::pickle([members...](const Result& result) { return py::make_tuple(packed(result.*members)...); },
                 [members...](const py::tuple& state) {
                   if (state.size() != sizeof...(members))
                     throw InvalidParameterError("a pickle of another version of raygauge");
                   Result result;
                   std::size_t next = 0;
                   ((result.*members = unpacked<Member>(state[next++])), ...);
                   return result;
                 }));
}

void bind_counters(py::module_& module) {
  py::class_<DistanceCounters> type(module, "Counters", "What a solve did.");
  for (const CounterInfo& counter : kCounters) {
    type.def_property_readonly(
        counter.name,
        [member = counter.member](const DistanceCounters& counters) { return counters.*member; },
        counter.description);
  }
  type.def("__repr__",
           [](const DistanceCounters& counters) {
             return "Counters(pivots=" + std::to_string(counters.pivots) +
                    ", support_queries=" + std::to_string(counters.support_queries) +
                    ", exact_pivots=" + std::to_string(counters.exact_pivots) + ")";
           })
      .def(py::pickle(
          [](const DistanceCounters& counters) {
            py::dict values;
            for (const CounterInfo& counter : kCounters) values[counter.name] = counters.*counter.member;
            return values;
          },
          [](const py::dict& values) {
            DistanceCounters counters;
            for (const CounterInfo& counter : kCounters)
              counters.*counter.member = values[counter.name].cast<std::int64_t>();
            return counters;
          }));
}

void bind_distance(py::module_& module) {
  py::class_<DistanceResult> type(module, "Distance", kDistanceResultDoc);
  type.def_readonly("distance", &DistanceResult::distance)
      .def_readonly("lower", &DistanceResult::lower)
      .def_readonly("upper", &DistanceResult::upper)
      .def_property_readonly("gap", gap_of)
      .def_property_readonly("status",
                             [](const DistanceResult& result) { return status_object(result.status); })
      .def_property_readonly("normal",
                             [](const DistanceResult& result) { return array_or_none(result.normal); })
      .def_property_readonly("contact_point",
                             [](const DistanceResult& result) { return array_or_none(result.contact_point); })
      .def_readonly("sigma", &DistanceResult::sigma)
      .def_readonly("seconds", &DistanceResult::seconds)
      .def_property_readonly("origin_weights", origin_weights)
      .def_readonly("counters", &DistanceResult::counters)
      .def("__float__", [](const DistanceResult& result) { return result.distance; })
      .def("__repr__", [](const DistanceResult& result) { return repr_of(result, "Distance"); });
  using R = DistanceResult;
  copied_by(type, &R::distance, &R::lower, &R::upper, &R::status, &R::sigma, &R::seconds, &R::normal,
            &R::contact_point, &R::origin_weights, &R::counters);
}

void bind_depth(py::module_& module) {
  py::class_<ObjectDepth>(module, "Depth", kDepthDoc)
      .def_readonly("depth", &ObjectDepth::depth)
      .def_readonly("lower", &ObjectDepth::lower)
      .def_readonly("upper", &ObjectDepth::upper)
      .def_property_readonly("status", [](const ObjectDepth& depth) { return status_object(depth.status); })
      .def_property_readonly("normal", [](const ObjectDepth& depth) { return array_or_none(depth.normal); })
      .def_property_readonly("point_1", [](const ObjectDepth& depth) { return array_or_none(depth.point_1); })
      .def_property_readonly("point_2", [](const ObjectDepth& depth) { return array_or_none(depth.point_2); })
      .def_readonly("support_queries", &ObjectDepth::support_queries)
      .def("__float__", [](const ObjectDepth& depth) { return depth.depth; })
      .def("__repr__", [](const ObjectDepth& depth) {
        return "Depth(" + number(depth.depth) + ", lower=" + number(depth.lower) +
               ", upper=" + number(depth.upper) + ", status='" + std::string(to_string(depth.status)) + "')";
      });
}

void bind_object_distance(py::module_& module) {
  py::class_<ObjectDistance> type(module, "ObjectDistance", kObjectDistanceResultDoc);
  type.def_property_readonly("distance", [](const ObjectDistance& r) { return r.distance.distance; })
      .def_property_readonly("lower", [](const ObjectDistance& r) { return r.distance.lower; })
      .def_property_readonly("upper", [](const ObjectDistance& r) { return r.distance.upper; })
      .def_property_readonly("gap", [](const ObjectDistance& r) { return gap_of(r.distance); })
      .def_property_readonly("status",
                             [](const ObjectDistance& r) { return status_object(r.distance.status); })
      .def_property_readonly("normal",
                             [](const ObjectDistance& r) { return array_or_none(r.distance.normal); })
      .def_property_readonly("counters", [](const ObjectDistance& r) { return r.distance.counters; })
      .def_property_readonly("closest_point_1",
                             [](const ObjectDistance& r) { return array_or_none(r.closest_point_1); })
      .def_property_readonly("closest_point_2",
                             [](const ObjectDistance& r) { return array_or_none(r.closest_point_2); })
      .def_property_readonly("gradient_1",
                             [](const ObjectDistance& r) { return array_or_none(r.gradient_1); })
      .def_property_readonly("gradient_2",
                             [](const ObjectDistance& r) { return array_or_none(r.gradient_2); })
      .def_property_readonly("pose_gradient",
                             [](const ObjectDistance& r) {
                               const int n = static_cast<int>(r.gradient_1.size());
                               return r.pose_gradient.kind == GradientKind::none
                                          ? py::object(py::none())
                                          : py::cast(PoseGradientOf{r.pose_gradient, n});
                             })
      .def_property_readonly("depth",
                             [](const ObjectDistance& r) {
                               return r.depth.evaluations > 0 ? py::cast(ObjectDepth(r.depth))
                                                              : py::object(py::none());
                             })
      .def_property_readonly("signed_distance", &ObjectDistance::signed_distance)
      .def("__float__", [](const ObjectDistance& r) { return r.signed_distance(); })
      .def("__repr__", [](const ObjectDistance& r) { return repr_of(r.distance, "ObjectDistance"); });
  using R = ObjectDistance;
  copied_by(type, &R::distance, &R::closest_point_1, &R::closest_point_2, &R::gradient_1, &R::gradient_2,
            &R::pose_gradient, &R::closest_point_evaluations, &R::gradient_evaluations,
            &R::pose_gradient_evaluations);
}

void bind_separation(py::module_& module) {
  py::class_<SeparationResult> type(module, "SeparationResult", kSeparationResultDoc);
  type.def_property_readonly("outcome",
                             [](const SeparationResult& result) {
                               return py::reinterpret_borrow<py::object>(
                                   outcome_members()[static_cast<std::size_t>(result.outcome)]);
                             })
      .def_property_readonly("normal",
                             [](const SeparationResult& result) { return array_or_none(result.normal); })
      .def_readonly("lower", &SeparationResult::lower)
      .def_readonly("upper", &SeparationResult::upper)
      .def_readonly("counters", &SeparationResult::counters)
      .def("__repr__", [](const SeparationResult& result) {
        return std::string("SeparationResult('") + kOutcomeNames[static_cast<std::size_t>(result.outcome)] +
               "', lower=" + number(result.lower) + ", upper=" + number(result.upper) + ")";
      });
  using R = SeparationResult;
  copied_by(type, &R::outcome, &R::normal, &R::lower, &R::upper, &R::counters);
}

}  // namespace

std::vector<std::string> status_names() {
  std::vector<std::string> names;
  for (const DistanceStatus status : kStatuses) names.emplace_back(to_string(status));
  return names;
}

std::vector<std::string> outcome_names() { return {kOutcomeNames.begin(), kOutcomeNames.end()}; }

py::object status_object(DistanceStatus status) {
  return py::reinterpret_borrow<py::object>(status_members()[static_cast<std::size_t>(status)]);
}

void bind_results(py::module_& module) {
  const std::vector<std::string> names = status_names();
  keep_members(text_enum(module, "Status", names, kStatusDoc), names, status_members());
  const std::vector<std::string> outcomes = outcome_names();
  keep_members(text_enum(module, "Separation", outcomes, kSeparationDoc), outcomes, outcome_members());
  bind_counters(module);
  bind_distance(module);
  bind_depth(module);
  bind_object_distance(module);
  bind_separation(module);
}

}  // namespace raygauge::python
