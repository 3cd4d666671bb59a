// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "raygauge/sweep/instance.h"

namespace raygauge {

/// A hard family with a known distance, and the dimensions to try it in.
struct HardCase {
  std::string generator;
  Parameters parameters;
  int largest_n = 50;
  bool rounded = false;  ///< the exact distance is no double: the generator's is one beside it
  int certified_n = 20;  ///< up to this n every method must certify it to 1e-12
};

/// Every hard family of point sets with an exact distance, in the variants that differ in kind.
std::vector<HardCase> hard_cases();

/// The same for balls of several norms and bodies of revolution.
std::vector<HardCase> smooth_hard_cases();

/// Families whose distance no formula gives, meant for dimensions up to 8 and more.
std::vector<HardCase> hard_cases_of_unknown_distance();

/// The dimensions among 2, 3, 5, 8, 20, 50 that the case goes up to, as far as `limit`.
std::vector<int> dimensions_of(const HardCase& tested, int limit);

/// A name for a test: letters, digits and underscores.
std::string label(const HardCase& tested);

inline std::ostream& operator<<(std::ostream& out, const HardCase& tested) { return out << label(tested); }

}  // namespace raygauge
