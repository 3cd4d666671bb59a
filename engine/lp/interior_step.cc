// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/interior_step.h"

#include <Eigen/Core>
#include <algorithm>
#include <functional>
#include <utility>

#include "engine/lp/tuning.h"
#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

using Matrix = Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
using VectorMap = Eigen::Map<Eigen::VectorXd>;

constexpr double kStep = 0.995;  // of the way to the boundary
// Of further correctors, after J. Gondzio, Comput. Optim. Appl. 6 (1996).
constexpr double kReachFurther = 0.3;   // longer steps to aim at
constexpr double kNeighbourhood = 0.1;  // of the centre, for products x·s: from 0.1 to 10 times it
constexpr double kLongEnough = 0.9;     // a step

// The weights x / s of the matrix. Those of A count (Σβ)² times as much: compared in the units of each, x
// about 1 in A and s about Σβ, and the other way round in Q.
double weigh(InteriorSides& sides) {
  double beta = 0;
  for (InteriorSide& side : sides) {
    for (std::size_t i = 0; i < side.lanes; ++i) {
      side.weight[i] = i < side.size ? side.x[i] / side.s[i] : 0.0;
      if (!side.is_A()) beta += side.x[i];
    }
  }
  return beta * beta;
}

// ds = -Aᵀdy and dx = S⁻¹ (target - X ds) - x: to first order x s becomes the target.
void take_direction(InteriorSide& side, const InteriorPasses& passes, const double* dy, double last) {
  double* products = side.weight.data();
  passes.price(side, dy, products);
  const double dt = side.last * last;
  for (std::size_t i = 0; i < side.size; ++i) {
    side.ds[i] = -side.sign * products[i] - dt;
    side.dx[i] = (side.target[i] - side.x[i] * side.ds[i]) / side.s[i] - side.x[i];
  }
}

double longest_step(const InteriorSide& side, const AlignedBuffer<double>& value,
                    const AlignedBuffer<double>& change) {
  double rate = 0;  // the fastest fall, relative
  for (std::size_t i = 0; i < side.size; ++i) rate = std::max(rate, -change[i] / value[i]);
  return rate > 0 ? 1 / rate : kInfinity;
}

StepLengths longest_steps(const InteriorSides& sides) {
  StepLengths lengths;
  for (const InteriorSide& side : sides) {
    lengths.x = std::min(lengths.x, kStep * longest_step(side, side.x, side.dx));
    lengths.s = std::min(lengths.s, kStep * longest_step(side, side.s, side.ds));
  }
  return lengths;
}

// Towards longer steps: products x·s that would leave the neighbourhood of the centre after them are drawn
// back.
void draw_to_centre(InteriorSides& sides, const StepLengths& lengths, double centre) {
  const double x_length = std::min(1.0, lengths.x + kReachFurther);
  const double s_length = std::min(1.0, lengths.s + kReachFurther);
  for (InteriorSide& side : sides) {
    for (std::size_t i = 0; i < side.size; ++i) {
      const double product = (side.x[i] + x_length * side.dx[i]) * (side.s[i] + s_length * side.ds[i]);
      const double least = kNeighbourhood * centre;
      const double most = centre / kNeighbourhood;
      if (product < least) side.target[i] += least - product;
      if (product > most) side.target[i] += std::max(most - product, -most);
    }
  }
}

}  // namespace

double complementarity(const InteriorSides& sides, const StepLengths& lengths) {
  double sum = 0;
  for (const InteriorSide& side : sides) {
    for (std::size_t i = 0; i < side.size; ++i) {
      const double x = side.x[i] + (lengths.x > 0 ? lengths.x * side.dx[i] : 0.0);
      const double s = side.s[i] + (lengths.s > 0 ? lengths.s * side.ds[i] : 0.0);
      sum += x * s;
    }
  }
  return sum;
}

void InteriorStep::begin(int n, const Kernels& kernels, const InteriorSides& sides) {
  n_ = n;
  kernels_ = &kernels;
  dy_.reserve(static_cast<std::size_t>(n) + 1);
  border_.reserve(2 * static_cast<std::size_t>(n));
  ranked_.reserve(sides[0].lanes + sides[1].lanes);
}

// As counted, those of A `unit` times as much.
void InteriorStep::leave_out_negligible(InteriorSides& sides, double negligible, double unit) {
  double* ranks = ranked_.data();
  for (const InteriorSide& side : sides) {
    const double factor = side.is_A() ? unit : 1.0;
    for (std::size_t i = 0; i < side.lanes; ++i) *ranks++ = factor * side.weight[i];
  }
  double* nth = ranked_.data() + std::min<std::ptrdiff_t>(n_, ranks - ranked_.data() - 1);
  std::nth_element(ranked_.data(), nth, ranks, std::greater<>());
  for (InteriorSide& side : sides) {
    const double least = negligible * *nth / (side.is_A() ? unit : 1.0);
    for (std::size_t i = 0; i < side.lanes; ++i) {
      if (side.weight[i] < least) side.weight[i] = 0;
    }
  }
}

