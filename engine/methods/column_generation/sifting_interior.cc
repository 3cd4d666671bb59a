// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// Degenerate optima, where a simplex stalls: what the interior-point method proves without a basis.
#include <algorithm>
#include <cmath>

#include "engine/methods/column_generation/sifting.h"
#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

// A distance that small, in units where both sets have magnitude 1, may be zero.
constexpr double kMaybeZero = 1e-4;

// An objective that small, in the same units, is zero or close to it: it is worth a look at the points of A.
constexpr double kNearlyZero = 1e-6;

// An interior-point method that fails so soon fails for the condition of the points, not of the problem.
constexpr std::int64_t kFewIterations = 12;

// A weight above carries, others are zero but for rounding: of most bases, and of those that a shear has left
// so ill-conditioned that weights of 1e-4 are rounding.
constexpr double kCarries[] = {1e-9, 1e-3};

// Of the relative gap that is asked for: where a known upper bound is met.
constexpr double kShareOfTolerance = 0.25;

// That exact arithmetic may take for weights that other arithmetic has as good.
constexpr double kSecondsForWeights = 1e-3;

// Of points of Q with -u·q <= 1, which all are, those with |u·q| up to here may lie in the plane of u on its
// way to infinity.
constexpr double kNearPlane = 30;

}  // namespace

bool Sifting::interior_may_help(PrimalSimplex::End end) const noexcept {
  if (end != PrimalSimplex::End::stalled && end != PrimalSimplex::End::failed) return false;
  return interior_state_ == InteriorState::untried && n_ >= kLeastToStall && is_complete() &&
         chosen_A_.empty();
}

// True where the result is complete. Otherwise the simplex goes on, from a better start if there is one.
bool Sifting::finish_inside(Effects effects, DistanceResult& result) {
  solve_inside(direction_.data());
  if (separated_ && is_separated()) {
    finish(DistanceStatus::unreachable, kInfinity, kInfinity, effects, result);
    return true;
  }
  if (certify_on_the_way(effects, result)) return true;
  program_.be_patient();
  if (interior_state_ == InteriorState::converged) start_inside();
  return false;
}

// Runs the interior-point method, from a guess of the normal.
void Sifting::solve_inside(const double* guess) {
  ray_.find(working_A_, working_Q_, n_);
  interior_.may_pause(is_complete() && chosen_A_.empty());
  interior_.end_at((1 - kShareOfTolerance * tolerance_) * ray_.upper());
  InteriorPoint::End end =
      interior_.solve(working_A_.view(), working_Q_.view(), n_, guess, *kernels_, *stopwatch_);
  const bool soon = interior_.iterations() < kFewIterations && !stopwatch_->expired();
  if (end == InteriorPoint::End::failed && soon && whitened_.compute(working_A_, working_Q_, n_, *stopwatch_))
    end = interior_.solve_whitened(whitened_, n_, guess, *kernels_, *stopwatch_);
  note_inside(end);
}

void Sifting::note_inside(InteriorPoint::End end) {
  separated_ = end == InteriorPoint::End::separated;
  switch (end) {
    case InteriorPoint::End::failed:
      interior_state_ = InteriorState::failed;
      break;
    case InteriorPoint::End::paused:
      interior_state_ = InteriorState::paused;
      break;
    default:
      interior_state_ = InteriorState::converged;
  }
}

// Where a limit on basis changes ends a solve that knows no upper bound: some steps of the interior-point
// method, none of which is a basis change.
bool Sifting::certify_by_last_look(Effects effects, DistanceResult& result) {
  const bool untried = interior_state_ == InteriorState::untried && n_ >= kLeastToStall;
  if (!untried || !is_complete() || !chosen_A_.empty()) return false;
  const std::vector<double> guess(program_.normal(), program_.normal() + n_);
  solve_inside(guess.data());
  if (interior_state_ == InteriorState::failed) return false;
  return certify_on_the_way(effects, result);
}

// Where the interior-point method has paused and nothing is proven, it goes on.
bool Sifting::certify_on_the_way(Effects effects, DistanceResult& result) {
  while (!certify_inside(effects, result)) {
    if (interior_state_ != InteriorState::paused) return false;
    note_inside(interior_.go_on(*stopwatch_));
    if (separated_ && is_separated()) {
      finish(DistanceStatus::unreachable, kInfinity, kInfinity, effects, result);
      return true;
    }
  }
  return true;
}

// The lower bound of the interior-point method's normal where that is better than `lower`, the one of the
// program's normal, which is the normal at hand otherwise.
double Sifting::bound_inside(double lower) {
  if (interior_state_ == InteriorState::untried) return lower;
  const std::vector<double> nothing(static_cast<std::size_t>(n_) + 1, 0.0);
  std::int64_t best_A = 0;
  std::int64_t best_Q = 0;
  const double inside = refine_lower(interior_.duals(), nothing.data(), &best_A, &best_Q);
  if (inside > lower && inside < kInfinity) return inside;
  return refine_lower(program_.normal(), nothing.data(), &best_A, &best_Q);
}

