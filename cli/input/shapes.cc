// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/shapes.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "cli/input/height_field.h"
#include "cli/input/mesh_object_file.h"
#include "cli/input/rotation_note.h"
#include "raygauge/exceptions.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/grasp_wrenches.h"
#include "raygauge/sets/half_space.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/p_norm_ball.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/polytopes.h"
#include "raygauge/sets/truncated_cone.h"

namespace raygauge::cli {
namespace {

/// One parameter with the way to read its value.
template <class Read>
struct Typed {
  ShapeParameter parameter;
  Read read;  ///< a member function of ShapeValues
};

template <class Read>
Typed<Read> typed(const char* name, const char* type, const char* description, Read read) {
  return {{name, type, description, {}}, read};
}

auto number(const char* name, const char* description = "") {
  return typed(name, "a number", description, &ShapeValues::number);
}
auto number_or(double usual, const char* name, const char* description) {
  auto one = number(name, description);
  one.parameter.usual = usual;
  return one;
}
auto vector(const char* name, const char* description = "") {
  return typed(name, "a vector", description, &ShapeValues::vector);
}
auto matrix(const char* name, const char* description) {
  return typed(name, "a list of rows", description, &ShapeValues::matrix);
}
auto set(const char* name, const char* description = "") {
  return typed(name, "a set", description, &ShapeValues::set);
}
auto sets(const char* name, const char* description) {
  return typed(name, "a list of sets", description, &ShapeValues::sets);
}
auto file(const char* name, const char* description) {
  return typed(name, "a file name", description, &ShapeValues::file);
}

auto path(const char* name, const char* description) {
  return typed(name, "a file name", description, &ShapeValues::path);
}
auto text(const char* name, const char* description) {
  return typed(name, "a word", description, &ShapeValues::text);
}

/// A shape whose set is `make` of the parameters' values, in their order.
template <class Make, class... Reads>
Shape made_by(Make make, const char* name, const char* description, const Typed<Reads>&... parameters) {
  return {name,
          description,
          {parameters.parameter...},
          [=](const ShapeValues& values) -> std::function<SetPointer()> {
            // Braces: the values are read, and complained about, from left to right.
            const std::tuple read{(values.*parameters.read)(parameters.parameter.name)...};
            return [=] { return std::apply(make, read); };
          }};
}

/// A shape whose set is constructed of the parameters' values, in their order.
template <class Set, class... Reads>
Shape shape(const char* name, const char* description, const Typed<Reads>&... parameters) {
  const auto construct = [](const auto&... values) -> SetPointer {
    return std::make_shared<const Set>(values...);
  };
  return made_by(construct, name, description, parameters...);
}

SetPointer point_set(const Eigen::MatrixXd& rows) { return std::make_shared<PointSet>(rows.transpose()); }

SetPointer zonotope(const Vector& center, const Eigen::MatrixXd& rows) {
  return std::make_shared<Zonotope>(center, rows.transpose());
}

SetPointer rigid_image(const SetPointer& S, const Eigen::MatrixXd& R, const Vector& t) {
  return AffineImage::rigid(S, rotation_with_note("rigid_image.R", R), t);
}

SetPointer itself(const SetPointer& set) { return set; }

Shape named_file() {
  return made_by(
      itself, "file", "what another file holds",
      file("file", "points in any format or a set file; a relative name starts at the folder of this file"));
}

Shape cloud() {
  return made_by(read_cloud, "cloud", "balls about points, with --between",
                 path("file", "points, one a row, in any form that points are read in, or a PCD file"),
                 number("radius", "of the balls"));
}

Shape height_field() {
  return made_by(
      read_height_field, "height_field", "the solid below heights on a regular grid, with --between",
      path("file", "heights, a row of the grid a row, in any form of points, or a grey picture (.pgm)"),
      number("spacing", "of rows and columns"), number_or(1, "unit", "what a height of 1 stands for"),
      number_or(0, "floor", "z of the bottom"));
}

Shape mesh() {
  return made_by(read_mesh_as, "mesh", "the triangles of a file, with --between", path("file", "a mesh"),
                 text("as", "hull, surface, or solid: what they bound too"));
}

}  // namespace

const std::vector<Shape>& shapes() {
  static const std::vector<Shape> kShapes = {
      made_by(point_set, "point_set", "the convex hull of points", matrix("points", "one point a row")),
      named_file(),
      shape<Ball>("ball", "{x : |x - center| <= radius}", vector("center"), number("radius", ">= 0")),
      shape<Ellipsoid>("ellipsoid", "{center + factor z : |z| <= 1}", vector("center"),
                       matrix("factor", "n rows; its columns are the semi-axes where they are orthogonal")),
      shape<PNormBall>("p_norm_ball", "{center + diag(semi_axes) z : ‖z‖_p <= 1}", vector("center"),
                       vector("semi_axes", ">= 0"), number("p", "1 … inf")),
      shape<Box>("box", "{x : lower <= x <= upper}", vector("lower"), vector("upper", ">= lower")),
      shape<Simplex>("simplex", "conv{corner, corner + legs_1 e_1, …, corner + legs_n e_n}", vector("corner"),
                     vector("legs", "of either sign")),
      shape<HPolytope>("h_polytope", "{x : G x <= g}, bounded", matrix("G", "inequalities"), vector("g")),
      shape<HalfSpace>("half_space", "{x : n·x <= b}, unbounded", vector("normal"), number("offset")),
      mesh(),
      cloud(),
      height_field(),
      made_by(zonotope, "zonotope", "{center + Σ t_i g_i : |t_i| <= 1}", vector("center"),
              matrix("generators", "one generator g_i a row")),
      shape<Capsule>("capsule", "the points within radius of the segment from p to q", vector("p"),
                     vector("q"), number("radius", ">= 0")),
      shape<Cylinder>("cylinder", "the cylinder around the segment from p to q", vector("p"),
                      vector("q", "not p"), number("radius", ">= 0")),
      shape<TruncatedCone>("truncated_cone", "the hull of two discs across the axis from base to top",
                           vector("base"), number("base_radius", ">= 0"), vector("top", "not base"),
                           number("top_radius", ">= 0; 0: a cone")),
      shape<ContactWrenches>("contact_wrenches",
                             "the wrenches (f, p x f) of a contact with friction, normal force at most 1",
                             vector("p", "where"), vector("n", "not zero; into the object that is held"),
                             number("mu", ">= 0; coefficient of friction"),
                             number("facets", "0: the exact cone; m >= 3: an inscribed one of m facets")),
      shape<AffineImage>("affine_image", "{M x + t : x in S}", set("S"), matrix("M", "n × n, invertible"),
                         vector("t")),
      made_by(rigid_image, "rigid_image", "{R x + t : x in S}", set("S"),
              matrix("R", "n × n, a rotation, of 6 digits or more"), vector("t")),
      shape<MinkowskiSum>("minkowski_sum", "A + B = {a + b : a in A, b in B}", set("A"), set("B")),
      shape<MinkowskiDifference>("minkowski_difference", "A2 - A1 = {a2 - a1 : a2 in A2, a1 in A1}",
                                 set("A2"), set("A1")),
      shape<UnionHull>("union_hull", "the convex hull of a union", sets("sets", "one or more")),
  };
  return kShapes;
}

const ShapeParameter& Shape::parameter(const std::string& parameter_name) const {
  return *std::find_if(parameters.begin(), parameters.end(),
                       [&](const ShapeParameter& parameter) { return parameter.name == parameter_name; });
}

const Shape& find_shape(const std::string& name, const std::string& place) {
  std::vector<std::string> known;
  for (const Shape& shape : shapes()) {
    if (shape.name == name) return shape;
    known.push_back(shape.name);
  }
  throw UnknownNameError("shape", name, known, place);
}

}  // namespace raygauge::cli
