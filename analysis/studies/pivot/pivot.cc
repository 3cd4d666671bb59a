// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/pivot/pivot.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <tuple>

#include "analysis/data/columns.h"
#include "analysis/data/parameter_columns.h"
#include "analysis/data/pool.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

using Columns = std::vector<AnalysisColumn>;
using Key = std::vector<Value>;

/// What different records of one cell of the grid may not be mixed over.
const std::vector<std::string> kIdentity = {"generator", "generator_parameters", "method",
                                            "method_parameters", "tolerance"};

Columns columns_named(const std::vector<Record>& records, const std::vector<std::string>& names,
                      const std::string& place) {
  Columns columns;
  for (const std::string& name : names) columns.push_back(column_among(records, name, place));
  return columns;
}

Key key_of(const Columns& columns, const Record& record) {
  Key key;
  key.reserve(columns.size());
  for (const AnalysisColumn& column : columns) key.push_back(column.get(record));
  return key;
}

Columns concatenated(const Columns& a, const Columns& b) {
  Columns all = a;
  all.insert(all.end(), b.begin(), b.end());
  return all;
}

/// Whether records that agree in `grouping` may differ in `column`.
bool varies_within(const std::vector<Record>& records, const Columns& grouping,
                   const AnalysisColumn& column) {
  std::map<Key, Value> seen;
  return std::any_of(records.begin(), records.end(), [&](const Record& record) {
    const auto [place, first] = seen.emplace(key_of(grouping, record), column.get(record));
    return !first && place->second != column.get(record);
  });
}

/// Whether the generator's parameters in `instances`, which are those records with their pools, differ in a
/// group of the records.
bool parameters_vary(const std::vector<Record>& records, const std::vector<Record>& instances,
                     const Columns& grouping) {
  std::map<Key, std::string> seen;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const std::string& parameters = instances[i].generator_parameters;
    const auto [place, first] = seen.emplace(key_of(grouping, records[i]), parameters);
    if (!first && place->second != parameters) return true;
  }
  return false;
}

/// The column with what differs between the records alone: other parameters tell nothing apart.
AnalysisColumn short_column(const AnalysisColumn& column, const std::vector<Record>& records) {
  AnalysisColumn result = column;
  const VaryingParameters varying(records);
  if (column.name == "generator_parameters")
    result.get = [varying](const Record& record) -> Value { return varying.of_generator(record); };
  if (column.name == "method_parameters")
    result.get = [varying](const Record& record) -> Value { return varying.of_method(record); };
  return result;
}

/// The identity columns that the table must be split by. Pairs of a pool are instances: they may mix.
Columns implied_rows(const std::vector<Record>& records, const Columns& rows, const Columns& columns,
                     const Pool& pool) {
  const std::vector<Record> instances = pool(records);
  Columns implied;
  for (const std::string& name : kIdentity) {
    const AnalysisColumn& column = analysis_column(name);
    const Columns grouping = concatenated(concatenated(implied, rows), columns);
    if (name == "generator_parameters" ? parameters_vary(records, instances, grouping)
                                       : varies_within(records, grouping, column))
      implied.push_back(short_column(column, records));
  }
  return implied;
}

/// The distinct keys, numbers by size and texts by first appearance, first column slowest.
std::vector<Key> sorted_keys(const std::vector<Record>& records, const Columns& columns) {
  std::vector<std::map<Value, std::size_t>> ranks(columns.size());
  for (std::size_t c = 0; c < columns.size(); ++c) {
    for (const Record& record : records) ranks[c].emplace(columns[c].get(record), ranks[c].size());
    if (columns[c].type == ValueType::text) continue;
    std::size_t rank = 0;
    for (auto& [value, place] : ranks[c]) place = rank++;
  }
  std::map<std::vector<std::size_t>, Key> keys;
  for (const Record& record : records) {
    const Key key = key_of(columns, record);
    std::vector<std::size_t> place;
    for (std::size_t c = 0; c < key.size(); ++c) place.push_back(ranks[c].at(key[c]));
    keys.emplace(place, key);
  }
  std::vector<Key> result;
  for (auto& [place, key] : keys) result.push_back(key);
  return result;
}

std::map<Key, std::size_t> positions(const std::vector<Key>& keys) {
  std::map<Key, std::size_t> result;
  for (std::size_t i = 0; i < keys.size(); ++i) result.emplace(keys[i], i);
  return result;
}

/// Fills the cells of a pivot whose keys are known.
class Filler {
 public:
  Filler(Pivot& pivot, const Columns& rows, const Columns& columns)
      : pivot_(pivot),
        rows_(rows),
        columns_(columns),
        row_positions_(positions(pivot.row_keys)),
        column_positions_(positions(pivot.column_keys)),
        values_(pivot.row_keys.size() * pivot.column_keys.size()) {
    pivot.cells.assign(values_.size(), {});
  }

  void count(const std::vector<Record>& records) {
    for (const Record& record : records) {
      PivotCell& cell = pivot_.cells[place_of(record)];
      ++cell.records;
      if (!is_solved(record)) ++cell.unsolved;
      if (!record.agrees) ++cell.disagreeing;
    }
  }

  void fill_counts() {
    for (PivotCell& cell : pivot_.cells) {
      if (cell.records == 0) continue;
      const std::string& name = pivot_.value.name;
      cell.value = static_cast<double>(name == "count"      ? cell.records
                                       : name == "failures" ? cell.unsolved
                                                            : cell.disagreeing);
    }
  }

