// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "analysis/constants.h"
#include "analysis/render/report/blocks.h"
#include "analysis/studies/sections.h"
#include "analysis/studies/wrong_answers/wrong_answers.h"
#include "engine/numerics/number_text.h"

namespace raygauge::report {
namespace {

/// "wrong": 3 of 2450 answers, …
std::string remark_on(const WrongAnswers& row) {
  return std::to_string(row.wrong()) + " of " + std::to_string(row.asked) + " answers wrong, " +
         std::to_string(row.wrong_sign) + " of them of the wrong sign, " +
         std::to_string(row.gave_up + row.limits) + " without an answer";
}

Chart picture_of(const WrongStudy& study) {
  constexpr double kNone = 1e-4;  // per cent; a logarithmic axis has no 0
  constexpr double kPerCent = 100;
  constexpr double kMicroseconds = 1e6;
  Chart chart;
  chart.caption =
      "Share of wrong answers against the median time: off by more than 1e-6 of the size of the bodies, or "
      "of the "
      "wrong sign. No wrong answer is drawn at 0.0001 %. A crossed point: some solves came to no answer.";
  chart.x = {"median time of a solve (µs)", true, "µs"};
  chart.y = {"wrong answers (%)", true, "%"};
  for (const WrongInPlace& part : study.places) {
    for (const WrongAnswers& row : part.methods) {
      if (std::isinf(row.median_seconds)) continue;
      Series series;
      series.method = row.method;
      series.facets = {{"tolerance", rounded_text(part.tolerance, 3)},
                       {"quantity", std::string(to_string(part.quantity))},
                       {"place", part.place.empty() ? "all" : part.place}};
      series.points.push_back({kMicroseconds * row.median_seconds,
                               std::max(kPerCent * row.wrong_share(), kNone), kNaN, kNaN, remark_on(row),
                               row.gave_up + row.limits > 0});
      chart.series.push_back(std::move(series));
    }
  }
  return chart;
}

}  // namespace

std::optional<Section> wrong_answers_section(const Input& input) {
  if (std::none_of(input.records.begin(), input.records.end(), is_of_bodies)) return std::nullopt;
  const WrongStudy study = wrong_answers(input.merged.records, input.filter);
  Section section{"wrong_answers", "Who is wrong", {}};
  section.blocks.emplace_back(picture_of(study));
  for (const Table& table : wrong_answers_tables(study)) section.blocks.emplace_back(table);
  section.blocks.emplace_back(
      Text{{"raygauge export --refutations writes a proof of each wrong answer, which a reader can check."},
           false});
  return section;
}

}  // namespace raygauge::report
