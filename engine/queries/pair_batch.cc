// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/queries/pair_batch.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/queries/separation_bins.h"
#include "engine/queries/spatial_query.h"
#include "engine/sets/parameters.h"
#include "engine/threads/chunk_team.h"
#include "engine/threads/shared_tools.h"
#include "raygauge/exceptions.h"
#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/queries/solver.h"

namespace raygauge {
namespace {

constexpr std::size_t kPath = 16;  // pairs of a path that start from each other, always on one thread

// Pairs that a thread takes at once: more than a cache line of any answer, but of a small batch fewer, so
// that all threads end together.
std::ptrdiff_t chunk_of(std::ptrdiff_t count, int threads) {
  constexpr std::ptrdiff_t kFew = kPath, kMany = 4 * kFew, kChunksPerThread = 4;
  return count < kMany * kChunksPerThread * threads ? kFew : kMany;
}

// Vector `i` of an array of vectors.
void put(std::span<double> out, std::size_t i, const Vector& value, int n) {
  if (out.empty()) return;
  double* to = out.data() + i * static_cast<std::size_t>(n);
  if (value.size() == n) {
    std::copy_n(value.data(), n, to);
  } else {
    std::fill_n(to, n, std::numeric_limits<double>::quiet_NaN());
  }
}

// What counts in R^n of gradient `i`, NaN where there is none.
void put(std::span<double> out, std::size_t i, GradientKind kind, const Twist& gradient, int n) {
  if (out.empty()) return;
  const int size = 3 * n - 3;
  double* to = out.data() + i * static_cast<std::size_t>(size);
  if (kind == GradientKind::none) {
    std::fill_n(to, size, std::numeric_limits<double>::quiet_NaN());
    return;
  }
  std::copy_n(&gradient.linear.x, n, to);
  std::copy_n(n == 2 ? &gradient.angular.z : &gradient.angular.x, size - n, to + n);
}

void put(const SeparationAnswers& answers, std::size_t i, const SeparationResult& r, int n) {
  answers.outcome[i] = r.outcome;
  put(answers.normal, i, r.normal, n);
}

void put(const BatchAnswers& answers, std::size_t i, const PoseGradient& gradient, int n) {
  if (!answers.gradient_kind.empty()) answers.gradient_kind[i] = gradient.kind;
  put(answers.pose_gradients_1, i, gradient.kind, gradient.body_1, n);
  put(answers.pose_gradients_2, i, gradient.kind, gradient.body_2, n);
}

void put(const BatchAnswers& answers, std::size_t i, const DistanceResult& r, int n) {
  if (!answers.distance.empty()) answers.distance[i] = r.distance;
  if (!answers.lower.empty()) answers.lower[i] = r.lower;
  if (!answers.upper.empty()) answers.upper[i] = r.upper;
  if (!answers.status.empty()) answers.status[i] = r.status;
  if (!answers.pivots.empty()) answers.pivots[i] = r.counters.pivots;
  put(answers.normal, i, r.normal, n);
}

void put(const BatchAnswers& answers, std::size_t i, const ObjectDistance& r, int n) {
  put(answers, i, r.distance, n);
  put(answers, i, r.pose_gradient, n);
  const bool inside = r.depth.evaluations > 0;
  put(answers.closest_points_1, i, inside ? r.depth.point_1 : r.closest_point_1, n);
  put(answers.closest_points_2, i, inside ? r.depth.point_2 : r.closest_point_2, n);
  if (!inside) return;
  if (!answers.distance.empty()) answers.distance[i] = r.signed_distance();
  if (!answers.lower.empty()) answers.lower[i] = -r.depth.upper;
  if (!answers.upper.empty()) answers.upper[i] = -r.depth.lower;
  if (!answers.status.empty()) answers.status[i] = r.depth.status;
  put(answers.normal, i, r.depth.normal, n);
}

void check_room(const char* name, std::size_t size, std::size_t wanted, bool may_be_empty = true) {
  if ((size == 0 && may_be_empty) || size == wanted) return;
  throw InvalidParameterError("batch: " + std::string(name) + " has room for " + std::to_string(size) +
                              " numbers, the pairs need " + std::to_string(wanted));
}

void check_rooms(std::size_t count, int n, const BatchAnswers& answers) {
  const std::size_t numbers = count * static_cast<std::size_t>(n);
  check_room("distance", answers.distance.size(), count);
  check_room("lower", answers.lower.size(), count);
  check_room("upper", answers.upper.size(), count);
  check_room("status", answers.status.size(), count);
  check_room("pivots", answers.pivots.size(), count);
  check_room("normal", answers.normal.size(), numbers);
  check_room("closest_points_1", answers.closest_points_1.size(), numbers);
  check_room("closest_points_2", answers.closest_points_2.size(), numbers);
  check_room("contact_points", answers.contact_points.size(), numbers);
  check_room("gradient_kind", answers.gradient_kind.size(), count);
  check_room("pose_gradients_1", answers.pose_gradients_1.size(), 3 * (numbers - count));
  check_room("pose_gradients_2", answers.pose_gradients_2.size(), 3 * (numbers - count));
}

ObjectEffects effects_for(const BatchAnswers& answers) {
  const bool points = !answers.closest_points_1.empty() || !answers.closest_points_2.empty();
  const bool gradients = !answers.gradient_kind.empty() || !answers.pose_gradients_1.empty() ||
                         !answers.pose_gradients_2.empty();
  return (points ? ObjectEffects::closest_points : ObjectEffects::none) |
         (gradients ? ObjectEffects::pose_gradient : ObjectEffects::none);
}

// The same kind of error, which says in which pair it arose; others as they are.
std::exception_ptr named(std::exception_ptr error, std::ptrdiff_t i) {
  const auto text = [i](const Error& e) { return "problem " + std::to_string(i) + ": " + e.what(); };
  try {
    std::rethrow_exception(std::move(error));
  } catch (const DimensionMismatchError& e) {
    return std::make_exception_ptr(DimensionMismatchError(text(e)));
  } catch (const NonFiniteError& e) {
    return std::make_exception_ptr(NonFiniteError(text(e)));
  } catch (const EmptySetError& e) {
    return std::make_exception_ptr(EmptySetError(text(e)));
  } catch (const InvalidParameterError& e) {
    return std::make_exception_ptr(InvalidParameterError(text(e)));
  } catch (...) {
    return std::current_exception();
  }
}

}  // namespace

struct PairBatch::Team {
  // The solvers of one thread at a time, each made when it is first needed.
  struct alignas(64) Member {
    std::optional<DistanceSolver> gauge;
    std::optional<ObjectDistanceSolver> distance;
    std::optional<GrowthDistanceSolver> growth;
    std::optional<SeparationBins> separation;
    WarmStart warm;  // of the pair before, on a path
    int number = 0;
  };

