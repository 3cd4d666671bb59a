// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/cgal_method.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>
#include <CGAL/version.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "baselines/pair_method.h"
#include "baselines/rigid_body.h"

namespace raygauge {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Number = Kernel::FT;
using Point = Kernel::Point_3;
using Way = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Eigen::Vector3d;
using Kind = RigidBody::Kind;

Point exact(const Vector3d& p) { return {p.x(), p.y(), p.z()}; }
Vector3d rounded(const Way& v) {
  return {CGAL::to_double(v.x()), CGAL::to_double(v.y()), CGAL::to_double(v.z())};
}

std::vector<Point> vertices_of(const RigidBody& body) {
  std::vector<Point> vertices;
  for (const Vector3d& p : body.vertices) vertices.push_back(exact(body.frame * p));
  if (body.kind != Kind::box) return vertices;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      for (const double z : {-1.0, 1.0})
        vertices.push_back(exact(body.frame * body.half.cwiseProduct(Vector3d(x, y, z))));
    }
  }
  return vertices;
}

/// A triangle of the boundary of D = A2 - A1: n·x <= offset in D.
struct Facet {
  Kernel::Triangle_3 triangle;
  Way n;
  Number offset;
};

class CgalPair final : public BodyPair {
 public:
  CgalPair(std::vector<Point> first, std::vector<Point> second, const Vector& center_1,
           const Vector& center_2)
      : first_(std::move(first)), second_(std::move(second)), between_(exact(center_2) - exact(center_1)) {}

  PairAnswer answer(Quantity quantity, double /*tolerance*/) override {
    const std::vector<Facet> facets = boundary();
    switch (quantity) {
      case Quantity::growth:
        return {growth(facets)};
      case Quantity::depth:
        return depth(facets);
      default:
        return distance(facets);
    }
  }

 private:
  std::vector<Facet> boundary() const {
    std::vector<Point> differences;
    for (const Point& p : first_) {
      for (const Point& q : second_) differences.push_back(CGAL::ORIGIN + (q - p));
    }
    Mesh hull;
    CGAL::convex_hull_3(differences.begin(), differences.end(), hull);
    std::vector<Facet> facets;
    for (const auto face : hull.faces()) {
      const auto edge = hull.halfedge(face);
      const Kernel::Triangle_3 triangle(hull.point(hull.source(edge)), hull.point(hull.target(edge)),
                                        hull.point(hull.target(hull.next(edge))));
      const Way n = CGAL::cross_product(triangle[1] - triangle[0], triangle[2] - triangle[0]);
      facets.push_back({triangle, n, n * (triangle[0] - CGAL::ORIGIN)});
    }
    return facets;
  }

  /// Of the triangles that the origin is beyond, the nearest; 0 where there is none.
  static PairAnswer distance(const std::vector<Facet>& facets) {
    std::optional<Number> least;
    for (const Facet& facet : facets) {
      if (facet.offset >= 0) continue;
      const Number squared = CGAL::squared_distance(Point(CGAL::ORIGIN), facet.triangle);
      if (!least || squared < *least) least = squared;
    }
    return {least ? std::sqrt(CGAL::to_double(*least)) : 0.0};
  }

  /// min offset/|n|, compared by squares.
  static PairAnswer depth(const std::vector<Facet>& facets) {
    const Facet* nearest = nullptr;
    std::optional<Number> least;
    for (const Facet& facet : facets) {
      if (facet.offset <= 0) return {0.0};
      const Number squared = facet.offset * facet.offset / facet.n.squared_length();
      if (least && squared >= *least) continue;
      least = squared;
      nearest = &facet;
    }
    return {std::sqrt(CGAL::to_double(*least)), -rounded(nearest->n)};
  }

  /// With p from centre to centre, in D: (1 - 1/σ) p is on the boundary of D, so that
  /// σ = max over the facets of -n·p/(offset - n·p).
  double growth(const std::vector<Facet>& facets) const {
    Number most = 0;
    for (const Facet& facet : facets) {
      const Number along = facet.n * between_;
      most = std::max<Number>(most, -along / (facet.offset - along));
    }
    return CGAL::to_double(most);
  }

  std::vector<Point> first_, second_;
  Way between_;
};

}  // namespace

void register_cgal_method(MethodRegistry& registry) {
  PairLibrary library;
  library.name = "cgal";
  library.description =
      "distance, depth, growth and separation of two polytopes of R^3 by CGAL's convex hulls, exactly";
  library.takes = "boxes and hulls that are not flat, of R^3";
  library.quantities = {Quantity::distance, Quantity::depth, Quantity::separated, Quantity::growth};
  library.make = [](const ConvexSet& one, const ConvexSet& two,
                    const Parameters& /*none*/) -> std::unique_ptr<BodyPair> {
    const auto first = RigidBody::of(one), second = RigidBody::of(two);
    const auto takes = [](const auto& body) {
      return body && (body->kind == Kind::box || body->kind == Kind::hull);
    };
    if (!takes(first) || !takes(second)) return nullptr;
    return std::make_unique<CgalPair>(vertices_of(*first), vertices_of(*second), one.center(), two.center());
  };
  registry.add(pair_component(std::move(library)));
}

std::string cgal_library_version() { return CGAL_VERSION_STR; }

}  // namespace raygauge
