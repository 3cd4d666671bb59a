// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/contact_finder.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "raygauge/numerics/vector3.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/spatial_shape.h"

namespace raygauge {
namespace {

constexpr double kTilt = 0.02;  // radians from the normal at which the corners of a face are looked for
constexpr double kNearNormal = 1e-6;
constexpr int kDirections = 8;
constexpr double kFlat = 1e-9;  // of its longest side: below it a face is an edge

DistanceOptions options_of_contacts() {
  DistanceOptions options;
  options.method = DistanceMethod::newton;
  return options;
}

Eigen::Vector3d in_space(const Vector& v) {
  Eigen::Vector3d all = Eigen::Vector3d::Zero();
  all.head(v.size()) = v;
  return all;
}

using Corners = std::vector<Eigen::Vector3d>;

double cross2(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return a[0] * b[1] - a[1] * b[0]; }

double size_of(const Corners& face) {
  double size = 0;
  for (const Eigen::Vector3d& p : face) size = std::max(size, (p - face.front()).head<2>().norm());
  return size;
}

double area_of(const Corners& face) {
  double twice = 0;
  for (std::size_t i = 2; i < face.size(); ++i) twice += cross2(face[i - 1] - face[0], face[i] - face[0]);
  return std::fabs(twice) / 2;
}

bool is_polygon(const Corners& face) {
  const double size = size_of(face);
  return face.size() > 2 && area_of(face) > kFlat * size * size;
}

// Heights of a face as a linear function of the place, by least squares about its middle.
class Heights {
 public:
  explicit Heights(const Corners& face) {
    middle_.setZero();
    for (const Eigen::Vector3d& p : face) middle_ += p / static_cast<double>(face.size());
    Eigen::Matrix2d A = Eigen::Matrix2d::Zero();
    Eigen::Vector2d b = Eigen::Vector2d::Zero();
    for (const Eigen::Vector3d& p : face) {
      const Eigen::Vector3d away = p - middle_;
      A += away.head<2>() * away.head<2>().transpose();
      b += away[2] * away.head<2>();
    }
    slope_ = A.completeOrthogonalDecomposition().solve(b);
  }
  double at(const Eigen::Vector3d& p) const { return middle_[2] + slope_.dot((p - middle_).head<2>()); }

 private:
  Eigen::Vector3d middle_;
  Eigen::Vector2d slope_;
};

// Sutherland and Hodgman: what of a polygon, segment or point is inside a polygon, counterclockwise.
Corners clipped(Corners subject, const Corners& window) {
  const double slack = 1e-12 * (size_of(window) + size_of(subject));
  for (std::size_t i = 0; i < window.size() && !subject.empty(); ++i) {
    const Eigen::Vector3d& p = window[i];
    Eigen::Vector3d side = window[(i + 1) % window.size()] - p;
    const double length = side.head<2>().norm();
    if (!(length > slack)) continue;
    side /= length;
    const auto inside = [&](const Eigen::Vector3d& x) { return cross2(side, x - p) + slack; };
    Corners kept;
    for (std::size_t k = 0; k < subject.size(); ++k) {
      const Eigen::Vector3d &a = subject[k], &b = subject[(k + 1) % subject.size()];
      const double in_a = inside(a), in_b = inside(b);
      if (in_a >= 0) kept.push_back(a);
      if ((in_a > 0 && in_b < 0) || (in_a < 0 && in_b > 0))
        kept.push_back(a + in_a / (in_a - in_b) * (b - a));
    }
    subject = kept;
  }
  return subject;
}

// The part of segment a beside segment b, where they run in one direction; else nothing.
Corners beside(const Corners& a, const Corners& b) {
  const Eigen::Vector3d way = a.back() - a.front(), other = b.back() - b.front();
  const double square = way.head<2>().squaredNorm();
  if (!(square > 0) || std::fabs(cross2(way, other)) > 1e-3 * std::sqrt(square) * other.head<2>().norm())
    return {};
  const auto along = [&](const Eigen::Vector3d& p) {
    return way.head<2>().dot((p - a.front()).head<2>()) / square;
  };
  const double from = std::max(0.0, std::min(along(b.front()), along(b.back())));
  const double to = std::min(1.0, std::max(along(b.front()), along(b.back())));
  if (!(from <= to)) return {};
  return {a.front() + from * way, a.front() + to * way};
}

Corners without_doubles(const Corners& corners) {
  const double near = 1e-9 * size_of(corners);
  Corners kept;
  for (const Eigen::Vector3d& p : corners) {
    const bool known = std::any_of(
        kept.begin(), kept.end(), [&](const Eigen::Vector3d& q) { return (p - q).head<2>().norm() <= near; });
    if (!known) kept.push_back(p);
  }
  return kept;
}

Corners common(const Corners& a, const Corners& b) {
  if (a.empty() || b.empty()) return {};
  if (is_polygon(b)) return clipped(a, b);
  if (is_polygon(a)) return clipped(b, a);
  if (a.size() > 1 && b.size() > 1) return beside(a, b);
  return {};
}

}  // namespace

ContactFinder::ContactFinder(int dimension)
    : n_(dimension),
      ball_(std::make_shared<Ball>(Vector::Zero(dimension), 1.0)),
      solver_(options_of_contacts()),
      frame_(Eigen::Matrix3d::Identity()) {}

void ContactFinder::measure(const Posed& a, const Posed& b, const Eigen::Vector3d& previous, WarmStart& warm,
                            PartContact& contact) {
  constexpr ObjectEffects kAll =
      ObjectEffects::closest_points | ObjectEffects::gradient | ObjectEffects::depth;
  const ObjectDistance& found = solver_.solve(a, b, *ball_, kAll, &warm);
  Vector normal = found.gradient_1;
  contact.lower = found.distance.lower;
  contact.overlap = 0;
  Vector point_a = found.closest_point_1, point_b = found.closest_point_2;
  if (found.depth.evaluations > 0 && !(found.distance.lower > 0)) {
    contact.lower = -found.depth.upper;
    contact.overlap = std::max(0.0, found.depth.lower);
    normal = found.depth.normal;
    point_a = found.depth.point_1;
    point_b = found.depth.point_2;
  }
  contact.normal = previous;
  if (normal.size() == n_ && normal.norm() > 0) contact.normal = in_space(normal).normalized();
  witness_ = Eigen::Vector3d::Constant(std::nan(""));
  if (point_a.size() == n_ && point_b.size() == n_) witness_ = (in_space(point_a) + in_space(point_b)) / 2;
}

// The support points in directions about sign × normal: of a smooth face those of directions next to it. Of a
// ball around a core, the points above those of the core.
ContactFinder::Corners ContactFinder::face_of(const Posed& S, double sign) const {
  const Eigen::MatrixXd R = S.pose != nullptr ? S.pose->rotation() : Eigen::MatrixXd::Identity(n_, n_);
  SpatialShape shape;
  const double radius = S.set.spatial_shape_unchecked(shape) ? shape.radius : 0.0;
  const Eigen::Vector3d normal = sign * frame_.row(2).transpose();
  const auto support = [&](double angle, double tilt) {
    const Eigen::Vector3d u =
        normal + tilt * (std::cos(angle) * frame_.row(0) + std::sin(angle) * frame_.row(1)).transpose();
    const Eigen::VectorXd inner = R.transpose() * u.head(n_);
    Eigen::VectorXd point(n_);
    S.set.support_unchecked(inner.data(), point.data());
    Eigen::Vector3d all = Eigen::Vector3d::Zero();
    all.head(n_) = R * point;
    if (S.pose != nullptr) all.head(n_) += Eigen::VectorXd(S.pose->translation());
    return Eigen::Vector3d(frame_ * (all + radius * (normal - u.normalized()) - witness_));
  };
  const int count = n_ == 2 ? 2 : kDirections;
  Corners corners;
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * std::numbers::pi * k / count;
    const Eigen::Vector3d corner = support(angle, kTilt), nearer = support(angle, kTilt / 2);
    const bool smooth = (corner - nearer).norm() > kFlat * (corner.norm() + nearer.norm());
    corners.push_back(smooth ? support(angle, kNearNormal) : corner);
  }
  return without_doubles(corners);
}

