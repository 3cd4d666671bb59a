// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/isotropic_map.h"

#include <algorithm>
#include <cmath>

#include "engine/numerics/decompositions.h"
#include "engine/sets/tuning.h"

namespace raygauge {
namespace {

constexpr Eigen::Index kMostPoints = 4096;
constexpr double kFlattest = 1e-6;  // Σ squares the ratio

}  // namespace

std::optional<IsotropicMap> isotropic_map(const Eigen::Ref<const Eigen::MatrixXd>& points) {
  const Eigen::Index n = points.rows();
  const Eigen::Index count = std::min(points.cols(), kMostPoints);
  const double magnitude = points.cwiseAbs().maxCoeff();
  if (n < 2 || count < 2 * n || !std::isnormal(magnitude) || !std::isnormal(1 / magnitude)) return {};
  Eigen::MatrixXd chosen(n, count);
  for (Eigen::Index i = 0; i < count; ++i) chosen.col(i) = points.col(i * points.cols() / count) / magnitude;
  Eigen::MatrixXd sigma = Eigen::MatrixXd::Zero(n, n);
  sigma.selfadjointView<Eigen::Lower>().rankUpdate(chosen, 1.0 / static_cast<double>(count));
  const auto factor = cholesky_factor(sigma);
  if (!factor) return {};
  const Eigen::MatrixXd& F = *factor;
  const double longest = F.diagonal().maxCoeff();
  const double shortest = F.diagonal().minCoeff();
  if (!(longest > tuned::kRoundEnough * shortest && shortest > kFlattest * longest)) return {};
  IsotropicMap map{F * magnitude, Eigen::MatrixXd::Identity(n, n) / magnitude};
  F.triangularView<Eigen::Lower>().solveInPlace(map.inverse);
  return map;
}

}  // namespace raygauge
