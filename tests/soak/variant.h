// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "tests/soak/proven_instance.h"

namespace raygauge::soak {

/// A change of a proven instance after which its proof still holds, so that its distance is known exactly:
///
///   - points without weight in the proof are dropped, moved by 1e-16 to 1e-1 of themselves, or moved away
///     from (A) or towards (Q) the origin by a power of two, where the dual half of the proof allows it;
///   - points are repeated and shuffled;
///   - axes are permuted, reflected, scaled by powers of two (up to 2^40 ≈ 1e12 apart), and sheared by
///     x_i ± x_j where no coordinate is rounded;
///   - both sets, or A alone, are scaled by a power of two.
class Variant {
 public:
  /// Makes the variant of `base` that `stream` asks for.
  void make(const ProvenInstance& base, RandomStream& stream);

  const Eigen::MatrixXd& A() const noexcept { return A_; }
  const Eigen::MatrixXd& Q() const noexcept { return Q_; }

  /// d of the variant is 2^shift() times that of the base.
  int shift() const noexcept { return shift_; }

 private:
  void choose_points(const ProvenInstance& base, RandomStream& stream);
  void move_points(const ProvenInstance& base, RandomStream& stream);
  void turn_axes(RandomStream& stream);
  void shear(RandomStream& stream);
  void scale_axes(RandomStream& stream);
  void scale_sets(RandomStream& stream);

  Eigen::MatrixXd A_;
  Eigen::MatrixXd Q_;
  std::vector<Eigen::Index> from_A_;  // the base's point that a column comes from
  std::vector<Eigen::Index> from_Q_;
  Vector point_;
  int shift_ = 0;
};

}  // namespace raygauge::soak