// By what the interior-point method ends with: the columns that carry weight, or a plane.
bool Sifting::certify_inside(Effects effects, DistanceResult& result) {
  const double* y = interior_.duals();
  const double distance = std::fabs(y[n_]);
  if (certify_ray(effects, result)) return true;
  if (distance < kMaybeZero && certify_carriers(0, effects, result)) return true;
  if (certify_carriers(distance, effects, result)) return true;
  if (distance < 1 / kMaybeZero) return false;
  farkas_.assign(y, y + n_);
  return certify_by_plane(kNearPlane / farthest_of_Q(y), effects, result) ||
         certify_by_plane(effects, result);
}

// max u·q.
double Sifting::farthest_of_Q(const double* u) {
  const double* products = products_with(working_Q_, u);
  return *std::max_element(products, products + working_Q_.size());
}

// The point of A on a ray with one of Q, where the normal proves that there is no better one.
bool Sifting::certify_ray(Effects effects, DistanceResult& result) {
  const double upper = ray_.upper();
  if (!(upper < kInfinity) || !(interior_.duals()[n_] >= (1 - tolerance_) * upper)) return false;
  const double lower = bound_inside(0);
  if (!Bounds(lower, upper).close(tolerance_)) return false;
  finish_with_ray(DistanceStatus::optimal, lower, effects, result);
  return true;
}

// As finish(), with the upper bound of that point.
void Sifting::finish_with_ray(DistanceStatus status, double lower, Effects effects, DistanceResult& result) {
  finish(status, lower, ray_.upper(), effects, result);
  const double ratio = std::ldexp(ray_.ratio(), -scaling_.distance_shift());
  result.distance = std::max(result.lower, std::min(ratio, result.upper));
  double* contact = result.room_for_contact(effects, n_);
  if (contact == nullptr) return;
  working_A_.copy_point(ray_.point_of_A(), contact);
  for (int k = 0; k < n_; ++k) contact[k] /= scaling_.factor_A()[k];
}

// carriers_ into face_, those of A alone or of both sets.
void Sifting::collect_carriers(bool with_Q) {
  face_.begin(n_ + 1, *kernels_);
  std::vector<double> column(static_cast<std::size_t>(n_) + 1);
  for (const auto& [id, weight] : carriers_) {
    const bool from_Q = is_from_Q(id);
    if (from_Q && !with_Q) continue;
    (from_Q ? working_Q_ : working_A_).copy_point(id / 2, column.data());
    for (int k = 0; from_Q && k < n_; ++k) column[static_cast<std::size_t>(k)] *= -1;
    column.back() = from_Q ? 0.0 : 1.0;
    face_.add(column.data(), from_Q ? 1.0 : 0.0, weight, id);
  }
}

// The carriers where d is about `distance`, those of A alone where that is 0.
bool Sifting::certify_carriers(double distance, Effects effects, DistanceResult& result) {
  interior_.carriers(distance > 0 ? distance : 1.0, carriers_);
  collect_carriers(distance > 0);
  const std::size_t rows = static_cast<std::size_t>(n_) + 1;
  if (!face_.choose(*stopwatch_)) return false;
  const double upper = face_.upper(*stopwatch_);
  if (!(upper < kInfinity)) return false;
  std::vector<double> y(interior_.duals(), interior_.duals() + rows), y_low(rows);
  face_.refine_duals(y.data(), y_low.data());
  std::int64_t best_A = 0;
  std::int64_t best_Q = 0;
  const double lower = refine_lower(y.data(), y_low.data(), &best_A, &best_Q);
  // Weights of dependent points are not the one solution that a result is to hold.
  if (upper > 0 ? !Bounds(lower, upper).close(tolerance_) : !face_.is_independent_zero(*stopwatch_))
    return false;
  finish_with_face(lower, upper, effects, result);
  return true;
}

// Where the objective is zero but for rounding, whatever the simplex is at: whether the basic points of A
// that carry weight combine to the origin. The simplex itself may need many basis changes more, without a
// gain, until no artificial column is left.
bool Sifting::certify_zero(Effects effects, DistanceResult& result) {
  if (n_ < kLeastToStall || !(program_.objective() < kNearlyZero) || program_.pivots() == pivots_at_zero_)
    return false;
  pivots_at_zero_ = program_.pivots();
  int tried = 0;
  for (const double least : kCarries) {
    if (!collect_face(least, false) || face_.count() == tried) continue;
    tried = face_.count();
    if (!face_.is_independent_zero(*stopwatch_)) continue;
    price_everything(true);  // the result has the normal at hand
    finish_with_face(0, 0, effects, result);
    return true;
  }
  return false;
}

