// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "bindings/c/handles.h"
#include "raygauge/exceptions.h"
#include "raygauge/methods/options.h"
#include "raygauge/queries/membership.h"

namespace raygauge::c {
namespace {

[[noreturn]] void refuse_pose(const char* name, int pose, int set) {
  throw DimensionMismatchError(std::string(name) + ": the pose is of R^" + std::to_string(pose) +
                               ", the set of R^" + std::to_string(set));
}

/// What `pair`, of the caller, stands for.
struct Pair {
  explicit Pair(const rg_pair& pair)
      : first(posed(pair.first, pair.pose_first, "pair->first")),
        second(posed(pair.second, pair.pose_second, "pair->second")) {}
  Posed first, second;
};

WarmStart* first_of(rg_warm* warm) { return warm == nullptr ? nullptr : warm->starts.data(); }

void check_effects(std::uint32_t effects, std::uint32_t known) {
  if ((effects & ~known) == 0) return;
  throw InvalidParameterError("effects: this query knows the flags " + std::to_string(known) + ", got " +
                              std::to_string(effects));
}

/// Changes an option. Throws InvalidParameterError, and then nothing has changed.
template <class Change>
rg_error change_options(rg_solver* solver, const Change& change) {
  return guarded([&] {
    rg_solver& changed = needed(solver, "solver");
    DistanceOptions options = changed.options;
    change(options);
    if (const std::string problem = validate(options); !problem.empty()) throw InvalidParameterError(problem);
    changed.last = {};
    changed.distances.reset();
    changed.objects.reset();
    changed.growth.reset();
    changed.options = options;
  });
}

/// The solver in its place, made if there is none yet.
template <class Solver>
Solver& ready(std::optional<Solver>& place, const DistanceOptions& options,
              const std::function<bool()>& stop) {
  if (!place) {
    place.emplace(options);
    if (stop) place->set_stop(stop);
  }
  return *place;
}

DistanceMethod method_of(const std::string& name) {
  constexpr DistanceMethod kMethods[] = {DistanceMethod::automatic, DistanceMethod::column_generation,
                                         DistanceMethod::newton, DistanceMethod::zheng_yamane};
  std::vector<std::string> names;
  for (const DistanceMethod method : kMethods) {
    if (name == to_string(method)) return method;
    names.emplace_back(to_string(method));
  }
  throw UnknownNameError("method", name, names);
}

rg_answer answer_of(const DistanceResult& r) {
  return {r.distance, r.lower, r.upper, static_cast<std::int32_t>(r.status), -1};
}

bool is_depth(const ObjectDistance& r) { return r.depth.evaluations > 0; }

std::int32_t meeting(const ObjectDistance& r) {
  if (r.distance.lower > 0) return 0;
  const bool common =
      r.distance.status == DistanceStatus::contains_origin || (is_depth(r) && r.depth.lower > 0);
  return common ? 1 : -1;
}

/// Of a depth, whose lower bound may be 0 without proof that the objects meet, the distance bounds it from
/// above.
rg_answer answer_of(const ObjectDistance& r) {
  rg_answer answer = answer_of(r.distance);
  answer.meet = meeting(r);
  if (!is_depth(r)) return answer;
  answer.distance = 0 - r.depth.depth;
  answer.lower = 0 - r.depth.upper;
  answer.upper = r.depth.lower > 0 ? -r.depth.lower : r.distance.upper;
  answer.status = static_cast<std::int32_t>(r.depth.status);
  return answer;
}

rg_error solve_objects(rg_solver* solver, const rg_pair* pair, const rg_set* Q, std::uint32_t effects,
                       bool depth, rg_warm* warm, rg_answer* answer) {
  return guarded([&] {
    rg_solver& used = needed(solver, "solver");
    const Pair posed(needed(pair, "pair"));
    rg_answer& out = needed(answer, "answer");
    check_effects(effects, RG_CLOSEST_POINTS | RG_GRADIENT);
    const int n = posed.first.dimension();
    const ConvexSet& metric = Q == nullptr ? used.euclidean.of(n) : *Q->set;
    ObjectEffects asked = depth ? ObjectEffects::depth : ObjectEffects::none;
    if ((effects & RG_CLOSEST_POINTS) != 0) asked = asked | ObjectEffects::closest_points;
    if ((effects & RG_GRADIENT) != 0) asked = asked | ObjectEffects::gradient;
    ObjectDistanceSolver& ask = ready(used.objects, used.options, used.stop);
    used.last = {};
    const ObjectDistance& r = ask.solve(posed.first, posed.second, metric, asked, first_of(warm));
    used.last = {n, nullptr, &r, nullptr};
    out = answer_of(r);
  });
}

/// The vector of that name; nullptr where the query has none of it.
const Vector* vector_of(const ObjectDistance& r, std::int32_t which) {
  switch (which) {
    case RG_NORMAL:
      return is_depth(r) ? &r.depth.normal : &r.distance.normal;
    case RG_POINT_1:
      return is_depth(r) ? &r.depth.point_1 : &r.closest_point_1;
    case RG_POINT_2:
      return is_depth(r) ? &r.depth.point_2 : &r.closest_point_2;
    case RG_GRADIENT_1:
      return &r.gradient_1;
    case RG_GRADIENT_2:
      return &r.gradient_2;
    default:
      return nullptr;
  }
}

const Vector* vector_of(const LastResult& last, std::int32_t which) {
  if (last.objects != nullptr) return vector_of(*last.objects, which);
  if (last.separation != nullptr) return which == RG_NORMAL ? &last.separation->normal : nullptr;
  if (which == RG_NORMAL) return &last.distance->normal;
  return which == RG_CONTACT_POINT ? &last.distance->contact_point : nullptr;
}

}  // namespace

Posed posed(const rg_set* set, const rg_pose* pose, const char* name) {
  const ConvexSet& S = *needed(set, name).set;
  if (pose == nullptr) return {S};
  if (pose->pose.dimension() != S.dimension()) refuse_pose(name, pose->pose.dimension(), S.dimension());
  return {S, pose->pose};
}

DistanceOptions growth_options(const DistanceOptions& options) {
  DistanceOptions growth = options;
  if (growth.method == DistanceMethod::automatic) growth.method = DistanceMethod::newton;
  return growth;
}

}  // namespace raygauge::c

