// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/scene/pair_solver.h"

#include <algorithm>
#include <cmath>

#include "engine/numerics/floating_point.h"
#include "engine/queries/spatial_solve.h"
#include "raygauge/sets/ball.h"

namespace raygauge {
namespace {

// Room for the rounding of the few operations of a bound, relative to what they are made of.
constexpr double kRounding = 1e-13;
constexpr double kOutward = 1 + kRounding;

constexpr double kNoThreshold = std::numeric_limits<double>::quiet_NaN();

DistanceOptions newton_options(double tolerance) {
  DistanceOptions options;
  options.method = DistanceMethod::newton;
  options.tolerance = tolerance;
  return options;
}

PoseNumbers numbers_of(const Placement& at) { return {at.R.data(), at.t.data(), at.defect}; }

void copy(const double* numbers, int n, SmallVector& v) {
  v.resize(n);
  if (n == 3) {
    Eigen::Vector3d::Map(v.data()) = Eigen::Vector3d::Map(numbers);
  } else {
    v = SmallVector::Map(numbers, n);
  }
}

// What h(u) of a placed set may lose: rounding_error(n) Σ_k |u_k| m_k with the magnitudes of PlacedSet, each
// at most |t_k| + `turned` (turned_magnitude).
double support_error(const SmallVector& u, double turned, const Placement& at) {
  const int n = static_cast<int>(u.size());
  return 2 * ConvexSet::rounding_error(n) * u.lpNorm<1>() * (at.t.lpNorm<1>() + turned);
}

}  // namespace

// A solve by fixed-size code, which keeps what it made of two parts while these move.
class PairSolver::FixedSolve {
 public:
  void forget() noexcept { first_ = nullptr; }

  // The solve about two bodies where they stand; nullptr where there is none.
  SpatialSolve* about(const ConvexSet& first, const PoseNumbers& at_1, const ConvexSet& second,
                      const PoseNumbers& at_2) {
    if (first_ != &first || second_ != &second) {
      first_ = &first;
      second_ = &second;
      bound_ = solve_.bind(first, second, InstructionSet::automatic);
    }
    return bound_ && solve_.place(at_1, at_2) ? &solve_ : nullptr;
  }

