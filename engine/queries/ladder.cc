// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/ladder.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "engine/numerics/floating_point.h"
#include "engine/queries/streamed_distance.h"
#include "engine/queries/streamed_hull.h"
#include "engine/sets/parameters.h"
#include "engine/sets/posed_view.h"
#include "raygauge/exceptions.h"
#include "raygauge/methods/options.h"

namespace raygauge {
namespace {

constexpr unsigned bits(Question question) { return static_cast<unsigned>(question); }
constexpr unsigned kGauge = bits(Question::gauge), kDistance = bits(Question::distance),
                   kGrowth = bits(Question::growth), kSeparation = bits(Question::separation),
                   kAll = kGauge | kDistance | kGrowth | kSeparation;

}  // namespace

// Whether a rung is due.
struct Ladder::Due {
  static bool streamed(const Ladder& /*ladder*/, const Ask& ask) {
    const auto is = [](const Posed& body) {
      return body.pose == nullptr && as_streamed_hull(body.set) != nullptr;
    };
    return is(ask.first) || is(ask.second);
  }
  static bool always(const Ladder& /*ladder*/, const Ask& /*ask*/) { return true; }
  static bool open_to_bodies(const Ladder& ladder, const Ask& /*ask*/) {
    return is_open_to_bodies(ladder.options_);
  }
  static bool body_distance(const Ladder& ladder, const Ask& ask) {
    return open_to_bodies(ladder, ask) && !ask.is_distance_open;
  }
  static bool mesh(const Ladder& /*ladder*/, const Ask& ask) {
    return as_mesh(ask.first.set) != nullptr || as_mesh(ask.second.set) != nullptr;
  }
  static bool half_space(const Ladder& /*ladder*/, const Ask& ask) {
    return as_half_space(ask.first.set) != nullptr || as_half_space(ask.second.set) != nullptr;
  }
  static bool common_point(const Ladder& ladder, const Ask& ask) {
    const bool whole = ask.question == Question::separation || std::isnan(ask.threshold);
    return open_to_bodies(ladder, ask) && whole && !ask.about_origin;
  }
  static bool known_overlap(const Ladder& ladder, const Ask& ask) {
    return ladder.has_depth_start_ && ladder.depth_start_.overlap && depth(ladder, ask) &&
           ((ask.first.set.spatial_shape() != nullptr && ask.second.set.spatial_shape() != nullptr) ||
            (!mesh(ladder, ask) && !half_space(ladder, ask)));
  }
  static bool depth(const Ladder& /*ladder*/, const Ask& ask) {
    const int n = ask.metric->dimension();
    return has_effect(ask.object_effects, ObjectEffects::depth) && n <= 3 && ask.first.dimension() == n &&
           ask.second.dimension() == n;
  }
  static bool unknown_depth(const Ladder& ladder, const Ask& ask) {
    return ladder.answer_.depth.evaluations == 0 && depth(ladder, ask);
  }
  static bool newton_chosen(const Ladder& ladder, const Ask& /*ask*/) {
    return ladder.methods_.chosen() == DistanceMethod::newton;
  }
  static bool newton_with_start(const Ladder& ladder, const Ask& ask) {
    return newton_chosen(ladder, ask) && ladder.methods_.problem().start != nullptr;
  }
  static bool newton_near_origin(const Ladder& ladder, const Ask& ask) {
    return newton_chosen(ladder, ask) && ladder.methods_.is_newton_near_origin() &&
           method_for(ladder.methods_.problem().Q) == DistanceMethod::newton;
  }
  static bool zheng_yamane_chosen(const Ladder& ladder, const Ask& /*ask*/) {
    return ladder.methods_.chosen() == DistanceMethod::zheng_yamane;
  }
  static bool distant(const Ladder& ladder, const Ask& /*ask*/) { return ladder.answer_.distance.lower > 0; }
  static bool near_origin(const Ladder& ladder, const Ask& ask) { return !distant(ladder, ask); }
  static bool normal_known(const Ladder& ladder, const Ask& /*ask*/) { return ladder.methods_.has_normal(); }
  static bool undecided(const Ladder& ladder, const Ask& ask) {
    return near_origin(ladder, ask) && ladder.answer_.distance.status == DistanceStatus::precision_limit;
  }
  static bool overlap(const Ladder& ladder, const Ask& ask) {
    return undecided(ladder, ask) && ask.first.dimension() <= 3 && !ask.is_distance_open;
  }
  static bool growth_into(const Ladder& ladder, const Ask& ask) {
    return undecided(ladder, ask) && !ask.is_growth_open && ladder.options_.max_iterations == 0;
  }
  static bool distance(const Ladder& ladder, const Ask& /*ask*/) {
    return ladder.options_.max_iterations == 0 &&
           ladder.answer_.distance.status != DistanceStatus::time_limit;
  }
};

// Each rung is asked where it is due and none before it has answered the question. Fixed-size code comes
// first; then the general methods, of which column generation always answers but may stop short of the
// tolerance: those after it narrow the bounds that it leaves. Support points that crowd around a smooth
// contact spoil its linear program; Newton steps need no crowd. What is then open may be answered by another
// question.
struct Ladder::Rung {
  unsigned questions;
  Group group;
  bool (*is_due)(const Ladder&, const Ask&);
  bool (*solve)(Ladder&, Ask&);
  const char* method;
  const char* arithmetic;
  const char* when;  // in words, for the README of this folder
};

namespace {

constexpr char kBodies[] = "doubles, then double-double", kDoubles[] = "doubles",
               kQuad[] = "quadruple precision", kAbove[] = "as above",
               kChosen[] = "`newton` is chosen: from its own first direction";
using Id = MethodId;

}  // namespace

constexpr Ladder::Rung Ladder::kRungs[] = {
    {kGauge, Group::bodies, &Due::streamed, &Solve::by_passes,  //
     "passes", "that of the rungs for working sets", "A or Q is a hull of points that memory does not hold"},
    {kDistance, Group::bodies, &Due::known_overlap, &Solve::depth,  //
     "depth", kBodies, "the depth is asked for, and the solve of the pair before found one"},
    {kDistance, Group::bodies, &Due::body_distance, &Solve::body_distance,  //
     "distance of bodies", kBodies, "bodies of R² and R³, Q a ball about the origin"},
    {kGrowth | kSeparation, Group::bodies, &Due::open_to_bodies, &Solve::body_growth,  //
     "growth of bodies", kBodies, "bodies of R² and R³"},
    {kDistance | kGrowth | kSeparation, Group::bodies, &Due::mesh, &Solve::mesh,  //
     "mesh", kBodies, "one of the two is a mesh, Q a ball about the origin; no growth"},
    {kDistance | kGrowth | kSeparation, Group::bodies, &Due::half_space, &Solve::half_space,  //
     "half-space", "doubles, then double-double", "one of the two is a half-space: a closed form; no growth"},
    {kGrowth | kSeparation, Group::bodies, &Due::common_point, &Solve::common_point,  //
     "common point of bodies", kBodies,
     "the growth distance about both centres is not known: where bodies meet, 1 bounds it"},
    {kDistance, Group::bodies, &Due::unknown_depth, &Solve::depth,  //
     "depth", kBodies,
     "the depth is asked for, in R¹ to R³, and is not known: one above 0 proves a common point"},

    {kAll, Group::general, &Due::newton_chosen, &Solve::by<Id::spatial_gauge, Start::given>,  //
     "newton in fixed size", kDoubles, "`newton` is chosen; curved sets of R³"},
    {kAll, Group::general, &Due::newton_with_start, &Solve::by<Id::nearest_point, Start::given>,  //
     "nearest point", kDoubles, "the same, from a known direction; polytopes, Q a ball about the origin"},
    {kAll, Group::general, &Due::newton_with_start, &Solve::by<Id::newton, Start::given>,  //
     "newton", kDoubles, "`newton` is chosen, from a known direction"},
    {kAll, Group::general, &Due::newton_chosen, &Solve::by<Id::nearest_point, Start::afresh>,  //
     "nearest point", kDoubles, kChosen},
    {kAll, Group::general, &Due::newton_chosen, &Solve::by<Id::newton, Start::afresh>,  //
     "newton", kDoubles, kChosen},
    {kAll, Group::general, &Due::newton_near_origin, &Solve::by<Id::origin_question, Start::given>,  //
     "origin question", "exact",
     "`newton`, chosen for a smooth Q, has no lower bound: is 0 in a set of points?"},
    {kAll, Group::general, &Due::newton_chosen, &Solve::by<Id::quad_newton, Start::of_newton>,  //
     "newton", kQuad, "`newton` is chosen: from where doubles ended"},
    {kAll, Group::general, &Due::zheng_yamane_chosen, &Solve::by<Id::zheng_yamane, Start::given>,  //
     "zheng_yamane", kDoubles, "`zheng_yamane` is chosen"},
    {kAll, Group::general, &Due::always, &Solve::by<Id::column_generation, Start::given>,  //
     "column generation", "doubles, then double-double, then exact",
     "always: sifting for two point sets, over support mappings otherwise"},
    {kAll, Group::general, &Due::near_origin, &Solve::by<Id::origin_question, Start::given>,  //
     "origin question", "exact", "the lower bound is 0, and it has not been asked"},
    {kAll, Group::general, &Due::distant, &Solve::by<Id::tangent_plane, Start::given>,  //
     "tangent plane", kDoubles, "the lower bound is above 0: is A beyond the tangent plane at 0 of Q?"},
    {kAll, Group::general, &Due::always, &Solve::by<Id::newton, Start::afresh>,  //
     "newton", kDoubles, "it has not been asked"},
    {kAll, Group::general, &Due::normal_known, &Solve::by<Id::quad_newton, Start::of_bounds>,  //
     "newton", kQuad, "a normal is known: from there"},
    {kAll, Group::general, &Due::always, &Solve::by<Id::quad_newton, Start::afresh>,  //
     "newton", kQuad, "it has not been asked from its own first direction"},

    {kGauge | kDistance, Group::open, &Due::overlap, &Solve::overlap,  //
     "common point of bodies", kBodies, "the lower bound is 0, in R² and R³"},
    {kDistance, Group::open, &Due::growth_into, &Solve::growth_into,  //
     "growth distance, all its rungs", kAbove, "the lower bound is 0: below 1 it proves a common point"},
    {kSeparation, Group::open, &Due::distance, &Solve::distance,  //
     "Euclidean distance, all its rungs", kAbove, "the growth distance may be on either side of 1"},
};

// One rung of the group after the other; those for other questions cost nothing.
template <Question kQuestion, Ladder::Group kGroup>
bool Ladder::climb(Ask& ask) {
  const auto answers = [&]<std::size_t kAt>() {
    constexpr const Rung& kRung = kRungs[kAt];
    if constexpr (kRung.group == kGroup && (kRung.questions & bits(kQuestion)) != 0)
      return kRung.is_due(*this, ask) && kRung.solve(*this, ask);
    return false;
  };
  return [&]<std::size_t... kAt>(std::index_sequence<kAt...> /*all*/) {
    return (answers.template operator()<kAt>() || ...);
  }
  (std::make_index_sequence<std::size(kRungs)>());
}

template <Question kQuestion>
void Ladder::answer(Ask& ask) {
  if (!climb<kQuestion, Group::bodies>(ask)) go_on<kQuestion>(ask);
}

template <Question kQuestion>
[[gnu::noinline]] void Ladder::go_on(Ask& ask) {
  if (!ask.is_known) {
    ask_general_methods(ask);
    tighten(ask);
  }
  if (kQuestion == Question::separation && conclude()) return;
  climb<kQuestion, Group::open>(ask);
}

void Ladder::ask_general_methods(Ask& ask) {
  const InPose in_pose_1(ask.first), in_pose_2(ask.second);
  const ConvexSet &first = in_pose_1.set(), &second = in_pose_2.set();
  const int n = second.dimension();
  if (ask.question == Question::gauge) return climb_general(first, second, ask, nullptr);
  if (ask.question == Question::distance) {
    const bool points = has_effect(ask.object_effects, ObjectEffects::closest_points);
    const ObjectPair pair(second, first, points);
    check_dimension("distance", "Q", ask.metric->dimension(), n);
    if (points) pairs_.begin(pair);
    climb_general(pair, *ask.metric, ask, points ? &pairs_ : nullptr);
    return;
  }
  center_2_.assign(ask.second);
  if (ask.about_origin) {
    center_1_.assign_origin(n);
  } else {
    center_1_.assign(ask.first);
  }
  const GrowthBody body(second, center_2_.point(), first, center_1_.point(), !ask.about_origin);
  const PointView ray(center_2_.point(), n, center_1_.point());
  climb_general(ray, body, ask, nullptr);
}

void Ladder::climb_general(const ConvexSet& A, const ConvexSet& Q, const Ask& ask, SupportPairs* pairs) {
  stopwatch_.start(std::min(options_.time_limit, ask.time_limit), &stop_);
  const double* start = ask.warm != nullptr ? recorded_normal(*ask.warm, A.dimension()) : nullptr;
  const Problem problem{A, Q, options_, stopwatch_, ask.effects, start, ask.threshold, pairs};
  methods_.begin(problem, answer_.distance);
  Ask same = ask;
  for (const Rung& rung : kRungs) {
    if (rung.group == Group::general && rung.is_due(*this, same) && rung.solve(*this, same)) break;
  }
  methods_.finish();
  if (ask.warm != nullptr) record_normal(answer_.distance.normal, *ask.warm);
  if (ask.question != Question::distance) return;
  answer_.closest_point_evaluations = answer_.gradient_evaluations = 0;
  const DistanceResult& distance = answer_.distance;
  const bool apart = pairs != nullptr && distance.lower > 0 && std::isfinite(distance.upper);
  if (apart && methods_.closest_points(*pairs, answer_.closest_point_1, answer_.closest_point_2)) {
    ++answer_.closest_point_evaluations;
  } else {
    answer_.closest_point_1.resize(0);
    answer_.closest_point_2.resize(0);
  }
}

// By what fixed-size code has proven where it has no answer.
void Ladder::tighten(const Ask& ask) {
  DistanceResult& result = answer_.distance;
  const Bounds& proven = ask.proven.bounds;
  const bool final =
      result.status == DistanceStatus::contains_origin || result.status == DistanceStatus::unreachable;
  Bounds bounds(result.lower, result.upper);
  const bool higher = bounds.raise_lower(proven.lower()), closer = bounds.reduce_upper(proven.upper());
  if (final || !(higher || closer) || !bounds.agree()) return;
  if (higher) result.normal = Vector::Map(ask.proven.normal, ask.first.dimension());
  const DistanceStatus status = bounds.close(options_.tolerance) ? DistanceStatus::optimal : result.status;
  write_bounds(bounds, std::min(result.distance, std::numeric_limits<double>::max()), status, result);
}

bool Ladder::Solve::by_passes(Ladder& ladder, Ask& ask) {
  StreamedDistance streamed(ask.first.set, ask.second.set, ladder.options_, &ladder.stop_);
  ladder.answer_.distance = streamed.solve(ask.effects);
  return true;
}

// Bodies that have come to overlap since the solve before have a depth.
bool Ladder::Solve::body_distance(Ladder& ladder, Ask& ask) {
  bool likely_overlap = false;
  const auto is_known = [&](bool* overlap) {
    return ladder.bodies_.distance(ask.first, ask.second, *ask.metric, ladder.options_, ask.object_effects,
                                   ask.warm, ladder.answer_, overlap);
  };
  const bool wants_depth = ladder.has_depth_start_ && Due::unknown_depth(ladder, ask);
  if (is_known(wants_depth ? &likely_overlap : nullptr)) return true;
  if (likely_overlap) {
    ladder.guesses_overlap_ = true;
    const bool overlaps = depth(ladder, ask);
    ladder.guesses_overlap_ = false;
    if (overlaps || is_known(nullptr)) return true;
  }
  ask.is_distance_open = ladder.bodies_.was_asked();
  ask.proven = ladder.bodies_.proven();
  return false;
}

// The growth distance may be too near 1 to tell on which side it is.
bool Ladder::Solve::body_growth(Ladder& ladder, Ask& ask) {
  ask.is_known =
      ladder.bodies_.growth(ask.second, ask.first, ask.about_origin, ladder.options_, ask.threshold, ask.warm,
                            ladder.answer_.distance, ask.pose_gradient != nullptr);
  if (!ask.is_known) ask.proven = ladder.bodies_.proven();
  return ask.is_known && (ask.question == Question::growth || ladder.conclude());
}

// A growth distance on one side of 1; true where the bounds say so.
bool Ladder::conclude() {
  const DistanceResult& growth = answer_.distance;
  const Separation outcome = growth.lower > 1   ? Separation::separated
                             : growth.upper < 1 ? Separation::intersecting
                                                : Separation::undecided;
  conclude(outcome, {growth.lower, growth.upper});
  if (outcome == Separation::separated) separation_.normal = growth.normal;
  return outcome != Separation::undecided;
}

// The normal of a separation is the caller's to set.
void Ladder::conclude(Separation outcome, Bounds growth) {
  if (outcome == Separation::separated) growth.raise_lower(1);
  if (outcome == Separation::intersecting) growth.reduce_upper(1);
  separation_.outcome = outcome;
  separation_.lower = growth.lower();
  separation_.upper = growth.upper();
  separation_.counters = answer_.distance.counters;
  if (outcome != Separation::separated) separation_.normal.resize(0);
}

void Ladder::set_options(const DistanceOptions& options) {
  if (const std::string problem = validate(options); !problem.empty()) throw InvalidParameterError(problem);
  options_ = options;
  meshes_.reset();
}

const DistanceResult& Ladder::gauge(Ask& ask) {
  answer<Question::gauge>(ask);
  return answer_.distance;
}

// The distance writes over the normal of the solve before, from which a depth may begin.
ObjectDistance& Ladder::distance(Ask& ask) {
  bodies_.begin();
  const int n = ask.first.dimension();
  const bool had_depth = !std::isnan(answer_.depth.depth);
  const bool wants_depth = has_effect(ask.object_effects, ObjectEffects::depth);
  has_depth_start_ = wants_depth && ask.warm != nullptr && n <= 3 && recorded_normal(*ask.warm, n) != nullptr;
  if (has_depth_start_) depth_start_ = *ask.warm;
  answer_.depth.evaluations = 0;
  answer<Question::distance>(ask);
  if (wants_depth && !(answer_.distance.lower > 0)) {
    if (answer_.depth.evaluations == 0) find_depth(ask);
  } else if (had_depth || answer_.depth.evaluations > 0) {
    answer_.depth = ObjectDepth();
  }
  if (ask.warm != nullptr) ask.warm->overlap = answer_.depth.lower > 0;
  answer_.pose_gradient_evaluations = 0;
  if (has_effect(ask.object_effects, ObjectEffects::pose_gradient)) {
    find_pose_gradient(ask);
  } else {
    answer_.pose_gradient.kind = GradientKind::none;
  }
  return answer_;
}

// The bodies of a distance or a growth distance where fixed-size code has put them, if it was asked.
const SpatialPair* Ladder::known_pair(const Ask& ask) const {
  return Due::open_to_bodies(*this, ask) ? bodies_.pair() : nullptr;
}

const DistanceResult& Ladder::growth(Ask& ask) {
  bodies_.begin();
  answer<Question::growth>(ask);
  if (ask.pose_gradient != nullptr) find_growth_gradient(ask);
  return answer_.distance;
}

const SeparationResult& Ladder::separation(Ask& ask) {
  ask.threshold = 1;
  answer<Question::separation>(ask);
  return separation_;
}

std::string Ladder::table() {
  std::string text = "| rung | asked by | method | arithmetic | when |\n| --- | --- | --- | --- | --- |\n";
  int number = 0;
  for (const Rung& rung : kRungs) {
    std::string askers;
    for (const auto& [question, name] : {std::pair{kGauge, "distance"},
                                         {kDistance, "objects"},
                                         {kGrowth, "growth"},
                                         {kSeparation, "separation"}}) {
      if ((rung.questions & question) != 0) askers += (askers.empty() ? "" : ", ") + std::string(name);
    }
    text += "| " + std::to_string(++number) + " | " + (rung.questions == kAll ? "all" : askers) + " | " +
            rung.method + " | " + rung.arithmetic + " | " + rung.when + " |\n";
  }
  return text;
}

}  // namespace raygauge
