// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "raygauge/sweep/record.h"
#include "results/schema/older_files.h"

namespace raygauge::testing {

/// With the registered name, role and measures of hardness that its names stand for.
inline Record with_facts(Record record) {
  const std::string label = record.method;
  std::vector<Record> records = {std::move(record)};
  records.front().method_name.clear();
  records.front().exact_distance_rounding = 0;
  complete_older_records(records, "");
  records.front().method = label;
  return records.front();
}

/// A solved record of generator example2 at tolerance 1e-6, certified to half of that.
inline Record record(const std::string& method, int n, int N, int repetition, double milliseconds) {
  Record result;
  result.generator = "example2";
  result.generator_parameters = "separation=1.5";
  result.method = method;
  result.n = n;
  result.N = N;
  result.tolerance = 1e-6;
  result.seed = 1;
  result.repetition = repetition;
  result.seconds = milliseconds / 1e3;
  result.distance = 2;
  result.lower = 2 - 1e-6;
  result.upper = 2;
  result.exact_distance = 2;
  result.status = DistanceStatus::optimal;
  return with_facts(std::move(result));
}

/// One record for each time, repetitions counted from 0.
inline void add_records(std::vector<Record>& records, const std::string& method, int n, int N,
                        const std::vector<double>& milliseconds) {
  for (std::size_t i = 0; i < milliseconds.size(); ++i)
    records.push_back(record(method, n, N, static_cast<int>(i), milliseconds[i]));
}

/// The message of the exception of type E that `call` throws; a remark if it throws none.
template <class E, class Call>
std::string message_of(const Call& call) {
  try {
    call();
  } catch (const E& error) {
    return error.what();
  }
  return "no such exception";
}

}  // namespace raygauge::testing
