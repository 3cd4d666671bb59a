// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/pose_gradients.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/numerics/fused.h"
#include "engine/sets/place_shape.h"
#include "raygauge/sets/half_space.h"

namespace raygauge {
namespace {

constexpr double kTilt = 1e-7;      // faces are parallel to this
constexpr double kParallel = 1e-6;  // ... and edges
constexpr double kNearly = 1 + 1e-10;
constexpr double kBeside = 1e-5;  // of the size: contacts of curved bodies are known to the root of the gap

Vector3 vector_of(const Vector& v) { return spatial(v, static_cast<int>(v.size())); }

// Mostly it is of length 1 already.
Vector3 unit(const Vector3& v) {
  constexpr double kUnitSquare = 0x1p-50;
  const double square = dot(v, v);
  return std::fabs(square - 1) <= kUnitSquare ? v : v * (1 / std::sqrt(square));
}

Vector3 origin_of(const Posed& body) {
  const Pose* pose = body.pose;
  if (pose == nullptr) return {};
  const double* t = pose->translation_data();
  const int n = pose->dimension();
  return {t[0], n > 1 ? t[1] : 0.0, n > 2 ? t[2] : 0.0};
}

}  // namespace

double PoseGradient::along(const Twist& twist_1, const Twist& twist_2) const noexcept {
  if (kind == GradientKind::none || kind == GradientKind::undecided)
    return std::numeric_limits<double>::quiet_NaN();
  if (kind == GradientKind::unique) return dot(body_1, twist_1) + dot(body_2, twist_2);
  double greatest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < candidates.size();) {
    double least = std::numeric_limits<double>::infinity();
    const int normal = candidates[i].normal;
    for (; i < candidates.size() && candidates[i].normal == normal; ++i)
      least = std::min(least, dot(candidates[i].body_1, twist_1) + dot(candidates[i].body_2, twist_2));
    greatest = std::max(greatest, least);
  }
  return greatest;
}

bool PoseGradients::bind() {
  if (pair_ == nullptr) return faces_.bind(*posed_[0], *posed_[1], isa_);
  if (pair_ != faces_.pair()) faces_.bind(*pair_);
  return true;
}

// Whether body i has one point only across n, outward of the first body, in whose frame it is.
bool PoseGradients::is_tower(int i, const Vector3& n, double tilt) const {
  const Vector3 v = i == 0 ? n : pair_->frame().R.transposed_times(-n);
  return raygauge::has_one_top(pair_->shape(i), v, tilt, isa_);
}

// The number of a body with one point only, one without edges first: -1: there is none.
int PoseGradients::top_of(const Vector3& n, double tilt) const {
  for (int i = 0; i < 2; ++i)
    if (is_smooth(pair_->shape(i))) return i;
  Vector3 end[2];
  if (count_highest(pair_->shape(0), n, tilt, end) == 1) return 0;
  if (count_highest(pair_->shape(1), pair_->frame().R.transposed_times(-n), tilt, end) == 1) return 1;
  return is_tower(0, n, tilt) ? 0 : is_tower(1, n, tilt) ? 1 : -1;
}

// Which body it takes less time to look at: kinds begin with the simple ones, and one that a distance ends
// with a vertex of has most likely nothing else there.
bool PoseGradients::is_second_simpler() const {
  const SpatialShape &one = pair_->shape(0), &two = pair_->shape(1);
  if (one.kind != two.kind || end_ == nullptr) return one.kind > two.kind;
  bool has_vertex[2] = {true, true};
  for (int i = 1; i < end_->count; ++i) {
    has_vertex[0] &= end_->point[i].index_1 == end_->point[0].index_1;
    has_vertex[1] &= end_->point[i].index_2 == end_->point[0].index_2;
  }
  return has_vertex[1] && !has_vertex[0];
}

