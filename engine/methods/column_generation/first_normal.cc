// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/column_generation/first_normal.h"

#include <algorithm>
#include <cmath>

#include "engine/methods/column_generation/tuning.h"
#include "engine/sets/isotropic_map.h"

namespace raygauge {
void FirstNormal::guess(WorkingSets& sets) {
  const int n = sets.n();
  double* guess = sets.direction();
  sets.A().set->center_unchecked(guess);
  for (int k = 0; k < n; ++k) guess[k] *= -sets.A().factor[k];
  framed_ = choose_frame(sets);
  if (framed_) turn(guess, n);
  double largest = 0;
  for (int k = 0; k < n; ++k) largest = std::max(largest, std::fabs(guess[k]));
  for (int k = 0; k < n && largest > 0; ++k) guess[k] /= largest;
  if (!(largest > 0)) guess[0] = 1.0;
  looked_ = n >= tuned::kLeastForAxes && !framed_;
  if (looked_) axes_.find(sets.Q().pool.view(), n);
}

void FirstNormal::start(WorkingSets& sets, PrimalSimplex& program) const {
  const FirstGuess::Frame frame = {frame_.data(), inverse_frame_.data()};
  program.start(
      sets.A().pool, sets.Q().pool,
      {sets.direction(), error(sets), framed_ ? &frame : nullptr, looked_ && axes_.any() ? &axes_ : nullptr});
}

// Of the first normal, relative.
double FirstNormal::error(const WorkingSets& sets) {
  const double spacing = std::max(sets.A().set->spacing(), sets.Q().set->spacing());
  if (!sets.is_complete()) return tuned::kNormalErrorOfSample + tuned::kSpacingsOfSample * spacing;
  const bool few = sets.n() <= tuned::kDimensionsOfTableau;
  return (few ? tuned::kNormalErrorOfFew : tuned::kNormalErrorOfMany) + spacing;
}

// The isotropic map of Q, scaled as Q is. False where none is needed.
bool FirstNormal::choose_frame(const WorkingSets& sets) {
  const IsotropicMap* map = sets.Q().set->isotropic();
  if (map == nullptr) return false;
  const auto n = static_cast<std::size_t>(sets.n());
  frame_.reserve(n * n);
  inverse_frame_.reserve(n * n);
  for (int j = 0; j < sets.n(); ++j) {
    for (int i = 0; i < sets.n(); ++i) {
      const std::size_t entry = static_cast<std::size_t>(j) * n + static_cast<std::size_t>(i);
      frame_[entry] = sets.Q().factor[i] * map->F(i, j);
      inverse_frame_[entry] = map->inverse(i, j) / sets.Q().factor[j];
    }
  }
  return true;
}

// F⁻ᵀ F⁻¹ v in place of v, with as much room behind it.
void FirstNormal::turn(double* v, int n) const {
  using Map = Eigen::Map<const Eigen::MatrixXd>;
  const Map inverse(inverse_frame_.data(), n, n);
  Eigen::Map<Eigen::VectorXd> guess(v, n);
  Eigen::Map<Eigen::VectorXd> white(v + n, n);
  white.noalias() = inverse * guess;
  guess.noalias() = inverse.transpose() * white;
}

}  // namespace raygauge
