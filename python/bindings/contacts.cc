// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// Gradients by pose and contact patches.
#include <pybind11/numpy.h>

#include <array>
#include <limits>
#include <string>

#include "python/bindings/arrays.h"
#include "python/bindings/bindings.h"
#include "python/bindings/contact_docs.h"
#include "python/bindings/interrupt.h"
#include "python/bindings/pose_gradient.h"
#include "python/bindings/poses.h"
#include "python/bindings/results.h"
#include "python/bindings/solving.h"
#include "raygauge/exceptions.h"
#include "raygauge/queries/object_distance.h"

namespace raygauge::python {
namespace {

// NOLINTNEXTLINE(misc-unused-using-decls): clang-tidy 14 sees no use of a literal
using py::literals::operator""_a;

constexpr std::array kKinds{"none", "unique", "one_sided", "undecided"};

Vector numbers(const Twist& twist, int n) {
  Vector v(n == 2 ? 3 : 6);
  if (n == 2) {
    v << twist.linear.x, twist.linear.y, twist.angular.z;
  } else {
    v << twist.linear.x, twist.linear.y, twist.linear.z, twist.angular.x, twist.angular.y, twist.angular.z;
  }
  return v;
}

Twist twist_of(py::handle object, int n, const char* name) {
  const Vector v = as_vector(object, name);
  if (v.size() != (n == 2 ? 3 : 6)) {
    throw DimensionMismatchError(std::string(name) + ": a twist in R^" + std::to_string(n) + " has " +
                                 (n == 2 ? "3" : "6") + " numbers, got " + std::to_string(v.size()));
  }
  if (n == 2) return {{v[0], v[1], 0}, {0, 0, v[2]}};
  return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
}

struct PatchOf {
  ContactPatch patch;
  int n = 3;