  Team(const DistanceOptions& given, int threads) : options(given) {
    const int count = in_range(given, threads);
    for (int k = 0; k < count; ++k) {
      members.add(std::make_unique<Member>());
      members.all().back()->number = k;
    }
    options.threads = 1;
    helpers.be_patient();
  }

  static int in_range(const DistanceOptions& options, int threads) {
    const DistanceSolver checked(options);
    if (threads == 0) return options.threads;
    if (threads >= 1 && threads <= kMostBatchThreads) return threads;
    throw InvalidParameterError("batch: threads must lie in 1 … " + std::to_string(kMostBatchThreads) +
                                ", got " + std::to_string(threads));
  }

  template <class Solver>
  Solver& ready(std::optional<Solver>& solver) const {
    if (!solver) {
      solver.emplace(options);
      if (stop) solver->set_stop(stop);
    }
    return *solver;
  }

  // work(first, last) for all chunks of 0 … count - 1, on all threads.
  template <class Work>
  void run(std::ptrdiff_t count, const Work& work) {
    const int threads = static_cast<int>(members.all().size());
    const std::ptrdiff_t chunk = chunk_of(count, threads), chunks = (count + chunk - 1) / chunk;
    if (const auto useful = static_cast<int>(std::clamp<std::ptrdiff_t>(chunks, 1, threads)); useful > size)
      helpers.resize(size = useful);
    helpers.run(static_cast<int>(chunks), true,
                [&](int c) { work(c * chunk, std::min(count, (c + 1) * chunk)); });
  }

  // Asking 10^4 bodies that are not in the cache for their dimensions takes as long as some of the solves.
  void check_dimensions(std::span<const PosedPair> pairs, int n);

