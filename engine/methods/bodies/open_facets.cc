// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/bodies/open_facets.h"

#include "engine/numerics/fused.h"

namespace raygauge {

// Half a row at a time, as not all machines have longer vectors.
RAYGAUGE_VECTORS OpenFacets::Least OpenFacets::find_least(const Row* rows, std::size_t count) noexcept {
  using Pack [[gnu::vector_size(sizeof(Row) / 2), gnu::may_alias]] = double;
  Pack best = Pack{} + kClosed, at = Pack{} + kNone, number = {0, 1, 2, 3};
  Pack best_2 = best, at_2 = at;
  for (std::size_t i = 0; i < count; ++i) {
    const Pack here = *reinterpret_cast<const Pack*>(rows[i].value);
    const Pack here_2 = *reinterpret_cast<const Pack*>(rows[i].value + kLanes / 2);
    at = here < best ? number : at;
    best = here < best ? here : best;
    at_2 = here_2 < best_2 ? number : at_2;
    best_2 = here_2 < best_2 ? here_2 : best_2;
    number += static_cast<double>(kLanes);
  }
  constexpr double kHalf = 0.5 * kLanes;
  at = best_2 < best ? at_2 + kHalf : at;
  best = best_2 < best ? best_2 : best;
  Pack other = __builtin_shufflevector(best, best, 2, 3, 0, 1);
  at = other < best ? __builtin_shufflevector(at, at, 2, 3, 0, 1) : at;
  best = other < best ? other : best;
  other = __builtin_shufflevector(best, best, 1, 0, 3, 2);
  at = other < best ? __builtin_shufflevector(at, at, 1, 0, 3, 2) : at;
  best = other < best ? other : best;
  return {best[0], static_cast<std::int32_t>(at[0])};
}

OpenFacets::Least OpenFacets::least() const noexcept { return find_least(rows_.data(), rows_.size()); }

}  // namespace raygauge
