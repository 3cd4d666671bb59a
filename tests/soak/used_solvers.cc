// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "tests/soak/used_solvers.h"

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/ball.h"
#include "scene/queries/pair_solver.h"
#include "tests/soak/random_set.h"
#include "tests/soak/result_checks.h"

namespace raygauge::soak {
namespace {

constexpr int kMostDimensions = 6;
constexpr int kBatch = 3;
constexpr std::array<double, 2> kTolerances = {1e-6, 1e-10};
constexpr std::array<DistanceMethod, 3> kMethods = {DistanceMethod::newton, DistanceMethod::column_generation,
                                                    DistanceMethod::zheng_yamane};

DistanceOptions options_of(std::size_t team) {
  DistanceOptions options;
  options.tolerance = kTolerances[team % kTolerances.size()];
  options.method = kMethods[team / kTolerances.size()];
  return options;
}

// The numbers of an answer in order.
class Numbers {
 public:
  void add(double value) { bits_.push_back(std::bit_cast<std::uint64_t>(value)); }
  void add(const double* values, std::ptrdiff_t count) {
    add(static_cast<double>(count));
    for (std::ptrdiff_t i = 0; i < count; ++i) add(values[i]);
  }
  void add(const Vector& v) { add(v.data(), v.size()); }
  void add(const SmallVector& v) { add(v.data(), v.size()); }
  void add(const DistanceResult& r) {
    for (const double value : {r.distance, r.lower, r.upper, r.sigma, static_cast<double>(r.status)})
      add(value);
    add(r.normal);
    add(r.contact_point);
    for (const PointWeight& point : r.origin_weights) add(point.weight);
    const DistanceCounters& c = r.counters;
    for (const std::int64_t count :
         {c.outer_iterations, c.ray_iterations, c.pivots, c.support_queries, c.points_priced,
          c.refactorisations, c.exact_pivots, c.witness_evaluations})
      add(static_cast<double>(count));
  }
  void add(const WarmStart& warm) {
    add(static_cast<double>(warm.dimension));
    add(static_cast<double>(warm.count));
    add(warm.normal.data(), 3);
    add(warm.long_normal.data(), std::ssize(warm.long_normal));
    for (std::size_t i = 0; i < static_cast<std::size_t>(warm.count); ++i) {
      add(static_cast<double>(warm.point_A[i]));
      add(static_cast<double>(warm.point_Q[i]));
    }
  }
  friend bool operator==(const Numbers&, const Numbers&) = default;

 private:
  std::vector<std::uint64_t> bits_;
};

// Two bodies in poses: the second is moved to where a point of it is `gap` beyond one of the first.
struct Pair {
  Pair(RandomStream& stream, int n, double size)
      : A(draw_set(stream, Vector::Zero(n), size, 1)),
        B(draw_set(stream, Vector::Zero(n), size, 1)),
        pose_A(stream.uniform() < 0.3 ? Eigen::MatrixXd::Identity(n, n) : stream.rotation(n),
               Vector::Zero(n)),
        pose_B(n) {
    const Eigen::MatrixXd R =
        stream.uniform() < 0.5 ? Eigen::MatrixXd(pose_A.rotation()) : stream.rotation(n);
    const Vector u = pose_A.rotation() * draw_direction(stream, n);
    const double gap = stream.uniform() < 0.3 ? 0.0 : std::pow(10.0, -16 * stream.uniform());
    const double sign = stream.uniform() < 0.3 ? -1 : 1;
    const Vector a = pose_A.rotation() * support(*A.set, pose_A.rotation().transpose() * u),
                 b = R * support(*B.set, R.transpose() * -u);
    pose_B = Pose(R, a - b + sign * gap * size * u);
  }

  static Vector support(const ConvexSet& S, const Vector& u) {
    Vector point(u.size());
    S.support_unchecked(u.data(), point.data());
    return point;
  }

  Posed first() const { return {*A.set, pose_A}; }
  Posed second() const { return {*B.set, pose_B}; }

