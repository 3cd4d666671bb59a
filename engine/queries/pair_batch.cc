// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/queries/pair_batch.h"

#include <omp.h>

#include <algorithm>
#include <exception>
#include <limits>
#include <string>
#include <vector>

#include "engine/sets/parameters.h"
#include "raygauge/exceptions.h"
#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/object_distance.h"

namespace raygauge {
namespace {

constexpr int kChunk = 64;  // pairs that a thread takes at once: more than a cache line of any answer

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

void put(const BatchAnswers& answers, std::size_t i, const DistanceResult& r, int n) {
  if (!answers.distance.empty()) answers.distance[i] = r.distance;
  if (!answers.lower.empty()) answers.lower[i] = r.lower;
  if (!answers.upper.empty()) answers.upper[i] = r.upper;
  if (!answers.status.empty()) answers.status[i] = r.status;
  put(answers.normal, i, r.normal, n);
}

void check_room(const char* name, std::size_t size, std::size_t wanted) {
  if (size == 0 || size == wanted) return;
  throw InvalidParameterError("batch: " + std::string(name) + " has room for " + std::to_string(size) +
                              " numbers, the pairs need " + std::to_string(wanted));
}

// By all threads: asking 10^4 bodies that are not in the cache for their dimensions takes as long as some of
// the solves.
void check_dimensions(std::span<const PosedPair> pairs, int n, int threads) {
  const std::ptrdiff_t count = std::ssize(pairs);
  std::ptrdiff_t misfit = count;
#pragma omp parallel for num_threads(threads) default(none) shared(pairs, n, count) reduction(min : misfit)
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const PosedPair& pair = pairs[static_cast<std::size_t>(i)];
    if (pair.first.dimension() != n || pair.second.dimension() != n) misfit = std::min(misfit, i);
  }
  if (misfit == count) return;
  const PosedPair& pair = pairs[static_cast<std::size_t>(misfit)];
  check_dimension("batch", "a first body", pair.first.dimension(), n);
  check_dimension("batch", "a second body", pair.second.dimension(), n);
}

void check(std::span<const PosedPair> pairs, int n, int threads, const BatchAnswers& answers,
           std::span<WarmStart> warm) {
  check_dimensions(pairs, n, threads);
  const std::size_t count = pairs.size(), numbers = count * static_cast<std::size_t>(n);
  check_room("distance", answers.distance.size(), count);
  check_room("lower", answers.lower.size(), count);
  check_room("upper", answers.upper.size(), count);
  check_room("status", answers.status.size(), count);
  check_room("normal", answers.normal.size(), numbers);
  check_room("closest_points_1", answers.closest_points_1.size(), numbers);
  check_room("closest_points_2", answers.closest_points_2.size(), numbers);
  check_room("warm", warm.size(), count);
}

}  // namespace

struct PairBatch::Team {
  struct Member {
    explicit Member(const DistanceOptions& options) : distance(options), growth(options) {}
    ObjectDistanceSolver distance;
    GrowthDistanceSolver growth;
  };

  explicit Team(DistanceOptions options) {
    const int threads = DistanceSolver(options).options().threads;  // in its range
    options.threads = 1;
    for (int i = 0; i < threads; ++i) members.emplace_back(options);
  }

  std::vector<Member> members;
};

namespace {

// solve(member, i) for all pairs i, each by one thread. The first exception ends the batch and is thrown
// again.
template <class Member, class Solve>
void share(std::vector<Member>& members, std::ptrdiff_t count, const Solve& solve) {
  std::exception_ptr error;
  bool failed = false;
  const int threads = static_cast<int>(members.size());
#pragma omp parallel for schedule(dynamic, kChunk) num_threads(threads) default(none) \
    shared(kChunk, members, count, solve, error, failed)
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    bool skip = false;
#pragma omp atomic read
    skip = failed;
    if (skip) continue;
    try {
      solve(members[static_cast<std::size_t>(omp_get_thread_num())], static_cast<std::size_t>(i));
    } catch (...) {
#pragma omp critical(raygauge_pair_batch)
      if (!error) error = std::current_exception();
#pragma omp atomic write
      failed = true;
    }
  }
  if (error) std::rethrow_exception(error);
}

}  // namespace

PairBatch::PairBatch(const DistanceOptions& options) : team_(std::make_unique<Team>(options)) {}
PairBatch::~PairBatch() = default;
PairBatch::PairBatch(PairBatch&&) noexcept = default;
PairBatch& PairBatch::operator=(PairBatch&&) noexcept = default;

void PairBatch::distances(std::span<const PosedPair> pairs, const ConvexSet& Q, const BatchAnswers& answers,
                          std::span<WarmStart> warm) {
  const int n = Q.dimension();
  check(pairs, n, static_cast<int>(team_->members.size()), answers, warm);
  const bool points = !answers.closest_points_1.empty() || !answers.closest_points_2.empty();
  const ObjectEffects effects = points ? ObjectEffects::closest_points : ObjectEffects::none;
  share(team_->members, std::ssize(pairs), [&](Team::Member& member, std::size_t i) {
    WarmStart* start = warm.empty() ? nullptr : &warm[i];
    const ObjectDistance& r = member.distance.solve(pairs[i].first, pairs[i].second, Q, effects, start);
    put(answers, i, r.distance, n);
    put(answers.closest_points_1, i, r.closest_point_1, n);
    put(answers.closest_points_2, i, r.closest_point_2, n);
  });
}

void PairBatch::growth_distances(std::span<const PosedPair> pairs, const BatchAnswers& answers,
                                 std::span<WarmStart> warm) {
  if (pairs.empty()) return;
  const int n = pairs.front().first.dimension();
  check(pairs, n, static_cast<int>(team_->members.size()), answers, warm);
  share(team_->members, std::ssize(pairs), [&](Team::Member& member, std::size_t i) {
    WarmStart* start = warm.empty() ? nullptr : &warm[i];
    put(answers, i, member.growth.solve_about_centers(pairs[i].first, pairs[i].second, start), n);
  });
}

}  // namespace raygauge