// Of bodies with edges: whether one has one point only in contact, or both have an edge, and these cross:
// then there is one pair of points.
RAYGAUGE_VECTORS bool PoseGradients::has_one_contact(const Vector3& normal) const {
  const SpatialShape &one = pair_->shape(0), &two = pair_->shape(1);
  const Vector3 n = pair_->frame().to_body(&normal.x), m = pair_->frame().R.transposed_times(-n);
  const bool turned = is_second_simpler();
  Vector3 simple[2], other[2];
  const int of_simple = count_highest(turned ? two : one, turned ? m : n, kTilt, simple);
  if (of_simple == 1) return true;
  const int of_other = count_highest(turned ? one : two, turned ? n : m, kTilt, other);
  if (of_other == 1) return true;
  if (of_simple == 2 && of_other == 2) {
    const auto &first = turned ? other : simple, &second = turned ? simple : other;
    const Vector3 end[2] = {pair_->frame().from_second(second[0]), pair_->frame().from_second(second[1])};
    if (are_crossing(n, first, end, kParallel)) return true;
  }
  return is_tower(0, n, kTilt) || is_tower(1, n, kTilt);
}

// Of polytopes, whose facet the portal is then a part of: whether the ray is well within it.
bool PoseGradients::leads_through_portal() const {
  constexpr double kWithin = 1e-5;  // of the sum of the weights
  if (end_ == nullptr || end_->count != 3 || pair_->is_curved()) return false;
  const Vector3 p = pair_->between_centers();
  Vector3 corner[3];
  for (int i = 0; i < 3; ++i) corner[i] = end_->point[i].a1 - end_->point[i].a2 + p;
  const double weight[3] = {dot(cross(corner[1], corner[2]), p), dot(cross(corner[2], corner[0]), p),
                            dot(cross(corner[0], corner[1]), p)};
  const double sum = weight[0] + weight[1] + weight[2];
  return weight[0] > kWithin * sum && weight[1] > kWithin * sum && weight[2] > kWithin * sum && sum > 0;
}

// By how much the normal of a growth distance may be turned: of balls with the radius r, a gap g turns it by
// up to √(2 g/r).
double PoseGradients::tilt_of(const DistanceResult& growth) const {
  constexpr double kMost = 1e-2;
  const double radius = pair_ != nullptr ? pair_->radius() : 0.0;
  if (!(radius > 0)) return kTilt;
  const double gap = (growth.upper - growth.lower) / growth.upper * pair_->size();
  return std::clamp(2 * std::sqrt(2 * gap / radius), kTilt, kMost);
}

// The one point that both bodies, scaled about their centres, have in common across `normal`, where that
// needs no faces: one body has one point there, and the normal is unique, as a surface is round or the ray
// leads through a facet of the difference.
bool PoseGradients::find_single_contact(const Vector3& normal, double sigma, double tilt, Vector3& x) const {
  if (pair_ == nullptr || pair_->dimension() != 3) return false;
  const SpatialShape &one = pair_->shape(0), &two = pair_->shape(1);
  const bool round = one.radius > 0 || two.radius > 0 || is_smooth(one) || is_smooth(two);
  if (!round && !leads_through_portal()) return false;
  const Vector3 n = pair_->frame().to_body(&normal.x);
  const int i = top_of(n, tilt);
  if (i < 0) return false;
  const SpatialShape& shape = pair_->shape(i);
  const Vector3 v = i == 0 ? n : pair_->frame().R.transposed_times(-n);
  const Vector3 top = with_core(shape, [&](const auto& core) {
    const auto view = core.look(v, isa_);
    return view.point(view.index);
  });
  const Vector3 scaled = shape.center + (top + v * shape.radius - shape.center) * sigma;
  pair_->frame().point_to_world(i == 0 ? scaled : pair_->frame().from_second(scaled), &x.x);
  return true;
}

bool PoseGradients::is_half_space(int i) const { return as_half_space(posed_[i]->set) != nullptr; }

