// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/patch_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raygauge {
namespace {

constexpr std::int32_t kGone = -1;

GapPair between(const GapPair& a, const GapPair& b, double share) {
  const auto mix = [share](const Vector3& p, const Vector3& q) { return p + (q - p) * share; };
  return {{mix(a.pair.point_1, b.pair.point_1), mix(a.pair.point_2, b.pair.point_2), -1},
          a.gap + (b.gap - a.gap) * share};
}

// Corners that lose the same but for rounding and small motions: those with odd numbers go first, then those
// that are odd when halved. So of a regular polygon a regular one remains. Of others with equal losses, as
// where discs overlap, it is always the same one that goes: each number has a rank of its own.
double rank_of(std::int32_t index) {
  constexpr double kHigher = 1.05, kGolden = 0.618033988749895, kOwn = 1e-3;
  const double turns = kGolden * index;
  double rank = 1 + kOwn * (turns - std::floor(turns));
  for (int half = 0; half < 2 && index >= 0 && index % 2 == 0; ++half, index /= 2) rank *= kHigher;
  return rank;
}

}  // namespace

void PatchPoints::keep_within(double gap) {
  if (std::all_of(pairs_.begin(), pairs_.end(), [gap](const GapPair& pair) { return pair.gap <= gap; }))
    return;
  other_.clear();
  const std::size_t count = pairs_.size();
  for (std::size_t i = 0; i < count; ++i) {
    const GapPair &at = pairs_[i], &next = pairs_[(i + 1) % count];
    const bool is_in = at.gap <= gap, goes_in = next.gap <= gap;
    if (is_in) other_.push_back(at);
    const bool has_edge = count > 2 || (count == 2 && i == 0);
    if (!has_edge || is_in == goes_in) continue;
    other_.push_back(between(at, next, (gap - at.gap) / (next.gap - at.gap)));
  }
  std::swap(pairs_, other_);
}

double PatchPoints::least_gap() const {
  double least = __builtin_inf();
  for (const GapPair& pair : pairs_) least = std::min(least, pair.gap);
  return least;
}

void PatchPoints::weigh(const Vector3& normal, std::int32_t i, double widest, double margin) {
  constexpr double kNearer = 8, kLargest = std::numeric_limits<double>::max();
  const GapPair& here = at(i);
  const Vector3 &x = here.pair.point_1, &before = at(here.before).pair.point_1,
                &after = at(here.after).pair.point_1;
  const double area = std::fabs(dot(normal, cross(x - before, after - before)));
  const double nearer = margin > 0 ? (widest - here.gap) / margin : 0.0;
  losses_.open(i, std::min(kLargest, area * here.rank * (1 + kNearer * nearer)));  // also of no number
}

void PatchPoints::reduce(const Vector3& normal, int most, double margin) {
  const auto count = static_cast<std::int32_t>(pairs_.size());
  if (count <= most) return;
  double widest = -__builtin_inf();
  for (std::int32_t i = 0; i < count; ++i) {
    GapPair& pair = at(i);
    widest = std::max(widest, pair.gap);
    pair.rank = rank_of(pair.pair.index);
    pair.before = i > 0 ? i - 1 : count - 1;
    pair.after = i + 1 < count ? i + 1 : 0;
  }
  losses_.clear();
  losses_.resize(count);
  for (std::int32_t i = 0; i < count; ++i) weigh(normal, i, widest, margin);
  for (std::int32_t left = count; left > most; --left) {
    const std::int32_t gone = losses_.least().facet;
    const GapPair& pair = at(gone);
    losses_.close(gone);
    at(pair.before).after = pair.after;
    at(pair.after).before = pair.before;
    for (const std::int32_t i : {pair.before, pair.after}) weigh(normal, i, widest, margin);
    at(gone).before = kGone;
  }
  std::erase_if(pairs_, [](const GapPair& pair) { return pair.before == kGone; });
}

}  // namespace raygauge
