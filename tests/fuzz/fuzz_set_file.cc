// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// A set file: a set that is accepted lives in some R^n, and its support function is that of its support point
// up to the error that the set states.
#include <cmath>

#include "tests/fuzz/harness.h"
#include "tests/fuzz/set_text.h"

namespace raygauge::fuzz::set_file {
namespace {

/// h(u) = u·s(u), unless the numbers of the set are too large for its products.
void require_support_point(const ConvexSet& set, const Vector& u) {
  const int n = set.dimension();
  Vector magnitude(n);
  set.magnitude_unchecked(magnitude.data());
  const double allowed = 3 * ConvexSet::rounding_error(n) * magnitude.dot(u.cwiseAbs());
  if (!std::isfinite(allowed) || magnitude.maxCoeff() > 1e150) return;
  const double h = set.support_function(u);
  const Vector point = set.support_mapping(u);
  require(point.allFinite(), "support points are finite");
  require(std::fabs(h - u.dot(point)) <= allowed + 1e-300, "the support point attains the support function");
  const double beside = u.dot(set.center()) - h;
  require(beside <= allowed + 1e-300, "the centre lies in the set");
}

}  // namespace
}  // namespace raygauge::fuzz::set_file

namespace raygauge::fuzz {

void check_set_file(std::string_view input) {
  expect_success_or_error([&] {
    const cli::SetPointer set = set_of(input);
    require(set != nullptr && set->dimension() >= 1, "an accepted set lives in some R^n");
    const int n = set->dimension();
    set_file::require_support_point(*set, Vector::Unit(n, 0));
    set_file::require_support_point(*set, -Vector::Ones(n));
  });
}

}  // namespace raygauge::fuzz
