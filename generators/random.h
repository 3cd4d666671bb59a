// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "raygauge/sweep/instance.h"

namespace raygauge {

/// What a stream of random numbers is for. Streams of different purposes are independent, so that drawing
/// more of one thing never changes another.
enum class RandomPurpose : std::uint64_t {
  points_of_A = 1,
  points_of_Q = 2,
  placement = 3,  ///< where A lies
  shape = 4,      ///< stretches, maps, cluster centres
  order = 5,      ///< permutations
};

/// A sequence of random numbers that is a pure function of (seed, generator's name, n, N, repetition,
/// purpose):
///
///     block b  =  Philox4x64-10(counter = (b, purpose, n + 2^32 N, repetition), key = (seed,
///     hash(generator))),
///
/// four 64-bit words each (Salmon et al., "Parallel random numbers: as easy as 1, 2, 3", SC 2011). There is
/// no hidden state, so instances do not depend on the order or the thread in which they are made. All derived
/// numbers use + - * / √ and exact operations alone: the same bits on every IEEE 754 machine. Generator
/// parameters are not part of the key: instances that differ in a parameter share their random numbers.
class RandomStream {
 public:
  RandomStream(const InstanceKey& key, std::string_view generator, RandomPurpose purpose);

  /// 64 random bits.
  std::uint64_t bits();

  /// Uniform on {0, 1, …, 2^53 - 1} / 2^53, within [0, 1).
  double uniform();

  /// Uniform on {first, …, last}. Throws InvalidParameterError if first > last.
  std::int64_t integer(std::int64_t first, std::int64_t last);

  /// Standard normal (Marsaglia's polar method).
  double normal();

  /// Uniform on the unit sphere of R^n. Throws InvalidParameterError unless n >= 1.
  Vector unit_vector(int n);

  /// Uniform (Haar) on SO(n), the rotations of R^n. Throws InvalidParameterError unless n >= 1.
  Eigen::MatrixXd rotation(int n);

  /// Uniform on the permutations of 0, …, size-1 (Fisher and Yates).
  std::vector<std::ptrdiff_t> permutation(std::ptrdiff_t size);

 private:
  void refill();

  std::uint64_t key_[2];
  std::uint64_t counter_[4];
  std::uint64_t words_[4] = {};
  int words_left_ = 0;
  double spare_normal_ = 0;
  bool has_spare_normal_ = false;
};

/// 64-bit FNV-1a of a name: fixed for ever, unlike std::hash.
std::uint64_t stable_hash(std::string_view name);

}  // namespace raygauge
