// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <iterator>
#include <limits>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "tests/baselines/point_set_instances.h"

namespace raygauge::testing {

/// An instance with its distance known on paper. All data are dyadic, so that the distance is exact.
struct ClosedForm {
  std::string name;
  Instance sets;
  double distance;
};

inline void PrintTo(const ClosedForm& form, std::ostream* out) { *out << form.name; }

inline constexpr double kInf = std::numeric_limits<double>::infinity();

/// (2, -1/2, 3/4, 2, -1/2, …) of R^n.
inline Vector dyadic_point(Eigen::Index n) {
  Vector p(n);
  for (Eigen::Index k = 0; k < n; ++k) p[k] = std::vector<double>{2, -0.5, 0.75}[static_cast<size_t>(k % 3)];
  return p;
}

/// A point p against cube, cross-polytope and simplex: ‖p‖∞, ‖p‖₁, Σp + (n+1)·max(0, -min p).
inline std::vector<ClosedForm> point_against_polytopes(Eigen::Index n) {
  const Vector p = dyadic_point(n), zero = Vector::Zero(n);
  const std::string in = "R" + std::to_string(n);
  const auto size = static_cast<double>(n);
  return {
      {"PointAgainstCube" + in, instance(p, cube(zero)), p.cwiseAbs().maxCoeff()},
      {"PointAgainstCrossPolytope" + in, instance(p, cross_polytope(zero)), p.cwiseAbs().sum()},
      {"PointAgainstSimplex" + in, instance(p, corner_simplex(n)),
       p.sum() + (size + 1) * std::max(0.0, -p.minCoeff())},
  };
}

/// Boxes, cross-polytopes and simplices against each other: thousands of ties, optima that are not unique.
inline std::vector<ClosedForm> bodies_against_polytopes(Eigen::Index n) {
  const Vector c = 2 * dyadic_point(n), zero = Vector::Zero(n);
  const std::string in = "R" + std::to_string(n);
  const Vector outside = (c.cwiseAbs() - Vector::Constant(n, 0.25)).cwiseMax(0);
  // Σ(|c_i| - t)₊ = r at t = 7/2: every |c_i| = 4 gives 1/2, the others nothing.
  const double r = 0.5 * static_cast<double>((c.cwiseAbs().array() == 4).count());
  return {
      {"BoxAgainstCrossPolytope" + in, instance(cube(c, 0.25), cross_polytope(zero)), outside.sum()},
      {"BoxAgainstCube" + in, instance(cube(c, 0.25), cube(zero)), outside.maxCoeff()},
      {"CrossPolytopeAgainstCube" + in, instance(cross_polytope(c, r), cube(zero)), 3.5},
      {"AxesAgainstCrossPolytope" + in, instance(3 * Matrix::Identity(n, n), cross_polytope(zero)), 3},
      {"AxesAgainstCube" + in, instance(3 * Matrix::Identity(n, n), cube(zero)), 3 / static_cast<double>(n)},
  };
}

/// 0 in A: in its interior, on a face, at a vertex.
inline std::vector<ClosedForm> origin_in_A(Eigen::Index n) {
  const Vector one = Vector::Ones(n), zero = Vector::Zero(n);
  const std::string in = "R" + std::to_string(n);
  return {
      {"OriginInsideA" + in, instance(cube(zero, 2), cross_polytope(zero)), 0},
      {"OriginOnFaceOfA" + in, instance(cube(Vector::Unit(n, 0)), cross_polytope(zero)), 0},
      {"OriginAtVertexOfA" + in, instance(cube(one), cross_polytope(zero)), 0},
  };
}

/// Q with 0 on its boundary, or flat: finite and infinite distances side by side.
inline std::vector<ClosedForm> degenerate_gauges() {
  const Matrix half = points({{0, 1}, {0, -1}, {2, 0}});
  Matrix flat(3, 4);
  flat << cube(Vector::Zero(2)), Eigen::RowVectorXd::Zero(4);
  return {
      {"OriginOnBoundaryOfQ", instance(points({{3, 1}}), half), 2.5},
      {"FlatQCrossedByA", instance(points({{4, 0, -1}, {4, 0, 1}}), flat), 4},
      {"BehindTheBoundaryOfQ", instance(points({{-1, 0.5}}), half), kInf},
      {"OffThePlaneOfFlatQ", instance(points({{1, 0, 1}}), flat), kInf},
  };
}

/// What floating-point tolerances get wrong: a face of A at distance δ, A barely out of reach.
inline std::vector<ClosedForm> below_tolerances() {
  std::vector<ClosedForm> forms;
  for (const double delta : {1e-3, 1e-8, 1e-20, 1e-300}) {
    Matrix face = cube(Vector::Zero(3));
    face.row(0).setConstant(delta);
    forms.push_back({"FaceAtDistance", instance(face, cube(Vector::Zero(3))), delta});
  }
  const Matrix half = points({{0, 1}, {0, -1}, {2, 0}});
  forms.push_back({"BarelyBehindTheBoundaryOfQ", instance(points({{-1e-9, 0.5}}), half), kInf});
  Matrix flat(3, 4);
  flat << cube(Vector::Zero(2)), Eigen::RowVectorXd::Zero(4);
  forms.push_back({"BarelyOffThePlaneOfFlatQ", instance(points({{1, 0, 1e-9}}), flat), kInf});
  return forms;
}

/// Every family a floating-point simplex can be held to.
inline std::vector<ClosedForm> well_scaled_forms() {
  std::vector<ClosedForm> forms = degenerate_gauges();
  const auto append = [&](std::vector<ClosedForm> more) {
    std::move(more.begin(), more.end(), std::back_inserter(forms));
  };
  for (const Eigen::Index n : {1, 2, 3, 6, 9}) {
    append(point_against_polytopes(n));
    append(bodies_against_polytopes(n));
    append(origin_in_A(n));
  }
  return forms;
}

}  // namespace raygauge::testing
