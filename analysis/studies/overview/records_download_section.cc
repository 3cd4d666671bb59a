// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/render/report/deflate.h"
#include "analysis/studies/sections.h"
#include "results/journal/csv.h"

namespace raygauge::report {

std::optional<Section> records_section(const Input& input) {
  constexpr int kTimeDigits = 7;  // more than any clock has, and half the size of all 17
  Section section{"records", "Records", {}};
  section.blocks.push_back(RecordsDownload{input.records.size(), "records.csv", kTimeDigits,
                                           base64(gzip(csv_text(input.records, kTimeDigits)))});
  return section;
}

}  // namespace raygauge::report