 private:
  SpatialSolve solve_;
  const ConvexSet* first_ = nullptr;
  const ConvexSet* second_ = nullptr;
  bool bound_ = false;
};

SceneCounters& SceneCounters::operator+=(const SceneCounters& other) {
  distance_solves += other.distance_solves;
  separation_solves += other.separation_solves;
  growth_solves += other.growth_solves;
  closest_points += other.closest_points;
  gradients += other.gradients;
  plane_tests += other.plane_tests;
  ball_tests += other.ball_tests;
  support_queries += other.support_queries;
  return *this;
}

void PairAnswer::begin(int a, int b) noexcept {
  lower = value = rate = 0;
  upper = std::numeric_limits<double>::infinity();
  status = DistanceStatus::optimal;
  part_a = a;
  part_b = b;
  for (SmallVector* vector : {&normal, &point_a, &point_b, &gradient}) vector->resize(0);
}

PairAnswer& PairSolver::Nearest::next(const PartPair& pair) noexcept {
  next_->begin(pair.a, pair.b);
  return *next_;
}

// The nearest of several parts is that of the least upper bound; common points end the search.
void PairSolver::Nearest::take_next() {
  if (best_->part_a < 0) return std::swap(best_, next_);
  const double lower = std::min(best_->lower, next_->lower);
  const double rate = std::max(best_->rate, next_->rate);
  if (next_->upper < best_->upper || next_->intersecting()) std::swap(best_, next_);
  best_->lower = lower;
  best_->rate = rate;
}

PairSolver::PairSolver(int dimension)
    : dimension_(dimension),
      distance_(newton_options(1e-6)),
      separation_(newton_options(1e-6)),
      growth_(newton_options(1e-6)),
      set_Q_(dimension),
      ball_(std::make_shared<Ball>(Vector::Zero(dimension), 1.0)),
      fixed_(std::make_unique<FixedSolve>()),
      pose_a_(dimension),
      pose_b_(dimension),
      tolerance_(1e-6) {}

PairSolver::~PairSolver() = default;

void PairSolver::set_tolerance(double tolerance) {
  if (tolerance == tolerance_) return;
  tolerance_ = tolerance;
  distance_ = ObjectDistanceSolver(newton_options(tolerance));
  growth_ = GrowthDistanceSolver(newton_options(tolerance));
}

void PairSolver::bind(const Body& a, const Body& b, const SceneMetric& metric) {
  a_ = &a;
  b_ = &b;
  metric_ = &metric;
  fixed_->forget();
  part_pairs_.clear();
  for (int i = 0; i < static_cast<int>(a.parts.size()); ++i) {
    for (int j = 0; j < static_cast<int>(b.parts.size()); ++j) part_pairs_.push_back({i, j, 0});
  }
  outer_radius_ = 1;
  if (!metric.euclidean()) {
    const BoundingBall ball = bounding_ball(*metric.Q);
    outer_radius_ = (ball.center.norm() + ball.radius) * kOutward;
    magnitude_Q_.resize(dimension_);
    metric.Q->magnitude_unchecked(magnitude_Q_.data());
  }
}

void PairSolver::place(const Placement& a, const Placement& b, const Placement* metric_at) {
  at_a_ = a;
  at_b_ = b;
  posed_ = false;
  if (metric_->euclidean()) return;
  Placement turned = Placement::identity(dimension_);
  if (metric_at != nullptr) turned.R = metric_at->R;
  set_Q_.place(*metric_->Q, turned);
}

double PairSolver::ball_bound(const double* center_a, const double* center_b) {
  ++counters_.ball_tests;
  const double radii = a_->ball.radius + b_->ball.radius;
  double square = 0, size = radii;
  for (int k = 0; k < dimension_; ++k) {
    const double apart = center_a[k] - center_b[k];
    square += apart * apart;
    size += std::fabs(center_a[k]) + std::fabs(center_b[k]);
  }
  return std::max(0.0, std::sqrt(square) - radii - kRounding * size) / (outer_radius_ * kOutward);
}

double PairSolver::part_ball_bound(int i, int j) const {
  const BoundingBall& ball_a = a_->parts[static_cast<std::size_t>(i)].ball;
  const BoundingBall& ball_b = b_->parts[static_cast<std::size_t>(j)].ball;
  const SmallVector center_a = at_a_.R * ball_a.center + at_a_.t;
  const SmallVector center_b = at_b_.R * ball_b.center + at_b_.t;
  const double radii = ball_a.radius + ball_b.radius;
  const double rounding = kRounding * (at_a_.t.norm() + at_b_.t.norm() + a_->reach + b_->reach + radii);
  return std::max(0.0, (center_a - center_b).norm() - radii - rounding) / (outer_radius_ * kOutward);
}

// -h_A(u), A = b - a, rounding errors included, or less; the support points are in the frames of the bodies.
double PairSolver::depth_along(int i, int j, const SmallVector& u, SmallVector& point_a,
                               SmallVector& point_b) const {
  const BodyPart& part_a = a_->parts[static_cast<std::size_t>(i)];
  const BodyPart& part_b = b_->parts[static_cast<std::size_t>(j)];
  point_a.resize(dimension_);
  point_b.resize(dimension_);
  const SmallVector inner_a = -at_a_.turned_back(u);
  const SmallVector inner_b = at_b_.turned_back(u);
  const double h = part_b.set->support_unchecked(inner_b.data(), point_b.data()) +
                   part_a.set->support_unchecked(inner_a.data(), point_a.data()) + u.dot(at_b_.t - at_a_.t);
  const double error =
      support_error(u, part_a.turned_magnitude, at_a_) + support_error(u, part_b.turned_magnitude, at_b_);
  return -(h + error);
}

double PairSolver::apart_along(const SmallVector& u, SmallVector& arm_a, SmallVector& arm_b) {
  ++counters_.plane_tests;
  SmallVector point_a, point_b;
  const double depth = depth_along(0, 0, u, point_a, point_b);
  arm_a = at_a_.turned(point_a);
  arm_b = at_b_.turned(point_b);
  return depth / (u.norm() * (depth > 0 ? kOutward : 1.0));
}

// Weak duality (10) at u: -h_A(u) / h_Q(-u).
double PairSolver::part_plane_bound(int i, int j, const SmallVector& u) const {
  SmallVector point, other;
  const double depth = depth_along(i, j, u, point, other);
  if (!(depth > 0)) return 0;
  if (metric_->euclidean()) return depth / (u.norm() * kOutward);
  const SmallVector minus = -u;
  const double h_Q = set_Q_.support_unchecked(minus.data(), point.data()) +
                     support_error(u, turned_magnitude(magnitude_Q_), Placement::identity(dimension_));
  return h_Q > 0 ? depth / (h_Q * kOutward) : 0.0;
}

std::size_t PairSolver::memory_index(const PartPair& pair) const {
  return static_cast<std::size_t>(pair.a) * b_->parts.size() + static_cast<std::size_t>(pair.b);
}

void PairSolver::sort_part_pairs() {
  if (part_pairs_.size() == 1) {
    part_pairs_.front().ball_bound = 0;
    return;
  }
  for (PartPair& pair : part_pairs_) {
    pair.ball_bound = part_ball_bound(pair.a, pair.b);
    ++counters_.ball_tests;
  }
  std::sort(part_pairs_.begin(), part_pairs_.end(), [](const PartPair& x, const PartPair& y) {
    if (x.ball_bound != y.ball_bound) return x.ball_bound < y.ball_bound;
    return x.a != y.a ? x.a < y.a : x.b < y.b;
  });
}

double PairSolver::plane_bound(const PairMemory& memory, double& rate) {
  double lower = kInfinity;
  rate = 0;
  if (memory.size() != part_pairs_.size()) return 0;
  for (const PartPair& pair : part_pairs_) {
    const SmallVector& u = memory[memory_index(pair)].normal;
    double bound = 0;
    if (u.size() > 0) {
      ++counters_.plane_tests;
      bound = part_plane_bound(pair.a, pair.b, u);
    }
    double pair_rate = metric_->euclidean() ? kOutward : 0.0;
    if (u.size() > 0 && !metric_->euclidean()) {
      SmallVector point(dimension_);
      const SmallVector minus = -u;
      const double h_Q = set_Q_.support_unchecked(minus.data(), point.data());
      pair_rate = u.norm() / h_Q * (1 + 1e-9);
    }
    if (part_pairs_.size() > 1) {
      ++counters_.ball_tests;
      const double ball = part_ball_bound(pair.a, pair.b);
      if (ball > bound) {
        bound = ball;
        pair_rate = ball_rate();
      }
    }
    if (!(bound > 0)) return 0;
    lower = std::min(lower, bound);
    rate = std::max(rate, pair_rate);
  }
  return lower;
}

// Checks where they stand, unless that was done before.
void PairSolver::check_placements() {
  for (Placement* at : {&at_a_, &at_b_}) {
    if (at->defect != Placement::kUnchecked) continue;
    Pose& pose = at == &at_a_ ? pose_a_ : pose_b_;
    pose.assign(at->R.data(), at->t.data());
    at->defect = pose.defect();
  }
}

void PairSolver::pose_bodies() {
  if (posed_) return;
  pose_a_.assign_checked(at_a_.R.data(), at_a_.t.data(), at_a_.defect);
  pose_b_.assign_checked(at_b_.R.data(), at_b_.t.data(), at_b_.defect);
  posed_ = true;
}

const ConvexSet& PairSolver::set_of_a(const PartPair& pair) const {
  return *a_->parts[static_cast<std::size_t>(pair.a)].set;
}

const ConvexSet& PairSolver::set_of_b(const PartPair& pair) const {
  return *b_->parts[static_cast<std::size_t>(pair.b)].set;
}

Posed PairSolver::part_of_a(const PartPair& pair) {
  pose_bodies();
  return {set_of_a(pair), pose_a_};
}

Posed PairSolver::part_of_b(const PartPair& pair) {
  pose_bodies();
  return {set_of_b(pair), pose_b_};
}

// Parts that overlapped before are asked first whether they still do: a growth distance, stopped at 1, proves
// it for a small part of what it costs a distance of smooth sets to end at 0.
bool PairSolver::still_overlap(const PartPair& pair, PartMemory& memory) {
  if (!memory.overlapped) return false;
  const SeparationResult& found = separation_.separation(part_of_a(pair), part_of_b(pair), &memory.growth);
  counters_.support_queries += found.counters.support_queries;
  return found.outcome == Separation::intersecting;
}

bool PairSolver::solve_fixed(const PartPair& pair, bool closest_points, PartMemory& memory,
                             PairAnswer& answer) {
  if (!metric_->euclidean()) return false;
  SpatialSolve* solve = fixed_->about(set_of_a(pair), numbers_of(at_a_), set_of_b(pair), numbers_of(at_b_));
  if (solve == nullptr || !solve->distance(tolerance_, &memory.distance)) return false;
  counters_.support_queries += solve->support_queries();
  const SpatialAnswer& found = solve->answer();
  memory.overlapped = found.end == SpatialEnd::intersecting;
  if (memory.overlapped) {
    answer.upper = 0;
    answer.status = DistanceStatus::contains_origin;
    return true;
  }
  answer.lower = found.lower;
  answer.value = answer.upper = found.upper;
  copy(solve->normal(), dimension_, answer.normal);
  copy(solve->normal(), dimension_, memory.normal);
  answer.rate = kOutward;
  if (!closest_points) return true;
  answer.point_a.resize(dimension_);
  answer.point_b.resize(dimension_);
  solve->closest_points(answer.point_a.data(), answer.point_b.data());
  ++counters_.closest_points;
  return true;
}

void PairSolver::solve_parts(const PartPair& pair, bool closest_points, PartMemory& memory,
                             PairAnswer& answer) {
  ++counters_.distance_solves;
  if (still_overlap(pair, memory)) {
    answer.upper = 0;
    answer.status = DistanceStatus::contains_origin;
    return;
  }
  if (solve_fixed(pair, closest_points, memory, answer)) return;
  const ConvexSet& Q = metric_->euclidean() ? *ball_ : static_cast<const ConvexSet&>(set_Q_);
  const ObjectDistance& found =
      distance_.solve(part_of_a(pair), part_of_b(pair), Q,
                      closest_points ? ObjectEffects::closest_points : ObjectEffects::none, &memory.distance);
  const DistanceResult& distance = found.distance;
  counters_.closest_points += found.closest_point_evaluations;
  counters_.support_queries += distance.counters.support_queries;
  memory.overlapped = distance.status == DistanceStatus::contains_origin;
  answer.lower = distance.lower;
  answer.upper = distance.upper;
  answer.value = distance.distance;
  answer.status = distance.status;
  answer.point_a = found.closest_point_1;
  answer.point_b = found.closest_point_2;
  if (!(distance.lower > 0)) return;
  answer.rate = distance.normal.norm() * kOutward;
  answer.normal = distance.normal;
  if (distance.normal.size() == dimension_) memory.normal = distance.normal;
}

const PairAnswer& PairSolver::distance(PairMemory& memory, double enough, bool closest_points,
                                       bool gradient) {
  memory.resize(part_pairs_.size());
  sort_part_pairs();
  nearest_.clear();
  double beyond = kInfinity;  // a lower bound of the parts that were not solved
  double beyond_rate = 0;
  for (const PartPair& pair : part_pairs_) {
    if (nearest_.best().part_a >= 0 && pair.ball_bound >= nearest_.best().upper) break;
    if (pair.ball_bound > enough) {
      beyond = std::min(beyond, pair.ball_bound);
      beyond_rate = std::max(beyond_rate, ball_rate());
      break;
    }
    check_placements();
    solve_parts(pair, closest_points, memory[memory_index(pair)], nearest_.next(pair));
    nearest_.take_next();
    if (nearest_.best().intersecting()) break;
  }
  PairAnswer& best = nearest_.best();
  if (best.part_a < 0) {
    best.begin(-1, -1);
    best.lower = beyond;
  } else {
    best.lower = std::min(best.lower, beyond);
    best.value = std::clamp(best.value, best.lower, best.upper);
  }
  best.rate = std::max(best.rate, beyond_rate);
  if (gradient && best.normal.size() == dimension_ && best.lower > 0) {
    best.gradient = best.normal;  // body a is moved: A1 of d_Q(A2 - A1)
    ++counters_.gradients;
  }
  return best;
}

PairSeparation PairSolver::separation(PairMemory& memory) {
  memory.resize(part_pairs_.size());
  sort_part_pairs();
  PairSeparation outcome = PairSeparation::separated;
  for (const PartPair& pair : part_pairs_) {
    if (pair.ball_bound > 0) break;
    PartMemory& kept = memory[memory_index(pair)];
    if (kept.normal.size() > 0) {
      ++counters_.plane_tests;
      if (part_plane_bound(pair.a, pair.b, kept.normal) > 0) continue;
    }
    check_placements();
    const SeparationResult& found = separation_.separation(part_of_a(pair), part_of_b(pair), &kept.growth);
    ++counters_.separation_solves;
    counters_.support_queries += found.counters.support_queries;
    if (found.outcome == Separation::intersecting) return PairSeparation::intersecting;
    if (found.outcome == Separation::undecided) {
      outcome = PairSeparation::undecided;
    } else {
      kept.normal = found.normal;
    }
  }
  return outcome;
}

void PairSolver::growth_of_parts(const PartPair& pair, WarmStart& warm, PairAnswer& answer) {
  ++counters_.growth_solves;
  SpatialSolve* solve = fixed_->about(set_of_a(pair), numbers_of(at_a_), set_of_b(pair), numbers_of(at_b_));
  if (solve != nullptr && solve->growth(false, tolerance_, kNoThreshold, &warm)) {
    counters_.support_queries += solve->support_queries();
    answer.lower = solve->answer().lower;
    answer.upper = solve->answer().upper;
    answer.value = std::min(answer.upper, std::numeric_limits<double>::max());
    if (answer.upper == 0) answer.status = DistanceStatus::contains_origin;
    return;
  }
  const DistanceResult& found = growth_.solve_about_centers(part_of_a(pair), part_of_b(pair), &warm);
  counters_.support_queries += found.counters.support_queries;
  answer.lower = found.lower;
  answer.upper = found.upper;
  answer.value = found.distance;
  answer.status = found.status;
}

const PairAnswer& PairSolver::growth(PairMemory& memory) {
  memory.resize(part_pairs_.size());
  sort_part_pairs();
  check_placements();
  least_growth_.clear();
  for (const PartPair& pair : part_pairs_) {
    growth_of_parts(pair, memory[memory_index(pair)].growth, least_growth_.next(pair));
    least_growth_.take_next();
  }
  PairAnswer& best = least_growth_.best();
  best.value = std::clamp(best.value, best.lower, best.upper);
  return best;
}

}  // namespace raygauge
