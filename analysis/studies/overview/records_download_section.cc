// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/render/report/deflate.h"
#include "analysis/studies/sections.h"
#include "results/journal/csv.h"

namespace raygauge::report {
std::optional<Section> records_section(const Input& input) {
  constexpr int kTimeDigits = 7;               // more than any clock has, and half the size of all 17
  constexpr std::size_t kMostRecords = 20000;  // about 2 MB
  RecordsDownload download{input.records.size(), "records.csv", kTimeDigits, ""};
  if (download.count <= kMostRecords)
    download.gzip = base64(gzip(csv_columns(filtered(input.merged.records, input.filter), kTimeDigits)));
  Section section{"records", "Records", {}};
  section.blocks.emplace_back(std::move(download));
  return section;
}

}  // namespace raygauge::report
