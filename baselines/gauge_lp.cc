// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/gauge_lp.h"

#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

std::shared_ptr<const PointSet> as_point_set(const std::shared_ptr<const ConvexSet>& set, const char* name,
                                             const std::string& method) {
  auto points = std::dynamic_pointer_cast<const PointSet>(set);
  if (!points) {
    throw InvalidParameterError("method '" + method + "' takes point sets only, and " + name +
                                " is not a point set");
  }
  return points;
}

}  // namespace

GaugeLp::GaugeLp(const Instance& instance, const std::string& method)
    : A_(as_point_set(instance.A, "A", method)), Q_(as_point_set(instance.Q, "Q", method)) {
  if (A_->dimension() != Q_->dimension()) {
    throw DimensionMismatchError("A lives in R^" + std::to_string(A_->dimension()) + ", Q in R^" +
                                 std::to_string(Q_->dimension()));
  }
}

void GaugeLp::copy_column(std::ptrdiff_t j, double* out) const noexcept {
  const int n = A_->dimension();
  if (j < A_->size()) {
    A_->copy_point(j, out);
    out[n] = 1.0;
    return;
  }
  Q_->copy_point(j - A_->size(), out);
  for (int k = 0; k < n; ++k) out[k] = -out[k];
  out[n] = 0.0;
}

}  // namespace raygauge
