// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/queries/object_distance.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "engine/queries/body_faces.h"
#include "engine/queries/formula_distance.h"
#include "engine/queries/ladder.h"
#include "engine/queries/patch_points.h"
#include "engine/sets/parameters.h"
#include "engine/sets/place_shape.h"
#include "raygauge/exceptions.h"
#include "raygauge/sets/ball.h"

namespace raygauge {
namespace {

// Segments that cross at a larger angle have a point in common, not a line.
constexpr double kCrossing = 0.5;
constexpr double kOfMargin = 1e-9;  // bounds that are closer are close enough
constexpr double kMissed = 0.01;  // of the margin, by which the least gap may miss the distance or the depth

double checked_margin(double margin, int n) {
  if (n != 2 && n != 3) {
    throw InvalidParameterError("contact patch: bodies of R^2 or R^3 are needed, got n = " +
                                std::to_string(n));
  }
  if (!(margin >= 0) || !std::isfinite(margin))
    throw InvalidParameterError("margin: a number >= 0 is needed, got " + std::to_string(margin));
  return margin;
}

// Whether a body is a ball or an ellipsoid.
bool has_one_point(const SpatialPair* pair) {
  return pair != nullptr && (is_smooth(pair->shape(0)) || is_smooth(pair->shape(1)));
}

}  // namespace

class ContactPatchSolver::Work {
 public:
  explicit Work(const DistanceOptions& options) : isa_(options.instruction_set), ladder_(options) {}

  void set_stop(std::function<bool()> stop) { ladder_.set_stop(std::move(stop)); }

  const ContactPatch& solve(const Posed& A1, const Posed& A2, double margin, WarmStart* warm);

 private:
  bool take_faces(double margin);
  void take_closest(const Vector& point_1, const Vector& point_2);

  InstructionSet isa_;
  Ladder ladder_;
  const Ball ball_[2] = {Ball(Vector::Zero(2), 1.0), Ball(Vector::Zero(3), 1.0)};
  BodyFaces faces_;
  PatchPoints points_;
  ContactPatch patch_;
};

// Of the pairs of points that are above each other those with a gap within the margin, and of these at most
// 8.
// True where the nearest points, or the deepest, are not among them: where many small facets are within the
// margin.
bool ContactPatchSolver::Work::take_faces(double margin) {
  points_.begin();
  const double balls = faces_.ball_gap();
  for (const FacePair& pair : faces_.face().pairs())
    points_.add({pair, dot(faces_.normal(), pair.point_2 - pair.point_1) - balls});
  points_.keep_within(margin + 2 * faces_.noise());
  const bool lacks_closest = !points_.is_empty() && points_.least_gap() > patch_.upper + kMissed * margin;
  points_.reduce(faces_.normal(), ContactPatch::kMost - (lacks_closest ? 1 : 0), margin);
  patch_.count = 0;
  for (const GapPair& each : points_.pairs()) {
    ContactPoint& point = patch_.points[static_cast<std::size_t>(patch_.count++)];
    point.point_1 = faces_.to_world(0, each.pair.point_1);
    point.point_2 = faces_.to_world(1, each.pair.point_2);
    point.gap = each.gap;
  }
  patch_.error = faces_.error();
  return lacks_closest;
}

// The pair that the distance or the depth is known by: where faces have nothing in common, or lack it.
void ContactPatchSolver::Work::take_closest(const Vector& point_1, const Vector& point_2) {
  const int n = static_cast<int>(point_1.size());
  if (n == 0 || point_2.size() != n) return;
  ContactPoint& point = patch_.points[static_cast<std::size_t>(patch_.count)];
  point.point_1 = spatial(point_1, n);
  point.point_2 = spatial(point_2, n);
  point.gap = dot(patch_.normal, point.point_2 - point.point_1);
  const double error = patch_.upper - patch_.lower + faces_.noise();
  patch_.error = patch_.count > 0 ? std::max(patch_.error, error) : error;
  ++patch_.count;
}

const ContactPatch& ContactPatchSolver::Work::solve(const Posed& A1, const Posed& A2, double margin,
                                                    WarmStart* warm) {
  const int n = A1.dimension();
  check_dimension("contact patch", "A2", A2.dimension(), n);
  checked_margin(margin, n);
  ladder_.set_enough(kOfMargin * margin);
  const ObjectDistance& found = distance_of_objects(
      ladder_, A1, A2, ball_[n - 2], ObjectEffects::closest_points | ObjectEffects::depth, warm);
  patch_.count = 0;
  patch_.normal = {};
  patch_.error = DistanceResult::kUnset;
  const bool apart = found.distance.lower > 0;
  patch_.lower = apart ? found.distance.lower : -found.depth.upper;
  patch_.upper = apart ? found.distance.upper : -std::max(found.depth.lower, 0.0);
  patch_.status = apart ? found.distance.status : found.depth.status;
  const Vector& out = apart ? found.distance.normal : found.depth.normal;
  if (out.size() != n) return patch_;
  patch_.normal = spatial(out, n);
  patch_.normal = patch_.normal * (-1 / length(patch_.normal));
  if (patch_.lower > margin || !faces_.bind(A1, A2, isa_)) return patch_;
  const Vector &point_1 = apart ? found.closest_point_1 : found.depth.point_1,
               &point_2 = apart ? found.closest_point_2 : found.depth.point_2;
  const SpatialPair* const pair = point_1.size() == n && point_2.size() == n ? faces_.pair() : nullptr;
  const bool is_round = has_one_point(pair);
  if (!is_round) faces_.list(patch_.normal, std::max(margin - (apart ? patch_.upper : patch_.lower), 0.0));
  if (is_round || (pair != nullptr && faces_.face().has_vertex())) {
    take_closest(point_1, point_2);
    return patch_;
  }
  const bool lacks_closest = !faces_.find(margin, kCrossing) || take_faces(std::max(margin, patch_.upper));
  if (lacks_closest || patch_.count == 0) take_closest(point_1, point_2);
  return patch_;
}

DistanceOptions ContactPatchSolver::patch_options() {
  DistanceOptions options;
  options.tolerance = 1e-9;
  return options;
}

ContactPatchSolver::ContactPatchSolver(const DistanceOptions& options)
    : work_(std::make_unique<Work>(options)) {}

ContactPatchSolver::~ContactPatchSolver() = default;
ContactPatchSolver::ContactPatchSolver(ContactPatchSolver&&) noexcept = default;
ContactPatchSolver& ContactPatchSolver::operator=(ContactPatchSolver&&) noexcept = default;

void ContactPatchSolver::set_stop(std::function<bool()> stop) { work_->set_stop(std::move(stop)); }

const ContactPatch& ContactPatchSolver::solve(const Posed& A1, const Posed& A2, double margin,
                                              WarmStart* warm) {
  return work_->solve(A1, A2, margin, warm);
}

}  // namespace raygauge
