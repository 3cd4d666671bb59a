// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace raygauge {

/// The value that a variable of Student's t distribution stays below with this probability.
double student_t_quantile(std::size_t degrees_of_freedom, double probability);

/// The probability of a value above t.
double student_t_tail(std::size_t degrees_of_freedom, double t);

}  // namespace raygauge
