// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <vector>

#include "bench/loaded_library.h"
#include "bench/pair_bodies.h"

namespace raygauge::bench {

/// One query of the pairs of a row, ours and the library's: microseconds of processor time.
struct LibraryTally {
  std::vector<double> ours, theirs;  ///< from a cold start
  std::vector<double> ours_warm,
      theirs_warm;    ///< after the motion; empty where the library has no warm start
  int pairs = 0;      ///< that the query makes sense for
  int certified = 0;  ///< ... of which ours is proven to the tolerance
  int wrong =
      0;  ///< answers of the library off by more than 1e-5 of the size (growth: of the value), or none
  double worst = 0;  ///< by how much they are off
};

using LibraryTallies = std::array<LibraryTally, RAYGAUGE_QUERIES>;

/// Asks one pair for its distance if it is apart, for its depth if it overlaps, and for its growth distance
/// about the centres; both sides take turns.
void measure_beside(const raygauge_pair_library& library, const PosedPair& pair, double tolerance,
                    LibraryTallies& tallies);

/// The table: a line for each row and query, and what the ratios come to.
class LibraryTable {
 public:
  /// Loads the adapter and prints the head. Throws what LoadedLibrary throws.
  explicit LibraryTable(const std::string& path);

  const raygauge_pair_library& library() const { return loaded_.functions(); }
  void print(const std::string& row, const LibraryTallies& tallies);

  /// Geometric mean and largest ratio of each query, cold and warm.
  void print_summary() const;

 private:
  struct Ratios {
    std::vector<double> cold, warm;
  };
  LoadedLibrary loaded_;
  std::array<Ratios, RAYGAUGE_QUERIES> ratios_;
};

}  // namespace raygauge::bench
