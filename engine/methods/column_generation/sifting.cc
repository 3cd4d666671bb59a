// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/column_generation/sifting.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "engine/lp/affords.h"
#include "engine/methods/column_generation/simplex_status.h"
#include "engine/methods/column_generation/tuning.h"
#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

// An objective that small, in units where both sets have magnitude 1, is zero or close to it: it is worth a
// look at the points of A.
constexpr double kNearlyZero = 1e-6;

int least_for_interior(const WorkingSets& sets) {
  const std::ptrdiff_t points = sets.A().set->size() + sets.Q().set->size();
  if (points <= tuned::kFewPointsPerDimension * sets.n()) return tuned::kInteriorOfFew;
  return points <= tuned::kManyPointsPerDimension * sets.n() ? tuned::kInteriorOfSome
                                                             : tuned::kInteriorOfMany;
}

}  // namespace

void Sifting::solve(const PointSet& A, const PointSet& Q, const DistanceOptions& options,
                    const Stopwatch& stopwatch, Effects effects, DistanceResult& result) {
  begin(A, Q, options);
  sets_.choose();
  const SiftingSolve solve = about(options, stopwatch, effects, result);
  start(solve);
  if (interior_.certify_separated(solve)) return;
  if (interior_.may_certify(sets_)) {
    if (interior_.certify(solve)) return;
    interior_.start(solve);  // what start() has put off
  }
  run(solve);
}

void Sifting::solve_restricted(const PointSet& A, const PointSet& Q, std::span<const std::int64_t> index_A,
                               std::span<const std::int64_t> index_Q, const DistanceOptions& options,
                               const Stopwatch& stopwatch, DistanceResult& result) {
  begin(A, Q, options);
  sets_.choose(index_A, index_Q);
  const SiftingSolve solve = about(options, stopwatch, Effects::none, result);
  start(solve);
  run(solve);
}

SiftingSolve Sifting::about(const DistanceOptions& options, const Stopwatch& stopwatch, Effects effects,
                            DistanceResult& result) {
  return {.sets = sets_,
          .program = program_,
          .face = face_,
          .plane = plane_,
          .last = last_,
          .tolerance = options.tolerance,
          .stopwatch = stopwatch,
          .effects = effects,
          .result = result};
}

void Sifting::begin(const PointSet& A, const PointSet& Q, const DistanceOptions& options) {
  sets_.begin(A, Q, options);
  sets_.counters().outer_iterations = 1;
  pivots_are_limited_ = options.max_iterations > 0;
  pivots_at_zero_ = pivots_at_repair_ = -1;
  interior_.begin(sets_);
  refined_.begin();
  plane_.forget();
  program_.basis().share_with(sets_.helpers());
  program_.begin(sets_.n(), 0.25 * options.tolerance, options.max_iterations, sets_.kernels(),
                 sets_.n() >= tuned::kLeastToStall);
}

// Where the interior-point method may prove the answer, no basis is made before it has tried.
void Sifting::start(const SiftingSolve& solve) {
  first_.guess(sets_);
  if (sets_.n() >= least_for_interior(sets_) && !first_.has_all_axes()) {
    interior_.run(solve, sets_.direction());
    if (interior_.may_certify(sets_)) return interior_.start_at_normal(solve);
    if (interior_.state() == InteriorProof::State::converged) return interior_.start(solve);
  }
  first_.start(sets_, program_);
}

// After a solve that ended for no answer: what is done about it.
Sifting::Next Sifting::leave_impasse(const SiftingSolve& solve, End end) {
  if (interior_may_help(end)) {
    return plane_.certify(solve) || finish_inside(solve) ? Next::done : Next::again;
  }
  if (end == End::stalled) {
    program_.be_patient();
    return Next::again;
  }
  if (end != End::bounded || !(sets_.is_complete() || sets_.is_restricted() || bounds_mislead())) {
    return Next::conclude;
  }
  program_.raise_bounds();
  return Next::again;
}