using namespace raygauge;     // NOLINT(google-build-using-namespace)
using namespace raygauge::c;  // NOLINT(google-build-using-namespace)

rg_error rg_solver_create(rg_solver** solver) {
  return guarded([&] {
    rg_solver*& out = needed(solver, "solver");
    out = new rg_solver;
  });
}

void rg_solver_free(rg_solver* solver) { delete solver; }

rg_error rg_solver_set_tolerance(rg_solver* solver, double tolerance) {
  return change_options(solver, [&](DistanceOptions& options) { options.tolerance = tolerance; });
}

rg_error rg_solver_set_time_limit(rg_solver* solver, double seconds) {
  return change_options(solver, [&](DistanceOptions& options) { options.time_limit = seconds; });
}

rg_error rg_solver_set_max_iterations(rg_solver* solver, int64_t iterations) {
  return change_options(solver, [&](DistanceOptions& options) { options.max_iterations = iterations; });
}

rg_error rg_solver_set_method(rg_solver* solver, const char* method) {
  return change_options(
      solver, [&](DistanceOptions& options) { options.method = method_of(&needed(method, "method")); });
}

rg_error rg_solver_set_stop(rg_solver* solver, rg_stop stop, void* data) {
  return change_options(solver, [&](DistanceOptions&) {
    solver->stop = stop == nullptr ? std::function<bool()>() : [stop, data] { return stop(data) != 0; };
  });
}

rg_error rg_distance(rg_solver* solver, const rg_pair* pair, uint32_t effects, rg_warm* warm,
                     rg_answer* answer) {
  return guarded([&] {
    rg_solver& used = needed(solver, "solver");
    const Pair posed(needed(pair, "pair"));
    rg_answer& out = needed(answer, "answer");
    check_effects(effects, RG_WITNESS);
    DistanceSolver& ask = ready(used.distances, used.options, used.stop);
    used.last = {};
    const DistanceResult& r =
        ask.solve(posed.first, posed.second, (effects & RG_WITNESS) != 0 ? Effects::witness : Effects::none,
                  first_of(warm));
    used.last = {posed.first.dimension(), &r, nullptr, nullptr};
    out = answer_of(r);
  });
}

