// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/data/pool.h"

#include <algorithm>

namespace raygauge {
namespace {

constexpr const char* kFiles = "files";
constexpr const char* kPairs = "pairs=";

}  // namespace

Pool::Pool(const std::vector<Record>& records) {
  for (const Record& record : records) {
    if (record.generator != kFiles) continue;
    pairs_.emplace(record.generator_parameters, static_cast<int>(pairs_.size()));
    repetitions_ = std::max(repetitions_, record.repetition + 1);
  }
  if (pairs_.size() <= kMostPairsApart) pairs_.clear();
}

bool Pool::has(const Record& record) const { return !pairs_.empty() && record.generator == kFiles; }

std::vector<Record> Pool::operator()(std::vector<Record> records) const {
  const std::string parameters = kPairs + std::to_string(pairs_.size());
  for (Record& record : records) {
    if (!has(record)) continue;
    record.repetition += repetitions_ * pairs_.at(record.generator_parameters);
    record.generator_parameters = parameters;
  }
  return records;
}

Truth Pool::truth_of(const std::vector<Record>& records) const {
  return size() == 0 ? Truth(records) : Truth((*this)(records));
}

bool is_pool(const CellKey& cell) {
  return cell.generator == kFiles && cell.generator_parameters.starts_with(kPairs);
}

}  // namespace raygauge
