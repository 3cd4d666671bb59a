// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/student_t.h"

#include <boost/math/distributions/students_t.hpp>

namespace raygauge {

double student_t_quantile(std::size_t degrees_of_freedom, double probability) {
  const boost::math::students_t distribution(static_cast<double>(degrees_of_freedom));
  return boost::math::quantile(distribution, probability);
}

double student_t_tail(std::size_t degrees_of_freedom, double t) {
  const boost::math::students_t distribution(static_cast<double>(degrees_of_freedom));
  return boost::math::cdf(boost::math::complement(distribution, t));
}

}  // namespace raygauge
