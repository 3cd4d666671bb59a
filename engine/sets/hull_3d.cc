// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/hull_3d.h"

#ifdef RAYGAUGE_HAS_QHULL
#include <Eigen/Geometry>

#include <libqhullcpp/Qhull.h>
#include <libqhullcpp/QhullError.h>
#include <libqhullcpp/QhullFacetList.h>
#include <libqhullcpp/QhullVertexSet.h>

#include <algorithm>
#include <cmath>
#endif

namespace raygauge {

#ifdef RAYGAUGE_HAS_QHULL
namespace {

// Depth, as a share of the size of the set, from which a point counts as inside: Qhull's planes are good to
// 1e-13.
constexpr double kDeep = 1e-9;

struct Planes {
  Eigen::Matrix3Xd normals;
  Eigen::VectorXd offsets;  // normal·x + offset <= 0 inside
};

Planes planes_of(const orgQhull::Qhull& hull) {
  const auto facets = hull.facetList();
  Planes planes{Eigen::Matrix3Xd(3, facets.count()), Eigen::VectorXd(facets.count())};
  Eigen::Index f = 0;
  for (const auto& facet : facets) {
    const auto plane = facet.hyperplane();
    planes.normals.col(f) = Eigen::Vector3d::Map(plane.coordinates());
    planes.offsets[f++] = plane.offset();
  }
  planes.normals.conservativeResize(3, f);
  planes.offsets.conservativeResize(f);
  return planes;
}

void list_edges(const orgQhull::Qhull& hull, const Eigen::Matrix3Xd& unit, Hull3& out) {
  for (const auto& facet : hull.facetList()) {
    const auto corners = facet.vertices().toStdVector();
    if (corners.size() == 3) {
      const int a = corners[0].point().id(), b = corners[1].point().id(), c = corners[2].point().id();
      const Eigen::Vector3d normal = Eigen::Vector3d::Map(facet.hyperplane().coordinates());
      const Eigen::Vector3d turn = (unit.col(b) - unit.col(a)).cross(unit.col(c) - unit.col(a));
      const bool outward = turn.dot(normal) > 0;
      out.triangles.insert(out.triangles.end(), {a, outward ? b : c, outward ? c : b});
    }
    for (const auto& p : corners) {
      for (const auto& q : corners) {
        if (p != q) out.edges.emplace_back(p.point().id(), q.point().id());
      }
    }
  }
  std::sort(out.edges.begin(), out.edges.end());
  out.edges.erase(std::unique(out.edges.begin(), out.edges.end()), out.edges.end());
}

}  // namespace

bool has_hull_3d() noexcept { return true; }

Hull3 hull_3d(const Eigen::MatrixXd& points, const Eigen::Vector3d& center) {
  Hull3 out;
  const Eigen::Index N = points.cols();
  if (N < 5) return out;
  const double size = (points.colwise() - center).colwise().norm().maxCoeff();
  if (!(size > 0) || !std::isfinite(size)) return out;
  // About the centre and of size 1, where Qhull's absolute tolerances mean something.
  const Eigen::Matrix3Xd unit = (points.colwise() - center) / size;
  try {
    orgQhull::Qhull hull;
    hull.runQhull("", 3, static_cast<int>(N), unit.data(), "Qt Pp");
    const double slack = kDeep + 10 * (hull.qh()->max_outside - hull.qh()->min_vertex);
    const Planes planes = planes_of(hull);
    list_edges(hull, unit, out);
    out.inner_radius = std::max(0.0, (-planes.offsets.maxCoeff() - slack) * size * (1 - 1e-9));
    std::vector<bool> corner(static_cast<std::size_t>(N));
    for (const auto& edge : out.edges) corner[static_cast<std::size_t>(edge.first)] = true;
    for (Eigen::Index i = 0; i < N; ++i) {
      const bool inside = !corner[static_cast<std::size_t>(i)] &&
                          (planes.normals.transpose() * unit.col(i) + planes.offsets).maxCoeff() < -slack;
      if (!inside) out.kept.push_back(i);
    }
    out.found = true;
  } catch (const orgQhull::QhullError&) {
    out = {};
  }
  return out;
}

#else

bool has_hull_3d() noexcept { return false; }

Hull3 hull_3d(const Eigen::MatrixXd&, const Eigen::Vector3d&) { return {}; }

#endif

}  // namespace raygauge
