// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/parameters.h"

#include <cmath>
#include <cstdio>

#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

std::string shown(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

}  // namespace

double checked_nonnegative(const std::string& set, const std::string& parameter, double value) {
  if (!std::isfinite(value)) {
    throw NonFiniteError(set + ": " + parameter + " must be a finite number, got " + shown(value));
  }
  if (value < 0) {
    throw InvalidParameterError(set + ": " + parameter + " must not be negative, got " + shown(value));
  }
  return value;
}

const ConstVectorRef& checked_finite(const std::string& set, const std::string& parameter,
                                     const ConstVectorRef& value) {
  for (Eigen::Index k = 0; k < value.size(); ++k) {
    if (!std::isfinite(value[k])) {
      throw NonFiniteError(set + ": coordinate " + std::to_string(k) + " of " + parameter +
                           " must be a finite number, got " + shown(value[k]));
    }
  }
  return value;
}

void check_dimension(const std::string& set, const std::string& parameter, Eigen::Index size, int dimension) {
  if (size != dimension) {
    throw DimensionMismatchError(set + ": " + parameter + " has dimension " + std::to_string(size) +
                                 ", the set lives in R^" + std::to_string(dimension));
  }
}

void check_finite_matrix(const std::string& set, const std::string& parameter,
                         const Eigen::Ref<const Eigen::MatrixXd>& value) {
  for (Eigen::Index j = 0; j < value.cols(); ++j) {
    for (Eigen::Index i = 0; i < value.rows(); ++i) {
      if (!std::isfinite(value(i, j))) {
        throw NonFiniteError(set + ": entry (" + std::to_string(i) + ", " + std::to_string(j) + ") of " +
                             parameter + " must be a finite number, got " + shown(value(i, j)));
      }
    }
  }
}

const std::shared_ptr<const ConvexSet>& checked_set(const std::string& set, const std::string& parameter,
                                                    const std::shared_ptr<const ConvexSet>& operand) {
  if (operand == nullptr) throw InvalidParameterError(set + ": " + parameter + " must not be a null pointer");
  return operand;
}

}  // namespace raygauge
