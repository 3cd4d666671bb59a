// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// The steps of the method, and how long they are.
#include <algorithm>
#include <utility>

#include "engine/lp/interior_point.h"
#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

constexpr double kStep = 0.995;  // of the way to the boundary
// Of further correctors, after J. Gondzio, Comput. Optim. Appl. 6 (1996).
constexpr int kCorrections = 4;
constexpr double kReachFurther = 0.3;   // longer steps to aim at
constexpr double kNeighbourhood = 0.1;  // of the centre, for products x·s: from 0.1 to 10 times it
constexpr double kLongEnough = 0.9;     // a step
constexpr double kWorthwhile = 0.05;    // gain in length of both steps

}  // namespace

// ds = -Aᵀdy and dx = S⁻¹ (target - X ds) - x: to first order x s becomes the target.
void InteriorPoint::directions(Side& side) {
  double* products = side.weight.data();
  price(side, dy_.data(), products);
  const double dt = side.last * dy_[static_cast<std::size_t>(n_)];
  for (std::ptrdiff_t i = 0; i < side.points.size; ++i) {
    const auto at = static_cast<std::size_t>(i);
    side.ds[at] = -side.sign * products[at] - dt;
    side.dx[at] = (side.target[at] - side.x[at] * side.ds[at]) / side.s[at] - side.x[at];
  }
}

// The Newton step to the targets: M dy = b - A S⁻¹ target, and dx, ds.
void InteriorPoint::follow_targets() {
  std::fill_n(dy_.data(), n_ + 1, 0.0);
  double sum_of_A = 0;
  for (Side* side : {&A_, &Q_}) {
    for (std::ptrdiff_t i = 0; i < side->count; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const double weight = i < side->points.size ? side->target[at] / side->s[at] : 0.0;
      side->weight[at] = -side->sign * weight;
      if (side == &A_) sum_of_A += weight;
    }
    add_weighted(*side, dy_.data());
  }
  dy_[static_cast<std::size_t>(n_)] = 1 - sum_of_A;
  solve_for(dy_.data());
  for (Side* side : {&A_, &Q_}) directions(*side);
}

double InteriorPoint::longest_step(const Side& side, const AlignedBuffer<double>& value,
                                   const AlignedBuffer<double>& change) {
  double rate = 0;  // the fastest fall, relative
  for (std::ptrdiff_t i = 0; i < side.points.size; ++i) {
    const auto at = static_cast<std::size_t>(i);
    rate = std::max(rate, -change[at] / value[at]);
  }
  return rate > 0 ? 1 / rate : kInfinity;
}

// x·s after steps of these lengths.
double InteriorPoint::complementarity(double step_x, double step_s) const {
  double sum = 0;
  for (const Side* side : {&A_, &Q_}) {
    for (std::ptrdiff_t i = 0; i < side->points.size; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const double x = side->x[at] + (step_x > 0 ? step_x * side->dx[at] : 0.0);
      const double s = side->s[at] + (step_s > 0 ? step_s * side->ds[at] : 0.0);
      sum += x * s;
    }
  }
  return sum;
}

InteriorPoint::Lengths InteriorPoint::longest_steps() const {
  Lengths lengths;
  for (const Side* side : {&A_, &Q_}) {
    lengths.x = std::min(lengths.x, kStep * longest_step(*side, side->x, side->dx));
    lengths.s = std::min(lengths.s, kStep * longest_step(*side, side->s, side->ds));
  }
  return lengths;
}

// Towards longer steps: products x·s that would leave the neighbourhood of the centre after them are drawn
// back.
void InteriorPoint::draw_to_centre(const Lengths& lengths, double centre) {
  const double x_length = std::min(1.0, lengths.x + kReachFurther);
  const double s_length = std::min(1.0, lengths.s + kReachFurther);
  for (Side* side : {&A_, &Q_}) {
    for (std::ptrdiff_t i = 0; i < side->points.size; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const double product =
          (side->x[at] + x_length * side->dx[at]) * (side->s[at] + s_length * side->ds[at]);
      const double least = kNeighbourhood * centre;
      const double most = centre / kNeighbourhood;
      if (product < least) side->target[at] += least - product;
      if (product > most) side->target[at] += std::max(most - product, -most);
    }
  }
}

void InteriorPoint::keep_step() {
  kept_dy_.reserve(static_cast<std::size_t>(n_) + 1);
  std::swap(dy_, kept_dy_);
  for (Side* side : {&A_, &Q_}) {
    std::swap(side->dx, side->kept_dx);
    std::swap(side->ds, side->kept_ds);
  }
}

// Predictor, corrector (Mehrotra), and further correctors as long as they lengthen the step (Gondzio).
InteriorPoint::Lengths InteriorPoint::choose_step() {
  for (Side* side : {&A_, &Q_}) std::fill_n(side->target.data(), side->count, 0.0);
  follow_targets();
  const Lengths affine = longest_steps();
  const double now = complementarity(0, 0);
  const double ratio = complementarity(affine.x, affine.s) / now;
  const double centre = ratio * ratio * ratio * now / static_cast<double>(count_);
  for (Side* side : {&A_, &Q_}) {
    for (std::ptrdiff_t i = 0; i < side->points.size; ++i) {
      const auto at = static_cast<std::size_t>(i);
      side->target[at] = centre - side->dx[at] * side->ds[at];
    }
  }
  follow_targets();
  Lengths lengths = longest_steps();
  for (int correction = 0; many_ && correction < kCorrections; ++correction) {
    if (std::min(lengths.x, lengths.s) > kLongEnough) break;
    draw_to_centre(lengths, centre);
    keep_step();
    follow_targets();
    const Lengths corrected = longest_steps();
    if (corrected.x + corrected.s < lengths.x + lengths.s + kWorthwhile) {
      keep_step();  // the one before
      break;
    }
    lengths = corrected;
  }
  return lengths;
}

// The shorter of the two step lengths. While the points are rounded, the slacks move with y, which saves a
// pass.
double InteriorPoint::step() {
  const Lengths lengths = choose_step();
  for (Side* side : {&A_, &Q_}) {
    for (std::ptrdiff_t i = 0; i < side->points.size; ++i) {
      const auto at = static_cast<std::size_t>(i);
      side->x[at] += lengths.x * side->dx[at];
      side->s[at] += lengths.s * side->ds[at];
    }
  }
  for (int k = 0; k <= n_; ++k)
    y_[static_cast<std::size_t>(k)] += lengths.s * dy_[static_cast<std::size_t>(k)];
  if (!single_) {
    slacks(A_, 0.0);
    slacks(Q_, 1.0);
  }
  return std::min(lengths.x, lengths.s);
}

}  // namespace raygauge
