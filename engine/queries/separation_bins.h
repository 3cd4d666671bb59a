// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "engine/kernels/kernel.h"
#include "engine/kernels/separation_lanes.h"
#include "raygauge/queries/pair_batch.h"

namespace raygauge {

/// Collects pairs of boxes, balls, capsules and hulls of few points of R^3, those of one kind to a vector,
/// and decides eight of them at a time: what the lanes prove is the answer, everything else is left
/// undecided.
class SeparationBins {
 public:
  explicit SeparationBins(InstructionSet isa) : kernels_(&kernels_for(isa)) {}

  /// Answers are for pairs added from now on; empty normals are not computed.
  void begin(const SeparationAnswers& answers);

  /// Pair i of the answers, bodies of R^3. Its numbers are copied. Nothing is done with other kinds.
  void add(const PosedPair& pair, std::size_t i);

  /// Decides the pairs of vectors that are not full.
  void finish();

 private:
  template <class Lanes>
  struct Bin {
    Lanes lanes{};
    void (*Kernels::*separate)(Lanes*) = nullptr;
    std::array<std::size_t, PairLanes::kCount> pair{};
    std::array<bool, PairLanes::kCount> swapped{};
    int count = 0;
  };
  using Points = std::array<std::array<int, PairLanes::kCount>, 2>;

  template <class Lanes>
  void begin(Bin<Lanes>& bin, void (*Kernels::*separate)(Lanes*));
  template <class Lanes>
  void place(Bin<Lanes>& bin, const Posed& one, const Posed& two, double radius, bool swapped, std::size_t i);
  void fill_up();
  template <class Lanes>
  void decide(Bin<Lanes>& bin);
  template <class Lanes>
  void put_normal(const Bin<Lanes>& bin, std::size_t lane);

  const Kernels* kernels_;
  SeparationAnswers answers_;
  std::array<Bin<SeparationLanes>, 3> bins_{};  // of pairs with 0, 1 and 2 boxes
  Bin<HullLanes> hulls_{};                      // of pairs with a hull
  Points points_{};                             // of both bodies of each of these
};

/// Asks for the cache lines that SeparationBins::add reads of a pair: of sets and poses, and then, when these
/// are there, of the numbers that sets keep elsewhere.
void prefetch_bodies(const PosedPair& pair) noexcept;
void prefetch_numbers(const PosedPair& pair) noexcept;

}  // namespace raygauge