void ContactFinder::add_common_face(const Corners& face_a, const Corners& face_b, double band,
                                    PartContact& contact) const {
  const Heights above(face_a), below(face_b);
  for (const Eigen::Vector3d& p : without_doubles(common(face_a, face_b))) {
    const double high = above.at(p), low = below.at(p);
    const double gap = std::max(high - low, contact.lower);
    if (gap > contact.lower + band || contact.points.size() >= kDirections) continue;
    const Eigen::Vector3d middle(p[0], p[1], (high + low) / 2);
    contact.points.push_back({witness_ + frame_.transpose() * middle, gap});
  }
}

void ContactFinder::find(const Posed& a, const Posed& b, double band, const Eigen::Vector3d& previous,
                         WarmStart& warm, PartContact& contact) {
  measure(a, b, previous, warm, contact);
  contact.points.clear();
  if (!witness_.allFinite()) {
    Eigen::VectorXd u = -contact.normal.head(n_), point(n_);
    if (a.pose != nullptr) u = a.pose->rotation().transpose() * u;
    a.set.support_unchecked(u.data(), point.data());
    if (a.pose != nullptr) point = a.pose->rotation() * point + Eigen::VectorXd(a.pose->translation());
    witness_.setZero();
    witness_.head(n_) = point;
  }
  const Eigen::Vector3d& n = contact.normal;
  Eigen::Vector3d tangent(-n[1], n[0], 0);
  if (n_ == 3) {
    const Vector3 some = any_orthogonal(Vector3{n[0], n[1], n[2]});
    tangent = {some.x, some.y, some.z};
  }
  frame_ << tangent.transpose(), n.cross(tangent).transpose(), n.transpose();
  const Corners face_a = face_of(a, -1), face_b = face_of(b, 1);
  add_common_face(face_a, face_b, band, contact);
  // Curved faces have their nearest points between the corners.
  const double rounding = 1e-5 * std::fabs(contact.lower) + 1e-11 * (size_of(face_a) + size_of(face_b));
  const bool has_nearest = std::any_of(contact.points.begin(), contact.points.end(),
                                       [&](const GapPoint& p) { return p.gap <= contact.lower + rounding; });
  if (!has_nearest) contact.points.push_back({witness_, contact.lower});
}

}  // namespace raygauge
