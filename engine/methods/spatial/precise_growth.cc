// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/precise_growth.h"

#include <algorithm>
#include <cmath>

#include "engine/methods/spatial/precise_pieces.h"
#include "engine/methods/spatial/spatial_growth.h"
#include "engine/numerics/fused.h"
#include "engine/proof/bounds.h"

namespace raygauge {
namespace {

constexpr int kMostExchanges = 40;
constexpr int kMostNewtonSteps = 30;
constexpr double kLongestStep = 0.5, kShorter = 0.3, kShortest = 1e-20;
constexpr double kFall = 1e-12;  // of the ratio: rounding
constexpr int kMostIdleTurns = 3;
constexpr double kUp = 1 + 0x1p-48,
                 kDown = 1 - 0x1p-48;  // of a few operations on numbers that are certain otherwise

class PreciseGrowth {
 public:
  PreciseGrowth(PrecisePair& pair, const PreciseVector3& p) : pair_(pair), p_(p) {}

  bool begin(const SpatialPair& pair, const SpatialAnswer& answer);
  bool run(double tolerance);
  bool on_curves(const SpatialPair& pair, const SpatialAnswer& answer, double tolerance);
  void record(const SpatialPair& pair, bool done, SpatialAnswer& answer) const;

 private:
  bool descend(const SpatialPair& pair, double tolerance);
  bool newton_step(const SpatialPair& pair, double tolerance);
  ContactStep<DoubleDouble> step_of_pieces(const TangentMetric& metric, const PreciseVector3& target) const;
  PreciseVector3 combine(const ContactStep<DoubleDouble>& found) const;
  bool look(DoubleDouble& ratio);
  void bound_by_height(const PreciseVector3& n, const DoubleDouble& height);
  void bound_by_portal();
  void exchange(const PrecisePoint& w);
  bool turn_portal(const PreciseVector3& u);
  PreciseVector3 in_B(const PrecisePoint& point) const { return point.s + beyond_cores_; }

