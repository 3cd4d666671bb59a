// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "raygauge/sets/convex_set.h"

namespace raygauge {

// Checks that the constructors of sets share. Each throws with one line that names the parameter, what it got
// and what it needs; `set` is what is being made ("ball").

/// Returns `value`. Throws NonFiniteError, or InvalidParameterError if it is negative.
double checked_nonnegative(const std::string& set, const std::string& parameter, double value);

/// Returns the same vector. Throws NonFiniteError (naming the coordinate, counted from 0).
const ConstVectorRef& checked_finite(const std::string& set, const std::string& parameter,
                                     const ConstVectorRef& value);

/// Throws DimensionMismatchError unless size == dimension.
void check_dimension(const std::string& set, const std::string& parameter, Eigen::Index size, int dimension);

/// Throws NonFiniteError (naming row and column, counted from 0).
void check_finite_matrix(const std::string& set, const std::string& parameter,
                         const Eigen::Ref<const Eigen::MatrixXd>& value);

/// Returns the set itself. Throws InvalidParameterError for a null pointer.
const std::shared_ptr<const ConvexSet>& checked_set(const std::string& set, const std::string& parameter,
                                                    const std::shared_ptr<const ConvexSet>& operand);

}  // namespace raygauge