void Sifting::run(const SiftingSolve& solve) {
  const bool complete = sets_.is_complete(), restricted = sets_.is_restricted();
  const auto end_untold = [&] { write_answer(solve, DistanceStatus::precision_limit, 0, kInfinity); };
  for (;;) {
    const End end = program_.optimise(sets_.A().pool, sets_.Q().pool, solve.stopwatch);
    if (!restricted && certify_zero(solve)) return;
    const Next next = leave_impasse(solve, end);
    if (next == Next::done) return;
    if (next == Next::again) continue;
    const bool solved = end == End::solved;
    const bool trusted = trusts_simplex_ && solved;
    if (trusted && complete) return end_untold();
    if (solved && complete && certify_as_priced(solve)) return;
    if (solved) program_.basis().refresh_duals();
    const double estimate = program_.objective();
    double lower = 0;
    if (price_or_separate(solve, end, lower)) continue;
    const bool violated = sets_.has_violators();
    if (lower == kInfinity) return write_answer(solve, DistanceStatus::unreachable, lower, lower);
    // Proving the upper bound pays only when the gap can be closed, or nothing else is left to do.
    const bool open = estimate - lower > solve.tolerance * estimate;
    if (violated && !is_final(end) && !restricted && open) {
      prepare_next(end, true);
      continue;
    }
    if (trusted) return end_untold();
    const bool out_of_reach = end == End::unreachable || end == End::failed;
    if (out_of_reach && !restricted && plane_.certify(solve)) return;
    const double upper = prove_upper(solve, is_final(end) || restricted || (solved && !violated));
    if (upper == 0 || solve.closes(lower, upper)) return conclude(solve, lower, upper);
    if (!restricted && certify_refined(solve, end)) return;
    if (is_final(end) || restricted) return finish_short_of_tolerance(solve, end, lower, upper);
    // Where the lower bound is as good as asked for, what still prices out is rounding: the bounds on the
    // normal keep the answer open, not missing points.
    const bool points_are_missing = violated && (open || end != End::bounded);
    const bool again = !points_are_missing && end != End::bounded;
    const bool as_before = again && std::exchange(pivots_at_repair_, program_.pivots()) == program_.pivots();
    if (as_before || !prepare_next(end, points_are_missing))
      return finish_short_of_tolerance(solve, end, lower, upper);
  }
}

// `concluded`: there is no better basic solution to come.
double Sifting::prove_upper(const SiftingSolve& solve, bool concluded) {
  by_face_ = false;
  if (!affords_inverse(solve.stopwatch, sets_.n() + 1, sets_.kernels())) return kInfinity;
  double upper = program_.proven_upper();
  if (upper < kInfinity || !concluded) return upper;
  if (sets_.n() >= tuned::kLeastToStall) upper = face_.upper(solve);
  by_face_ = upper < kInfinity;
  return by_face_ ? upper : refined_.upper_despite_residual(solve);
}

void Sifting::conclude(const SiftingSolve& solve, double lower, double upper) {
  if (by_face_) return face_.write(solve, lower, upper);
  if (upper > 0) return write_answer(solve, DistanceStatus::optimal, lower, upper);
  write_answer(solve, DistanceStatus::contains_origin, 0, 0);
  last_.write_origin_weights(solve);
}

// The lower bound of the normal at hand. The normal of a program without a solution is tight at a vertex of
// Q: h_Q is zero, but for rounding. True where the program can look for one that separates by a margin
// instead.
bool Sifting::price_or_separate(const SiftingSolve& solve, End end, double& lower) {
  const bool roughly = end == End::unreachable && !sets_.is_restricted();
  lower = solve.sets.price(program_, roughly);
  if (!roughly || lower == kInfinity || sets_.has_violators()) return false;
  if (!plane_.has_direction()) plane_.take(program_.normal(), sets_.n());
  if (program_.separate()) return true;
  lower = solve.sets.price(program_, false);
  return false;
}

// What the program's next solve has and the last one had not: points, wider bounds on the normal, a fresh
// inverse. False when nothing is left to try.
bool Sifting::prepare_next(End end, bool points_are_missing) {
  if (points_are_missing) {
    sets_.add_violators();
    program_.allow_repairs();
  } else if (end == End::bounded) {
    program_.raise_bounds();
  } else {
    return program_.repair();
  }
  return true;
}

// The simplex loop ends right after a pricing. Of complete sets in place its values bound the distance as
// well as those of one more pass at better duals would, if that is good enough.
bool Sifting::certify_as_priced(const SiftingSolve& solve) {
  const std::optional<double> lower = sets_.bound_as_priced(program_);
  if (!lower) return false;
  const double upper = program_.proven_upper();
  if (upper == 0 || !solve.closes(*lower, upper)) return false;  // 0 is another status
  sets_.counters().support_queries += 2;
  write_answer(solve, DistanceStatus::optimal, *lower, upper);
  return true;
}

