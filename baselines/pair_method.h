// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "raygauge/sweep/method.h"

namespace raygauge {

/// What a collision library says of two bodies.
struct PairAnswer {
  /// The distance, zero or less where the bodies meet; whether they are separated: the same, or any number
  /// above 0 for yes; the depth, zero or less where they are apart; the growth distance. NaN: the library
  /// says that it failed.
  double value = DistanceResult::kUnset;
  /// Along the shortest way from the first body to the second, or for the second to get out; 0: not told.
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
};

/// A pair of bodies of R^3 inside a library.
class BodyPair {
 public:
  virtual ~BodyPair() = default;

  /// One call of the library, from a cold start. What it throws (std::exception) counts as no answer.
  virtual PairAnswer answer(Quantity quantity, double tolerance) = 0;
};

/// A collision library as a competitor.
struct PairLibrary {
  std::string name, description;
  std::vector<ParameterInfo> parameters;
  std::string takes;                 ///< "balls, boxes, …": of which bodies it makes pairs
  std::vector<Quantity> quantities;  ///< what its pairs answer
  /// The pair, or nullptr where the library has no such body. The sets outlive it.
  std::function<std::unique_ptr<BodyPair>(const ConvexSet& first, const ConvexSet& second, const Parameters&)>
      make;
};

/// The library as a method. Q is a ball of R^3 about the origin, and A = A2 - A1 a MinkowskiDifference of two
/// bodies, or one body, whose distance from the origin is asked for. Loading makes the library's bodies; a
/// solve is one call. `distance` and `status` are the library's claim: 0 and contains_origin where it finds
/// the bodies to meet, precision_limit where it throws or fails. `lower` is certified by raygauge from the
/// library's direction u, -h_A(u), rounded down, 0 where that proves nothing; `upper` is NaN, for a point
/// that a library names need not be in its body. Of a depth `upper` is certified, h_A(u), and `lower` is 0.
/// There is no time limit.
Component<SolveMethod> pair_component(PairLibrary library);

}  // namespace raygauge
