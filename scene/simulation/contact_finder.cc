// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/contact_finder.h"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <utility>

#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/half_space.h"

namespace raygauge {
namespace {

constexpr double kRounding = 10;  // times the proven error of a point
constexpr double kNarrower = 8;   // a band whose patch leans away from the bodies
constexpr int kMostNarrowings = 8;

Eigen::Vector3d in_space(const Vector3& v) { return {v.x, v.y, v.z}; }

// The support point along u.
Eigen::Vector3d support_point(const Posed& S, const Eigen::Vector3d& u) {
  const int n = S.dimension();
  Eigen::VectorXd along = u.head(n), point(n);
  if (S.pose != nullptr) along = S.pose->rotation().transpose() * along;
  S.set.support_unchecked(along.data(), point.data());
  if (S.pose != nullptr) point = S.pose->rotation() * point + Eigen::VectorXd(S.pose->translation());
  Eigen::Vector3d all = Eigen::Vector3d::Zero();
  all.head(n) = point;
  return all;
}

// Gaps of points on two faces are linear in the place. What they miss of that by rounding would tell the
// contact problem which of four feet carries nothing.
void straighten(const Eigen::Vector3d& normal, double rounding, std::vector<GapPoint>& points) {
  if (points.size() < 3) return;
  const auto count = static_cast<Eigen::Index>(points.size());
  Eigen::MatrixXd places(count, 4);
  Eigen::VectorXd gaps(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const GapPoint& point = points[static_cast<std::size_t>(k)];
    const Eigen::Vector3d from = point.at - points.front().at;
    places.row(k) << 1, (from - normal.dot(from) * normal).transpose();
    gaps[k] = point.gap;
  }
  const Eigen::VectorXd linear = places * places.completeOrthogonalDecomposition().solve(gaps);
  if (!((linear - gaps).lpNorm<Eigen::Infinity>() <= rounding)) return;
  for (Eigen::Index k = 0; k < count; ++k) points[static_cast<std::size_t>(k)].gap = linear[k];
}

// Onto one plane across the normal, between the bodies still. Points of one pair at different heights would
// ask for a turn by their gaps and for no slip, which no rigid body does to both: impulses along the line
// between them would grow to the rim of their cones.
void flatten(const Eigen::Vector3d& normal, std::vector<GapPoint>& points) {
  double height = 0;
  for (const GapPoint& point : points) height += normal.dot(point.at) / static_cast<double>(points.size());
  for (GapPoint& point : points) point.at += (height - normal.dot(point.at)) * normal;
}

// What a half-space is to a body near it: a box below its plane, twice as wide and thick as the body.
// Its half extents and its pose.
std::pair<Eigen::VectorXd, Pose> box_below(const Posed& half_space, const Posed& body) {
  const HalfSpace& H = *as_half_space(half_space.set);
  const int n = H.dimension();
  Eigen::VectorXd normal = H.normal() / H.normal().norm();
  double offset = H.offset() / H.normal().norm();
  if (half_space.pose != nullptr) {
    normal = half_space.pose->rotation() * normal;
    offset += normal.dot(Eigen::VectorXd(half_space.pose->translation()));
  }
  Eigen::MatrixXd axes = Eigen::HouseholderQR<Eigen::MatrixXd>(normal).householderQ();
  axes.col(0) = normal;
  if (axes.determinant() < 0) axes.col(n - 1) = -axes.col(n - 1);
  Eigen::VectorXd half(n), center(n);
  for (int k = 0; k < n; ++k) {
    Eigen::Vector3d axis = Eigen::Vector3d::Zero();
    axis.head(n) = axes.col(k);
    const double high = axis.dot(support_point(body, axis)), low = axis.dot(support_point(body, -axis));
    half[k] = high - low + (k == 0 ? std::max(0.0, offset - low) : 0);
    center[k] = k == 0 ? offset - half[k] : (high + low) / 2;
  }
  return {half, Pose(axes, axes * center)};
}

}  // namespace

void ContactFinder::find(const Posed& a, const Posed& b, double band, const Eigen::Vector3d& previous,
                         PartContact& contact) {
  const bool below_a = as_half_space(a.set) != nullptr;
  if (!below_a && as_half_space(b.set) == nullptr) return find_of_bounded(a, b, band, previous, contact);
  const auto& [half, pose] = below_a ? box_below(a, b) : box_below(b, a);
  const Box box(-half, half);
  const Posed floor(box, pose);
  find_of_bounded(below_a ? floor : a, below_a ? b : floor, band, previous, contact);
  // Planes across any other normal prove nothing of a half-space.
  contact.normal.head(a.dimension()) = (below_a ? -1.0 : 1.0) * pose.rotation().col(0);
  const ObjectDistance& proven =
      distances_.solve(a, b, Ball(Vector::Zero(a.dimension()), 1), ObjectEffects::depth);
  contact.lower = proven.depth.evaluations > 0 ? -proven.depth.upper : proven.distance.lower;
  contact.overlap = proven.depth.evaluations > 0 ? std::max(0.0, proven.depth.lower) : 0;
}

// Corners of a patch may miss the nearest pair of curved bodies by a share of the band: a patch of a narrower
// one has it.
void ContactFinder::add_nearest(const Posed& a, const Posed& b, double band, PartContact& contact) {
  const auto gap_of = [](const auto& one, const auto& two) { return one.gap < two.gap; };
  if (contact.points.empty()) return;
  const double least = std::min_element(contact.points.begin(), contact.points.end(), gap_of)->gap;
  const double narrow = std::max(0.0, contact.lower) + 10 * miss_;
  if (!(least - contact.lower > miss_ && narrow < band)) return;
  const ContactPatch& patch = solver_.solve(a, b, narrow);
  const auto all = patch.contacts();
  const auto nearest = std::min_element(all.begin(), all.end(), gap_of);
  if (nearest == all.end() || !(nearest->gap < least)) return;
  contact.points.push_back({(in_space(nearest->point_1) + in_space(nearest->point_2)) / 2, nearest->gap});
}

void ContactFinder::find_of_bounded(const Posed& a, const Posed& b, double band,
                                    const Eigen::Vector3d& previous, PartContact& contact) {
  const ContactPatch& patch = solver_.solve(a, b, band);
  const double apart = std::max(0.0, patch.lower);
  // Faces that lean are continued beyond their edges, far from the bodies in a wide band.
  for (int k = 0; k < kMostNarrowings && patch.error > miss_ && band > apart; ++k) {
    band = apart + (band - apart) / kNarrower;
    solver_.solve(a, b, band);
  }
  contact.lower = patch.lower;
  contact.overlap = std::max(0.0, -patch.upper);
  contact.points.clear();
  const Eigen::Vector3d normal = -in_space(patch.normal);
  contact.normal = normal.norm() > 0 ? Eigen::Vector3d(normal.normalized()) : previous;
  for (const ContactPoint& point : patch.contacts())
    contact.points.push_back({(in_space(point.point_1) + in_space(point.point_2)) / 2, point.gap});
  straighten(contact.normal, kRounding * patch.error, contact.points);
  add_nearest(a, b, band, contact);
  if (contact.points.size() > 1) flatten(contact.normal, contact.points);
  if (!contact.points.empty() || contact.lower > band) return;
  // Of bodies that touch to rounding no points may be known; curved ones touch where their support is.
  const bool by_a = a.set.smooth() || !b.set.smooth();
  contact.points.push_back(
      {by_a ? support_point(a, -contact.normal) : support_point(b, contact.normal), contact.lower});
}

}  // namespace raygauge
