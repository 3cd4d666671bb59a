// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/precise_growth.h"

#include <algorithm>
#include <cmath>

#include "engine/methods/spatial/active_pieces.h"
#include "engine/methods/spatial/portal.h"
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

  bool begin(const SpatialAnswer& answer);
  bool run(double tolerance);
  bool on_curves(const SpatialAnswer& answer, double tolerance);
  void record(bool done, SpatialAnswer& answer) const;

 private:
  bool descend(double tolerance);
  bool newton_step(double tolerance);
  bool look(DoubleDouble& ratio);
  void bound_by_height(const PreciseVector3& n, const DoubleDouble& height);
  void bound_by_portal();
  bool turn_portal(const PreciseVector3& u);
  Portal<DoubleDouble> portal() const { return {in_B(portal_[0]), in_B(portal_[1]), in_B(portal_[2])}; }
  PreciseVector3 in_B(const PrecisePoint& point) const { return point.s + beyond_cores_; }

  PrecisePair& pair_;
  PreciseVector3 p_;
  PrecisePoint portal_[3];       // of the cores
  PreciseVector3 beyond_cores_;  // p and the balls' points for the normal: what leads from the cores to B
  PreciseVector3 normal_;
  ActivePieces<PrecisePair> pieces_;  // of Newton steps, at u_
  PreciseVector3 u_;
  PreciseVector3 from_;  // the u_ before ...
  DoubleDouble from_ratio_;
  double taken_ = 0, longest_ = 0;  // ... the length of the step from there, and what it was limited to
  double radius_ = 0;
  Bounds bounds_;
  int iterations_ = 0;
};

// The pieces of the portal, which must not be the same.
bool PreciseGrowth::begin(const SpatialAnswer& answer) {
  const double size = length(answer.normal);
  if (!(size > 0) || answer.combination.count != 3) return false;
  for (int i = 0; i < 3; ++i) {
    portal_[i].index_1 = answer.combination.point[i].index_1;
    portal_[i].index_2 = answer.combination.point[i].index_2;
    for (int k = 0; k < i; ++k) {
      if (portal_[i].index_1 == portal_[k].index_1 && portal_[i].index_2 == portal_[k].index_2) return false;
    }
  }
  if (!turn_portal(precise(pair_.to_world(answer.normal * (1 / size))))) return false;
  if (portal().determinant().high < 0) std::swap(portal_[0], portal_[1]);
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
  DoubleDouble weight[3];
  if (!portal().weigh(p_, weight)) return;
  bounds_.reduce_upper(portal().sum_of_weights(p_, weight, pair_.error()));
}

// Pieces that are curved are as good as flat on needles: their points hardly move as the normal turns.
RAYGAUGE_FUSED bool PreciseGrowth::run(double tolerance) {
  double closest = __builtin_inf();
  int idle = 0;
  for (iterations_ = 0; iterations_ < kMostExchanges; ++iterations_) {
    DoubleDouble along;
    PreciseVector3 n = portal().normal(p_, along);
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
      portal_[portal().leaving(p_, in_B(w))] = w;
      continue;
    }
    idle = bounds_.gap() < 0.5 * closest ? 0 : idle + 1;
    closest = std::min(closest, bounds_.gap());
    if (!pair_.is_curved() || idle > kMostIdleTurns) return false;
  }
  return false;
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
RAYGAUGE_FUSED bool PreciseGrowth::newton_step(double tolerance) {
  DoubleDouble ratio;
  if (!look(ratio)) return false;
  const TangentMetric metric = pieces_.metric(pair_, u_, pair_.radius(), 0);
  const PreciseVector3 target = p_ * (DoubleDouble{1} / ratio);
  const ContactStep<DoubleDouble> found =
      pieces_.step(metric, u_, [&](int i) { return in_B(pieces_.point[i]) - target; });
  pieces_.keep(found);
  const double residual =
      length_of(p_ - in_B(pieces_.combine(found)) * ratio) + 4 * pair_.error() * (1 + ratio.high);
  bounds_.reduce_upper((ratio.rounded() + residual / radius_) * kUp);
  from_ = u_;
  from_ratio_ = ratio;
  const double long_by = turn(metric, found.y, longest_, u_);
  taken_ = std::min(long_by, longest_);
  return long_by > 0 && !bounds_.close(tolerance);
}

// From the normal and the pieces of the answer so far, if it is not lost to rounding, or from a rough one.
bool PreciseGrowth::on_curves(const SpatialAnswer& answer, double tolerance) {
  const double size = length(answer.normal);
  radius_ = pair_.in_doubles().inner_radius() * kDown - 2 * pair_.in_doubles().error();
  if (!(radius_ > 0) || !pair_.is_curved()) return false;
  pieces_.begin(answer.combination);
  for (int i = 0; i < pieces_.count; ++i) pieces_.weight[i] = 1.0 / pieces_.count;  // a portal has no weights
  if (size > 0) {
    u_ = precise(pair_.to_world(answer.normal * (1 / size)));
    if (descend(tolerance)) return true;
  }
  u_ = pair_.rough_normal(p_);
  pieces_.count = 0;
  return dot(u_, p_).high > 0 && descend(tolerance);
}

bool PreciseGrowth::descend(double tolerance) {
  from_ratio_ = {};
  for (iterations_ = 0; iterations_ < kMostNewtonSteps && newton_step(tolerance);) ++iterations_;
  return bounds_.close(tolerance);
}

void PreciseGrowth::record(bool done, SpatialAnswer& answer) const {
  answer.iterations += iterations_;
  answer.raise_lower(bounds_.lower(), pair_.to_first(normal_));
  answer.bounds.reduce_upper(bounds_.upper());
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
  const bool done = (growth.begin(answer) && growth.run(tolerance)) || growth.on_curves(answer, tolerance);
  growth.record(done, answer);
}

}  // namespace raygauge
