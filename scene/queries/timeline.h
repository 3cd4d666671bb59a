// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

#include "raygauge/scene/scene.h"

namespace raygauge {

/// Placement of every body at every instant and bounds on its motion: computed once, shared by all pairs and
/// threads.
///
/// Between instants j < k every point of body b moves by at most moved(b, k) - moved(b, j), rounded up; the
/// centre of its bounding ball by at most shifted(b, k) - shifted(b, j).
class Timeline {
 public:
  /// Bodies are shared between `threads` threads. Once `stop` is true the rest is left out.
  explicit Timeline(const Scene& scene, int threads = 1, const std::function<bool()>& stop = {});

  std::size_t size() const noexcept { return size_; }

  Placement placement(int body, std::size_t k) const;

  /// The middle of the body's bounding ball, as many numbers as there are dimensions.
  const double* center(int body, std::size_t k) const {
    return centers_.get() + index(body, k) * static_cast<std::size_t>(dimension_);
  }

  double moved(int body, std::size_t k) const { return moved_[index(body, k)]; }
  double shifted(int body, std::size_t k) const { return shifted_[index(body, k)]; }

  /// The greatest k >= from such that both bodies together have moved less than `budget` at every instant
  /// from `from` on; with `balls`, that the middles of their balls have shifted so. At least `from`.
  std::size_t last_within(BodyPair pair, std::size_t from, double budget, bool balls) const;

 private:
  void follow(const Scene& scene, std::size_t body, const std::function<bool()>& stop);
  std::size_t index(int body, std::size_t k) const { return static_cast<std::size_t>(body) * size_ + k; }

  std::size_t numbers_of_placement() const {
    const auto n = static_cast<std::size_t>(dimension_);
    return n * (n + 1) + 1;
  }

  int dimension_;
  std::size_t size_;
  // Arrays that the threads are the first to write to.
  std::unique_ptr<double[]> placements_;  // R by columns, then t, then the defect of R
  std::unique_ptr<double[]> centers_;
  std::unique_ptr<double[]> moved_, shifted_;
};

}  // namespace raygauge
