// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "raygauge/sweep/record.h"

namespace raygauge::testing {

/// With the facts that a run would store of such names: the registered name and the role of the method whose
/// name the label begins with, the rounding of Example 1, and `aspect` or `offset` for the hardness.
inline Record with_facts(Record record) {
  record.method_name = record.method;
  record.role = Role::engine;
  for (const char* name : {"column_generation", "newton", "zheng_yamane"})
    if (record.method.str().starts_with(name)) record.method_name = name;
  for (const char* name : {"clp_dual", "fcl_libccd", "glpk_dual", "glpk_primal", "nlopt_slsqp"})
    if (record.method.str().starts_with(name)) record.method_name = name;
  for (const char* library : {"clp", "command", "fcl", "glpk", "nlopt"})
    if (record.method.str().starts_with(library)) record.role = Role::baseline;
  if (record.method == "exact") record.role = Role::oracle;
  record.exact_distance_rounding = record.generator == "example1" ? 0x1p-45 : 0;
  for (const char* name : {"aspect", "offset"}) {
    const std::string mark = std::string(name) + "=";
    if (!record.generator_parameters.str().starts_with(mark)) continue;
    record.hardness_label = name;
    record.hardness = std::stod(record.generator_parameters.str().substr(mark.size()));
  }
  return record;
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
