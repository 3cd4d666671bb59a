// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/spatial_gauge.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/numerics/floating_point.h"
#include "engine/numerics/fused.h"

namespace raygauge {
namespace {

constexpr int kMostEvaluations = 24;
constexpr double kSmallest = 1e-50, kLargest = 1e50;  // of sizes that are squared and multiplied
constexpr double kRounding = 128 * 0x1p-53;  // of a height or point, relative to what it is computed from
constexpr double kUp = 1 + 0x1p-49, kDown = 1 - 0x1p-49;  // of a few operations
constexpr double kDamping = 1e-2;  // of the last step: superlinear, and safe far from the solution
constexpr double kLongestStep = 1, kShorter = 0.4;
constexpr double kNearAxis = 0.75;    // squared cosine of the angle at which a disc is tried
constexpr double kInside = 1 - 1e-9;  // of a disc's radius

Vector3 unit(const Vector3& v) { return v * (1 / length(v)); }

}  // namespace

bool SpatialGauge::Side::bind(const ConvexSet& S) {
  shape = S.spatial_shape();
  if (shape == nullptr) return false;
  if (!with_core(*shape, [](const auto& core) { return core.kPieces > 0; })) return false;
  const double size = shape->extent + shape->radius;
  error = kRounding * size;
  tried = !has_discs(*shape);
  with_core(*shape, [&](const auto& core) {
    if constexpr (requires { core.kIsCurved; }) form = core.form(shape->axis);
  });
  return size > kSmallest && size < kLargest;
}

// M with {x : (x - c)ᵀ M⁻¹ (x - c) <= 1} roughly the set.
Matrix3 SpatialGauge::Side::second_moment() const {
  const double ball = shape->radius * shape->radius;
  Matrix3 M{{{ball, 0, 0}, {0, ball, 0}, {0, 0, ball}}};
  const Matrix3 axes = with_core(*shape, [](const auto& core) { return core.half_axes(); });
  for (const Vector3& axis : axes.column) {
    M.column[0] = M.column[0] + axis * axis.x;
    M.column[1] = M.column[1] + axis * axis.y;
    M.column[2] = M.column[2] + axis * axis.z;
  }
  return M;
}

// v is of length 1, but for rounding.
void SpatialGauge::Side::look(const Vector3& v) {
  with_core(*shape, [&](const auto& core) {
    const auto view = core.look(v, InstructionSet::automatic);
    count = core.kPieces;
    top = 0;
    for (int i = 0; i < core.kPieces; ++i) {
      const std::int32_t piece = core.kFirstPiece - i;
      point[i] = view.point(piece);
      if (shape->radius > 0) point[i] = point[i] + v * shape->radius;
      height[i] = dot(v, point[i]);
      if (piece == view.index) top = i;
      curvature[i] = {};
      if constexpr (requires { core.kIsCurved; }) curvature[i] = core.curvature(shape->axis, v, piece);
    }
  });
}

// Without that of the ball, which is the same for all pieces.
void SpatialGauge::Side::add_hessian(int piece, double weight, const Vector3* t, double* h) const {
  const double share = curvature[piece].share * weight;
  if (!(share > 0)) return;
  const Vector3& y = curvature[piece].y;
  const double along[2] = {dot(y, t[0]), dot(y, t[1])};
  const Vector3 S0 = form * t[0], S1 = form * t[1];
  h[0] += (dot(t[0], S0) - along[0] * along[0]) * share;
  h[1] += (dot(t[0], S1) - along[0] * along[1]) * share;
  h[2] += (dot(t[1], S1) - along[1] * along[1]) * share;
}

// The normal for which two ellipsoids like the sets would meet: -M⁻¹c for the sum of their M and the centre c
// of A; -c where M is flat.
Vector3 SpatialGauge::rough_normal() const {
  const Matrix3 a = A_.second_moment(), q = Q_.second_moment();
  const Vector3 x = a.column[0] + q.column[0], y = a.column[1] + q.column[1], z = a.column[2] + q.column[2];
  const Vector3 yz = cross(y, z), &c = A_.shape->center;
  const double determinant = dot(x, yz);
  if (!(determinant > 0)) return -c;
  return (yz * c.x + cross(z, x) * c.y + cross(x, y) * c.z) * (-1 / determinant);
}

bool SpatialGauge::begin(const Problem& problem) {
  *this = {};  // no value of a solve outlives it
  if (problem.A.dimension() != 3 || problem.pairs != nullptr || problem.options.max_iterations != 0 ||
      !std::isnan(problem.threshold) || !A_.bind(problem.A) || !Q_.bind(problem.Q)) {
    return false;
  }
  constexpr double kOrigin[3] = {0, 0, 0};
  const bool centered = is_zero(Q_.shape->center) && Q_.shape->inner_radius > 0;
  radius_ = centered ? Q_.shape->inner_radius : problem.Q.inner_radius_unchecked(kOrigin);
  const double* start = problem.start;
  u_ = start != nullptr ? Vector3{start[0], start[1], start[2]} : rough_normal();
  const double size = length(u_);
  if (!(radius_ > 0) || !(size > 0) || !(size < kLargest)) return false;
  u_ = u_ * (1 / size);
  tolerance_ = problem.options.tolerance;
  return true;
}

// Both sets for u, and the bound from below.
void SpatialGauge::look(const Vector3& u) {
  A_.look(u);
  Q_.look(-u);
  ++evaluations_;
  const double height_A = A_.height[A_.top], height_Q = Q_.height[Q_.top];
  ratio_ = -height_A / height_Q;
  if (!bounds_.raise_lower((-height_A - A_.error) / (height_Q + Q_.error) * kDown)) return;
  estimate_ = ratio_;
  normal_ = u * (1 / height_Q);
}

// With a of A and q of Q, both to their errors: a = ρ q + r costs no more than ρ + |r|/R.
bool SpatialGauge::closes(const Vector3& a, const Vector3& q) {
  const double rest = length(a - q * ratio_) + A_.error + ratio_ * Q_.error;
  if (bounds_.reduce_upper((ratio_ + rest / radius_) * kUp)) contact_ = a;
  return bounds_.close(tolerance_);
}

// `flat`, whose directions are `sign` times u, on the disc whose normal is near.
bool SpatialGauge::try_disc(Side& flat, Side& other, double sign) {
  if (flat.tried) return false;
  const CoreDisc disc = disc_towards(*flat.shape, u_ * sign);
  const double along = sign * dot(u_, disc.normal);
  if (along * along < kNearAxis) return false;
  flat.tried = true;
  look(disc.normal * sign);
  if (!(ratio_ > 0)) return false;
  const Vector3& met = other.point[other.top];
  Vector3 q = (sign > 0 ? met * ratio_ : met * (1 / ratio_)) - disc.center;
  q = q - disc.normal * dot(q, disc.normal);
  if (!(length(q) < kInside * disc.radius)) return false;
  return sign > 0 ? closes(disc.center + q, met) : closes(met, disc.center + q);
}

// False where no shorter step is left. The ratio must not fall: the step before was too long.
bool SpatialGauge::shorten() {
  share_ *= kShorter;
  last_step_ *= kShorter;
  u_ = unit(from_ + way_ * share_);
  return share_ > 1e-4;
}

// The pairs of pieces at u_, and their Hessian with the weights of the step before; the first step takes the
// highest of each.
void SpatialGauge::gather(const Vector3* tangents, double* h) {
  if (steps_ == 0) weight_[A_.top][Q_.top] = 1;
  pairs_ = 0;
  for (int i = 0; i < A_.count; ++i) {
    for (int j = 0; j < Q_.count; ++j) pair_[pairs_++] = 2 * i + j;
    const double of_A = weight_[i][0] + weight_[i][1];
    if (of_A > 0) A_.add_hessian(i, of_A, tangents, h);
  }
  for (int j = 0; j < Q_.count; ++j) {
    const double of_Q = weight_[0][j] + weight_[1][j];
    if (of_Q > 0) Q_.add_hessian(j, of_Q * ratio_, tangents, h);
  }
}

// The weights of a step, and what they prove.
bool SpatialGauge::conclude(const ContactStep<double>& found) {
  double sum = 0;
  for (int i = 0; i < found.count; ++i) sum += std::max(found.weight[i], 0.0);
  std::fill_n(&weight_[0][0], 4, 0.0);
  Vector3 a, q;
  for (int i = 0; i < found.count; ++i) {
    const int in_A = pair_[found.piece[i]] / 2, in_Q = pair_[found.piece[i]] % 2;
    const double weight = std::max(found.weight[i], 0.0) / sum;
    weight_[in_A][in_Q] = weight;
    a = a + A_.point[in_A] * weight;
    q = q + Q_.point[in_Q] * weight;
  }
  return closes(a, q);
}

// From u_ and what look() found there. False where the solve is done, or nothing is left to gain.
bool SpatialGauge::step() {
  Vector3 tangents[2] = {any_orthogonal(u_), {}};
  tangents[1] = cross(u_, tangents[0]);
  double h[3] = {0, 0, 0};
  gather(tangents, h);
  const double rounding = A_.error + ratio_ * Q_.error, balls = A_.shape->radius + ratio_ * Q_.shape->radius;
  const double damping = kDamping * last_step_ * last_step_ * (h[0] + h[2]);
  const TangentMetric metric(tangents[0], tangents[1], h, balls + damping + rounding);
  ContactPiece<double> pieces[4];
  for (int i = 0; i < pairs_; ++i) {
    const int in_A = pair_[i] / 2, in_Q = pair_[i] % 2;
    const Vector3 point = A_.point[in_A] - Q_.point[in_Q] * ratio_;
    pieces[i].height = A_.height[in_A] + ratio_ * Q_.height[in_Q];
    metric.image(dot(metric.tangent[0], point), dot(metric.tangent[1], point), pieces[i].slope);
  }
  const ContactStep<double> found = contact_step(pieces, pairs_);
  ++steps_;
  if (conclude(found)) return false;
  double d[2];
  metric.step(found.y, d);
  way_ = metric.tangent[0] * d[0] + metric.tangent[1] * d[1];
  const double long_by = length(way_);
  if (long_by > kLongestStep) way_ = way_ * (kLongestStep / long_by);
  last_step_ = std::min(long_by, kLongestStep);
  return last_step_ > 0;
}

// Back at u_ if the contact is on no disc.
bool SpatialGauge::is_on_disc() {
  const std::int64_t before = evaluations_;
  if (try_disc(A_, Q_, 1) || try_disc(Q_, A_, -1)) return true;
  if (evaluations_ != before) look(u_);
  return false;
}

RAYGAUGE_FUSED bool SpatialGauge::descend() {
  while (evaluations_ < kMostEvaluations) {
    look(u_);
    if (!(ratio_ > 0) && evaluations_ == 1) return false;
    const double noise = 4 * (A_.error + ratio_ * Q_.error) / Q_.height[Q_.top];
    if (ratio_ < from_ratio_ - noise) {
      if (!shorten()) return false;
      continue;
    }
    if (is_on_disc()) return true;
    from_ = u_;
    from_ratio_ = ratio_;
    share_ = 1;
    if (!step()) return bounds_.close(tolerance_);
    u_ = unit(from_ + way_);
  }
  return false;
}

bool SpatialGauge::solve(const Problem& problem, DistanceResult& result) {
  if (!begin(problem) || !descend()) return false;
  report(problem, result);
  return true;
}

void SpatialGauge::report(const Problem& problem, DistanceResult& result) {
  write_bounds(bounds_, estimate_, DistanceStatus::optimal, result);
  result.normal.resize(3);
  result.normal << normal_.x, normal_.y, normal_.z;
  if (double* contact = result.room_for_contact(problem.effects, 3)) {
    contact[0] = contact_.x;
    contact[1] = contact_.y;
    contact[2] = contact_.z;
    ++contacts_;
  }
  result.counters = counters();
}

DistanceCounters SpatialGauge::counters() const {
  DistanceCounters counters;
  counters.outer_iterations = evaluations_ > 0 ? 1 : 0;
  counters.ray_iterations = evaluations_;
  counters.support_queries = 2 * evaluations_;
  counters.pivots = steps_;
  counters.witness_evaluations = contacts_;
  return counters;
}

}  // namespace raygauge
