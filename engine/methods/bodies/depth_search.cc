// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/bodies/depth_search.h"

#include <algorithm>
#include <cmath>

#include "engine/methods/spatial/nearest_on_simplex.h"
#include "engine/proof/bounds.h"

namespace raygauge {
namespace {

constexpr double kUp = 1 + 0x1p-50, kDown = 1 - 0x1p-50;
constexpr int kMostIterations = 1 << 15;     // a ring of equal depths to 1e-8 takes fewer
constexpr int kMostSetbacks = 32;            // of the least facet, which never sinks but for rounding
constexpr int kIterationsBetweenLooks = 32;  // at the watch: a pass over many points may take 1 ms

// Of length 1 in about; zero for zero.
template <class Real>
BasicVector3<Real> unit(const BasicVector3<Real>& v) {
  const double size = length_of(v);
  return size > 0 ? v * Real{1 / size} : BasicVector3<Real>{};
}

}  // namespace

template <class Real>
bool DepthSearch<Real>::is_done() const {
  return Bounds(std::max(lower_, goal_.floor) + goal_.ball_lower, upper_ + goal_.ball_upper)
      .close(goal_.tolerance * kDown);
}

// A gap that closes is less than what the bounds of one facet lose.
template <class Real>
bool DepthSearch<Real>::is_lost() const {
  constexpr double kLost = 16;
  return goal_.tolerance * (upper_ + goal_.ball_upper) < kLost * oracle_->error();
}

// The support point for u, whose height may be a better upper bound.
template <class Real>
void DepthSearch<Real>::probe(const Vector& u, DepthPoint<Real>& point) {
  const double height = oracle_->support(u, point);
  const double metric = oracle_->metric_lower(u);
  if (!(metric > 0)) return;
  const double size = length(rounded(u)) * kUp;
  const double upper = std::max((height + oracle_->error() * size) / metric * kUp, 0.0);
  if (upper < upper_) {
    upper_ = upper;
    normal_ = u;
  }
}

// Of the support points for u and -u the one that is farther from the plane through `from`. False if both are
// in that plane: D is flat.
template <class Real>
bool DepthSearch<Real>::farther(const Vector& u, const Vector& from, DepthPoint<Real>& point) {
  DepthPoint<Real> below;
  probe(u, point);
  probe(-u, below);
  const double up = rounded(dot(u, point.s - from)), down = rounded(dot(u, from - below.s));
  if (down > up) point = below;
  return std::max(up, down) > 4 * (InnerPolytope<Real>::noise_of(oracle_->size()) + oracle_->error());
}

// Of three corners and the point that is the farthest from their plane.
template <class Real>
bool DepthSearch<Real>::close_tetrahedron(DepthPoint<Real>* corner) {
  const Vector n = unit(triangle_normal<Real>(corner[0].s, corner[1].s, corner[2].s));
  return farther(n, corner[0].s, corner[3]) && polytope_.begin(corner, oracle_->size());
}

template <class Real>
bool DepthSearch<Real>::begin(const Vector& start, const DepthPoint<Real>* face) {
  DepthPoint<Real> corner[4];
  if (face != nullptr) {
    std::copy_n(face, 3, corner);
    if (close_tetrahedron(corner)) return true;
  }
  const Vector u = unit(start);
  probe(u, corner[0]);
  if (!farther(-u, corner[0].s, corner[1])) return false;
  const Vector edge = unit(corner[1].s - corner[0].s);
  const Vector across = vector_of<Real>(any_orthogonal(rounded(edge)));
  if (!farther(across - edge * (dot(across, edge) / dot(edge, edge)), corner[0].s, corner[2])) return false;
  return close_tetrahedron(corner);
}

template <class Real>
void DepthSearch<Real>::queue_new_facets() {
  for (const std::int32_t i : polytope_.made()) {
    const DepthFacet<Real>& facet = polytope_.facet(i);
    const double certain = facet.offset - oracle_->error() * kUp;
    const double metric = oracle_->metric_upper(facet.n);
    // A direction in which Q does not reach is no obstacle to it.
    const double value = certain > 0 && !(metric > 0) ? std::numeric_limits<double>::infinity()
                         : certain > 0                ? certain / metric * kDown
                                                      : certain;
    heap_.push_back({value, i, facet.stamp});
    std::push_heap(heap_.begin(), heap_.end());
  }
}

template <class Real>
auto DepthSearch<Real>::least() -> const Entry& {
  while (polytope_.facet(heap_.front().facet).stamp != heap_.front().stamp) {
    std::pop_heap(heap_.begin(), heap_.end());
    heap_.pop_back();
  }
  return heap_.front();
}

template <class Real>
DepthEnd DepthSearch<Real>::run(DepthOracle<Real>& oracle, const Vector& start, const Goal& goal,
                                const Stopwatch& watch, const DepthPoint<Real>* face) {
  oracle_ = &oracle;
  goal_ = goal;
  lower_ = -std::numeric_limits<double>::infinity();
  upper_ = std::numeric_limits<double>::infinity();
  iterations_ = 0;
  heap_.clear();
  solid_ = begin(start, face);
  if (!solid_) return is_done() ? DepthEnd::closed : DepthEnd::flat;
  queue_new_facets();
  DepthPoint<Real> point;
  int setbacks = 0;
  for (; iterations_ < kMostIterations; ++iterations_) {
    const Entry& entry = least();
    if (entry.value < lower_) ++setbacks;
    if (entry.value > 0) lower_ = std::max(lower_, entry.value);
    if (is_done()) return DepthEnd::closed;
    if (is_lost() || setbacks > kMostSetbacks) return DepthEnd::rounding;
    if (iterations_ % kIterationsBetweenLooks == kIterationsBetweenLooks - 1 && watch.expired())
      return DepthEnd::time;
    const DepthFacet<Real>& facet = polytope_.facet(entry.facet);
    if (!(dot(rounded(facet.n), rounded(facet.n)) > 0)) return DepthEnd::rounding;
    probe(facet.n, point);
    if (is_done()) return DepthEnd::closed;
    const double above = rounded(polytope_.above(facet, point.s));
    if (!(above > polytope_.noise()) || !polytope_.add(entry.facet, point)) return DepthEnd::rounding;
    queue_new_facets();
  }
  return DepthEnd::limit;
}

namespace {

// The point t u of the triangle by its weights, none of them below 0; how far these had to be moved for that.
double weights_along(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& u, double* weight) {
  const double all[3] = {dot(u, cross(b, c)), dot(u, cross(c, a)), dot(u, cross(a, b))};
  const double sum = all[0] + all[1] + all[2];
  double outside = 0, kept = 0;
  for (int i = 0; i < 3; ++i) {
    weight[i] = std::max(all[i] / sum, 0.0);
    outside = std::max(outside, -all[i] / sum);
    kept += weight[i];
  }
  for (int i = 0; i < 3; ++i) weight[i] /= kept;
  return std::isfinite(outside) && kept > 0 ? outside : std::numeric_limits<double>::infinity();
}

}  // namespace

// Of a convex polytope the ray leaves through the facet whose plane it meets first. A face of D may be
// several triangles in one plane: the one that holds the point.
template <class Real>
bool DepthSearch<Real>::contact(const Vector3& u, Vector3& a1, Vector3& a2) {
  if (!solid_) return false;
  constexpr double kSamePlane = 1 + 1e-9;
  const auto meets = [&](const Entry& entry) {
    const DepthFacet<Real>& facet = polytope_.facet(entry.facet);
    const double reach = rounded(facet.reach), along = dot(rounded(facet.n), u);
    const bool leaves = facet.stamp == entry.stamp && reach > 0 && along > 0;
    return leaves ? reach / along : std::numeric_limits<double>::infinity();
  };
  double first = std::numeric_limits<double>::infinity(), best = first;
  for (const Entry& entry : heap_) first = std::min(first, meets(entry));
  for (const Entry& entry : heap_) {
    if (!(meets(entry) <= first * kSamePlane)) continue;
    const DepthPoint<Real>* p[3];
    for (int i = 0; i < 3; ++i) p[i] = &polytope_.point(polytope_.facet(entry.facet).corner[i]);
    double weight[3];
    const double outside = weights_along(rounded(p[0]->s), rounded(p[1]->s), rounded(p[2]->s), u, weight);
    if (!(outside < best)) continue;
    best = outside;
    contact_ = entry.facet;
    a1 = p[0]->a1 * weight[0] + p[1]->a1 * weight[1] + p[2]->a1 * weight[2];
    a2 = p[0]->a2 * weight[0] + p[1]->a2 * weight[1] + p[2]->a2 * weight[2];
  }
  return best < std::numeric_limits<double>::infinity();
}

template <class Real>
void DepthSearch<Real>::add_near_normals(double relative, double angle, std::vector<Vector3>& normals) const {
  constexpr std::size_t kMost = 64;
  if (!solid_) return;
  const double most = upper_ + relative * (upper_ + goal_.ball_upper), cosine = std::cos(angle);
  const std::size_t first = normals.size();
  const Vector3 own = rounded(normal_) * (1 / length_of(normal_));
  for (const Entry& entry : heap_) {
    const DepthFacet<Real>& facet = polytope_.facet(entry.facet);
    if (facet.stamp != entry.stamp || !(entry.value <= most) || normals.size() >= kMost) continue;
    const Vector3 n = rounded(facet.n) * (1 / length_of(facet.n));
    const auto is_near = [&](const Vector3& other) { return dot(other, n) > cosine; };
    if (is_near(own) ||
        std::any_of(normals.begin() + static_cast<std::ptrdiff_t>(first), normals.end(), is_near))
      continue;
    normals.push_back(n);
  }
}

template class DepthSearch<double>;
template class DepthSearch<DoubleDouble>;

}  // namespace raygauge
