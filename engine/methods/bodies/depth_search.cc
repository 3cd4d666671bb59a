// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/bodies/depth_search.h"

#include <algorithm>
#include <cmath>

#include "engine/methods/bodies/nearness.h"
#include "engine/methods/spatial/triangle_normal.h"
#include "engine/proof/bounds.h"

namespace raygauge {
namespace {

constexpr double kUp = 1 + 0x1p-50, kDown = 1 - 0x1p-50;
constexpr double kUnitUp = 1 + 0x1p-48, kUnitDown = 1 - 0x1p-48;  // for the length of a facet's normal
constexpr int kMostIterations = 1 << 15;     // a ring of equal depths to 1e-8 takes fewer
constexpr int kMostSetbacks = 32;            // of the least facet, which never sinks but for rounding
constexpr int kIterationsBetweenLooks = 32;  // at the watch: a pass over many points may take 1 ms

// Of length 1 in about; zero for zero.
template <class Real>
BasicVector3<Real> unit(const BasicVector3<Real>& v) {
  const double size = length_of(v);
  return size > 0 ? v * Real{1 / size} : BasicVector3<Real>{};
}

// The point t u of the plane of a facet by the weights of its corners; by how much one of them is below 0,
// infinity where they are no numbers.
template <class Real>
double weights_along(const InnerPolytope<Real>& of, std::int32_t i, const Vector3& u, double* weight) {
  Vector3 p[3];
  for (int k = 0; k < 3; ++k) p[k] = rounded(of.point(of.facet(i).corner[k]).s);
  for (int k = 0; k < 3; ++k) weight[k] = dot(u, cross(p[(k + 1) % 3], p[(k + 2) % 3]));
  const double sum = weight[0] + weight[1] + weight[2];
  double outside = 0;
  for (int k = 0; k < 3; ++k) {
    weight[k] /= sum;
    outside = std::max(outside, -weight[k]);
  }
  return std::isfinite(sum) && sum > 0 ? outside : std::numeric_limits<double>::infinity();
}

// Of a convex polytope the ray leaves through the facet whose plane it meets first. A face of D may be
// several triangles in one plane: the one that holds the point.
template <class Real>
std::int32_t find_exit(const InnerPolytope<Real>& of, const Vector3& u) {
  constexpr double kSamePlane = 1 + 1e-9, kInfinite = std::numeric_limits<double>::infinity();
  const auto meets = [&](std::int32_t i) {
    const DepthFacet<Real>& facet = of.facet(i);
    const double reach = rounded(facet.reach), along = dot(rounded(facet.n), u);
    return facet.stamp > 0 && reach > 0 && along > 0 ? reach / along : kInfinite;
  };
  double first = kInfinite, best = kInfinite;
  std::int32_t exit = -1;
  for (std::int32_t i = 0; i < of.facet_count(); ++i) first = std::min(first, meets(i));
  for (std::int32_t i = 0; i < of.facet_count(); ++i) {
    if (!(meets(i) <= first * kSamePlane)) continue;
    double weight[3];
    const double outside = weights_along(of, i, u, weight);
    if (!(outside < best)) continue;
    best = outside;
    exit = i;
  }
  return exit;
}

// Whether D is for certain as thick as that.
template <class Real>
bool is_solid(const DepthOracle<Real>& D, double thickness) {
  return thickness > 4 * (InnerPolytope<Real>::noise_of(D.size()) + D.error());
}

}  // namespace

template <class Real>
bool DepthSearch<Real>::closes(double lower) const {
  return Bounds(std::max(lower, goal_.floor) + goal_.ball_lower, upper_ + goal_.ball_upper)
      .close(goal_.tolerance * kDown, goal_.enough);
}

// A gap that closes is less than what the bounds of one facet lose. A last search goes on until its own is
// not more than that.
template <class Real>
bool DepthSearch<Real>::is_lost() const {
  constexpr double kLost = 16;
  const double least = kLost * oracle_->error();
  return std::max(goal_.tolerance * (upper_ + goal_.ball_upper), goal_.enough) < least &&
         (goal_.is_first || upper_ - lower_ < least);
}

// The support point for u, of length 1 where it is a facet's normal, whose height may be a better upper
// bound.
template <class Real>
void DepthSearch<Real>::probe(const Vector& u, DepthPoint<Real>& point, bool is_unit) {
  const double height = oracle_->support(u, point);
  point.u = rounded(u);
  double upper = (height + oracle_->error() * kUnitUp) * kUnitUp * kUnitUp;
  if (!is_unit || !oracle_->is_euclidean()) {
    const double metric = oracle_->metric_lower(u);
    if (!(metric > 0)) return;
    upper = (height + oracle_->error() * length(rounded(u)) * kUp) / metric * kUp;
  }
  upper = std::max(upper, 0.0);
  if (upper < upper_) {
    upper_ = upper;
    normal_ = u;
  }
}

// The support points for u and -u; which of them is farther from the plane through `from`, below 0 if both
// are in it: D is flat.
template <class Real>
int DepthSearch<Real>::probe_both(const Vector& u, const Vector& from, DepthPoint<Real>* point) {
  probe(u, point[0], false);
  probe(-u, point[1], false);
  const double up = rounded(dot(u, point[0].s - from)), down = rounded(dot(u, from - point[1].s));
  if (!is_solid(*oracle_, std::max(up, down))) return -1;
  return down > up ? 1 : 0;
}

// Of the support points for three directions and their opposites: all six, where the origin is then inside,
// else four.
template <class Real>
bool DepthSearch<Real>::begin(const Vector& start) {
  DepthPoint<Real> corner[6];
  const Vector u = unit(start);
  probe(u, corner[0], false);
  probe(-u, corner[1], false);
  if (!is_solid(*oracle_, rounded(dot(u, corner[0].s - corner[1].s)))) return false;
  const Vector edge = unit(corner[1].s - corner[0].s);
  const Vector across = vector_of<Real>(any_orthogonal(rounded(edge)));
  int far = probe_both(across - edge * (dot(across, edge) / dot(edge, edge)), corner[0].s, corner + 2);
  if (far < 0) return false;
  if (far == 1) std::swap(corner[2], corner[3]);
  const Vector n = unit(triangle_normal<Real>(corner[0].s, corner[1].s, corner[2].s));
  far = probe_both(-n, corner[0].s, corner + 4);
  if (far < 0) return false;
  polytope_.begin_octahedron(corner, oracle_->size());
  if (value_[static_cast<std::size_t>(evaluate_new_facets())] > 0) return true;
  corner[3] = corner[4 + far];
  return polytope_.begin(corner, oracle_->size());
}

// What the plane of a facet proves, rounded down. A direction in which Q does not reach is no obstacle to it.
template <class Real>
double DepthSearch<Real>::value_of(const DepthFacet<Real>& facet) const {
  const double certain = facet.offset - oracle_->error() * kUp;
  if (!(certain > 0)) return certain;
  if (oracle_->is_euclidean()) return certain * kUnitDown * kUnitDown;
  const double metric = oracle_->metric_upper(facet.n);
  return metric > 0 ? certain / metric * kDown : std::numeric_limits<double>::infinity();
}

// A lower bound from which on closes() holds; NaN where none is known. Rounded up.
template <class Real>
double DepthSearch<Real>::closing() const {
  if (closes(0)) return -std::numeric_limits<double>::infinity();
  const double upper = upper_ + goal_.ball_upper;
  const double gap = std::max(upper * goal_.tolerance * kDown, goal_.enough) - upper * 0x1p-50;
  return upper - goal_.ball_lower - gap;
}

// The least of the facets that are new.
template <class Real>
std::int32_t DepthSearch<Real>::evaluate_new_facets() {
  const auto count = static_cast<std::size_t>(polytope_.facet_count());
  if (value_.size() < count) value_.resize(2 * count);
  double least = std::numeric_limits<double>::infinity();
  std::int32_t at = 0;
  for (const std::int32_t i : polytope_.made()) {
    const double value = value_of(polytope_.facet(i));
    value_[static_cast<std::size_t>(i)] = value;
    at = value < least ? i : at;
    least = std::min(value, least);
  }
  return at;
}

// Whether a facet closes the gap, by its plane or by a cap.
template <class Real>
bool DepthSearch<Real>::settles(std::int32_t i, double enough) {
  double& value = value_[static_cast<std::size_t>(i)];
  if (!(value >= enough) && !caps_.cover(rounded(polytope_.facet(i).n), value)) return false;
  settled_ = std::min(settled_, value);
  return true;
}

template <class Real>
void DepthSearch<Real>::open_new_facets() {
  const double enough = closing();
  open_.resize(polytope_.facet_count());
  for (const std::int32_t i : polytope_.made()) {
    if (settles(i, enough)) continue;
    const double value = value_[static_cast<std::size_t>(i)];
    open_.open(i, value);
    least_ = value < least_.value ? OpenFacets::Least{value, i} : least_;
  }
}

// After a better upper bound, or a new cap.
template <class Real>
void DepthSearch<Real>::reopen_facets() {
  const double enough = closing();
  least_ = {};
  for (std::int32_t i = 0; i < polytope_.facet_count(); ++i) {
    if (polytope_.facet(i).stamp == 0) continue;
    if (settles(i, enough)) {
      open_.close(i);
    } else if (const double value = value_[static_cast<std::size_t>(i)]; value < least_.value) {
      least_ = {value, i};
    }
  }
}

// The face that the pieces under the corners of the least facet have in common, if it proves what the bound
// needs beside that facet. False where it has to be expanded all the same.
template <class Real>
bool DepthSearch<Real>::find_cap(std::int32_t least, const DepthPoint<Real>& found) {
  // Shares of the upper bound: of a facet that is lower, or in whose direction D is higher, the face is
  // mostly another one.
  constexpr double kNear = 0.95, kSame = 0.999;
  if constexpr (kIsDouble<Real>) {
    if (!oracle_->follows() || least_.value < kNear * upper_) return false;
    const DepthFacet<Real>& facet = polytope_.facet(least);
    if (dot(facet.n, found.s) * kSame > upper_ || caps_.hold(facet.n)) return false;
    const DepthPoint<Real>* corner[3];
    for (int k = 0; k < 3; ++k) corner[k] = &polytope_.point(facet.corner[k]);
    const bool is_flat = share_a_face(corner, found);
    if (!is_flat && (bent_trials_ == 0 || !share_a_bend(corner, found))) return false;
    ProvenCap cap;
    if (is_flat && !cap.find(corner, facet.n, upper_, goal_.tolerance, *oracle_)) return false;
    if (!is_flat && bent_trials_-- > 0 && !cap.find_bent(corner, facet.n, upper_, goal_.tolerance, *oracle_))
      return false;
    DepthPoint<Real> point;
    probe(cap.normal(), point, true);
    if (!(cap.height() >= closing())) return false;
    caps_.add(cap);
    reopen_facets();
    return least_.facet != least;
  } else {
    return false;
  }
}

// Its direction as a bound, and its cap.
template <class Real>
void DepthSearch<Real>::take_likely_face() {
  if constexpr (kIsDouble<Real>) {
    DepthPoint<double> corner[4], point;
    Vector3 n;
    if (!oracle_->likely_face(corner, n)) return;
    probe(n, point, false);
    ProvenCap cap;
    if (cap.take_face(corner, n, *oracle_) && cap.height() >= closing()) caps_.add(cap);
  }
}

template <class Real>
void DepthSearch<Real>::restart(DepthOracle<Real>& oracle, const Goal& goal) {
  oracle_ = &oracle;
  goal_ = goal;
  lower_ = -std::numeric_limits<double>::infinity();
  upper_ = std::numeric_limits<double>::infinity();
  iterations_ = near_ = 0;
  bent_trials_ = 3;
  open_.clear();
  caps_.clear();
  least_ = {};
  settled_ = std::numeric_limits<double>::infinity();
}

template <class Real>
DepthEnd DepthSearch<Real>::run(DepthOracle<Real>& oracle, const Vector& start, const Goal& goal,
                                const Stopwatch& watch) {
  restart(oracle, goal);
  solid_ = begin(start);
  if (!solid_) return closes(lower_) ? DepthEnd::closed : DepthEnd::flat;
  take_likely_face();
  evaluate_new_facets();
  open_new_facets();
  return expand(watch);
}

// The way out is looked for along the least facet first, so that few of the others are queued.
template <class Real>
bool DepthSearch<Real>::run_again(DepthOracle<Real>& oracle, const DepthMemory& memory, const Goal& goal,
                                  const Stopwatch& watch) {
  restart(oracle, goal);
  polytope_.begin(memory, oracle.size(),
                  [&oracle](const DepthMemory::Corner& corner, DepthPoint<Real>& point) {
                    oracle.support_again(corner, point);
                  });
  const std::int32_t least = evaluate_new_facets();
  near_ = least;
  solid_ = value_[static_cast<std::size_t>(least)] > 0;
  if (!solid_) return false;
  DepthPoint<Real> point;
  probe(polytope_.facet(least).n, point, true);
  take_likely_face();
  open_new_facets();
  return expand(watch) == DepthEnd::closed;
}

template <class Real>
DepthEnd DepthSearch<Real>::expand(const Stopwatch& watch) {
  DepthPoint<Real> point;
  int setbacks = 0;
  for (; iterations_ < kMostIterations; ++iterations_) {
    const std::int32_t least = least_.facet;
    const bool has_least = least != OpenFacets::kNone;
    const double value = std::min(least_.value, settled_);
    if (has_least) near_ = least;
    if (value < lower_) ++setbacks;
    if (value > 0) lower_ = std::max(lower_, value);
    if (closes(lower_)) return DepthEnd::closed;
    if (!has_least || is_lost() || setbacks > kMostSetbacks) return DepthEnd::rounding;
    if (iterations_ % kIterationsBetweenLooks == kIterationsBetweenLooks - 1 && watch.expired())
      return DepthEnd::time;
    const DepthFacet<Real>& facet = polytope_.facet(least);
    if (!(dot(rounded(facet.n), rounded(facet.n)) > 0)) return DepthEnd::rounding;
    probe(facet.n, point, true);
    if (closes(lower_)) return DepthEnd::closed;
    if (find_cap(least, point)) continue;
    const double above = rounded(polytope_.above(facet, point.s));
    if (!(above > polytope_.noise()) || !polytope_.look(least, point)) return DepthEnd::rounding;
    for (const std::int32_t i : polytope_.seen()) open_.close(i);
    least_ = open_.least();  // of those that stay, while the new ones are measured
    polytope_.add(point);
    evaluate_new_facets();
    open_new_facets();
  }
  return DepthEnd::limit;
}

// From one facet to the next on the side of the ray, which is not far from where the search has ended.
template <class Real>
std::int32_t DepthSearch<Real>::walk_to_exit(const Vector3& u) const {
  constexpr int kMostSteps = 16;  // rounding may lead around in a circle
  std::int32_t at = polytope_.facet(near_).stamp > 0 ? near_ : polytope_.made().front();
  for (int step = 0; step < kMostSteps; ++step) {
    double weight[3];
    if (!(weights_along(polytope_, at, u, weight) < std::numeric_limits<double>::infinity())) return -1;
    const auto least = std::min_element(weight, weight + 3);
    if (!(*least < 0)) return at;
    at = facet_at(polytope_.facet(at).beyond[(least - weight + 1) % 3]);
  }
  return -1;
}

template <class Real>
bool DepthSearch<Real>::contact(const Vector3& u, Vector3& a1, Vector3& a2) const {
  if (!solid_) return false;
  if (caps_.contact(u, goal_.tolerance, a1, a2)) return true;
  std::int32_t exit = walk_to_exit(u);
  if (exit < 0) exit = find_exit(polytope_, u);
  if (exit < 0) return false;
  double weight[3], sum = 0;
  weights_along(polytope_, exit, u, weight);
  for (double& each : weight) sum += each = std::max(each, 0.0);
  if (!(sum > 0)) return false;
  a1 = a2 = {};
  for (int k = 0; k < 3; ++k) {
    const DepthPoint<Real>& p = polytope_.point(polytope_.facet(exit).corner[k]);
    a1 = a1 + p.a1 * (weight[k] / sum);
    a2 = a2 + p.a2 * (weight[k] / sum);
  }
  return true;
}

template <class Real>
void DepthSearch<Real>::add_near_normals(double relative, double angle, std::vector<Vector3>& normals) const {
  constexpr std::size_t kMost = 64;
  if (!solid_) return;
  const double most = upper_ + relative * (upper_ + goal_.ball_upper);
  const Nearness near(angle);
  const std::size_t first = normals.size();
  const Vector3 own = rounded(normal_) * (1 / length_of(normal_));
  const auto add = [&](const Vector3& n) {
    const auto is_near = [&](const Vector3& other) { return near(other, n); };
    if (normals.size() < kMost && !is_near(own) &&
        std::none_of(normals.begin() + static_cast<std::ptrdiff_t>(first), normals.end(), is_near))
      normals.push_back(n);
  };
  for (const ProvenCap& cap : caps_.all())
    if (cap.height() <= most) add(cap.normal());
  for (std::int32_t i = 0; i < polytope_.facet_count(); ++i) {
    const DepthFacet<Real>& facet = polytope_.facet(i);
    const bool is_covered = caps_.hold(rounded(facet.n));
    if (facet.stamp == 0 || is_covered || !(value_[static_cast<std::size_t>(i)] <= most)) continue;
    add(rounded(facet.n) * (1 / length_of(facet.n)));
  }
}

template class DepthSearch<double>;
template class DepthSearch<DoubleDouble>;

}  // namespace raygauge
