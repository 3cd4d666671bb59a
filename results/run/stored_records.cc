// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/run/stored_records.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "raygauge/exceptions.h"
#include "results/schema/schema.h"

namespace raygauge {
namespace {

std::map<std::string, int> method_ranks(const Experiment& experiment) {
  std::map<std::string, int> ranks;
  for (const ComponentSpec& method : experiment.methods) {
    ranks.emplace(label_of(method), static_cast<int>(ranks.size()));
  }
  return ranks;
}

/// NaN has many bit patterns, but one spelling in a journal: so that a run that was resumed is, bit for bit,
/// one that was not.
void make_nan_plain(Record& record) {
  for (const Column<Record>& column : record_columns()) {
    if (column.type != ValueType::float64 || !std::isnan(std::get<double>(column.get(record)))) continue;
    column.set(record, std::numeric_limits<double>::quiet_NaN());
  }
}

}  // namespace

RecordArranger::RecordArranger(const Experiment& experiment) : method_rank_(method_ranks(experiment)) {}

std::vector<Record> RecordArranger::arranged(const CellResult& cell, const RecordSource& source) const {
  const std::string place = "cell " + std::to_string(cell.cell);
  if (cell.records.empty()) throw InvalidParameterError(place + " has no records");
  std::vector<Record> records = cell.records;
  for (Record& record : records) {
    if (record.cell != cell.cell) {
      throw InvalidParameterError(place + " has a record of cell " + std::to_string(record.cell));
    }
    if (method_rank_.count(record.method) == 0) {
      throw InvalidParameterError(place + " has a record of method '" + record.method +
                                  "', which is not in the experiment");
    }
    record.session = source.session;
    record.host = source.host;
    record.rank = source.rank;
    make_nan_plain(record);
  }
  const auto key = [this](const Record& record) {
    return std::make_tuple(record.repetition, method_rank_.at(record.method));
  };
  std::stable_sort(records.begin(), records.end(),
                   [&key](const Record& a, const Record& b) { return key(a) < key(b); });
  return records;
}

}  // namespace raygauge