rg_error rg_object_distance(rg_solver* solver, const rg_pair* pair, const rg_set* Q, uint32_t effects,
                            rg_warm* warm, rg_answer* answer) {
  return solve_objects(solver, pair, Q, effects, false, warm, answer);
}

rg_error rg_signed_distance(rg_solver* solver, const rg_pair* pair, const rg_set* Q, uint32_t effects,
                            rg_warm* warm, rg_answer* answer) {
  return solve_objects(solver, pair, Q, effects, true, warm, answer);
}

rg_error rg_growth_distance(rg_solver* solver, const rg_pair* pair, rg_warm* warm, rg_answer* answer) {
  return guarded([&] {
    rg_solver& used = needed(solver, "solver");
    const Pair posed(needed(pair, "pair"));
    rg_answer& out = needed(answer, "answer");
    GrowthDistanceSolver& ask = ready(used.growth, growth_options(used.options), used.stop);
    used.last = {};
    const DistanceResult& r = ask.solve_about_centers(posed.first, posed.second, first_of(warm));
    used.last = {posed.first.dimension(), &r, nullptr, nullptr};
    out = answer_of(r);
  });
}

rg_error rg_separation(rg_solver* solver, const rg_pair* pair, rg_warm* warm, int32_t* outcome) {
  static_assert(RG_SEPARATED == static_cast<int>(Separation::separated) &&
                RG_INTERSECTING == static_cast<int>(Separation::intersecting) &&
                RG_UNDECIDED == static_cast<int>(Separation::undecided));
  return guarded([&] {
    rg_solver& used = needed(solver, "solver");
    const Pair posed(needed(pair, "pair"));
    int32_t& out = needed(outcome, "outcome");
    GrowthDistanceSolver& ask = ready(used.growth, growth_options(used.options), used.stop);
    used.last = {};
    const SeparationResult& r = ask.separation(posed.first, posed.second, first_of(warm));
    used.last = {posed.first.dimension(), nullptr, nullptr, &r};
    out = static_cast<int32_t>(r.outcome);
  });
}

rg_error rg_solver_vector(const rg_solver* solver, int32_t which, int32_t n, double* values) {
  return guarded([&] {
    const LastResult& last = needed(solver, "solver").last;
    in_range("which", which, RG_NORMAL, RG_GRADIENT_2);
    if (last.n == 0)
      throw InvalidParameterError("solver: it has no result; the last query failed, or there was none");
    if (n != last.n) {
      throw DimensionMismatchError("n: the last query was in R^" + std::to_string(last.n) + ", got " +
                                   std::to_string(n));
    }
    double* const out = &needed(values, "values");
    const Vector* const vector = vector_of(last, which);
    if (vector != nullptr && vector->size() == n) {
      std::copy_n(vector->data(), n, out);
    } else {
      std::fill_n(out, n, std::numeric_limits<double>::quiet_NaN());
    }
  });
}

rg_error rg_gauge(const rg_set* S, const double* x, double tolerance, double* lower, double* upper) {
  return guarded([&] {
    const ConvexSet& set = *needed(S, "S").set;
    double& low = needed(lower, "lower");
    double& high = needed(upper, "upper");
    const GaugeBounds bounds = gauge(set, Vector::Map(&needed(x, "x"), set.dimension()), tolerance);
    low = bounds.lower;
    high = bounds.upper;
  });
}

rg_error rg_contains(const rg_set* S, const double* x, double tolerance, int32_t* membership) {
  static_assert(RG_INSIDE == static_cast<int>(Membership::inside) &&
                RG_OUTSIDE == static_cast<int>(Membership::outside) &&
                RG_MEMBERSHIP_UNDECIDED == static_cast<int>(Membership::undecided));
  return guarded([&] {
    const ConvexSet& set = *needed(S, "S").set;
    int32_t& out = needed(membership, "membership");
    out = static_cast<int32_t>(contains(set, Vector::Map(&needed(x, "x"), set.dimension()), tolerance));
  });
}
