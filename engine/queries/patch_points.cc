// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/patch_points.h"

#include <algorithm>
#include <cmath>

namespace raygauge {
namespace {

GapPair between(const GapPair& a, const GapPair& b, double share) {
  const auto mix = [share](const Vector3& p, const Vector3& q) { return p + (q - p) * share; };
  return {{mix(a.pair.point_1, b.pair.point_1), mix(a.pair.point_2, b.pair.point_2), -1},
          a.gap + (b.gap - a.gap) * share,
          0,
          0};
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

double PatchPoints::loss(const Vector3& normal, std::size_t i, double widest, double margin) const {
  constexpr double kNearer = 8;
  const std::size_t count = pairs_.size();
  const Vector3 &at = pairs_[i].pair.point_1, &before = pairs_[(i + count - 1) % count].pair.point_1,
                &after = pairs_[(i + 1) % count].pair.point_1;
  const double area = std::fabs(dot(normal, cross(at - before, after - before)));
  const double nearer = margin > 0 ? (widest - pairs_[i].gap) / margin : 0.0;
  return area * pairs_[i].rank * (1 + kNearer * nearer);
}

void PatchPoints::reduce(const Vector3& normal, int most, double margin) {
  if (static_cast<int>(pairs_.size()) <= most) return;
  double widest = -__builtin_inf();
  for (const GapPair& pair : pairs_) widest = std::max(widest, pair.gap);
  for (GapPair& pair : pairs_) pair.rank = rank_of(pair.pair.index);
  for (std::size_t i = 0; i < pairs_.size(); ++i) pairs_[i].loss = loss(normal, i, widest, margin);
  while (static_cast<int>(pairs_.size()) > most) {
    const auto least = std::min_element(pairs_.begin(), pairs_.end(),
                                        [](const GapPair& a, const GapPair& b) { return a.loss < b.loss; });
    const std::size_t at = static_cast<std::size_t>(pairs_.erase(least) - pairs_.begin());
    const std::size_t count = pairs_.size();
    for (const std::size_t i : {(at + count - 1) % count, at % count})
      pairs_[i].loss = loss(normal, i, widest, margin);
  }
}

}  // namespace raygauge