  RandomSet A, B;
  Pose pose_A, pose_B;
};

// Of what a query consists.
struct Query {
  Query(RandomStream& stream, int n, double size)
      : kind(static_cast<int>(stream.integer(0, n <= 3 ? 8 : 6))),
        effects(static_cast<ObjectEffects>(stream.integer(0, 3))),
        metric(std::make_shared<Ball>(Vector::Zero(n), stream.uniform() < 0.7 ? 1.0 : 2.0), "ball") {
    if (stream.uniform() < 0.2) metric = draw_set(stream, Vector::Zero(n), size, 0);
    const auto count = static_cast<std::size_t>(kind == 5 ? kBatch : 1);
    for (std::size_t i = 0; i < count; ++i) pairs.emplace_back(stream, n, size);
    is_warm = stream.uniform() < 0.5;
  }

  int kind;
  ObjectEffects effects;
  RandomSet metric;
  std::vector<Pair> pairs;
  bool is_warm = false;

  std::string text() const {
    constexpr std::array<const char*, 9> kKinds = {
        "distance",   "growth about centres", "growth about the origin",
        "separation", "distance of sets",     "batch",
        "distance",   "distance in a scene",  "growth in a scene"};
    return std::string(kKinds[static_cast<std::size_t>(kind)]) + " of " + pairs[0].A.label + " and " +
           pairs[0].B.label + " in R^" + std::to_string(pairs[0].A.set->dimension()) +
           (is_warm ? ", warm" : ", cold");
  }
};

}  // namespace

struct UsedSolvers::Team {
  explicit Team(const DistanceOptions& options)
      : distance(options), growth(options), sets(options), batch(options), in_R2(2), in_R3(3) {
    in_R2.set_tolerance(options.tolerance);
    in_R3.set_tolerance(options.tolerance);
  }

  Numbers answer(const Query& query, WarmStart& kept);
  void answer_batch(const Query& query, Numbers& numbers);
  void answer_in_scene(const Query& query, Numbers& numbers);

