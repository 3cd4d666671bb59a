// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/body_faces.h"

#include <algorithm>
#include <cmath>

namespace raygauge {
namespace {

constexpr double kUp = 1 + 0x1p-50;
constexpr double kShareOfBall = 0.2;  // of a ball inside: a margin that reaches no farther sees one side

}  // namespace

bool BodyFaces::bind(const Posed& A1, const Posed& A2, InstructionSet isa) {
  dimension_ = A1.dimension();
  if ((dimension_ != 2 && dimension_ != 3) || A2.dimension() != dimension_) return false;
  factor_ = 1;
  has_shapes_ = pair_.bind(A1.set, A2.set, isa);
  if (!has_shapes_) return bind_views(A1, A2);
  if (!pair_.place(PoseNumbers(A1.pose), PoseNumbers(A2.pose))) return false;
  take_pair();
  return true;
}

void BodyFaces::bind(const SpatialPair& pair) {
  dimension_ = pair.dimension();
  factor_ = 1;
  has_shapes_ = true;
  pair_ = pair;
  take_pair();
}

void BodyFaces::take_pair() {
  for (int i = 0; i < 2; ++i) radius_[i] = pair_.shape(i).radius;
  noise_ = 2 * pair_.error();
  size_ = pair_.size();
}

bool BodyFaces::bind_views(const Posed& A1, const Posed& A2) {
  view_[0].emplace(A1);
  view_[1].emplace(A2);
  double sum = 0, far = 0;
  for (int i = 0; i < 2; ++i) {
    const ConvexSet& set = view_[i]->set();
    double magnitude[3] = {0, 0, 0};
    set.magnitude_unchecked(magnitude);
    for (const double each : magnitude) sum += each;
    radius_[i] = width_[i] = 0;
    Vector3 point;
    for (int k = 0; k < dimension_; ++k) {
      Vector3 u;
      (&u.x)[k] = 1;
      const double top = height(i, u, point), bottom = -height(i, -u, point);
      width_[i] += top - bottom;
      far = std::max(far, std::max(std::fabs(top), std::fabs(bottom)));
    }
  }
  noise_ = 4 * ConvexSet::rounding_error(dimension_ + 1) * sum;
  size_ = 2 * dimension_ * far;
  return size_ < 1 / noise_ && noise_ < 1;
}

void BodyFaces::scale(BodyScaling scaling, double factor) {
  factor_ = scaling == BodyScaling::none ? 1.0 : factor;
  if (has_shapes_) {
    Vector3 w;
    pair_.frame().point_to_world({}, &w.x);
    about_[0] = scaling == BodyScaling::about_origin ? -pair_.frame().to_body(&w.x) : pair_.shape(0).center;
    about_[1] = pair_.frame().from_second(pair_.shape(1).center);
    return;
  }
  about_[0] = about_[1] = {};
  if (scaling != BodyScaling::about_origin) view_[0]->set().center_unchecked(&about_[0].x);
  view_[1]->set().center_unchecked(&about_[1].x);
}

// The outward direction as body i sees it, in its own frame.
Vector3 BodyFaces::into(int i, const Vector3& outward) const {
  return i == 0 || !has_shapes_ ? outward : pair_.frame().R.transposed_times(outward);
}

double BodyFaces::height(int i, const Vector3& u, Vector3& point) const {
  if (has_shapes_) {
    const Vector3 v = into(i, u);
    const double h = with_core(pair_.shape(i), [&](const auto& core) {
      const auto view = core.look(v, pair_.instruction_set());
      return view.height(view.index);
    });
    return i == 0 ? h : h + dot(u, pair_.frame().from_second({}));
  }
  point = {};
  return view_[i]->set().support_unchecked(&u.x, &point.x);
}

void BodyFaces::add(int i, const Vector3& x) {
  face_.add(i, factor_ == 1 ? x : about_[i] + (x - about_[i]) * factor_);
}

void BodyFaces::list_face(int i, double margin) {
  const SpatialShape& shape = pair_.shape(i);
  double room = margin;
  if (!is_between_ends(shape) && shape.inner_radius > shape.radius)
    room = std::min(room, kShareOfBall * (shape.inner_radius - shape.radius));
  with_core(shape, [&](const auto& core) {
    core.face(into(i, i == 0 ? normal_ : -normal_), room + noise_, pair_.instruction_set(),
              [&](const Vector3& x) { add(i, i == 0 ? x : pair_.frame().from_second(x)); });
  });
}

// Corners of the face are the highest points along directions that are tilted in its plane. One that is
// tilted by δ has a point that is no more than δ times the width below.
void BodyFaces::sample(int i, double margin) {
  const Vector3 v = i == 0 ? normal_ : -normal_;
  Vector3 e = dimension_ == 3 ? any_orthogonal(v) : Vector3{-v.y, v.x, 0}, top, x;
  const Vector3 f = dimension_ == 3 ? cross(v, e) : -e;
  const double least = height(i, v, top) - margin - noise_, tilt = margin / width_[i];
  add(i, top);
  double spread = 0;
  const int count = dimension_ == 3 ? kSamples : 2;
  const auto tilted = [&](int k) {
    const double angle = 6.283185307179586476925 * k / count;
    return v + (e * std::cos(angle) + f * (dimension_ == 3 ? std::sin(angle) : 0.0)) * tilt;
  };
  for (int k = 0; width_[i] > 0 && k < count; ++k) {
    height(i, tilted(k), x);
    spread = std::max(spread, length(x - top));
  }
  for (int k = 0; spread > 2 * margin && k < count; ++k) {
    height(i, tilted(k), x);
    if (!(dot(v, x) < least)) add(i, x);
  }
}

void BodyFaces::list(const Vector3& normal, double margin) {
  constexpr double kLeastMargin = 1e-7;  // of the width: what a normal may be off by
  normal_ = has_shapes_ ? pair_.frame().to_body(&normal.x) : normal;
  face_.begin(normal_);
  for (int i = 0; i < 2; ++i) {
    if (has_shapes_) {
      list_face(i, margin);
    } else {
      sample(i, std::max(margin, kLeastMargin * width_[i]));
    }
  }
}

Vector3 BodyFaces::to_world(int i, const Vector3& point) const {
  if (!has_shapes_) return point;
  Vector3 world;
  pair_.frame().point_to_world(point + face_.normal(i) * (radius_[i] * factor_), &world.x);
  if (dimension_ == 2) world.z = 0;
  return world;
}

double BodyFaces::ball_gap() const {
  return factor_ * (radius_[0] * dot(face_.normal(0), normal_) - radius_[1] * dot(face_.normal(1), normal_));
}

// The support plane across the face's own normal m is above all of the body: a point of height t along m is
// within h(m) - t of the surface. A lifted one is within the spread of the heights of a point of the face.
double BodyFaces::error() const {
  double most = 0;
  Vector3 point;
  for (int i = 0; i < 2; ++i) {
    const double above = height(i, face_.normal(i), point) - face_.least_height(i);
    most = std::max(most, std::max(above, 0.0) / face_.slope(i));
  }
  return (most + 4 * noise_ + face_.offset()) * kUp;
}

double BodyFaces::overlap(const Vector3& normal) const {
  const Vector3 n = has_shapes_ ? pair_.frame().to_body(&normal.x) : normal;
  Vector3 point;
  return height(0, n, point) + height(1, -n, point) + (radius_[0] + radius_[1]) * length(n);
}

void BodyFaces::list_top(const Vector3& normal, double margin, std::vector<Vector3>& points) const {
  points.clear();
  if (!has_shapes_) return;
  const Vector3 v = pair_.frame().to_body(&normal.x);
  with_core(pair_.shape(0), [&](const auto& core) {
    core.face(v, margin + noise_, pair_.instruction_set(), [&](const Vector3& x) {
      Vector3 world;
      pair_.frame().point_to_world(x + v * radius_[0], &world.x);
      if (dimension_ == 2) world.z = 0;
      points.push_back(world);
    });
  });
}

bool BodyFaces::has_one_top(int i, const Vector3& normal, double tilt) const {
  if (!has_shapes_) return false;
  const Vector3 v = pair_.frame().to_body(&normal.x);
  return raygauge::has_one_top(pair_.shape(i), into(i, i == 0 ? v : -v), tilt, pair_.instruction_set());
}

int BodyFaces::smooth_directions(int i, Vector3& direction) const {
  if (!has_shapes_) return 0;
  const SpatialShape& shape = pair_.shape(i);
  if (is_curved(shape) && face_.is_inside_segment(i, noise_)) return 2;  // between the rims
  if (shape.radius > 0 || has_curved_surface(shape)) return 2;
  return with_core(shape, [&](const auto& core) {
    if constexpr (requires { core.radius_of(0); }) {
      const Vector3 v = into(i, i == 0 ? normal_ : -normal_);
      const auto view = core.look(v, pair_.instruction_set());
      const Vector3 tangent = cross(shape.axis.column[0], view.across.w);
      direction = i == 0 ? tangent : pair_.frame().R * tangent;
      return core.radius_of(view.index) > 0 && dot(tangent, tangent) > 0 ? 1 : 0;
    }
    return 0;
  });
}

}  // namespace raygauge