  // For all chunks of pairs, each on one thread, until `stop`: begin(member, first, last, thread, at), where
  // `at` is to say the pair that it has come to, and then solve(member, i, thread) for those pairs i that it
  // returns true for. The first exception ends the batch and is thrown again, naming its pair.
  template <class Begin, class Solve>
  void share(std::size_t pairs, const Begin& begin, const Solve& solve);

  template <class Solve>
  void share(std::size_t pairs, const Solve& solve) {
    const auto all = [](Member& /*member*/, std::size_t /*first*/, std::size_t /*last*/, int /*thread*/,
                        std::size_t& /*at*/) { return [](std::size_t /*i*/) { return true; }; };
    share(pairs, all, solve);
  }

  DistanceOptions options;
  std::function<bool()> stop;
  SharedTools<Member> members;
  int size = 1;  // threads of `helpers`, with the caller
  ChunkTeam helpers;
};

void PairBatch::Team::check_dimensions(std::span<const PosedPair> pairs, int n) {
  std::atomic<bool> misfit = false;
  run(std::ssize(pairs), [&](std::ptrdiff_t first, std::ptrdiff_t last) {
    for (std::ptrdiff_t i = first; i < last; ++i) {
      const PosedPair& pair = pairs[static_cast<std::size_t>(i)];
      if (pair.first.dimension() != n || pair.second.dimension() != n) misfit = true;
    }
  });
  for (std::size_t i = 0; misfit && i < pairs.size(); ++i) {
    check_dimension("batch", "a first body", pairs[i].first.dimension(), n);
    check_dimension("batch", "a second body", pairs[i].second.dimension(), n);
  }
}

template <class Begin, class Solve>
void PairBatch::Team::share(std::size_t pairs, const Begin& begin, const Solve& solve) {
  std::mutex mutex;
  std::exception_ptr error;
  std::atomic<bool> ended = false;
  // Whether the batch goes on after work(), which may change i.
  const auto attempt = [&](std::size_t& i, const auto& work) {
    try {
      if (stop && stop()) {
        ended = true;
      } else {
        work();
      }
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!error) error = named(std::current_exception(), static_cast<std::ptrdiff_t>(i));
      ended = true;
    }
    return !ended.load(std::memory_order_relaxed);
  };
  run(static_cast<std::ptrdiff_t>(pairs), [&](std::ptrdiff_t from, std::ptrdiff_t to) {
    if (ended.load(std::memory_order_relaxed)) return;
    members.lend([&](Member& member) {
      const auto first = static_cast<std::size_t>(from), last = static_cast<std::size_t>(to);
      std::size_t i = first;
      std::optional<decltype(begin(member, first, last, 0, i))> open;
      bool go_on = attempt(i, [&] { open.emplace(begin(member, first, last, member.number, i)); });
      for (i = first; i < last && go_on; ++i) {
        if ((*open)(i)) go_on = attempt(i, [&] { solve(member, i, member.number); });
      }
    });
  });
  if (error) std::rethrow_exception(error);
}

PairBatch::PairBatch(const DistanceOptions& options, int threads)
    : team_(std::make_unique<Team>(options, threads)) {}
PairBatch::~PairBatch() = default;
PairBatch::PairBatch(PairBatch&&) noexcept = default;
PairBatch& PairBatch::operator=(PairBatch&&) noexcept = default;

void PairBatch::set_stop(std::function<bool()> stop) {
  team_->stop = std::move(stop);
  for (const auto& member : team_->members.all()) {
    if (member->gauge) member->gauge->set_stop(team_->stop);
    if (member->distance) member->distance->set_stop(team_->stop);
    if (member->growth) member->growth->set_stop(team_->stop);
  }
}

void PairBatch::distances(std::span<const PosedPair> pairs, const ConvexSet& Q, const BatchAnswers& answers,
                          std::span<WarmStart> warm) {
  const int n = Q.dimension();
  team_->check_dimensions(pairs, n);
  check_rooms(pairs.size(), n, answers);
  check_room("warm", warm.size(), pairs.size());
  const ObjectEffects effects = effects_for(answers);
  team_->share(pairs.size(), [&](Team::Member& member, std::size_t i, int /*thread*/) {
    WarmStart* start = warm.empty() ? nullptr : &warm[i];
    ObjectDistanceSolver& solver = team_->ready(member.distance);
    put(answers, i, solver.solve(pairs[i].first, pairs[i].second, Q, effects, start), n);
  });
}

