// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "engine/kernels/kernel.h"
#include "engine/numerics/aligned_buffer.h"
#include "engine/threads/helpers.h"

namespace raygauge {

/// The points of one set in InteriorPoint, with their weights and slacks, at the end of the last block filled
/// up.
struct InteriorSide {
  PricedPoints points;
  std::size_t size = 0;   ///< points
  std::size_t lanes = 0;  ///< in either precision
  double sign = 1;        ///< of the coordinates in the program: 1 of A, -1 of Q
  double last = 0;        ///< entry of the columns in the convexity row
  AlignedBuffer<double> x;
  AlignedBuffer<double> s;
  AlignedBuffer<double> dx;
  AlignedBuffer<double> ds;
  AlignedBuffer<double> kept_dx;
  AlignedBuffer<double> kept_ds;
  AlignedBuffer<double> target;  ///< of x·s
  AlignedBuffer<double> weight;

  void bind(const PricedPoints& of, double sign_of_them);
  bool is_A() const noexcept { return sign > 0; }
  std::int64_t id(std::size_t i) const noexcept {
    const auto position = static_cast<std::ptrdiff_t>(i);
    return is_A() ? id_of_A(position) : id_of_Q(position);
  }
};
using InteriorSides = std::array<InteriorSide, 2>;  ///< A and Q

/// The passes over all points, which threads share: in single precision at first, then over the points as
/// they are.
class InteriorPasses {
 public:
  void begin(int n, bool single, const Kernels& kernels);
  void share_with(const Helpers& helpers) noexcept { helpers_ = helpers; }
  const Helpers& helpers() const noexcept { return helpers_; }

  /// Whether products in single precision suffice.
  bool is_single() const noexcept { return single_; }

  /// From here on of the points as they are. Where those leave too little of a slack, u becomes shorter and t
  /// less.
  void leave_single(InteriorSides& sides, double* y);

  /// u·p for every point.
  void price(const InteriorSide& side, const double* u, double* products) const;

  /// s = c - Aᵀy, c = 0 of A and 1 of Q.
  void compute_slacks(InteriorSide& side, const double* y) const;

  /// sum += Σ weight_i p_i.
  void add_weighted(const InteriorSide& side, double* sum);

 private:
  bool reads_single(const InteriorSide& side) const noexcept {
    return single_ && side.points.single_blocks != nullptr;
  }
  template <class Work>
  int share(const InteriorSide& side, const Work& work) const;

  int n_ = 0;
  bool single_ = false;
  const Kernels* kernels_ = nullptr;
  Helpers helpers_;
  AlignedBuffer<double> scratch_;  // of the kernel
};

}  // namespace raygauge
