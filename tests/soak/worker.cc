// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "tests/soak/worker.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

#include "baselines/exact_verify.h"

namespace raygauge::soak {
namespace {

constexpr double kOracleShare = 1e-4;       // of the solves, solved again in rational arithmetic
constexpr int kLargestOracleDimension = 8;  // beyond, one exact solve takes longer than all variants
constexpr int kPatientDimension = 15;       // above, a solve gets kSecondsPerSolve
constexpr double kSecondsPerSolve = 2;
constexpr double kShortNormal = 1e-9;

// As many variants of a base as this much work allows, in units of about 0.1 µs, so that neither instances
// which are slow to solve nor the making of new ones fill the time.
constexpr double kWorkPerBase = 60000;
constexpr std::int64_t kMostVariants = 1000;

double work_of(const DistanceCounters& counters, int n) {
  const double iterations = static_cast<double>(counters.pivots + counters.ray_iterations);
  const double exact = static_cast<double>(counters.exact_pivots) * n * n;
  return 30 + 2 * iterations * n + 50 * exact;
}

Truth truth_of(const ExactLpResult& exact, int shift) {
  Truth truth{exact.status, exact.rounded};
  if (shift != 0 && exact.status == DistanceStatus::optimal) {
    truth.rounded = round_nonnegative(scaled_rational(exact.value, shift));
  }
  return truth;
}

}  // namespace

Worker::Worker(const GeneratorRegistry& registry, std::vector<std::string> names, std::uint64_t seed)
    : registry_(registry), names_(std::move(names)), seed_(seed) {}

std::optional<Violation> Worker::run(std::int64_t base, std::int64_t most_solves) {
  // The number of the base takes the place of N and the repetition in the random numbers' key.
  const InstanceKey key{seed_, 1, static_cast<int>(base >> 31), static_cast<int>(base & 0x7fffffff)};
  RandomStream shape(key, "soak", RandomPurpose::shape);
  RandomStream stream(key, "soak", RandomPurpose::order);
  const ProvenInstance proven = draw_proven_instance(registry_, names_, shape);
  const auto n = static_cast<int>(proven.A.rows());
  ++tally_.families[proven.label].bases;
  ++tally_.dimensions[n].bases;
  const std::int64_t count = std::min(most_solves, kMostVariants);
  work_ = 0;
  for (std::int64_t v = 0; v < count && work_ < kWorkPerBase; ++v) {
    const bool ask_oracle = n <= kLargestOracleDimension && stream.uniform() < kOracleShare;
    if (auto violation = solve_variant(proven, stream, ask_oracle)) {
      violation->base = base;
      violation->variant = v;
      return violation;
    }
  }
  return std::nullopt;
}

Tally Worker::take_tally() { return std::exchange(tally_, {}); }

Worker::Request Worker::draw_request(RandomStream& stream, int n) const {
  constexpr std::array<double, 4> kTolerances = {1e-12, 1e-12, 1e-9, 1e-6};
  Request request;
  request.options.method =
      stream.uniform() < 0.7 ? DistanceMethod::column_generation : DistanceMethod::zheng_yamane;
  request.options.tolerance = kTolerances[static_cast<std::size_t>(stream.integer(0, 3))];
  if (n > kPatientDimension) request.options.time_limit = kSecondsPerSolve;
  if (stream.uniform() < 0.1) request.effects = Effects::witness;
  return request;
}

std::optional<Violation> Worker::solve_variant(const ProvenInstance& base, RandomStream& stream,
                                               bool ask_oracle) {
  variant_.make(base, stream);
  const auto n = static_cast<int>(base.A.rows());
  const Request request = draw_request(stream, n);
  const PointSet A(variant_.A()), Q(variant_.Q());
  const Truth truth = truth_of(base.truth, variant_.shift());
  DistanceSolver& solver =
      request.options.method == DistanceMethod::column_generation ? column_generation_ : zheng_yamane_;
  solver.set_options(request.options);
  FamilyTally counts;
  const auto begin = std::chrono::steady_clock::now();
  const DistanceResult& result = solver.solve(A, Q, request.effects);
  const std::size_t method = place_of(request.options.method);
  counts.seconds[method] = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  counts.by_method[method] = 1;
  work_ += work_of(result.counters, n);
  std::string what = check(result, truth, request.options.tolerance, counts);
  if (what.empty() && ask_oracle && !oracle_agrees(truth, counts)) what = "the oracle contradicts the truth";
  tally_.families[base.label].add(counts);
  tally_.dimensions[n].add(counts);
  if (what.empty()) return std::nullopt;
  return report(what, base, request, truth, result);
}

std::string Worker::check(const DistanceResult& result, const Truth& truth, double tolerance,
                          FamilyTally& counts) {
  counts.solves = 1;
  counts.by_status[static_cast<std::size_t>(result.status)] = 1;
  counts.settled_exactly = result.counters.exact_pivots > 0 ? 1 : 0;
  if (result.status == DistanceStatus::optimal && tolerance <= 1e-12) {
    counts.worst_width = (result.upper - result.lower) / result.upper;
  }
  std::string what = falsehood(result, truth, tolerance);
  if (!what.empty()) return what;
  const DualValue dual = dual_value(variant_.A(), variant_.Q(), result.normal);
  if (!dual.known) return "";
  counts.normals_checked = 1;
  counts.normals_short = dual.above < result.lower * (1 - kShortNormal) ? 1 : 0;
  // Weak duality at the returned normal: a bound that exceeds the upper one refutes it.
  return dual.below > result.upper || dual.below > truth.rounded.upper ? "the normal proves more than upper"
                                                                       : "";
}

bool Worker::oracle_agrees(const Truth& truth, FamilyTally& counts) const {
  counts.exact_checks = 1;
  const PointSet A(variant_.A()), Q(variant_.Q());
  const ExactLpResult exact = solve_exact_lp(A, Q);
  return verify(A, Q, exact) && exact.status == truth.status && exact.rounded.lower == truth.rounded.lower &&
         exact.rounded.upper == truth.rounded.upper;
}

Violation Worker::report(const std::string& what, const ProvenInstance& base, const Request& request,
                         const Truth& truth, const DistanceResult& result) const {
  Violation violation;
  violation.what = what;
  violation.family = base.label;
  violation.method = to_string(request.options.method);
  violation.tolerance = request.options.tolerance;
  violation.truth = truth;
  violation.result = result;
  violation.A = variant_.A();
  violation.Q = variant_.Q();
  DistanceSolver fresh(request.options);
  const DistanceResult& again = fresh.solve(PointSet(violation.A), PointSet(violation.Q), request.effects);
  violation.repeats_in_a_fresh_solver = !falsehood(again, truth, request.options.tolerance).empty();
  return violation;
}

}  // namespace raygauge::soak
