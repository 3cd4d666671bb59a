// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/pivot/pivot_table.h"

#include <algorithm>
#include <cmath>

#include "analysis/data/columns.h"
#include "engine/numerics/number_text.h"
#include "results/text/number_words.h"
#include "results/text/words.h"

namespace raygauge {
namespace {

constexpr int kDigits = 3;

std::string number_text(const Pivot& pivot, double value) {
  if (pivot.value.is_share()) return padded_significant(100 * value, kDigits) + " %";
  if (std::isinf(value))
    return pivot.value.is_ratio() || value > 0 ? "unsolved" : rounded_text(value, kDigits);
  if (pivot.value.counts() || value == std::round(value)) return rounded_text(value, 15);
  return padded_significant(value, kDigits);
}

/// Whether infinity means that solves were not finished.
bool is_time(const Pivot& pivot) {
  if (pivot.value.counts()) return false;
  return pivot.value.is_ratio() || analysis_column(pivot.value.quantity).is_time;
}

TableCell table_cell(const Pivot& pivot, const PivotCell& cell, bool intervals) {
  if (cell.records == 0) return {""};
  if (std::isnan(cell.value))
    return {cell.disagreeing == cell.records ? "disagree" : "none", Emphasis::alarm};
  std::string text = std::isinf(cell.value) && !is_time(pivot) ? rounded_text(cell.value, kDigits)
                                                               : number_text(pivot, cell.value);
  if (intervals && cell.interval) {
    text += " [" + number_text(pivot, cell.interval->lower) + ", " +
            (std::isinf(cell.interval->upper) ? "inf" : number_text(pivot, cell.interval->upper)) + "]";
  }
  const bool marked = !pivot.value.counts() && !pivot.value.is_share() &&
                      (cell.unsolved > 0 || cell.disagreeing > 0 || cell.without_value > 0);
  if (marked) text += "*";
  return {text, cell.value, marked ? Emphasis::alarm : Emphasis::none};
}

/// The cell, and with `separate` the ends of its interval beside it: empty where it has none.
void add_cells(TableRow& row, const Pivot& pivot, const PivotCell& cell, bool intervals, bool separate) {
  row.cells.push_back(table_cell(pivot, cell, intervals && !separate));
  if (!separate) return;
  const bool has_interval = cell.interval && !std::isnan(cell.value);
  row.cells.push_back(has_interval ? number_cell(cell.interval->lower) : TableCell(""));
  row.cells.push_back(has_interval ? number_cell(cell.interval->upper) : TableCell(""));
}

std::string key_text(const std::string& name, const Value& value) {
  const std::string text = text_of(value);
  return std::holds_alternative<std::string>(value) ? text : name + "=" + text;
}

std::string title(const Pivot& pivot) {
  std::string text = pivot.value.name;
  if (pivot.value.is_ratio()) {
    text += " ratio of time to the best of " + joined(pivot.baselines, ", ");
  } else if (!pivot.value.counts()) {
    text += " " + pivot.value.quantity;
    const std::string unit = analysis_column(pivot.value.quantity).unit;
    if (!unit.empty() && unit != "1" && pivot.value.quantity != "milliseconds" &&
        pivot.value.quantity != "microseconds" && pivot.value.quantity != "seconds") {
      text += " in " + unit;
    }
  }
  return text;
}

/// "newton, n=3, N=200"
std::string place_text(const Pivot& pivot, std::size_t row, std::size_t column) {
  std::vector<std::string> words;
  for (std::size_t c = 0; c < pivot.row_names.size(); ++c)
    words.push_back(key_text(pivot.row_names[c], pivot.row_keys[row][c]));
  for (std::size_t c = 0; c < pivot.column_names.size(); ++c)
    words.push_back(key_text(pivot.column_names[c], pivot.column_keys[column][c]));
  return joined(words, " ");
}

/// "…: newton n=3 2 of 20, …", the first few places where a count is not 0; "" if there are none.
std::string places_note(const Pivot& pivot, std::size_t PivotCell::*count, const std::string& what) {
  constexpr std::size_t kListed = 6;
  std::vector<std::string> places;
  std::size_t total = 0;
  std::size_t others = 0;
  for (std::size_t i = 0; i < pivot.cells.size(); ++i) {
    const PivotCell& cell = pivot.cells[i];
    if (cell.*count == 0) continue;
    total += cell.*count;
    if (places.size() == kListed) {
      ++others;
      continue;
    }
    const std::string place = place_text(pivot, i / pivot.column_keys.size(), i % pivot.column_keys.size());
    places.push_back(place + (place.empty() ? "" : " ") + std::to_string(cell.*count) + " of " +
                     std::to_string(cell.records));
  }
  if (total == 0) return "";
  if (others > 0) places.push_back("and in " + std::to_string(others) + " more cells");
  return "* " + std::to_string(total) + (total == 1 ? " record " : " records ") + what + ": " +
         joined(places, ", ");
}

std::vector<std::string> notes(const Pivot& pivot) {
  if (pivot.value.counts() || pivot.value.is_share()) return {};
  std::vector<std::string> notes = {
      places_note(pivot, &PivotCell::unsolved,
                  is_time(pivot) ? "unsolved (stopped at a limit), counted as infinitely slow"
                                 : "unsolved (stopped at a limit), counted with the value reached"),
      places_note(pivot, &PivotCell::disagreeing, "in disagreement with other methods, left out"),
      places_note(pivot, &PivotCell::without_value,
                  pivot.value.is_ratio() ? "without a baseline to divide by" : "without a value, left out")};
  notes.erase(std::remove(notes.begin(), notes.end(), ""), notes.end());
  return notes;
}

}  // namespace

Table pivot_table(const Pivot& pivot, bool intervals, bool separate) {
  separate = separate && intervals;
  Table table;
  table.title = title(pivot);
  table.key_columns = pivot.row_names.size();
  const std::size_t lines = std::max<std::size_t>(1, pivot.column_names.size());
  for (std::size_t line = 0; line < lines; ++line) {
    std::vector<std::string> header =
        line + 1 == lines ? pivot.row_names : std::vector<std::string>(table.key_columns);
    for (const auto& key : pivot.column_keys) {
      header.push_back(pivot.column_names.empty() ? table.title
                                                  : key_text(pivot.column_names[line], key[line]));
      if (!separate) continue;
      const std::string name = header.back();
      const bool last = line + 1 == lines;
      header.insert(header.end(), {name + (last ? " lower" : ""), name + (last ? " upper" : "")});
    }
    table.header.push_back(std::move(header));
  }
  for (std::size_t r = 0; r < pivot.row_keys.size(); ++r) {
    TableRow row;
    const auto& key = pivot.row_keys[r];
    const bool has_groups = table.key_columns > 1;
    row.starts_group = r > 0 && has_groups && key.front() != pivot.row_keys[r - 1].front();
    for (const Value& value : key) row.cells.emplace_back(text_of(value));
    for (std::size_t c = 0; c < pivot.column_keys.size(); ++c)
      add_cells(row, pivot, pivot.cell(r, c), intervals, separate);
    table.rows.push_back(std::move(row));
  }
  table.notes = notes(pivot);
  if (pivot.pooled > 0)
    table.notes.push_back("over all " + std::to_string(pivot.pooled) +
                          " pairs of the generator files; --rows pair shows each");
  if (!pivot.split_by.empty())
    table.notes.push_back("split by " + joined(pivot.split_by, ", ") + ", which the value must not mix");
  if (intervals)
    table.notes.emplace_back(
        "[lower, upper]: 95 % intervals; of medians by interpolated order statistics "
        "(Hettmansperger-Sheather), of ratios of medians by Zou-Donner from these");
  return table;
}

}  // namespace raygauge
