// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/centred_points.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "engine/lp/affords.h"
#include "engine/numerics/aligned_buffer.h"
#include "engine/numerics/floating_point.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {
namespace {

constexpr int kSteps = 15;
constexpr double kLongest = 1;       // change of v·p_j in a step
constexpr double kFarthest = 20;     // |v·p_j|: beyond, the weights leave few points
constexpr double kCentred = 1e-9;    // |r|, relative to Σ λ_j |p_j|
constexpr double kRoundedUp = 1.01;  // covers the rounding of the bounds themselves
constexpr double kSpare = 4;         // of α, above what the proof needs

// γ_m for sums of m products of rounded factors.
double gamma(double m) { return kRoundedUp * (m + 8) * kUnitRoundoff; }

class Centre {
 public:
  Centre(const PricedPoints& points, int n, const Kernels& kernels)
      : points_(points), n_(n), kernels_(kernels), v_(Eigen::VectorXd::Zero(n)) {
    const auto lanes = static_cast<std::size_t>(points.block_count) * PointSet::kLanes;
    weight_.reserve(lanes);
    products_.reserve(lanes);
    scratch_.reserve(static_cast<std::size_t>(n) * PointSet::kLanes);
    std::fill_n(weight_.data(), lanes, 0.0);
    std::fill_n(weight_.data(), points.size, 1.0);
  }

  bool find(const Stopwatch& stopwatch) {
    measure();
    for (int step = 0; step < kSteps; ++step) {
      const Eigen::VectorXd r = sum();
      if (r.norm() <= kCentred * sum_of_lengths_) return true;
      if (stopwatch.expired() || !affords(stopwatch, operations()) || !improve(r)) return false;
      measure();
    }
    return false;
  }

  bool is_proven() {
    const auto count = static_cast<double>(points_.size);
    const double r = kRoundedUp * (sum().norm() + gamma(count) * sum_of_lengths_ + n_ * kUnderflow);
    // What rounding may do to the eigenvalues of G as summed, and as factored.
    const double rounding = kRoundedUp * (gamma(count) + 2 * gamma(n_)) * sum_of_squares_;
    const double alpha = kSpare * (rounding + longest_ * r);
    if (!(alpha < kInfinity) || !(alpha > kUnderflow / kUnitRoundoff)) return false;
    add_all();
    for (int k = 0; k < n_; ++k) gram_.data()[static_cast<std::ptrdiff_t>(k) * gram_.rows() + k] -= alpha;
    return gram_.factor();
  }

 private:
  double operations() const {  // of a step
    return static_cast<double>(n_) * n_ * (0.5 * static_cast<double>(points_.size) + n_) / kernels_.width;
  }

  Eigen::VectorXd sum() {
    Eigen::VectorXd total = Eigen::VectorXd::Zero(n_);
    kernels_.add_weighted(points_.blocks, points_.block_count, n_, weight_.data(), scratch_.data(),
                          total.data());
    return total;
  }

  void add_all() {
    gram_.begin(n_, kernels_, {});
    gram_.add(points_, weight_.data(), false);
  }

  // Σ λ_j |p_j|, Σ λ_j |p_j|² and max |p_j|, rounded up.
  void measure() {
    sum_of_lengths_ = sum_of_squares_ = longest_ = 0;
    for (std::ptrdiff_t j = 0; j < points_.size; ++j) {
      const double* p = points_.blocks + j / PointSet::kLanes * n_ * PointSet::kLanes + j % PointSet::kLanes;
      double square = 0;
      for (std::ptrdiff_t k = 0; k < n_; ++k) square += p[k * PointSet::kLanes] * p[k * PointSet::kLanes];
      const double length = kRoundedUp * std::sqrt(square);
      sum_of_lengths_ += weight_[static_cast<std::size_t>(j)] * length;
      sum_of_squares_ += weight_[static_cast<std::size_t>(j)] * length * length;
      longest_ = std::max(longest_, length);
    }
    sum_of_lengths_ *= kRoundedUp;
    sum_of_squares_ *= kRoundedUp;
  }

  // A Newton step from v, as far as no v·p_j changes much.
  bool improve(const Eigen::VectorXd& r) {
    add_all();
    if (!gram_.factor()) return false;
    const Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>> G(gram_.data(), n_, n_,
                                                                       Eigen::OuterStride<>(gram_.rows()));
    Eigen::VectorXd step(n_);
    step = r;
    G.triangularView<Eigen::Lower>().solveInPlace(step);
    G.triangularView<Eigen::Lower>().transpose().solveInPlace(step);
    const double change = largest_product(step);
    if (!(change < kInfinity)) return false;
    v_ -= std::min(1.0, kLongest / change) * step;
    if (!(largest_product(v_) < kFarthest)) return false;
    for (std::ptrdiff_t j = 0; j < points_.size; ++j)
      weight_[static_cast<std::size_t>(j)] = std::exp(products_[static_cast<std::size_t>(j)]);
    return true;
  }

  // max |u·p_j|; the u·p_j stay in products_.
  double largest_product(const Eigen::VectorXd& u) {
    kernels_.products(points_.blocks, points_.block_count, n_, u.data(), products_.data());
    double largest = 0;
    for (std::ptrdiff_t j = 0; j < points_.size; ++j) {
      const double product = std::fabs(products_[static_cast<std::size_t>(j)]);
      if (!(product <= largest)) largest = product;  // NaN stays
      if (std::isnan(product)) break;
    }
    return largest;
  }

  PricedPoints points_;
  int n_;
  const Kernels& kernels_;
  Eigen::VectorXd v_;
  SharedGram gram_;
  AlignedBuffer<double> weight_;  // λ of the lanes, 0 beyond the points
  AlignedBuffer<double> products_;
  AlignedBuffer<double> scratch_;
  double sum_of_lengths_ = 0;
  double sum_of_squares_ = 0;
  double longest_ = 0;
};

}  // namespace

bool are_centred(const PricedPoints& points, int n, const Kernels& kernels, const Stopwatch& stopwatch) {
  Centre centre(points, n, kernels);
  return centre.find(stopwatch) && centre.is_proven();
}

}  // namespace raygauge