// Where the objective is zero but for rounding, whatever the simplex is at: it may need many basis changes
// more, without a gain, until no artificial column is left.
bool Sifting::certify_zero(const SiftingSolve& solve) {
  if (sets_.n() < tuned::kLeastToStall || !(program_.objective() < kNearlyZero) ||
      program_.pivots() == pivots_at_zero_)
    return false;
  pivots_at_zero_ = program_.pivots();
  if (!face_.proves_zero(solve)) return false;
  sets_.price(program_, true);  // the result has the normal at hand
  face_.write(solve, 0, 0);
  return true;
}

// The second line of proof: the basis at hand to some 30 digits. False where the bounds stay apart.
bool Sifting::certify_refined(const SiftingSolve& solve, End end) {
  if (end != End::solved && end != End::failed) return false;
  if (!affords_inverse(solve.stopwatch, sets_.n() + 1, sets_.kernels())) return false;
  const double lower = refined_.lower(solve);
  if (lower == kInfinity) return false;
  const double upper = by_face_ ? face_.upper(solve) : refined_.upper(solve);
  if (upper == 0 || !solve.closes(lower, upper)) return false;  // 0 is another status
  conclude(solve, lower, upper);
  return true;
}

// The bounds keep the normal near the guess; where that is good, the first pass finds the right points the
// sooner. Where most bounds are active or a pass has been spent on it, it is not, and raising them over the
// sample costs next to nothing.
bool Sifting::bounds_mislead() noexcept {
  const bool passes_are_cheap =
      sets_.n() * (sets_.A().set->size() + sets_.Q().set->size()) < tuned::kCheapNumbers;
  return !passes_are_cheap &&
         (sets_.counters().support_queries > 0 || 5 * program_.loop().artificials > 3 * sets_.n());
}

bool Sifting::interior_may_help(End end) const noexcept {
  if (end != End::stalled && end != End::failed) return false;
  return interior_.state() == InteriorProof::State::untried && sets_.n() >= tuned::kLeastToStall &&
         sets_.is_complete() && !sets_.is_restricted();
}

// True where the result is complete. Otherwise the simplex goes on, from a better start if there is one.
bool Sifting::finish_inside(const SiftingSolve& solve) {
  interior_.run(solve, sets_.direction());
  if (interior_.certify_separated(solve) || interior_.certify(solve)) return true;
  program_.be_patient();
  if (interior_.state() == InteriorProof::State::converged) interior_.start(solve);
  return false;
}

// Rounding (or a default pivot limit, which it takes rounding to reach) keeps the bounds apart. Over chosen
// points the upper bound is all that is asked for.
void Sifting::finish_short_of_tolerance(const SiftingSolve& solve, End end, double lower, double upper) {
  const bool restricted = sets_.is_restricted();
  const bool limited = end == End::time_limit || (end == End::pivot_limit && pivots_are_limited_);
  bool late = false;
  if (!limited && !(restricted && upper < kInfinity)) {
    if (!restricted && last_.certify_twofold(solve)) return;
    const ExactSimplex::End exact = last_.certify_exactly(solve, lower);
    if (exact == ExactSimplex::End::solved) return;
    late = exact == ExactSimplex::End::too_long;
  }
  late = late || solve.stopwatch.expired();
  if (!restricted) lower = std::max(lower, interior_.bound(solve, lower));
  CommonRay& ray = interior_.ray();
  const bool may_stall = sets_.n() >= tuned::kLeastToStall;
  if (may_stall && !(upper < kInfinity)) ray.find(sets_.A().pool, sets_.Q().pool, sets_.n());
  if (!(std::min(upper, ray.upper()) < kInfinity) && certify_by_last_look(solve)) return;
  const DistanceStatus status = late ? DistanceStatus::time_limit : status_of(end);
  if (ray.upper() < upper) return interior_.write_ray(solve, status, lower);
  write_answer(solve, status, lower, upper);
}

// Where a limit on basis changes ends a solve that knows no upper bound: some steps of the interior-point
// method, none of which is a basis change.
bool Sifting::certify_by_last_look(const SiftingSolve& solve) {
  const bool untried =
      interior_.state() == InteriorProof::State::untried && sets_.n() >= tuned::kLeastToStall;
  if (!untried || !sets_.is_complete() || sets_.is_restricted()) return false;
  const std::vector<double> guess(program_.normal(), program_.normal() + sets_.n());
  interior_.run(solve, guess.data());
  if (interior_.state() == InteriorProof::State::failed) return false;
  return interior_.certify(solve);
}

}  // namespace raygauge