// An upper bound from the basic columns with weight alone: at a degenerate optimum the others prove nothing.
double Sifting::upper_of_face() {
  int tried = 0;
  for (const double least : kCarries) {
    if (!collect_face(least) || face_.count() == tried) break;
    tried = face_.count();
    const double upper = face_.choose(*stopwatch_) ? face_.upper(*stopwatch_) : kInfinity;
    if (upper < kInfinity) return upper;
  }
  return kInfinity;
}

// The basic columns with a weight above `least`, into face_, those of A alone or of both sets. False where
// there is none, or an artificial one is among them.
bool Sifting::collect_face(double least, bool with_Q) {
  const BasisView& view = program_.basis().view();
  face_.begin(n_ + 1, *kernels_);
  for (int i = 0; i <= n_; ++i) {
    const double weight = view.x()[i];
    if (!(weight > least)) continue;
    if (is_artificial(view.id[i])) return false;
    if (is_from_Q(view.id[i]) && !with_Q) continue;
    face_.add(program_.basis().column(i), is_from_Q(view.id[i]) ? 1.0 : 0.0, weight, view.id[i]);
  }
  return face_.count() > 0;
}

// Where the enclosure does not tell how the weights round: by exact arithmetic, if that takes no time.
void Sifting::round_weights_of_face(std::vector<PointWeight>& weights) {
  start_.clear();
  for (const PointWeight& weight : weights) start_.push_back(id_of_A(weight.index));
  const ExactSimplex::End end =
      exact_.solve({A_, chosen_A_}, {Q_, chosen_Q_}, start_, *stopwatch_, kSecondsForWeights);
  if (end == ExactSimplex::End::solved && exact_.distance().above == 0) exact_.weights_of_A(weights);
}

void Sifting::weights_of_face(std::vector<PointWeight>& weights) const {
  weights.clear();
  for (int i = 0; i < face_.count(); ++i) {
    if (is_from_Q(face_.id(i))) continue;
    weights.push_back({working_A_.index_in(*A_, scaling_.factor_A(), face_.id(i) / 2), face_.weight(i)});
  }
}

// Of the basic solution, which is known to combine points of A to the origin: rounded as the rational
// numbers that they are, by the first arithmetic that is certain of it.
void Sifting::find_origin_weights(std::vector<PointWeight>& weights) {
  if (upper_of_face() == 0) {
    weights_of_face(weights);
    if (face_.is_rounded()) return;
  } else {
    program_.origin_weights(weights);
    for (PointWeight& weight : weights) {
      weight.index = working_A_.index_in(*A_, scaling_.factor_A(), weight.index);
    }
  }
  collect_basis();
  if (exact_.solve({A_, chosen_A_}, {Q_, chosen_Q_}, start_, *stopwatch_, kSecondsForWeights) ==
          ExactSimplex::End::solved &&
      exact_.distance().above == 0) {
    exact_.weights_of_A(weights);
    return;
  }
  using End = TwofoldSimplex::End;
  const End end = twofold_.solve({A_, scaling_.factor_A()}, {Q_, scaling_.factor_Q()}, start_,
                                 0.25 * tolerance_, *kernels_, *stopwatch_);
  if (end == End::solved && twofold_.upper(*stopwatch_) == 0) twofold_.weights_of_A(weights);
}

// u·p of the points, until the next call.
const double* Sifting::products_with(const ColumnPool& pool, const double* u) {
  const PricedPoints points = pool.view();
  collected_value_.reserve(static_cast<std::size_t>(points.block_count) * PointSet::kLanes);
  kernels_->products(points.blocks, points.block_count, n_, u, collected_value_.data());
  return collected_value_.data();
}

// As finish(), with the weights of the face.
void Sifting::finish_with_face(double lower, double upper, Effects effects, DistanceResult& result) {
  finish(DistanceStatus::optimal, lower, upper, effects, result);
  if (upper == 0) {
    result.status = DistanceStatus::contains_origin;
    weights_of_face(result.origin_weights);
    if (!face_.is_rounded()) round_weights_of_face(result.origin_weights);
  }
  double distance = 0;
  for (int i = 0; i < face_.count(); ++i) distance += is_from_Q(face_.id(i)) ? face_.weight(i) : 0.0;
  const double scaled = std::ldexp(distance, -scaling_.distance_shift());
  result.distance = std::max(result.lower, std::min(scaled, result.upper));
  double* contact = result.room_for_contact(effects, n_);
  if (contact == nullptr) return;
  std::fill_n(contact, n_, 0.0);
  for (int i = 0; i < face_.count(); ++i) {
    if (is_from_Q(face_.id(i))) continue;
    for (int k = 0; k < n_; ++k) contact[k] += face_.weight(i) * face_.column(i)[k] / scaling_.factor_A()[k];
  }
}

}  // namespace raygauge