// Of a half-space and a body: the points of the body that are the nearest to the plane, or the deepest. What
// is above one of them is on their normal: it turns with the same gradient.
void PoseGradients::add_lowest(const Vector3& by_translation, PoseGradient& gradient) {
  const int body = is_half_space(0) ? 1 : 0;
  const Vector3 n = by_translation * ((body == 0 ? -1 : 1) / length(by_translation));
  gradient.kind = GradientKind::undecided;
  if (!faces_.bind(*posed_[body], *posed_[body], isa_)) return;
  if (faces_.has_one_top(0, n, kTilt)) {
    gradient.kind = GradientKind::unique;
    return;
  }
  faces_.list_top(n, kTilt * faces_.size(), lowest_);
  for (const Vector3& x : lowest_) gradient.candidates.push_back(candidate(by_translation, x, x));
  if (!lowest_.empty()) gradient.kind = GradientKind::one_sided;
}

inline void PoseGradients::put(const Vector3& by_translation, const Vector3& x1, const Vector3& x2,
                               Twist& body_1, Twist& body_2) const {
  const Vector3& n = by_translation;
  body_1 = {n * factor_, cross(x1 - origin_of(*posed_[0]) * factor_, n)};
  body_2 = {-n, -cross(x2 - origin_of(*posed_[1]), n)};
}

PoseGradient::Candidate PoseGradients::candidate(const Vector3& by_translation, const Vector3& x1,
                                                 const Vector3& x2) const {
  Candidate made;
  put(by_translation, x1, x2, made.body_1, made.body_2);
  return made;
}

// All pairs of points that are optimal for one normal, across which the faces are listed.
void PoseGradients::add_candidates(const Vector3& by_translation, int number, PoseGradient& gradient) {
  if (!faces_.find(kTilt * faces_.size(), kParallel)) return;
  for (const FacePair& pair : faces_.face().pairs()) {
    gradient.candidates.push_back(
        candidate(by_translation, faces_.to_world(0, pair.point_1), faces_.to_world(1, pair.point_2)));
    gradient.candidates.back().normal = number;
  }
}

RAYGAUGE_VECTORS void PoseGradients::of_distance(const ObjectDistance& answer, bool by_ball,
                                                 PoseGradient& gradient) {
  gradient.kind = GradientKind::none;
  gradient.candidates.clear();
  const bool apart = answer.distance.lower > 0 && std::isfinite(answer.distance.upper);
  const Vector& normal = apart ? answer.distance.normal : answer.depth.normal;
  const Vector& point_1 = apart ? answer.closest_point_1 : answer.depth.point_1;
  const Vector& point_2 = apart ? answer.closest_point_2 : answer.depth.point_2;
  const bool is_inside = answer.depth.evaluations > 0 && answer.depth.lower > 0;
  const int n = posed_[0]->dimension();
  if ((!apart && !is_inside) || (n != 2 && n != 3) || point_1.size() != n || point_2.size() != n) return;
  const Vector3 by_translation = vector_of(normal);
  put(by_translation, vector_of(point_1), vector_of(point_2), gradient.body_1, gradient.body_2);
  gradient.kind = by_ball ? GradientKind::unique : GradientKind::undecided;
  if (by_ball && pair_ == nullptr && is_half_space(0) != is_half_space(1))
    return add_lowest(by_translation, gradient);
  if (by_ball && pair_ == nullptr && bind()) pair_ = faces_.pair();
  if (!by_ball) return;
  const bool may_be_one = pair_ != nullptr && other_normals_.empty();
  if (may_be_one && (is_smooth(pair_->shape(0)) || is_smooth(pair_->shape(1)))) return;
  if (may_be_one && has_one_contact(-unit(by_translation))) return;
  of_faces(answer, by_translation, gradient);
}