bool InteriorStep::factor(InteriorSides& sides, InteriorPasses& passes, double negligible) {
  gram_.begin(n_, *kernels_, passes.helpers());
  const double unit = weigh(sides);
  if (negligible > 0) leave_out_negligible(sides, negligible, unit);
  for (InteriorSide& side : sides) gram_.add(side.points, side.weight.data(), passes.is_single());
  if (!gram_.factor()) return false;
  const Matrix G(gram_.data(), n_, n_, Eigen::OuterStride<>(gram_.rows()));
  const InteriorSide& A = sides[0];
  double* g = border_.data();
  std::fill_n(g, n_, 0.0);
  passes.add_weighted(A, g);
  double corner = 0;
  for (std::size_t i = 0; i < A.size; ++i) corner += A.weight[i];
  const VectorMap border(g, n_);
  VectorMap solved(g + n_, n_);
  solved = border;
  const auto lower = G.triangularView<Eigen::Lower>();
  lower.solveInPlace(solved);
  pivot_ = corner - solved.squaredNorm();
  lower.transpose().solveInPlace(solved);
  return pivot_ > 0;
}

// rhs (n + 1 numbers) becomes M⁻¹ rhs.
void InteriorStep::solve_for(double* rhs) {
  const Matrix G(gram_.data(), n_, n_, Eigen::OuterStride<>(gram_.rows()));
  VectorMap v(rhs, n_);
  const VectorMap solved(border_.data() + n_, n_);
  const double last = (rhs[n_] - solved.dot(v)) / pivot_;
  if ((v.array() != 0).any()) {  // zero without targets
    const auto lower = G.triangularView<Eigen::Lower>();
    lower.solveInPlace(v);
    lower.transpose().solveInPlace(v);
  }
  v -= last * solved;
  rhs[n_] = last;
}

// The Newton step to the targets: M dy = b - A S⁻¹ target, and dx, ds.
void InteriorStep::follow_targets(InteriorSides& sides, InteriorPasses& passes) {
  std::fill_n(dy_.data(), n_ + 1, 0.0);
  double sum_of_A = 0;
  for (InteriorSide& side : sides) {
    for (std::size_t i = 0; i < side.lanes; ++i) {
      const double weight = i < side.size ? side.target[i] / side.s[i] : 0.0;
      side.weight[i] = -side.sign * weight;
      if (side.is_A()) sum_of_A += weight;
    }
    passes.add_weighted(side, dy_.data());
  }
  dy_[static_cast<std::size_t>(n_)] = 1 - sum_of_A;
  solve_for(dy_.data());
  for (InteriorSide& side : sides)
    take_direction(side, passes, dy_.data(), dy_[static_cast<std::size_t>(n_)]);
}

void InteriorStep::keep(InteriorSides& sides) {
  kept_dy_.reserve(static_cast<std::size_t>(n_) + 1);
  std::swap(dy_, kept_dy_);
  for (InteriorSide& side : sides) {
    std::swap(side.dx, side.kept_dx);
    std::swap(side.ds, side.kept_ds);
  }
}

StepLengths InteriorStep::choose(InteriorSides& sides, InteriorPasses& passes, bool correct) {
  for (InteriorSide& side : sides) std::fill_n(side.target.data(), side.lanes, 0.0);
  follow_targets(sides, passes);
  const StepLengths affine = longest_steps(sides);
  const double now = complementarity(sides);
  const double ratio = complementarity(sides, affine) / now;
  const double centre = ratio * ratio * ratio * now / static_cast<double>(sides[0].size + sides[1].size);
  for (InteriorSide& side : sides) {
    for (std::size_t i = 0; i < side.size; ++i) side.target[i] = centre - side.dx[i] * side.ds[i];
  }
  follow_targets(sides, passes);
  StepLengths lengths = longest_steps(sides);
  for (int correction = 0; correct && correction < tuned::kCorrectionsOfStep; ++correction) {
    if (std::min(lengths.x, lengths.s) > kLongEnough) break;
    draw_to_centre(sides, lengths, centre);
    keep(sides);
    follow_targets(sides, passes);
    const StepLengths corrected = longest_steps(sides);
    if (corrected.x + corrected.s < lengths.x + lengths.s + tuned::kWorthCorrecting) {
      keep(sides);  // the one before
      break;
    }
    lengths = corrected;
  }
  return lengths;
}

// While the points are rounded, the slacks move with y, which saves a pass.
double InteriorStep::take(InteriorSides& sides, InteriorPasses& passes, double* y, bool correct) {
  const StepLengths lengths = choose(sides, passes, correct);
  for (InteriorSide& side : sides) {
    for (std::size_t i = 0; i < side.size; ++i) {
      side.x[i] += lengths.x * side.dx[i];
      side.s[i] += lengths.s * side.ds[i];
    }
  }
  for (int k = 0; k <= n_; ++k) y[k] += lengths.s * dy_[static_cast<std::size_t>(k)];
  for (InteriorSide& side : sides) {
    if (!passes.is_single()) passes.compute_slacks(side, y);
  }
  return std::min(lengths.x, lengths.s);
}

}  // namespace raygauge