  py::array_t<double> points(Vector3 ContactPoint::*member) const {
    py::array_t<double> rows({patch.count, n});
    auto out = rows.mutable_unchecked<2>();
    for (int i = 0; i < patch.count; ++i) {
      const Vector3& x = patch.points[static_cast<std::size_t>(i)].*member;
      for (int k = 0; k < n; ++k) out(i, k) = (&x.x)[k];
    }
    return rows;
  }
  py::array_t<double> gaps() const {
    py::array_t<double> values(patch.count);
    for (int i = 0; i < patch.count; ++i)
      values.mutable_at(i) = patch.points[static_cast<std::size_t>(i)].gap;
    return values;
  }
  py::object normal() const {
    if (patch.normal.x == 0 && patch.normal.y == 0 && patch.normal.z == 0) return py::none();
    return readonly_array(Vector::Map(&patch.normal.x, n));
  }
};

// NOLINTNEXTLINE(readability-function-size): a parameter a keyword of the Python function
PatchOf contact_patch(const SetLike& A1, const SetLike& A2, double margin, double tolerance,
                      const PoseLike& pose_1, const PoseLike& pose_2, const WarmStartLike& warm,
                      double time_limit) {
  const SetPointer first = as_set(A1, "A1");
  const SetPointer second = as_set(A2, "A2");
  const auto first_pose = as_pose(pose_1, first->dimension(), "pose_1");
  const auto second_pose = as_pose(pose_2, second->dimension(), "pose_2");
  WarmStart* const kept = as_warm_start(warm);
  SignalWatch signals;
  ContactPatchSolver solver(options_of("automatic", tolerance, time_limit));
  solver.set_stop(signals.function());
  return signals.run([&] {
    return PatchOf{solver.solve(posed(*first, first_pose), posed(*second, second_pose), margin, kept),
                   first->dimension()};
  });
}

void bind_gradient(py::module_& module) {
  py::class_<PoseGradientOf>(module, "PoseGradient", kPoseGradientDoc)
      .def_property_readonly(
          "kind", [](const PoseGradientOf& g) { return kKinds[static_cast<std::size_t>(g.gradient.kind)]; })
      .def_property_readonly(
          "body_1", [](const PoseGradientOf& g) { return readonly_array(numbers(g.gradient.body_1, g.n)); })
      .def_property_readonly(
          "body_2", [](const PoseGradientOf& g) { return readonly_array(numbers(g.gradient.body_2, g.n)); })
      .def(
          "along",
          [](const PoseGradientOf& g, const ArrayLike& twist_1, const ArrayLike& twist_2) {
            return g.gradient.along(twist_of(twist_1, g.n, "twist_1"), twist_of(twist_2, g.n, "twist_2"));
          },
          kAlongDoc, "twist_1"_a, "twist_2"_a)
      .def("__repr__",
           [](const PoseGradientOf& g) {
             return std::string("PoseGradient('") + kKinds[static_cast<std::size_t>(g.gradient.kind)] + "')";
           })
      .def(
          py::pickle([](const PoseGradientOf& g) { return py::make_tuple(g.n, packed_gradient(g.gradient)); },
                     [](const py::tuple& state) {
                       return PoseGradientOf{unpacked_gradient(state[1]), state[0].cast<int>()};
                     }));
}

}  // namespace

py::tuple packed_gradient(const PoseGradient& gradient) {
  const auto pair = [](const Twist& one, const Twist& two, int number) {
    return py::make_tuple(readonly_array(numbers(one, 3)), readonly_array(numbers(two, 3)), number);
  };
  py::list candidates;
  for (const PoseGradient::Candidate& each : gradient.candidates)
    candidates.append(pair(each.body_1, each.body_2, each.normal));
  return py::make_tuple(pair(gradient.body_1, gradient.body_2, static_cast<int>(gradient.kind)), candidates);
}

PoseGradient unpacked_gradient(const py::object& state) {
  PoseGradient gradient;
  const auto both = state.cast<py::tuple>();
  const auto pair = [](py::handle object) {
    const auto of = py::reinterpret_borrow<py::tuple>(object);
    return PoseGradient::Candidate{twist_of(of[0], 3, "a pickle"), twist_of(of[1], 3, "a pickle"),
                                   of[2].cast<int>()};
  };
  const PoseGradient::Candidate first = pair(both[0]);
  gradient.body_1 = first.body_1;
  gradient.body_2 = first.body_2;
  gradient.kind = static_cast<GradientKind>(first.normal);
  for (const py::handle each : both[1]) gradient.candidates.push_back(pair(each));
  return gradient;
}

void bind_contacts(py::module_& module) {
  bind_gradient(module);
  py::class_<PatchOf>(module, "ContactPatch", kContactPatchDoc)
      .def_property_readonly("points_1", [](const PatchOf& p) { return p.points(&ContactPoint::point_1); })
      .def_property_readonly("points_2", [](const PatchOf& p) { return p.points(&ContactPoint::point_2); })
      .def_property_readonly("gap", &PatchOf::gaps)
      .def_property_readonly("normal", &PatchOf::normal)
      .def_property_readonly("error", [](const PatchOf& p) { return p.patch.error; })
      .def_property_readonly("lower", [](const PatchOf& p) { return p.patch.lower; })
      .def_property_readonly("upper", [](const PatchOf& p) { return p.patch.upper; })
      .def_property_readonly("status", [](const PatchOf& p) { return status_object(p.patch.status); })
      .def("__len__", [](const PatchOf& p) { return p.patch.count; })
      .def("__repr__", [](const PatchOf& p) {
        return "<raygauge.ContactPatch of " + std::to_string(p.patch.count) + " points>";
      });
  module.def("contact_patch", &contact_patch, kContactPatchQueryDoc, "A1"_a, "A2"_a, "margin"_a = 0.0,
             "tolerance"_a = 1e-9, py::kw_only(), "pose_1"_a = py::none(), "pose_2"_a = py::none(),
             "warm"_a = py::none(), "time_limit"_a = std::numeric_limits<double>::infinity());
}

}  // namespace raygauge::python
