// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/exact_simplex.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/kernels/kernel.h"

namespace raygauge {
namespace {

std::ptrdiff_t index_of(std::int64_t id) { return id / 2; }

std::int64_t pivot_limit(int m) { return 1000 + 100 * static_cast<std::int64_t>(m); }

// Seconds of a product and a division of two integers, by the product of their numbers of limbs, and of the
// bookkeeping around them: measured at n = 20 … 100.
constexpr double kSecondsPerLimbProduct = 1e-9;
constexpr double kSecondsPerEntry = 5e-8;

// Columns priced between two looks at the clock.
constexpr std::ptrdiff_t kColumnsBetweenLooks = 1024;

constexpr int kLowestTop = -1000;  // 2^1000 is a double

// For exponents that may leave the range of int: beyond ±kFarOut every double is 0 or infinite anyway.
int clamped(std::int64_t exponent) {
  constexpr std::int64_t kFarOut = 100000;
  return static_cast<int>(std::clamp(exponent, -kFarOut, kFarOut));
}

DoubleDouble scaled(const DoubleDouble& value, std::int64_t exponent) {
  return {std::ldexp(value.high, clamped(exponent)), std::ldexp(value.low, clamped(exponent))};
}

double ratio(const BigInteger& numerator, const BigInteger& denominator, std::int64_t exponent) {
  const ScaledDouble a = numerator.approximate();
  const ScaledDouble b = denominator.approximate();
  return std::ldexp(a.mantissa.high / b.mantissa.high, clamped(a.exponent - b.exponent + exponent));
}

const double* coordinates(const PointSet& S, std::ptrdiff_t i) {
  return S.data() + (i / PointSet::kLanes) * S.dimension() * PointSet::kLanes + i % PointSet::kLanes;
}

}  // namespace

ExactSimplex::End ExactSimplex::solve(const Points& A, const Points& Q, std::span<const std::int64_t> start,
                                      const Stopwatch& stopwatch, double most_seconds) {
  A_ = A;
  Q_ = Q;
  n_ = A.set->dimension();
  m_ = n_ + 1;
  pivots_ = 0;
  deadline_ = Deadline(&stopwatch);
  scaling_.compute(*A.set, *Q.set);
  if (deadline_.is_over()) return End::stopped;
  if (expected_seconds(n_, scaling_.mean_bits()) > std::min(stopwatch.remaining(), most_seconds)) {
    return End::too_long;
  }
  const auto size = static_cast<std::size_t>(m_);
  column_.resize(size);
  Y_.resize(size);
  phase_ = SimplexPhase::reach;
  start_from(start);
  if (deadline_.was_over()) return End::stopped;
  basis_.make_nonnegative();
  basis_.perturb();
  if (basis_.has_reached()) phase_ = SimplexPhase::optimise;
  return run_phases(*this, pivots_ + pivot_limit(m_));
}

double ExactSimplex::expected_seconds(int n, double bits) noexcept {
  const double m = n + 1;
  const double limbs = m * bits / 64;  // of the last determinants; their square grows by a third of its mean
  return m * m * m * (kSecondsPerEntry + kSecondsPerLimbProduct * limbs * limbs / 3);
}

// From the unit basis, M = D = 1, one column after the other; columns that depend on those before are left
// out.
void ExactSimplex::start_from(std::span<const std::int64_t> start) {
  basis_.reset(m_);
  for (const std::int64_t id : start) {
    if (id < 0) continue;
    form_column(id);
    basis_.transform(column_, deadline_);
    if (deadline_.was_over()) return;
    if (const int row = basis_.free_row(); row >= 0) replace(row, id);
  }
}

bool ExactSimplex::enter(std::int64_t id) {
  form_column(id);
  basis_.transform(column_, deadline_);
  if (deadline_.was_over()) return false;
  const int row = basis_.leaving_row(phase_ == SimplexPhase::optimise);
  // Artificial variables leave out of turn, at most m times; after that the perturbation starts anew.
  const bool out_of_turn = basis_.is_artificial(row);
  if (!replace(row, id)) return false;
  if (out_of_turn) basis_.perturb();
  return true;
}

bool ExactSimplex::replace(int row, std::int64_t id) {
  basis_.replace(row, id, deadline_);
  if (deadline_.was_over()) return false;
  ++pivots_;
  return true;
}

// Y = D y: the rows of M whose variables cost 1.
void ExactSimplex::compute_duals() {
  for (BigInteger& y : Y_) y.clear();
  for (int i = 0; i < m_; ++i) {
    const bool costs = phase_ == SimplexPhase::optimise ? basis_.is_from_Q(i) : basis_.is_artificial(i);
    if (costs) basis_.add_row(i, Y_);
  }
}

double ExactSimplex::Direction::rough(const double* p) const {
  double sum = constant.high;
  for (std::size_t k = 0; k < unit.size(); ++k) sum += factor[k].high * (unit[k] * p[k * PointSet::kLanes]);
  return sum;
}

double ExactSimplex::Direction::precise(const double* p) const {
  DoubleDouble sum = constant;
  for (std::size_t k = 0; k < unit.size(); ++k) sum = sum + factor[k] * (unit[k] * p[k * PointSet::kLanes]);
  return sum.rounded();
}

// D times the reduced cost of a point p as a Direction, up to a positive factor that leaves no term above 2:
// of A it is -Y_n - Σ_k Y_k a'_k, of Q it is cost · D + Σ_k Y_k q'_k.
void ExactSimplex::aim(bool from_Q, Direction& direction) const {
  const PointSet& S = from_Q ? *Q_.set : *A_.set;
  const auto size = static_cast<std::size_t>(n_);
  direction.factor.assign(size, {});
  direction.unit.assign(size, 0);
  std::vector<ScaledDouble> term(size);
  ScaledDouble constant;
  if (!from_Q) {
    constant = Y_[size].approximate();
    constant.mantissa = -constant.mantissa;
  } else if (phase_ == SimplexPhase::optimise) {
    constant = basis_.D().approximate();
  }
  std::int64_t largest =
      constant.mantissa.high != 0 ? constant.exponent : std::numeric_limits<std::int64_t>::min() / 2;
  for (int k = 0; k < n_; ++k) {
    const auto at = static_cast<std::size_t>(k);
    term[at] = Y_[at].approximate();
    const double magnitude = S.coordinate_magnitude()[k];
    if (term[at].mantissa.high == 0 || magnitude == 0) continue;
    const int top = std::max(std::ilogb(magnitude) + 1, kLowestTop);
    direction.unit[at] = std::ldexp(1.0, -top);
    term[at].exponent += top + (from_Q ? scaling_.shift_Q(k) : scaling_.shift_A(k));
    largest = std::max(largest, term[at].exponent);
  }
  for (int k = 0; k < n_; ++k) {
    const auto at = static_cast<std::size_t>(k);
    if (S.coordinate_magnitude()[k] == 0) continue;
    const DoubleDouble factor = scaled(term[at].mantissa, term[at].exponent - largest);
    direction.factor[at] = from_Q ? factor : -factor;
  }
  direction.constant = scaled(constant.mantissa, constant.exponent - largest);
}

std::int64_t ExactSimplex::price() {
  compute_duals();
  Candidate best;
  price_set(A_, false, best);
  price_set(Q_, true, best);
  return best.id;
}

// Dantzig: the most negative reduced cost.
void ExactSimplex::price_set(const Points& points, bool from_Q, Candidate& best) {
  aim(from_Q, direction_);
  // No term is above 2 in magnitude: n products and sums lose less than this.
  const double rough_error = (n_ + 2) * (n_ + 2) * 0x1p-49;
  const double error = (n_ + 2) * (n_ + 2) * 0x1p-96;
  const auto count = points.chosen.empty() ? points.set->size() : std::ssize(points.chosen);
  for (std::ptrdiff_t c = 0; c < count; ++c) {
    if (c % kColumnsBetweenLooks == 0 && deadline_.is_over()) return;
    const std::int64_t index = points.chosen.empty() ? c : points.chosen[static_cast<std::size_t>(c)];
    const double* p = coordinates(*points.set, index);
    if (direction_.rough(p) > rough_error) continue;
    const double reduced_cost = direction_.precise(p);
    if (!(reduced_cost <= error) || (best.id >= 0 && reduced_cost >= best.reduced_cost)) continue;
    const std::int64_t id = from_Q ? id_of_Q(index) : id_of_A(index);
    if (reduced_cost >= -error && exact_reduced_cost_sign(id) >= 0) continue;
    best = {id, reduced_cost};
  }
}

int ExactSimplex::exact_reduced_cost_sign(std::int64_t id) {
  form_column(id);
  BigInteger sum, product;
  if (is_from_Q(id) && phase_ == SimplexPhase::optimise) sum = basis_.D();
  for (int k = 0; k < m_; ++k) {
    product.assign_product(Y_[static_cast<std::size_t>(k)], column_[static_cast<std::size_t>(k)]);
    sum.subtract(product);
  }
  return sum.sign();
}

void ExactSimplex::form_column(std::int64_t id) {
  const bool from_Q = is_from_Q(id);
  const double* p = coordinates(from_Q ? *Q_.set : *A_.set, index_of(id));
  for (int k = 0; k < n_; ++k) {
    const double value = p[static_cast<std::ptrdiff_t>(k) * PointSet::kLanes];
    column_[static_cast<std::size_t>(k)].assign_scaled(from_Q ? -value : value,
                                                       from_Q ? scaling_.shift_Q(k) : scaling_.shift_A(k));
  }
  column_[static_cast<std::size_t>(n_)].assign_scaled(from_Q ? 0 : 1, 0);
}

RoundedRatio ExactSimplex::distance() const {
  BigInteger sum;
  for (int i = 0; i < m_; ++i) {
    if (basis_.is_from_Q(i)) sum.add(basis_.x(i));
  }
  return rounded_ratio(sum, basis_.D(), -scaling_.lift());
}

void ExactSimplex::normal(double* u) const {
  for (int k = 0; k < n_; ++k) u[k] = ratio(Y_[static_cast<std::size_t>(k)], basis_.D(), scaling_.shift_Q(k));
}

void ExactSimplex::weights_of_A(std::vector<PointWeight>& weights) const {
  weights.clear();
  for (int i = 0; i < m_; ++i) {
    if (!basis_.is_from_A(i) || basis_.x(i).sign() == 0) continue;
    weights.push_back({index_of(basis_.id(i)), rounded_ratio(basis_.x(i), basis_.D(), 0).nearest});
  }
}

void ExactSimplex::contact_point(double* p) const {
  std::fill_n(p, n_, 0.0);
  for (int i = 0; i < m_; ++i) {
    if (!basis_.is_from_A(i)) continue;
    const double alpha = ratio(basis_.x(i), basis_.D(), 0);
    const double* a = coordinates(*A_.set, index_of(basis_.id(i)));
    for (int k = 0; k < n_; ++k) p[k] += alpha * a[static_cast<std::ptrdiff_t>(k) * PointSet::kLanes];
  }
}

}  // namespace raygauge