void PairBatch::growth_distances(std::span<const PosedPair> pairs, const BatchAnswers& answers,
                                 std::span<WarmStart> warm) {
  if (pairs.empty()) return;
  const int n = pairs.front().first.dimension();
  team_->check_dimensions(pairs, n);
  check_rooms(pairs.size(), n, answers);
  check_room("warm", warm.size(), pairs.size());
  team_->share(pairs.size(), [&](Team::Member& member, std::size_t i, int /*thread*/) {
    WarmStart* start = warm.empty() ? nullptr : &warm[i];
    GrowthDistanceSolver& solver = team_->ready(member.growth);
    put(answers, i, solver.solve_about_centers(pairs[i].first, pairs[i].second, start), n);
  });
}

// What the lanes of a chunk leave undecided is asked one by one.
template <class Source>
void PairBatch::separate(std::size_t count, const Source& pairs, int n, const SeparationAnswers& answers) {
  check_room("outcome", answers.outcome.size(), count, false);
  check_room("normal", answers.normal.size(), count * static_cast<std::size_t>(n));
  std::fill(answers.outcome.begin(), answers.outcome.end(), Separation::undecided);
  std::fill(answers.normal.begin(), answers.normal.end(), std::numeric_limits<double>::quiet_NaN());
  const auto in_lanes = [&](Team::Member& member, std::size_t first, std::size_t last, int thread,
                            std::size_t& at) {
    if (!member.separation) member.separation.emplace(team_->options.instruction_set);
    member.separation->begin(answers);
    for (at = first; n == 3 && is_open_to_bodies(team_->options) && at < last; ++at) {
      const PosedPair& pair = pairs(at, thread);
      if (pair.first.dimension() == n && pair.second.dimension() == n) member.separation->add(pair, at);
    }
    member.separation->finish();
    return [&answers](std::size_t i) { return answers.outcome[i] == Separation::undecided; };
  };
  team_->share(count, in_lanes, [&](Team::Member& member, std::size_t i, int thread) {
    const PosedPair& pair = pairs(i, thread);
    check_dimension("batch", "a first body", pair.first.dimension(), n);
    put(answers, i, team_->ready(member.growth).separation(pair.first, pair.second), n);
  });
}

void PairBatch::separations(std::span<const PosedPair> pairs, const SeparationAnswers& answers) {
  const auto given = [&](std::size_t i, int /*thread*/) -> const PosedPair& {
    constexpr std::size_t kAhead = 8;
    if (i + 2 * kAhead < pairs.size()) prefetch_bodies(pairs[i + 2 * kAhead]);
    if (i + kAhead < pairs.size()) prefetch_numbers(pairs[i + kAhead]);
    return pairs[i];
  };
  separate(pairs.size(), given, pairs.empty() ? 3 : pairs.front().first.dimension(), answers);
}

void PairBatch::separations(std::size_t count, const PairSource& pairs, int n,
                            const SeparationAnswers& answers) {
  separate(count, pairs, n, answers);
}

void PairBatch::distances(std::size_t count, const PairSource& pairs, const ConvexSet& Q,
                          const BatchAnswers& answers, ObjectEffects effects) {
  const int n = Q.dimension();
  check_rooms(count, n, answers);
  const ObjectEffects all = effects | effects_for(answers);
  team_->share(count, [&](Team::Member& member, std::size_t i, int thread) {
    const PosedPair pair = pairs(i, thread);
    put(answers, i, team_->ready(member.distance).solve(pair.first, pair.second, Q, all), n);
  });
}

void PairBatch::gauge_distances(std::size_t count, const PairSource& pairs, int n,
                                const BatchAnswers& answers, bool along_path) {
  check_rooms(count, n, answers);
  const Effects effects = answers.contact_points.empty() ? Effects::none : Effects::witness;
  team_->share(count, [&](Team::Member& member, std::size_t i, int thread) {
    if (i % kPath == 0) member.warm.clear();
    const PosedPair pair = pairs(i, thread);
    DistanceSolver& solver = team_->ready(member.gauge);
    const DistanceResult& r =
        solver.solve(pair.first, pair.second, effects, along_path ? &member.warm : nullptr);
    put(answers, i, r, n);
    put(answers.contact_points, i, r.contact_point, n);
  });
}

}  // namespace raygauge
