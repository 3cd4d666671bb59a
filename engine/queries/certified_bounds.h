// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <span>

#include "raygauge/sets/point_set.h"

namespace raygauge {

/// Weak duality, equation (10), for any direction u (n doubles): d_Q(A) >= -h_A(u) / h_Q(-u), rounding errors
/// included. 0 where u proves nothing; +infinity where u is a Farkas direction.
double certified_lower(const PointSet& A, const PointSet& Q, const double* u);

/// A proven upper bound on d_Q(A) from the points that carry an (approximate) primal solution: the best
/// combination of those points alone, certified. The weights only say which points matter: those above 1e-12
/// of their sum are used. +infinity where they prove nothing, or not within `time_limit` seconds: exact
/// arithmetic on points that have no feasible combination can take hours. Throws InvalidParameterError for an
/// index outside its set or for spans of different lengths.
double certified_upper(const PointSet& A, const PointSet& Q, std::span<const std::ptrdiff_t> index_A,
                       std::span<const double> alpha, std::span<const std::ptrdiff_t> index_Q,
                       std::span<const double> beta,
                       double time_limit = std::numeric_limits<double>::infinity());

}  // namespace raygauge