  ObjectDistanceSolver distance;
  GrowthDistanceSolver growth;
  DistanceSolver sets;
  PairBatch batch;
  PairSolver in_R2, in_R3;
  bool certified = false;  // the last answer
};

void UsedSolvers::Team::answer_batch(const Query& query, Numbers& numbers) {
  std::vector<PosedPair> pairs;
  for (const Pair& pair : query.pairs) pairs.push_back({pair.first(), pair.second()});
  const std::size_t count = pairs.size(), n = static_cast<std::size_t>(query.metric.set->dimension());
  std::vector<double> lower(count), upper(count), normal(count * n), points(count * n);
  BatchAnswers answers;
  answers.lower = lower;
  answers.upper = upper;
  answers.normal = normal;
  answers.closest_points_1 = points;
  batch.distances(pairs, *query.metric.set, answers);
  for (const auto* values : {&lower, &upper, &normal, &points})
    numbers.add(values->data(), std::ssize(*values));
  answers.closest_points_1 = {};
  batch.growth_distances(pairs, answers);
  for (const auto* values : {&lower, &upper, &normal}) numbers.add(values->data(), std::ssize(*values));
}

void UsedSolvers::Team::answer_in_scene(const Query& query, Numbers& numbers) {
  const Pair& pair = query.pairs[0];
  const int n = pair.A.set->dimension();
  const auto motion = std::make_shared<StaticMotion>(Placement::identity(n));
  const Body a = make_body("a", {pair.A.set}, motion), b = make_body("b", {pair.B.set}, motion);
  SceneMetric metric;
  if (query.metric.label != "ball") metric.Q = query.metric.set;
  PairSolver& solver = n == 2 ? in_R2 : in_R3;
  PairMemory memory;
  solver.bind(a, b, metric);
  solver.place(make_placement(pair.pose_A.rotation(), pair.pose_A.translation()),
               make_placement(pair.pose_B.rotation(), pair.pose_B.translation()));
  const PairAnswer& answer =
      query.kind == 7 ? solver.distance(memory, std::numeric_limits<double>::infinity(), true, true)
                      : solver.growth(memory);
  for (const double value :
       {answer.lower, answer.upper, answer.value, answer.rate, static_cast<double>(answer.status)})
    numbers.add(value);
  for (const auto* vector : {&answer.normal, &answer.point_a, &answer.point_b, &answer.gradient})
    numbers.add(*vector);
  numbers.add(static_cast<double>(solver.separation(memory)));
}

Numbers UsedSolvers::Team::answer(const Query& query, WarmStart& kept) {
  Numbers numbers;
  const Pair& pair = query.pairs[0];
  WarmStart* warm = query.is_warm ? &kept : nullptr;
  const auto take = [&](const DistanceResult& r) {
    numbers.add(r);
    certified = is_final(r);
  };
  switch (query.kind) {
    case 1:
      take(growth.solve_about_centers(pair.first(), pair.second(), warm));
      break;
    case 2:
      take(growth.solve(pair.first(), pair.second(), warm));
      break;
    case 3: {
      const SeparationResult& r = growth.separation(pair.first(), pair.second(), warm);
      numbers.add(static_cast<double>(r.outcome));
      numbers.add(r.lower);
      numbers.add(r.upper);
      numbers.add(r.normal);
      certified = r.outcome != Separation::undecided;
      break;
    }
    case 4:
      take(sets.solve(pair.second(), Posed(*query.metric.set), Effects::witness, warm));
      break;
    case 5:
      answer_batch(query, numbers);
      break;
    case 7:
    case 8:
      answer_in_scene(query, numbers);
      break;
    default: {
      const ObjectDistance& r =
          distance.solve(pair.first(), pair.second(), *query.metric.set, query.effects, warm);
      take(r.distance);
      for (const Vector* v : {&r.closest_point_1, &r.closest_point_2, &r.gradient_1, &r.gradient_2})
        numbers.add(*v);
    }
  }
  numbers.add(kept);
  return numbers;
}

UsedSolvers::UsedSolvers(std::uint64_t seed) : seed_(seed) {
  for (std::size_t team = 0; team < kTolerances.size() * kMethods.size(); ++team)
    teams_.push_back(std::make_unique<Team>(options_of(team)));
}

UsedSolvers::~UsedSolvers() = default;

std::optional<std::string> UsedSolvers::check(std::int64_t number) {
  RandomStream stream({seed_, 1, static_cast<int>(number >> 31), static_cast<int>(number & 0x7fffffff)},
                      "used_solvers", RandomPurpose::shape);
  const double share = stream.uniform();
  const int n = share < 0.6 ? 3 : share < 0.8 ? 2 : static_cast<int>(stream.integer(4, kMostDimensions));
  const double size =
      stream.uniform() < 0.7 ? 1.0 : std::ldexp(1.0, static_cast<int>(stream.integer(-40, 40)));
  const Query query(stream, n, size);
  const auto team = static_cast<std::size_t>(stream.integer(0, std::ssize(teams_) - 1));
  WarmStart left;
  if (query.is_warm) Team(options_of(team)).answer(query, left);
  WarmStart also_left = left;
  const Numbers used = teams_[team]->answer(query, left);
  tally_.certified += teams_[team]->certified ? 1 : 0;
  ++tally_.queries;
  Team fresh(options_of(team));
  if (fresh.answer(query, also_left) == used) return std::nullopt;
  return "query " + std::to_string(number) + ", " + query.text() + ", method " +
         std::string(to_string(options_of(team).method)) + ": a used solver and a new one differ";
}

std::string to_string(const UsedSolverTally& tally) {
  return std::to_string(tally.queries) + " queries of used solvers, " + std::to_string(tally.certified) +
         " certified\n";
}

}  // namespace raygauge::soak
