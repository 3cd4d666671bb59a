// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// The expression of --where: what is accepted can be asked of any record, and twice with one answer.
#include <limits>
#include <string>

#include "analysis/data/filter.h"
#include "tests/fuzz/harness.h"

namespace raygauge::fuzz::filter {
namespace {

Record limited_record() {
  Record record;
  record.status = DistanceStatus::time_limit;
  record.lower = record.distance = std::numeric_limits<double>::quiet_NaN();
  record.upper = std::numeric_limits<double>::infinity();
  record.agrees = false;
  return record;
}

}  // namespace
}  // namespace raygauge::fuzz::filter

namespace raygauge::fuzz {

void check_filter(std::string_view input) {
  static const Record plain, limited = filter::limited_record();
  expect_success_or_error([&] {
    const std::string expression(input);
    const Filter filter(expression), negated("!(" + expression + ")");
    for (const Record& record : {plain, limited}) {
      require(filter(record) != negated(record), "a record passes a condition or its negation");
    }
  });
}

}  // namespace raygauge::fuzz
