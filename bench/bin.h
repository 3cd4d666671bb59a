// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <random>

#include "raygauge/simulation.h"

namespace raygauge::bench {

/// Boxes, balls and capsules in turn, dropped into a bin with friction.
class Bin {
 public:
  Bin(int bodies, double seconds, double step = 1e-3, double tolerance = 1e-4);

  const Scene& scene() const { return scene_; }
  const Dynamics& dynamics() const { return dynamics_; }

 private:
  using Point = Eigen::Vector3d;

  double uniform(double size) { return std::uniform_real_distribution<double>(-size, size)(random_); }
  void add(std::shared_ptr<const ConvexSet> set, const Placement& at);
  void add_standing(const Point& low, const Point& high);
  void add_bin(double w);
  void add_thrown(int number, int side);

  std::mt19937_64 random_{3};
  Scene scene_;
  Dynamics dynamics_;
};

}  // namespace raygauge::bench
