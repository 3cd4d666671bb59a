// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "bench/bin.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"

namespace raygauge::bench {

Bin::Bin(int bodies, double seconds, double step, double tolerance) {
  scene_.name = "bin";
  scene_.instants = {0, seconds};
  dynamics_.gravity = Eigen::Vector3d(0, 0, -9.81);
  dynamics_.contact = ContactLaw{0.5, std::nullopt};
  dynamics_.step = step;
  dynamics_.tolerance = tolerance;
  const int side = std::max(4, static_cast<int>(std::lround(std::cbrt(bodies) * 1.2)));
  add_bin(0.125 * side + 0.15);
  for (int k = 0; k < bodies; ++k) add_thrown(k, side);
}

void Bin::add(std::shared_ptr<const ConvexSet> set, const Placement& at) {
  scene_.bodies.push_back(make_body("b" + std::to_string(scene_.bodies.size()), {std::move(set)},
                                    std::make_shared<StaticMotion>(at)));
  dynamics_.bodies.emplace_back();
}

void Bin::add_standing(const Point& low, const Point& high) {
  add(std::make_shared<Box>(low, high),
      {SmallMatrix(Eigen::Matrix3d::Identity()), SmallVector(Point::Zero())});
}

void Bin::add_bin(double w) {
  add_standing({-w, -w, -0.2}, {w, w, 0});
  add_standing({-w - 0.2, -w, 0}, {-w, w, 2});
  add_standing({w, -w, 0}, {w + 0.2, w, 2});
  add_standing({-w, -w - 0.2, 0}, {w, -w, 2});
  add_standing({-w, w, 0}, {w, w + 0.2, 2});
}

void Bin::add_thrown(int number, int side) {
  const int row = number / side % side, layer = number / (side * side);
  const Point place(0.25 * (number % side - 0.5 * (side - 1)) + uniform(0.01),
                    0.25 * (row - 0.5 * (side - 1)) + uniform(0.01), 0.15 + 0.25 * layer);
  const Eigen::Matrix3d R =
      Eigen::Quaterniond(uniform(1), uniform(1), uniform(1), uniform(1)).normalized().toRotationMatrix();
  std::shared_ptr<const ConvexSet> set =
      std::make_shared<Box>(Point(-0.07, -0.06, -0.05), Point(0.07, 0.06, 0.05));
  if (number % 3 == 1) set = std::make_shared<Ball>(Point(0, 0, 0), 0.08);
  if (number % 3 == 2) set = std::make_shared<Capsule>(Point(0, 0, -0.05), Point(0, 0, 0.05), 0.05);
  add(set, {SmallMatrix(R), SmallVector(place)});
  dynamics_.bodies.back() = reacting_body(scene_.bodies.back(), std::nullopt, 1000);
}

}  // namespace raygauge::bench