  PrecisePair& pair_;
  PreciseVector3 p_;
  PrecisePoint portal_[3];       // of the cores
  PreciseVector3 beyond_cores_;  // p and the balls' points for the normal: what leads from the cores to B
  PreciseVector3 normal_;
  PrecisePieces pieces_;  // of Newton steps, at u_
  PreciseVector3 u_;
  PreciseVector3 from_;  // the u_ before ...
  DoubleDouble from_ratio_;
  double taken_ = 0, longest_ = 0;  // ... the length of the step from there, and what it was limited to
  double radius_ = 0;
  Bounds bounds_;
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
void PreciseGrowth::bound_by_height(const PreciseVector3& n, const DoubleDouble& height) {
  const double slack = 4 * pair_.error() * length_of(n);
  const double along = dot(n, p_).rounded() - slack, top = height.rounded() + slack;
  if (!(along > 0) || !(top > 0)) return;
  if (bounds_.raise_lower(along / top * kDown)) normal_ = n;
}

void PreciseGrowth::bound_by_portal() {
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
    norm += length_of(n[i]) / std::fabs(determinant.high);
  }
  const double error = pair_.error();
  if (!(8 * norm * error < 0.25)) return;
  const double total = sum.rounded();
  const double uncertainty = 2 * norm * (length_of(r) + 4 * error * (1 + std::fabs(total)));
  const double least = std::min({weight[0].rounded(), weight[1].rounded(), weight[2].rounded()});
  if (least >= uncertainty) bounds_.reduce_upper((total + 3 * uncertainty) * kUp);
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
    const double scale = length_of(n);
    if (!(scale > 0)) return false;
    n = n * DoubleDouble{1 / scale};
    if (!turn_portal(n)) return false;
    DoubleDouble height;
    const PrecisePoint w = pair_.support(n, height);
    bound_by_height(n, height + dot(n, p_));
    bound_by_portal();
    if (bounds_.close(tolerance)) return true;
    if (dot(n, w.s - portal_[0].s).high > pair_.error()) {
      exchange(w);
      continue;
    }
    idle = bounds_.gap() < 0.5 * closest ? 0 : idle + 1;
    closest = std::min(closest, bounds_.gap());
    if (!pair_.is_curved() || idle > kMostIdleTurns) return false;
  }
  return false;
}

// The pieces as they stand above p/σ, the height of each and its slope across u.
ContactStep<DoubleDouble> PreciseGrowth::step_of_pieces(const TangentMetric& metric,
                                                        const PreciseVector3& target) const {
  ContactPiece<DoubleDouble> pieces[4];
  for (int i = 0; i < pieces_.count; ++i) {
    const PreciseVector3 above = in_B(pieces_.point[i]) - target;
    pieces[i].height = dot(u_, above);
    metric.image(dot(precise(metric.tangent[0]), above), dot(precise(metric.tangent[1]), above),
                 pieces[i].slope);
  }
  return contact_step(pieces, pieces_.count);
}

// Of points of B, with the weights of a step, of which rounding may leave some negative.
PreciseVector3 PreciseGrowth::combine(const ContactStep<DoubleDouble>& found) const {
  PreciseVector3 sum;
  DoubleDouble all;
  for (int i = 0; i < found.count; ++i) {
    if (!(found.weight[i] > DoubleDouble{})) continue;
    sum = sum + in_B(pieces_.point[i]) * found.weight[i];
    all = all + found.weight[i];
  }
  return sum * (DoubleDouble{1} / all);
}

// The ratio at u_ and the piece that is highest there, which joins the others. Where the ratio is lower than
// before, the step was too long: back, with the piece that it met.
bool PreciseGrowth::look(DoubleDouble& ratio) {
  DoubleDouble height;
  PrecisePoint w = pair_.support(u_, height);
  const DoubleDouble along = dot(u_, p_), top = height + along;
  ratio = along / top;
  if (ratio.high > from_ratio_.high * (1 - kFall)) {
    bound_by_height(u_, top);
    longest_ = kLongestStep;
  } else {
    u_ = from_;
    ratio = from_ratio_;
    longest_ = kShorter * taken_;
    pair_.follow(u_, w);
  }
  beyond_cores_ = p_ + pair_.ball_points(u_);
  pieces_.follow(pair_, u_, &w);
  return ratio.high > 0 && longest_ > kShortest;
}

// At u_ with ratio σ: the least of the greatest of  (s_l - p/σ)·(u + d) + dᵀHd/2  over the pieces, whose
// weights make a point x of B nearly p/σ; p = σx + r costs no more than σ + |r|/R.
RAYGAUGE_FUSED bool PreciseGrowth::newton_step(const SpatialPair& pair, double tolerance) {
  DoubleDouble ratio;
  if (!look(ratio)) return false;
  const TangentMetric metric = pieces_.metric(pair, u_, pair.radius() + pair_.error(), 0);
  const ContactStep<DoubleDouble> found = step_of_pieces(metric, p_ * (DoubleDouble{1} / ratio));
  pieces_.keep(found);
  const double residual = length_of(p_ - combine(found) * ratio) + 4 * pair_.error() * (1 + ratio.high);
  bounds_.reduce_upper((ratio.rounded() + residual / radius_) * kUp);
  DoubleDouble d[2];
  metric.step(found.y, d);
  const double long_by = std::hypot(d[0].high, d[1].high);
  const DoubleDouble share{long_by > longest_ ? longest_ / long_by : 1.0};
  from_ = u_;
  from_ratio_ = ratio;
  taken_ = std::min(long_by, longest_);
  u_ = u_ + (precise(metric.tangent[0]) * d[0] + precise(metric.tangent[1]) * d[1]) * share;
  u_ = u_ * DoubleDouble{1 / length_of(u_)};
  return long_by > 0 && !bounds_.close(tolerance);
}

// From the normal and the pieces of the answer so far, if it is not lost to rounding, or from a rough one.
bool PreciseGrowth::on_curves(const SpatialPair& pair, const SpatialAnswer& answer, double tolerance) {
  const double size = length(answer.normal);
  radius_ = pair.inner_radius() * kDown - 2 * pair.error();
  if (!(radius_ > 0) || !pair_.is_curved()) return false;
  pieces_.begin(answer.combination);
  for (int i = 0; i < pieces_.count; ++i) pieces_.weight[i] = 1.0 / pieces_.count;  // a portal has no weights
  if (size > 0) {
    double world[3] = {0, 0, 0};
    pair.to_world(answer.normal * (1 / size), world);
    u_ = precise({world[0], world[1], world[2]});
    if (descend(pair, tolerance)) return true;
  }
  u_ = pair_.rough_normal(p_);
  pieces_.count = 0;
  return dot(u_, p_).high > 0 && descend(pair, tolerance);
}

bool PreciseGrowth::descend(const SpatialPair& pair, double tolerance) {
  from_ratio_ = {};
  for (iterations_ = 0; iterations_ < kMostNewtonSteps && newton_step(pair, tolerance);) ++iterations_;
  return bounds_.close(tolerance);
}

void PreciseGrowth::record(const SpatialPair& pair, bool done, SpatialAnswer& answer) const {
  answer.iterations += iterations_;
  const double normal[3] = {normal_.x.high, normal_.y.high, normal_.z.high};
  answer.bound_from_below(bounds_.lower(), pair.to_body(normal));
  answer.bound_from_above(bounds_.upper());
  if (!done) return;
  answer.end = SpatialEnd::closed;
  for (int i = 0; i < answer.combination.count; ++i) {
    answer.combination.point[i].index_1 = portal_[i].index_1;
    answer.combination.point[i].index_2 = portal_[i].index_2;
  }
}

}  // namespace

void precise_growth(const SpatialPair& pair, double tolerance, SpatialAnswer& answer) {
  PrecisePair precise;
  if (!precise.bind(pair)) return;
  PreciseGrowth growth(precise, precise.between_centers());
  const bool done =
      (growth.begin(pair, answer) && growth.run(tolerance)) || growth.on_curves(pair, answer, tolerance);
  growth.record(pair, done, answer);
}

}  // namespace raygauge
