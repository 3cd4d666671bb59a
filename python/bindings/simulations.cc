// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>

#include <atomic>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "python/bindings/arrays.h"
#include "python/bindings/bindings.h"
#include "python/bindings/scene_answers.h"
#include "python/bindings/scene_bodies.h"
#include "python/bindings/simulated_columns.h"
#include "raygauge/exceptions.h"

namespace raygauge::python {
namespace {

// NOLINTNEXTLINE(misc-unused-using-decls): clang-tidy 14 sees no use of a literal
using py::literals::operator""_a;

std::optional<double> number_of(const py::dict& given, const char* key) {
  if (!given.contains(key) || given[key].is_none()) return std::nullopt;
  return value_of<double>(given, key);
}

Eigen::Vector3d vector_of(py::handle object, int n, const char* name) {
  Eigen::Vector3d all = Eigen::Vector3d::Zero();
  if (object.is_none()) return all;
  const Vector given = as_vector(object, name);
  if (given.size() != n)
    throw DimensionMismatchError(std::string(name) + ": " + std::to_string(n) + " numbers are needed, got " +
                                 std::to_string(given.size()));
  all.head(n) = given;
  return all;
}

/// A number in the plane; in space three principal moments along the axes, or a matrix.
std::optional<Eigen::Matrix3d> inertia_of(py::handle object, int n) {
  if (object.is_none()) return std::nullopt;
  const auto given = as_doubles(object, "inertia");
  Eigen::Matrix3d J = Eigen::Matrix3d::Zero();
  if (n == 2 && given.size() == 1) {
    J(2, 2) = *given.data();
  } else if (n == 3 && given.size() == 3) {
    J = Eigen::Vector3d::Map(given.data()).asDiagonal();
  } else if (n == 3 && given.ndim() == 2 && given.shape(0) == 3 && given.shape(1) == 3) {
    J = Eigen::Matrix3d::Map(given.data()).transpose();
  } else {
    throw DimensionMismatchError("inertia: a number in the plane, 3 numbers or 3 rows of 3 in space, got " +
                                 described(object));
  }
  return J;
}

BodyDynamics dynamics_of(const py::dict& given, const Body& body) {
  const auto mass = number_of(given, "mass"), density = number_of(given, "density");
  if (!mass && !density) return {};
  const int n = body.dimension();
  const py::object spin = given["spin"];
  BodyDynamics how = reacting_body(body, mass, density, inertia_of(py::object(given["inertia"]), n));
  how.velocity = vector_of(py::object(given["velocity"]), n, "velocity");
  if (n == 2 && !spin.is_none()) how.spin[2] = vector_of(py::make_tuple(spin), 1, "spin")[0];
  if (n == 3) how.spin = vector_of(spin, 3, "spin");
  return how;
}

/// A body that reacts begins where it stands; its rates are its first velocities.
py::dict standing(const py::dict& given) {
  if (!number_of(given, "mass") && !number_of(given, "density")) return given;
  py::dict still = given.attr("copy")();
  for (const char* key : {"velocity", "spin"}) still[key] = py::none();
  return still;
}

ContactLaw law_of(const py::dict& given) {
  return {number_of(given, "friction"), number_of(given, "restitution")};
}

using Groups = std::vector<std::tuple<std::vector<int>, std::vector<int>, py::dict>>;

Dynamics dynamics_of(const Scene& scene, const py::list& bodies, const py::dict& effects) {
  Dynamics dynamics;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    dynamics.bodies.push_back(dynamics_of(bodies[b].cast<py::dict>(), scene.bodies[b]));
  if (const py::object gravity = effects["gravity"]; !gravity.is_none())
    dynamics.gravity = vector_of(gravity, scene.dimension(), "gravity");
  if (const py::object contact = effects["contact"]; !contact.is_none())
    dynamics.contact = law_of(contact.cast<py::dict>());
  if (const py::object damping = effects["damping"]; !damping.is_none()) {
    const auto given = damping.cast<py::dict>();
    dynamics.damping =
        Damping{number_of(given, "linear").value_or(0), number_of(given, "angular").value_or(0)};
  }
  for (const auto& [first, second, law] : effects["pairs"].cast<Groups>())
    dynamics.pairs.push_back({first, second, law_of(law)});
  dynamics.step = value_of<double>(effects, "step");
  dynamics.tolerance = value_of<double>(effects, "tolerance");
  const auto overlap = value_of<std::string>(effects, "overlap_at_start");
  if (overlap != "refuse" && overlap != "resolve")
    throw InvalidParameterError("overlap_at_start must be 'refuse' or 'resolve', got '" + overlap + "'");
  if (overlap == "resolve") dynamics.overlap_at_start = StartOverlap::resolved;
  return dynamics;
}

py::dict simulation(const py::list& bodies, py::handle instants,
                    const std::vector<std::pair<int, int>>& ignored, const py::list& queries,
                    const py::dict& effects, int threads) {
  py::list first;
  for (const py::handle body : bodies) first.append(standing(body.cast<py::dict>()));
  const Scene scene = scene_of(first, instants, ignored, queries);
  return simulated_columns(scene, dynamics_of(scene, bodies, effects), threads);
}

}  // namespace

void bind_simulations(py::module_& module) {
  module.def("simulation", &simulation, "The columns of a simulation; use raygauge.simulate.", "bodies"_a,
             "instants"_a, "ignored"_a, "queries"_a, "effects"_a, "threads"_a);
}

}  // namespace raygauge::python
