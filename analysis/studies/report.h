// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/data/cell_ratio.h"
#include "analysis/data/filter.h"
#include "analysis/data/instances.h"
#include "analysis/data/merge.h"
#include "analysis/data/pool.h"
#include "analysis/data/record_groups.h"
#include "analysis/data/truth.h"
#include "analysis/render/report/blocks.h"
#include "analysis/studies/stability/stability.h"
#include "raygauge/sweep/record.h"

namespace raygauge::report {

/// What a report is made of, and what more than one section needs of it.
struct Input {
  const MergedResults& merged;  ///< all records of the files: truths and baselines may lie outside the filter
  Filter filter;
  Pool pool;                 ///< the user's own pairs
  std::vector<Record> kept;  ///< those that pass the filter, pairs pooled, where these differ from all
  const std::vector<Record>& records;  ///< those that pass the filter; pairs of the user's own as a Pool
  RecordGroups groups;                 ///< of the records that pass, as all that follows but the truth
  MethodList methods;                  ///< methods_of() them
  Truth truth;                         ///< of all records
  std::vector<std::string> baselines;  ///< of ratios; empty where no method is a baseline
  std::vector<CellTimes> cells;        ///< cell_times() of them
  std::vector<CellRatio> ratios;       ///< empty without baselines
  std::map<CellKey, std::vector<MethodInstances>> instances;  ///< instances_by_cell()
  Stability stability;                                        ///< make_stability()

  /// Throws EmptySetError where no record passes, and as baseline_records().
  Input(const MergedResults& merged, const Filter& filter, std::vector<std::string> baselines);
  Input(const Input&) = delete;
  Input& operator=(const Input&) = delete;

 private:
  std::vector<CellRatio> ratios_of_cells() const;
  bool all_as_they_are() const { return filter.expression().empty() && pool.size() == 0; }
};

/// A part of the page: blocks under a title.
struct Section {
  std::string id;
  std::string title;
  std::vector<Block> blocks;
};

/// Makes a section, or nothing where the records lack its data.
using SectionMaker = std::function<std::optional<Section>(const Input&)>;

/// Every section in its order on the page: a new one is one file in sections/ and one line in sections.cc.
const std::vector<SectionMaker>& section_makers();

/// The report of the records that pass `filter`: one HTML page that needs no network. `baselines` empty:
/// default_baselines(), of GLPK or else of NLopt. Throws EmptySetError if no record passes, UnknownNameError
/// for an unknown baseline.
std::string make_page(const MergedResults& merged, const Filter& filter,
                      const std::vector<std::string>& baselines);

}  // namespace raygauge::report
