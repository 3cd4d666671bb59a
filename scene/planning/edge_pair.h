// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>

#include "raygauge/numerics/vector3.h"
#include "scene/planning/edge_bodies.h"

namespace raygauge {

/// A body of the robot and another one, of the robot too or an obstacle, seen from the last link that carries
/// both.
struct EdgePair {
  int a = 0, b = 0;
  int carrier = -1;                            ///< that link; -1: the scene
  std::size_t left_out_a = 0, left_out_b = 0;  ///< joints up to that link
};

/// Between two moments a function of time is at least (1-s) first + s last - 4 s (1-s) sag - drift.
struct Sagging {
  double sag = 0, drift = 0;
};

/// A lower bound on that.
double least_between(double first, double last, const Sagging& sagging) noexcept;

/// Two shapes of a pair from one moment to a later one (the same one: at that time), tested for being farther
/// apart than some margin all the time. What a test says is proven; that it says no means nothing.
class EdgeTests {
 public:
  EdgeTests(const RobotChain& chain, std::vector<EdgeBody>& bodies, const EdgeStage& stage)
      : chain_(chain), bodies_(bodies), stage_(stage) {}

  /// The bounds of shapes belong to this edge from now on.
  void begin_edge() noexcept { ++edge_; }

  /// By bounding balls, and by the boxes of obstacles that stand.
  bool balls_apart(const EdgePair& pair, std::size_t shape_a, std::size_t shape_b, int first, int last,
                   double margin);

  /// At one moment: the distance is more than this, by planes across the unit vector u of the carrier;
  /// -infinity where they prove nothing.
  double planes_apart(const EdgePair& pair, std::size_t shape_a, std::size_t shape_b, int moment,
                      const Eigen::Vector3d& u) const;

  /// How far their bounding balls are apart at one moment, but for rounding.
  double ball_gap(const EdgePair& pair, std::size_t shape_a, std::size_t shape_b, int moment) const;

  /// Less for shapes that are more likely to be in contact at one moment: how far the middle of the one is
  /// from the box of an obstacle that stands, or the middles from each other, but for how thick the shapes
  /// are. No bound.
  double likely_gap(const EdgePair& pair, std::size_t shape_a, std::size_t shape_b, int moment) const;

  /// By how much that may sag, and how much the distance of points of both bodies.
  Sagging sagging(const EdgePair& pair, std::size_t shape_a, std::size_t shape_b, int first, int last);

  /// How far points of both shapes may be from where they were computed, together, at most.
  double slack(const EdgePair& pair, std::size_t shape_a, std::size_t shape_b, int moment) const;

  /// What computed gaps of two shapes may lose at one moment: slack() and rounding.
  double loss(const EdgePair& pair, std::size_t shape_a, std::size_t shape_b, int moment) const;

  /// Both bodies at one moment, seen from the carrier: x of the first one is at R_a x, x of the second one at
  /// R_b x + way.
  void stand(const EdgePair& pair, int moment, Matrix3& R_a, Matrix3& R_b, Vector3& way) const;

  /// A vector of the carrier in the scene, and back.
  Eigen::Vector3d to_scene(const EdgePair& pair, int moment, const Eigen::Vector3d& u) const;
  Eigen::Vector3d to_carrier(const EdgePair& pair, int moment, const Eigen::Vector3d& u) const;

 private:
  const EdgeBody& body(int i) const { return bodies_[static_cast<std::size_t>(i)]; }
  EdgeShape& measured(int body, std::size_t shape);
  bool box_apart(const EdgeBody& a, const EdgeShape& one, const EdgeBody& b, const EdgeShape& other,
                 int first, int last, double enough) const;

  const RobotChain& chain_;
  std::vector<EdgeBody>& bodies_;
  const EdgeStage& stage_;
  std::int64_t edge_ = 0;
};

}  // namespace raygauge
