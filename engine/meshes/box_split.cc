// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/meshes/box_split.h"

#include <algorithm>
#include <array>
#include <limits>

namespace raygauge {
namespace {

using Items = std::span<const SplitItem>;

constexpr int kBins = 16;
constexpr float kHuge = std::numeric_limits<float>::infinity();

struct Bounds {
  float low[3] = {kHuge, kHuge, kHuge}, high[3] = {-kHuge, -kHuge, -kHuge};

  void add(const float* at, const float* half) {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], at[k] - half[k]);
      high[k] = std::max(high[k], at[k] + half[k]);
    }
  }
  void add(const Bounds& other) {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], other.low[k]);
      high[k] = std::max(high[k], other.high[k]);
    }
  }
  float surface() const {
    const float x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
    return x * y + y * z + z * x;
  }
};

Bounds bounds_of_centers(Items items) {
  constexpr float kNone[3] = {0, 0, 0};
  Bounds bounds;
  for (const SplitItem& item : items) bounds.add(item.center, kNone);
  return bounds;
}

/// Some of the items that follow one another along an axis.
struct Run {
  Bounds bounds;
  std::ptrdiff_t count = 0;
};

/// The best cut between two runs.
class Cut {
 public:
  Cut(std::ptrdiff_t items, std::ptrdiff_t unit) : items_(items), unit_(unit) {}

  void look(int axis, std::span<const Run> runs) {
    std::array<float, kBins> above{};
    Bounds bounds;
    for (std::size_t i = runs.size() - 1; i > 0; --i) {
      bounds.add(runs[i].bounds);
      above[i] = bounds.surface();
    }
    bounds = {};
    std::ptrdiff_t count = 0;
    for (std::size_t i = 1; i < runs.size(); ++i) {
      bounds.add(runs[i - 1].bounds);
      count += runs[i - 1].count;
      if (count == 0 || count == items_) continue;
      const float cost =
          bounds.surface() * static_cast<float>(count) + above[i] * static_cast<float>(items_ - count);
      if (!(cost < cost_)) continue;
      cost_ = cost;
      const std::ptrdiff_t most = (items_ - 1) / unit_;  // units before a cut
      best_ = {axis, std::clamp((count + unit_ / 2) / unit_, std::ptrdiff_t{1}, most) * unit_};
    }
  }

  const BoxSplit& best() const { return best_; }

 private:
  std::ptrdiff_t items_, unit_;
  float cost_ = kHuge;
  BoxSplit best_;
};

void look_in_bins(Items items, const Bounds& centers, int axis, Cut& cut) {
  std::array<Run, kBins> runs;
  const float low = centers.low[axis], scale = static_cast<float>(kBins) / (centers.high[axis] - low);
  if (!(scale < kHuge)) return;
  for (const SplitItem& item : items) {
    const int bin = std::clamp(static_cast<int>((item.center[axis] - low) * scale), 0, kBins - 1);
    Run& run = runs[static_cast<std::size_t>(bin)];
    run.bounds.add(item.center, item.half);
    ++run.count;
  }
  cut.look(axis, runs);
}

}  // namespace

BoxSplit middle_split(Items items, std::ptrdiff_t unit) {
  const Bounds centers = bounds_of_centers(items);
  BoxSplit split;
  for (int k = 1; k < 3; ++k) {
    if (centers.high[k] - centers.low[k] > centers.high[split.axis] - centers.low[split.axis]) split.axis = k;
  }
  split.first = (std::ssize(items) + unit - 1) / unit / 2 * unit;
  return split;
}

BoxSplit best_split(Items items, std::ptrdiff_t unit) {
  Cut cut(std::ssize(items), unit);
  const Bounds centers = bounds_of_centers(items);
  for (int axis = 0; axis < 3; ++axis) look_in_bins(items, centers, axis, cut);
  return cut.best().first > 0 ? cut.best() : middle_split(items, unit);
}

}  // namespace raygauge
