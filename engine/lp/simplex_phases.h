// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace raygauge {

/// How a simplex that begins with artificial columns ended.
enum class SimplexEnd : std::uint8_t {
  solved,       ///< no point prices out, or the gap is small enough
  unreachable,  ///< no multiple of Q meets A: the duals are a Farkas direction, with a margin where the
                ///< arithmetic asks for one
  failed,       ///< not even these digits decide, or there were too many pivots
  stopped,      ///< by the stopwatch, in the middle of anything; nothing is known
  too_long,     ///< not begun: what it is expected to take is more than the stopwatch leaves
};

/// Artificial columns are driven out; a direction that leaves Q behind by a margin is looked for, which is a
/// negative cost of its points; Σβ is minimised.
enum class SimplexPhase : std::uint8_t { reach, separate, optimise };

/// The phases of the simplex method, in whatever arithmetic `program` has its basis. It gives
///
///     price()        the point that shall enter, -1 where none does,
///     enter(id)      a pivot; false where rounding leaves none, or time,
///     refresh()      prices and weights from a new factorisation; false where they are so already,
///     separate()     on to that phase; false where the direction at hand is a proof,
///
/// and phase(), begin(phase), has_reached(): no artificial column has weight, pivots(), is_late().
template <class Program>
SimplexEnd run_phases(Program& program, std::int64_t most_pivots) {
  for (;;) {
    const std::int64_t entering = program.price();
    if (program.is_late()) return SimplexEnd::stopped;
    if (entering >= 0 && program.pivots() < most_pivots && program.enter(entering)) {
      if (program.phase() == SimplexPhase::reach && program.has_reached())
        program.begin(SimplexPhase::optimise);
      continue;
    }
    if (program.is_late()) return SimplexEnd::stopped;
    if (program.refresh()) continue;
    if (entering >= 0) return SimplexEnd::failed;
    if (program.phase() == SimplexPhase::optimise) return SimplexEnd::solved;
    const bool has_reached = program.has_reached();
    if (program.phase() == SimplexPhase::separate)
      return has_reached ? SimplexEnd::failed : SimplexEnd::unreachable;
    if (has_reached) {
      program.begin(SimplexPhase::optimise);
    } else if (!program.separate()) {
      return SimplexEnd::unreachable;
    }
  }
}

}  // namespace raygauge
