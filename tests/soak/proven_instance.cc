// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "tests/soak/proven_instance.h"

#include <cmath>
#include <utility>

#include "baselines/exact_verify.h"
#include "raygauge/exceptions.h"

namespace raygauge::soak {
namespace {

// Products of numbers in this range neither overflow nor lose digits to underflow.
constexpr double kSmallest = 0x1p-500;
constexpr double kLargest = 0x1p500;

bool in_range(double x) { return x == 0 || (std::fabs(x) > kSmallest && std::fabs(x) < kLargest); }

// Whether u·x + constant < 0 beyond doubt: the terms carry n + 3 roundings of 2^-52 each at most.
bool is_certainly_negative(const Vector& u, const Eigen::Ref<const Eigen::VectorXd>& x, double sign,
                           double constant) {
  double sum = constant;
  double size = std::fabs(constant);
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    if (!in_range(x[k])) return false;
    const double term = sign * u[k] * x[k];
    sum += term;
    size += std::fabs(term);
  }
  const double margin = static_cast<double>(x.size() + 8) * 0x1p-51 * size;
  return size > 0x1p-900 && sum < -margin;
}

std::vector<bool> carriers(const std::vector<ExactWeight>& weights, Eigen::Index size) {
  std::vector<bool> carries(static_cast<std::size_t>(size), false);
  for (const ExactWeight& weight : weights) carries[static_cast<std::size_t>(weight.index)] = true;
  return carries;
}

}  // namespace

bool ProvenInstance::may_join_A(const Eigen::Ref<const Eigen::VectorXd>& a) const {
  if (truth.status == DistanceStatus::contains_origin) return true;  // no distance is below 0
  return dual_is_rounded && is_certainly_negative(u, a, 1, t);
}

bool ProvenInstance::may_join_Q(const Eigen::Ref<const Eigen::VectorXd>& q) const {
  if (truth.status == DistanceStatus::contains_origin) return true;
  return dual_is_rounded &&
         is_certainly_negative(u, q, -1, truth.status == DistanceStatus::unreachable ? 0 : -1);
}

ProvenInstance prove(std::string label, const Eigen::MatrixXd& A, const Eigen::MatrixXd& Q) {
  ProvenInstance proven;
  proven.label = std::move(label);
  proven.A = A;
  proven.Q = Q;
  const PointSet set_A(A), set_Q(Q);
  proven.truth = solve_exact_lp(set_A, set_Q);
  if (!verify(set_A, set_Q, proven.truth)) throw Error("the exact program's proof does not verify");
  proven.carries_A = carriers(proven.truth.alpha, A.cols());
  proven.carries_Q = carriers(proven.truth.beta, Q.cols());
  proven.u.resize(A.rows());
  proven.t = proven.truth.t.convert_to<double>();
  proven.dual_is_rounded = in_range(proven.t);
  for (Eigen::Index k = 0; k < A.rows(); ++k) {
    proven.u[k] = proven.truth.u[static_cast<std::size_t>(k)].convert_to<double>();
    proven.dual_is_rounded = proven.dual_is_rounded && in_range(proven.u[k]);
  }
  return proven;
}

ProvenInstance draw_proven_instance(const GeneratorRegistry& registry, const std::vector<std::string>& names,
                                    RandomStream& stream) {
  for (;;) {
    const RandomFamily family = draw_family(registry, names, stream);
    Instance instance;
    try {
      instance = registry.make(family.generator, family.parameters)->generate(family.key);
    } catch (const InvalidParameterError&) {
      continue;  // the family has no member of that dimension or size
    } catch (const NonFiniteError&) {
      continue;  // scaled beyond the range of doubles
    }
    const auto& A = dynamic_cast<const PointSet&>(*instance.A);
    const auto& Q = dynamic_cast<const PointSet&>(*instance.Q);
    if ((A.size() + Q.size()) * A.dimension() > kMostCoordinates) continue;
    return prove(family.generator, A.points(), Q.points());
  }
}

}  // namespace raygauge::soak
