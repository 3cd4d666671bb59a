// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Where sifting begins: the first normal, by a guess or by the interior-point method.
#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/lp/affords.h"
#include "engine/methods/column_generation/sifting.h"
#include "engine/numerics/floating_point.h"
#include "engine/sets/isotropic_map.h"

namespace raygauge {
namespace {

// Dimensions from which on the interior-point method finds the optimal basis, or that there is none, sooner
// than the simplex, by the points of both sets for each dimension (AVX-512, its time over that of the
// simplex): N = n + 2 to 3 n: 0.6 to 0.9 at n = 60, 0.5 at n = 80, 0.3 at n = 120, 0.1 from n = 200 on;
// N = 10 n: 1.5 at n = 80, 1 at n = 100, 0.9 at n = 120; N = 100 n: 1.3 at n = 150, 1.1 at n = 200.
constexpr int kInteriorOfFew = 70;
constexpr int kInteriorOfSome = 130;
constexpr int kInteriorOfMany = 200;
constexpr std::ptrdiff_t kFewPoints = 8;
constexpr std::ptrdiff_t kManyPoints = 60;

// Dimensions from which on it pays to look whether points of Q stand on the axes.
constexpr int kLeastForAxes = 16;

// Of an upper bound: the gap of an interior-point method whose columns make a good basis all the same.
constexpr double kNearUpperBound = 1e-3;

// In which the simplex chooses basis changes by a tableau.
constexpr int kFewDimensions = 10;

// Of the normal that it ends with, where its columns make no basis.
constexpr double kErrorInside = 1e-3;

}  // namespace

// Guess of the normal: from the centre of A towards the origin, as seen where Q is in isotropic position.
// Exact for homothetic ellipsoids, and never far off in angle for anything round.
void Sifting::start() {
  double* guess = direction_.data();
  A_->center_unchecked(guess);
  for (int k = 0; k < n_; ++k) guess[k] *= -scaling_.factor_A()[k];
  const bool framed = choose_frame();
  if (framed) turn_guess(guess);
  double largest = 0;
  for (int k = 0; k < n_; ++k) largest = std::max(largest, std::fabs(guess[k]));
  for (int k = 0; k < n_ && largest > 0; ++k) guess[k] /= largest;
  if (!(largest > 0)) guess[0] = 1.0;
  const bool look = n_ >= kLeastForAxes && !framed;
  if (look) axes_.find(working_Q_.view(), n_);
  if (n_ >= least_for_interior() && !(look && axes_.complete())) {
    solve_inside(guess);
    basis_is_due_ = may_be_proven_inside();
    if (basis_is_due_) return start_at_normal();
    if (interior_state_ == InteriorState::converged) return start_inside();
  }
  const double error = guess_error();
  const PrimalSimplex::Frame frame = {frame_.data(), inverse_frame_.data()};
  program_.start(working_A_, working_Q_, guess, error, framed ? &frame : nullptr,
                 look && axes_.any() ? &axes_ : nullptr);
}

int Sifting::least_for_interior() const {
  const std::ptrdiff_t points = A_->size() + Q_->size();
  if (points <= kFewPoints * n_) return kInteriorOfFew;
  return points <= kManyPoints * n_ ? kInteriorOfSome : kInteriorOfMany;
}

// Of the first normal, relative. Where all points are priced from the start, bounds too narrow, which have to
// be raised, cost more than bounds too wide; a normal of a sample had better stay near the guess.
double Sifting::guess_error() const {
  const double spacing = std::max(A_->spacing(), Q_->spacing());
  if (!is_complete()) return 0.02 + 0.8 * spacing;
  return (n_ <= kFewDimensions ? 0.15 : 0.05) + spacing;
}

// From the columns that carry weight at the end of the interior-point method, or from its normal.
void Sifting::start_inside() {
  interior_.columns(start_);
  if (!separated_ && affords_inverse(*stopwatch_, n_ + 1, *kernels_) &&
      program_.start_from(working_A_, working_Q_, start_, *stopwatch_))
    return;
  start_at_normal();
}

// Whether what the interior-point method ends with may prove the answer without a basis, whose inverse takes
// longer than all its other proofs. Where its equations have lost their digits, it may have come near a known
// upper bound.
bool Sifting::may_be_proven_inside() const {
  if (!is_complete() || !chosen_A_.empty()) return false;
  if (interior_state_ == InteriorState::failed)
    return ray_.upper() < kInfinity && interior_.duals()[n_] >= (1 - kNearUpperBound) * ray_.upper();
  return interior_state_ == InteriorState::paused ||
         (interior_state_ == InteriorState::converged &&
          (ray_.upper() < kInfinity || interior_.is_degenerate()));
}

// What start() has put off.
void Sifting::begin_from_basis() {
  if (std::exchange(basis_is_due_, false)) start_inside();
}

void Sifting::start_at_normal() {
  double* guess = direction_.data();
  double largest = 0;
  for (int k = 0; k < n_; ++k) largest = std::max(largest, std::fabs(interior_.normal()[k]));
  for (int k = 0; k < n_; ++k) guess[k] = interior_.normal()[k] / largest;
  program_.start(working_A_, working_Q_, guess, kErrorInside);
}

// Whether the interior-point method's normal, which separates the working sets, separates the sets.
bool Sifting::is_separated() {
  double* u = direction_.data();
  double* v = u + n_;
  for (int k = 0; k < n_; ++k) {
    u[k] = Scaling::direction_component(scaling_.factor_A()[k], interior_.normal()[k]);
    v[k] = -Scaling::direction_component(scaling_.factor_Q()[k], interior_.normal()[k]);
  }
  counters_.support_queries += 2;
  counters_.points_priced += A_->size() + Q_->size();
  h_A_ = support_value(*kernels_, *A_, u, nullptr, resolution_for(tolerance_));
  h_Q_ = support_value(*kernels_, *Q_, v, nullptr, resolution_for(tolerance_));
  return lower_bound(h_A_, h_Q_) == kInfinity;
}

// The isotropic map of Q, scaled as Q is. False where none is needed.
bool Sifting::choose_frame() {
  const IsotropicMap* map = Q_->isotropic();
  if (map == nullptr) return false;
  const auto n = static_cast<std::size_t>(n_);
  frame_.reserve(n * n);
  inverse_frame_.reserve(n * n);
  for (int j = 0; j < n_; ++j) {
    for (int i = 0; i < n_; ++i) {
      const std::size_t entry = static_cast<std::size_t>(j) * n + static_cast<std::size_t>(i);
      frame_[entry] = scaling_.factor_Q()[i] * map->F(i, j);
      inverse_frame_[entry] = map->inverse(i, j) / scaling_.factor_Q()[j];
    }
  }
  return true;
}

// F⁻ᵀ F⁻¹ v in place of v.
void Sifting::turn_guess(double* v) const {
  using Map = Eigen::Map<const Eigen::MatrixXd>;
  const Map inverse(inverse_frame_.data(), n_, n_);
  Eigen::Map<Eigen::VectorXd> guess(v, n_);
  Eigen::Map<Eigen::VectorXd> white(v + n_, n_);
  white.noalias() = inverse * guess;
  guess.noalias() = inverse.transpose() * white;
}

}  // namespace raygauge