  void fill_values(const std::vector<Record>& records) {
    const AnalysisColumn& column = analysis_column(pivot_.value.quantity);
    for (const Record& record : records) {
      if (record.agrees || pivot_.value.is_share()) add(place_of(record), number_of(column, record));
    }
    aggregate();
    if (pivot_.value.name != "median") return;
    for (std::size_t i = 0; i < values_.size(); ++i) {
      if (!values_[i].empty()) pivot_.cells[i].interval = median_interval(values_[i]);
    }
  }

  void fill_ratios(const std::vector<Record>& records, const std::vector<CellRatio>& ratios) {
    std::map<std::tuple<CellKey, std::string, std::string>, std::size_t> places;
    for (const Record& record : records)
      places.emplace(std::make_tuple(cell_key(record), record.method, record.method_parameters),
                     place_of(record));
    std::map<std::size_t, const CellRatio*> only;
    for (const CellRatio& each : ratios) {
      const std::size_t place =
          places.at(std::make_tuple(each.times.cell, each.times.method, each.times.method_parameters));
      add(place, each.ratio.ratio);
      const auto [found, first] = only.emplace(place, &each);
      if (!first) found->second = nullptr;
    }
    aggregate();
    for (const auto& [place, ratio] : only) {
      if (ratio != nullptr && !values_[place].empty()) pivot_.cells[place].interval = ratio->ratio.interval;
    }
  }

 private:
  void add(std::size_t place, double value) {
    if (std::isnan(value)) {
      ++pivot_.cells[place].without_value;
    } else {
      values_[place].push_back(value);
    }
  }

  std::size_t place_of(const Record& record) const {
    return row_positions_.at(key_of(rows_, record)) * pivot_.column_keys.size() +
           column_positions_.at(key_of(columns_, record));
  }

  void aggregate() {
    for (std::size_t i = 0; i < values_.size(); ++i) {
      if (!values_[i].empty()) pivot_.cells[i].value = aggregate_of(pivot_.value, values_[i]);
    }
  }

  Pivot& pivot_;
  const Columns& rows_;
  const Columns& columns_;
  std::map<Key, std::size_t> row_positions_;
  std::map<Key, std::size_t> column_positions_;
  std::vector<std::vector<double>> values_;
};

/// A ratio belongs to a whole cell of the grid and cannot be split by what varies inside.
void require_cell_columns(const Columns& columns) {
  static const std::set<std::string> kCellColumns = {
      "generator", "generator_parameters", "method", "method_parameters", "n", "N", "tolerance", "cell"};
  for (const AnalysisColumn& column : columns) {
    if (kCellColumns.count(column.name) > 0 || find_analysis_column(column.name) == nullptr) continue;
    throw InvalidParameterError(
        "a ratio compares whole cells (generator, n, N, tolerance, method) and cannot be split by '" +
        column.name + "'");
  }
}

std::vector<Record> without_methods(const std::vector<Record>& records,
                                    const std::vector<std::string>& methods) {
  std::vector<Record> rest;
  std::copy_if(records.begin(), records.end(), std::back_inserter(rest), [&](const Record& record) {
    return std::find(methods.begin(), methods.end(), record.method) == methods.end();
  });
  return rest;
}

std::vector<std::string> names_of(const Columns& columns) {
  std::vector<std::string> names;
  for (const AnalysisColumn& column : columns) names.push_back(column.name);
  return names;
}

void require_records(const std::vector<Record>& records, const std::string& why) {
  if (records.empty()) throw EmptySetError("there is nothing to tabulate: " + why);
}

}  // namespace

Pivot make_pivot(const std::vector<Record>& records, const PivotOptions& options) {
  Pivot pivot;
  pivot.value = parse_aggregate(options.value);
  Columns rows = columns_named(records, options.rows, "rows");
  const Columns columns = columns_named(records, options.columns, "columns");
  std::vector<Record> kept = filtered(records, options.filter);
  require_records(kept, records.empty()
                            ? "no records"
                            : "no record passes the filter '" + options.filter.expression() + "'");
  std::vector<Record> denominators;
  if (pivot.value.is_ratio()) {
    require_cell_columns(concatenated(rows, columns));
    pivot.baselines = options.baselines.empty() ? default_baselines(records) : options.baselines;
    denominators = baseline_records(records, options.filter, pivot.baselines);
    kept = without_methods(kept, pivot.baselines);
    require_records(kept, "the baselines are all there is, and their own ratio says nothing");
  }
  if (!pivot.value.counts()) {
    const Pool pool(kept);
    const Columns implied = implied_rows(kept, rows, columns, pool);
    pivot.split_by = names_of(implied);
    rows = concatenated(implied, rows);
    if (varies_within(kept, concatenated(rows, columns), analysis_column("generator_parameters")))
      pivot.pooled = pool.size();
  }
  pivot.row_names = names_of(rows);
  pivot.column_names = names_of(columns);
  pivot.row_keys = sorted_keys(kept, rows);
  pivot.column_keys = sorted_keys(kept, columns);

  Filler filler(pivot, rows, columns);
  filler.count(kept);
  if (pivot.value.counts()) {
    filler.fill_counts();
  } else if (pivot.value.is_ratio()) {
    filler.fill_ratios(kept, cell_ratios(kept, denominators, pivot.baselines));
  } else {
    filler.fill_values(kept);
  }
  return pivot;
}

}  // namespace raygauge
