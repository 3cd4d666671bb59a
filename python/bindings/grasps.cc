// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "python/bindings/grasps.h"

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "python/bindings/arrays.h"
#include "python/bindings/interrupt.h"
#include "python/bindings/results.h"
#include "python/bindings/solving.h"
#include "raygauge/exceptions.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/grasp_wrenches.h"

namespace raygauge::python {
namespace {

// NOLINTNEXTLINE(misc-unused-using-decls): clang-tidy 14 sees no use of a literal
using py::literals::operator""_a;

constexpr const char* kGraspQualityDoc = R"(How good a grasp is, see grasp_quality.

quality: the least wrench, by the metric, that the contacts cannot resist; float() is the same number.
lower, upper, status: proven bounds. force_closure: True if lower > 0, False if upper is 0, None if that is not proven.
normal: shape (6,), the direction u with h_Q(u) = 1 that proves upper. wrench: shape (6,), that least wrench; both None if unknown.
)";

constexpr const char* kQueryDoc = R"(The grasp quality of Ferrari & Canny, with proven bounds on both sides.

It is the depth of 0 among the wrenches (force, torque about the origin) that contacts with friction can exert on an object.
points, normals: shape (m, 3); normals point into the object. mu: one coefficient of friction, or m.
metric: the unit ball Q of R^6 that measures wrenches; None is |(f, t)| <= 1. Ellipsoid weighs torques otherwise.
forces: 'sum', normal forces sum up to 1, or 'each', each is at most 1. edges: 0 for exact friction cones, or pyramids of 3 and more
edges inside them. tolerance: of the gap, relative.
Raises InvalidParameterError, EmptySetError, DimensionMismatchError or NonFiniteError.

>>> points = np.vstack([np.eye(3), -np.eye(3)])
>>> r = rg.grasp_quality(points, -points, 0.5, tolerance=1e-4)
>>> r.force_closure, bool(r.lower <= 0.5 * np.sqrt(2 / 3) <= r.upper)
(True, True)
>>> round(rg.grasp_quality(points, -points, 0.5, edges=4).quality, 6)
0.288675
)";

struct Quality {
  double lower = 0, upper = 0;
  DistanceStatus status = DistanceStatus::precision_limit;
  Vector normal, wrench;

  std::optional<bool> force_closure() const {
    if (lower > 0) return true;
    return upper == 0 ? std::optional<bool>(false) : std::nullopt;
  }
};

py::object array_or_nothing(const Vector& v) {
  return v.size() > 0 ? py::object(readonly_array(v)) : py::none();
}

std::vector<GraspContact> contacts_of(const ArrayLike& points, const ArrayLike& normals,
                                      const ArrayLike& mu) {
  const Eigen::MatrixXd p = as_matrix(points, "points"), n = as_matrix(normals, "normals");
  if (p.cols() != 3 || n.cols() != 3 || n.rows() != p.rows())
    throw DimensionMismatchError("points and normals must both have the shape (m, 3)");
  const bool one = py::isinstance<py::float_>(mu) || py::isinstance<py::int_>(mu);
  const Vector friction = one ? Vector::Constant(p.rows(), mu.cast<double>()) : as_vector(mu, "mu");
  if (friction.size() != p.rows())
    throw DimensionMismatchError("mu: one number or one of each of the " + std::to_string(p.rows()) +
                                 " contacts, got " + std::to_string(friction.size()));
  std::vector<GraspContact> contacts;
  for (Eigen::Index i = 0; i < p.rows(); ++i) contacts.push_back({p.row(i), n.row(i), friction[i]});
  return contacts;
}

GraspForces forces_of(const std::string& name) {
  if (name != "sum" && name != "each") throw UnknownNameError("bound of forces", name, {"sum", "each"});
  return name == "sum" ? GraspForces::sum : GraspForces::each;
}

// NOLINTNEXTLINE(readability-function-size): a parameter a keyword of the Python function
Quality grasp_quality(const ArrayLike& points, const ArrayLike& normals, const ArrayLike& mu,
                      const py::object& metric, double tolerance, int edges, const std::string& forces,
                      double time_limit) {
  const SetPointer Q =
      metric.is_none() ? std::make_shared<Ball>(Vector::Zero(6), 1.0) : as_set(metric, "metric");
  const GraspWrenches wrenches(contacts_of(points, normals, mu), forces_of(forces), edges);
  SignalWatch signals;
  DepthSolver solver(options_of("automatic", tolerance, time_limit));
  solver.set_stop(signals.function());
  return signals.run([&] {
    const ObjectDepth& depth = solver.solve(wrenches, *Q);
    Quality quality{depth.lower, depth.upper, depth.status, depth.normal, {}};
    if (depth.normal.size() > 0) quality.wrench = depth.upper * Q->support_mapping(depth.normal);
    return quality;
  });
}

std::string text_of(const Quality& quality) {
  return py::str("<raygauge.GraspQuality {:.6g} in [{:.9g}, {:.9g}]>")
      .format(quality.upper, quality.lower, quality.upper);
}

}  // namespace

void bind_grasps(py::module_& module) {
  py::class_<Quality>(module, "GraspQuality", kGraspQualityDoc)
      .def_property_readonly("quality", [](const Quality& q) { return q.upper; })
      .def_property_readonly("lower", [](const Quality& q) { return q.lower; })
      .def_property_readonly("upper", [](const Quality& q) { return q.upper; })
      .def_property_readonly("status", [](const Quality& q) { return status_object(q.status); })
      .def_property_readonly("force_closure",
                             [](const Quality& q) -> py::object {
                               const std::optional<bool> closed = q.force_closure();
                               return closed ? py::object(py::bool_(*closed)) : py::none();
                             })
      .def_property_readonly("normal", [](const Quality& q) { return array_or_nothing(q.normal); })
      .def_property_readonly("wrench", [](const Quality& q) { return array_or_nothing(q.wrench); })
      .def("__float__", [](const Quality& q) { return q.upper; })
      .def("__repr__", &text_of)
      .def(py::pickle(
          [](const Quality& q) {
            return py::make_tuple(q.lower, q.upper, static_cast<int>(q.status), readonly_array(q.normal),
                                  readonly_array(q.wrench));
          },
          [](const py::tuple& state) {
            return Quality{state[0].cast<double>(), state[1].cast<double>(),
                           static_cast<DistanceStatus>(state[2].cast<int>()), as_vector(state[3], "a pickle"),
                           as_vector(state[4], "a pickle")};
          }));
  module.def("grasp_quality", &grasp_quality, kQueryDoc, "points"_a, "normals"_a, "mu"_a,
             "metric"_a = py::none(), "tolerance"_a = 1e-6, py::kw_only(), "edges"_a = 0, "forces"_a = "sum",
             "time_limit"_a = std::numeric_limits<double>::infinity());
}

}  // namespace raygauge::python