// By all that both bodies have in contact, along the normal and along those that are as near.
void PoseGradients::of_faces(const ObjectDistance& answer, const Vector3& by_translation,
                             PoseGradient& gradient) {
  const Vector3 way = by_translation * (-1 / length(by_translation));
  const bool bound = bind();
  if (bound) faces_.list(way, kTilt * faces_.size());
  if (bound && other_normals_.empty() && faces_.face().are_crossing_segments(kParallel)) return;
  gradient.kind = GradientKind::undecided;
  if (!bound) return;
  add_candidates(by_translation, 0, gradient);
  const std::size_t own = gradient.candidates.size();
  int number = 0;
  const double most =
      (answer.depth.upper + 2 * (answer.depth.upper - answer.depth.lower)) / length(by_translation) * kNearly;
  for (const Vector3& other : other_normals_) {
    if (!(faces_.overlap(-other) <= most)) continue;
    const std::size_t before = gradient.candidates.size();
    faces_.list(-other, kTilt * faces_.size());
    add_candidates(other * length(by_translation), ++number, gradient);
    if (gradient.candidates.size() == before) return;
  }
  if (own == 0) return;
  gradient.kind = gradient.candidates.size() == 1 ? GradientKind::unique : GradientKind::one_sided;
  if (own == 1 && number == 0) gradient.candidates.clear();
}

// Both bodies, scaled, touch along n. True where one pair of points, or more, is known there.
bool PoseGradients::find_contact(const Vector3& n, double tilt) {
  constexpr double kFarBeside = 1e-2;
  const double size = faces_.size();
  faces_.list(n, tilt * size);
  return faces_.find(std::max(tilt, kBeside) * size, kParallel) || faces_.find(kFarBeside * size, kParallel);
}

// Of the last contact: whether no other plane separates the bodies there.
bool PoseGradients::has_one_normal() {
  const CommonFace& face = faces_.face();
  if (face.is_crossing(kTilt * faces_.size())) return true;
  Vector3 tangent[2];
  int smooth[2];
  for (int i = 0; i < 2; ++i) smooth[i] = faces_.smooth_directions(i, tangent[i]);
  if (smooth[0] == 2 || smooth[1] == 2) return true;
  for (int i = 0; i < 2; ++i) {
    if (face.extent(i) == 1) tangent[i] = face.direction(i);
    if (face.extent(i) == 2 || (face.extent(i) == 0 && smooth[i] == 0)) return false;
  }
  return face.pairs_count() == 1 && length(cross(tangent[0], tangent[1])) > kTilt;
}

// With u = -normal, h_B(u) = 1 and σ = max u·p/h_B(u), the common point moves with A1 by v1 and with A2 by
// v2: dσ = u·(v2 - v1).
void PoseGradients::of_growth(const DistanceResult& answer, bool about_origin, PoseGradient& gradient) {
  gradient.kind = GradientKind::none;
  gradient.candidates.clear();
  if (!(answer.lower > 0) || !std::isfinite(answer.upper) || answer.normal.size() == 0) return;
  const double sigma = answer.distance;
  factor_ = about_origin ? sigma : 1.0;
  const Vector3 by_translation = vector_of(answer.normal), n = by_translation * (-1 / length(by_translation));
  const double tilt = tilt_of(answer);
  Vector3 common;
  if (!about_origin && find_single_contact(n, sigma, tilt, common)) {
    const Candidate only = candidate(by_translation, common, common);
    gradient.body_1 = only.body_1;
    gradient.body_2 = only.body_2;
    gradient.kind = GradientKind::unique;
    return;
  }
  if (!bind()) return;
  faces_.scale(about_origin ? BodyScaling::about_origin : BodyScaling::about_centers, sigma);
  if (!find_contact(n, tilt)) return;
  const bool is_smooth = has_one_normal();
  for (const FacePair& pair : faces_.face().pairs()) {
    const Vector3 x = (faces_.to_world(0, pair.point_1) + faces_.to_world(1, pair.point_2)) * 0.5;
    gradient.candidates.push_back(candidate(by_translation, x, x));
  }
  gradient.body_1 = gradient.candidates.front().body_1;
  gradient.body_2 = gradient.candidates.front().body_2;
  gradient.kind = !is_smooth                        ? GradientKind::undecided
                  : gradient.candidates.size() == 1 ? GradientKind::unique
                                                    : GradientKind::one_sided;
  if (gradient.kind != GradientKind::one_sided) gradient.candidates.clear();
}

}  // namespace raygauge
