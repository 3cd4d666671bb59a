// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "raygauge/numerics/instruction_set.h"

namespace raygauge {

/// How d_Q(A) is computed. All methods end in the same certificate.
enum class DistanceMethod : std::uint8_t {
  automatic,          ///< one of those below, by the sets: method_for()
  column_generation,  ///< the linear program of Example 2, its columns from support mappings: no outer loop
  zheng_yamane,       ///< Algorithm 1 as published: scale Q by (10), shoot a ray, warm-start as in Fig. 3c
  newton,  ///< Newton steps on the dual with the Hessians of the support functions, Wolfe's steps where A is
           ///< a polytope and Q a ball about the origin; column generation where there are none
};

std::string_view to_string(DistanceMethod method) noexcept;

/// When a solve ends.
enum class StopRule : std::uint8_t {
  certified_gap,    ///< upper - lower <= tolerance * upper
  published_sigma,  ///< |σ_k - 1| < tolerance, the test of the paper (`zheng_yamane` only); the result
                    ///< reports the gap reached
};

/// Quantities besides the distance and its bounds. Only those requested are computed.
enum class Effects : std::uint8_t {
  none = 0,
  witness = 1,  ///< the contact point v of (15)
};

constexpr bool has_effect(Effects asked, Effects effect) noexcept {
  return (static_cast<unsigned>(asked) & static_cast<unsigned>(effect)) != 0;
}

/// Most threads that one solve may use.
inline constexpr int kMostThreads = 64;

/// Tunables of a DistanceSolver; the defaults below are the only ones.
struct DistanceOptions {
  DistanceMethod method = DistanceMethod::automatic;

  /// The solve stops when upper - lower <= tolerance * upper. In (0, 1).
  double tolerance = 1e-6;

  StopRule stop_rule = StopRule::certified_gap;

  /// Largest number of basis changes; 0 lets the solver choose from n (it is then a guard against stalling
  /// only).
  std::int64_t max_iterations = 0;

  /// Wall time in seconds. The clock is read about every 10 ms of work; a solve that finishes before the next
  /// reading returns its answer.
  double time_limit = std::numeric_limits<double>::infinity();

  /// Threads of one solve, 1 … kMostThreads. They share the passes of `column_generation` over point sets of
  /// 2^15 coordinates and more, and its interior-point method and inverses of bases in many dimensions;
  /// everything else is done by the caller's thread. Leave it at 1 where other solves keep the cores busy.
  int threads = 1;

  /// Kernels to run; anything but `automatic` throws InvalidParameterError where the machine lacks the
  /// instructions.
  InstructionSet instruction_set = InstructionSet::automatic;
};

/// What is wrong with `options`, the first thing in one line that begins with the name of the option:
/// "tolerance must lie in (0, 1), got 2"; empty if nothing is wrong. A solver throws InvalidParameterError
/// with this line.
std::string validate(const DistanceOptions& options);

}  // namespace raygauge
