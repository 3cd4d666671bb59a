// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/render/report/blocks.h"

#include <cmath>

#include "engine/numerics/number_text.h"
#include "results/text/number_words.h"

namespace raygauge::report {

Facets problem_facets(const CellKey& cell) {
  return {{"problem", problem_name(cell)}, {"tolerance", rounded_text(cell.tolerance, 3)}};
}

std::string time_words(double seconds) {
  constexpr int kShown = 3;
  if (!std::isfinite(seconds)) return "unsolved";
  constexpr double kMilli = 1e-3;
  constexpr double kMicro = 1e-6;
  if (seconds >= 1) return padded_significant(seconds, kShown) + " s";
  if (seconds >= kMilli) return padded_significant(seconds / kMilli, kShown) + " ms";
  return padded_significant(seconds / kMicro, kShown) + " µs";
}

}  // namespace raygauge::report
