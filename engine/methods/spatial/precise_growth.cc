// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/precise_growth.h"

#include <algorithm>
#include <cmath>

#include "engine/methods/spatial/contact_program.h"
#include "engine/methods/spatial/spatial_growth.h"
#include "engine/numerics/fused.h"

namespace raygauge {
namespace {

constexpr int kMostExchanges = 40;
constexpr int kMostNewtonSteps = 4;
constexpr int kMostIdleTurns = 3;
constexpr double kUp = 1 + 0x1p-48,
                 kDown = 1 - 0x1p-48;  // of a few operations on numbers that are certain otherwise

double size_of(const PreciseVector3& v) {
  return length(Vector3{v.x.rounded(), v.y.rounded(), v.z.rounded()});
}

class PreciseGrowth {
 public:
  PreciseGrowth(PrecisePair& pair, const PreciseVector3& p) : pair_(pair), p_(p) {}

  bool begin(const SpatialPair& pair, const SpatialAnswer& answer);
  bool run(double tolerance);
  bool newton_step(const SpatialPair& pair, const PreciseVector3& gap, PreciseVector3& u) const;
  bool at_normal(const SpatialPair& pair, const Vector3& normal, double tolerance);
  void record(const SpatialPair& pair, SpatialAnswer& answer) const;

 private:
  void bound_from_below(const PreciseVector3& n, const DoubleDouble& height);
  void bound_from_above();
  void exchange(const PrecisePoint& w);
  bool turn_portal(const PreciseVector3& u);
  PreciseVector3 in_B(const PrecisePoint& point) const { return point.s + beyond_cores_; }

  PrecisePair& pair_;
  PreciseVector3 p_;
  PrecisePoint portal_[3];       // of the cores
  PreciseVector3 beyond_cores_;  // p and the balls' points for the normal: what leads from the cores to B
  PreciseVector3 normal_;
  double lower_ = 0, upper_ = __builtin_inf();
  int iterations_ = 0;
};

// The pieces of the portal, which must not be the same.
bool PreciseGrowth::begin(const SpatialPair& pair, const SpatialAnswer& answer) {
  const double size = length(answer.normal);
  if (!(size > 0) || answer.combination.count != 3) return false;
  for (int i = 0; i < 3; ++i) {
    portal_[i].index_1 = answer.combination.point[i].index_1;
    portal_[i].index_2 = answer.combination.point[i].index_2;
    for (int k = 0; k < i; ++k) {
      if (portal_[i].index_1 == portal_[k].index_1 && portal_[i].index_2 == portal_[k].index_2) return false;
    }
  }
  double world[3] = {0, 0, 0};
  pair.to_world(answer.normal * (1 / size), world);
  if (!turn_portal({{world[0], 0}, {world[1], 0}, {world[2], 0}})) return false;
  if (dot(cross(in_B(portal_[0]), in_B(portal_[1])), in_B(portal_[2])).high < 0)
    std::swap(portal_[0], portal_[1]);
  return true;
}

// Rims and curved surfaces follow the normal, as do the balls' points.
bool PreciseGrowth::turn_portal(const PreciseVector3& u) {
  for (PrecisePoint& corner : portal_) {
    if (!pair_.follow(u, corner)) return false;
  }
  beyond_cores_ = p_ + pair_.ball_points(u);
  return true;
}

// n·p and n·s are within |n| error() of what they stand for.
void PreciseGrowth::bound_from_below(const PreciseVector3& n, const DoubleDouble& height) {
  const double slack = 4 * pair_.error() * size_of(n);
  const double along = dot(n, p_).rounded() - slack, top = height.rounded() + slack;
  if (!(along > 0) || !(top > 0)) return;
  const double lower = along / top * kDown;
  if (!(lower > lower_)) return;
  lower_ = lower;
  normal_ = n;
}

void PreciseGrowth::bound_from_above() {
  const PreciseVector3 corner[3] = {in_B(portal_[0]), in_B(portal_[1]), in_B(portal_[2])};
  const PreciseVector3 n[3] = {cross(corner[1], corner[2]), cross(corner[2], corner[0]),
                               cross(corner[0], corner[1])};
  const DoubleDouble determinant = dot(n[0], corner[0]);
  if (!(std::fabs(determinant.high) > 0)) return;
  DoubleDouble weight[3], sum;
  PreciseVector3 r = p_;
  double norm = 0;
  for (int i = 0; i < 3; ++i) {
    weight[i] = dot(n[i], p_) / determinant;
    sum = sum + weight[i];
    r = r - corner[i] * weight[i];
    norm += size_of(n[i]) / std::fabs(determinant.high);
  }
  const double error = pair_.error();
  if (!(8 * norm * error < 0.25)) return;
  const double total = sum.rounded();
  const double uncertainty = 2 * norm * (size_of(r) + 4 * error * (1 + std::fabs(total)));
  const double least = std::min({weight[0].rounded(), weight[1].rounded(), weight[2].rounded()});
  const double upper = (total + 3 * uncertainty) * kUp;
  if (least >= uncertainty && upper < upper_) upper_ = upper;
}

// Puts w in the place of the corner without which the cone still holds p.
void PreciseGrowth::exchange(const PrecisePoint& w) {
  const PreciseVector3 s = in_B(w);
  const double d0 = dot(p_, cross(s, in_B(portal_[0]))).high, d1 = dot(p_, cross(s, in_B(portal_[1]))).high,
               d2 = dot(p_, cross(s, in_B(portal_[2]))).high;
  portal_[leaving_corner(d0, d1, d2)] = w;
}

// Pieces that are curved are as good as flat on needles: their points hardly move as the normal turns.
RAYGAUGE_FUSED bool PreciseGrowth::run(double tolerance) {
  double closest = __builtin_inf();
  int idle = 0;
  for (iterations_ = 0; iterations_ < kMostExchanges; ++iterations_) {
    PreciseVector3 n = cross(portal_[1].s - portal_[0].s, portal_[2].s - portal_[0].s);
    if (dot(n, p_).high < 0) n = -n;
    const double scale = size_of(n);
    if (!(scale > 0)) return false;
    n = n * DoubleDouble{1 / scale};
    if (!turn_portal(n)) return false;
    DoubleDouble height;
    const PrecisePoint w = pair_.support(n, height);
    bound_from_below(n, height + dot(n, p_));
    bound_from_above();
    if (upper_ - lower_ <= tolerance * upper_) return true;
    if (dot(n, w.s - portal_[0].s).high > pair_.error()) {
      exchange(w);
      continue;
    }
    idle = upper_ - lower_ < 0.5 * closest ? 0 : idle + 1;
    closest = std::min(closest, upper_ - lower_);
    if (!pair_.is_curved() || idle > kMostIdleTurns) return false;
  }
  return false;
}

// The Newton step of spatial_growth: H d = p/σ - s(u), d ⊥ u.
bool PreciseGrowth::newton_step(const SpatialPair& pair, const PreciseVector3& gap, PreciseVector3& u) const {
  const double rounded[3] = {u.x.high, u.y.high, u.z.high};
  const Vector3 inner = pair.to_body(rounded);
  Matrix3 H;
  if (!pair.hessian(inner, H)) return false;
  const TangentMetric metric(inner, H, 0);
  PreciseVector3 tangent[2];
  for (int i = 0; i < 2; ++i) {
    double world[3] = {0, 0, 0};
    pair.to_world(metric.tangent[i], world);
    tangent[i] = {{world[0], 0}, {world[1], 0}, {world[2], 0}};
  }
  DoubleDouble y[2], d[2];
  metric.image(dot(tangent[0], gap), dot(tangent[1], gap), y);
  metric.step(y, d);
  u = u + tangent[0] * d[0] + tangent[1] * d[1];
  return true;
}

RAYGAUGE_FUSED bool PreciseGrowth::at_normal(const SpatialPair& pair, const Vector3& normal,
                                             double tolerance) {
  const double size = length(normal), radius = pair.inner_radius() * kDown - 2 * pair.error();
  if (!(size > 0) || !(radius > 0)) return false;
  double world[3] = {0, 0, 0};
  pair.to_world(normal * (1 / size), world);
  PreciseVector3 u{{world[0], 0}, {world[1], 0}, {world[2], 0}};
  for (iterations_ = 0; iterations_ < kMostNewtonSteps; ++iterations_) {
    DoubleDouble height;
    const PreciseVector3 s = pair_.support(u, height).s + p_;
    const DoubleDouble along = dot(u, p_), ratio = along / (height + along);
    if (!(ratio.high > 0)) return false;
    bound_from_below(u, height + along);
    const double residual = size_of(p_ - s * ratio) + 4 * pair_.error() * (1 + ratio.high);
    upper_ = std::min(upper_, (ratio.rounded() + residual / radius) * kUp);
    if (upper_ - lower_ <= tolerance * upper_) return true;
    if (!newton_step(pair, p_ * (DoubleDouble{1} / ratio) - s, u)) return false;
  }
  return false;
}

void PreciseGrowth::record(const SpatialPair& pair, SpatialAnswer& answer) const {
  answer.end = SpatialEnd::closed;
  answer.lower = lower_;
  answer.upper = upper_;
  answer.iterations += iterations_;
  const double normal[3] = {normal_.x.high, normal_.y.high, normal_.z.high};
  answer.normal = pair.to_body(normal);
  for (int i = 0; i < answer.combination.count; ++i) {
    answer.combination.point[i].index_1 = portal_[i].index_1;
    answer.combination.point[i].index_2 = portal_[i].index_2;
  }
}

}  // namespace

void precise_growth(const SpatialPair& pair, const Kernels& kernels, double tolerance,
                    SpatialAnswer& answer) {
  PrecisePair precise;
  if (!precise.bind(pair, kernels)) return;
  PreciseGrowth growth(precise, precise.between_centers());
  const bool closed = growth.begin(pair, answer)
                          ? growth.run(tolerance)
                          : pair.radius() == 0 && growth.at_normal(pair, answer.normal, tolerance);
  if (closed) growth.record(pair, answer);
}

}  // namespace raygauge
