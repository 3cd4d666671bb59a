// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "analysis/studies/wrong_answers/wrong_answers.h"
#include "engine/numerics/number_text.h"
#include "results/text/number_words.h"

namespace raygauge {
namespace {

TableCell count(std::size_t number, Emphasis emphasis) {
  return {std::to_string(number), static_cast<double>(number), number > 0 ? emphasis : Emphasis::none};
}

/// Per cent with two digits; 0 is none at all.
TableCell share_cell(const WrongAnswers& answers) {
  if (answers.wrong() == 0) return {"0", 0.0};
  return {padded_significant(100 * answers.wrong_share(), 2) + " %", answers.wrong_share(), Emphasis::alarm};
}

TableCell time_cell(double seconds) {
  return TableCell(std::isinf(seconds) ? "unsolved" : padded_significant(1e6 * seconds, 3));
}

std::string name_of(const std::string& place) { return place.empty() ? "all" : place; }

std::string title(const std::string& what, const WrongInPlace& part) {
  const std::string about =
      part.quantity == Quantity::distance ? "" : ", quantity " + std::string(to_string(part.quantity));
  return what + about + " at tolerance " + rounded_text(part.tolerance, 6);
}

Table by_method(const WrongInPlace& part) {
  Table table;
  table.title = title("Who is wrong", part);
  table.key_columns = 2;
  table.header = {{"place", "method", "asked", "wrong", "share", "wrong sign", "gave up", "limit",
                   "worst error", "median µs"}};
  table.notes = {
      "wrong: off by more than 1e-6 of the size of the bodies, or of the wrong sign: that bodies apart meet, "
      "or "
      "the reverse (by more than 1e-9); worst error: in sizes, of growth in 1",
      "gave up: an exception, or the solver says that it failed; limit: no answer in time"};
  return table;
}

void add_rows(Table& table, const WrongInPlace& part) {
  for (std::size_t i = 0; i < part.methods.size(); ++i) {
    const WrongAnswers& row = part.methods[i];
    TableRow line;
    line.starts_group = i == 0;
    line.cells = {TableCell(i == 0 ? name_of(part.place) : ""),
                  TableCell(row.method),
                  count(row.asked, Emphasis::none),
                  count(row.wrong(), Emphasis::alarm),
                  share_cell(row),
                  count(row.wrong_sign, Emphasis::alarm),
                  count(row.gave_up, Emphasis::alarm),
                  count(row.limits, Emphasis::alarm),
                  TableCell(padded_significant(row.worst, 2)),
                  time_cell(row.median_seconds)};
    table.rows.push_back(std::move(line));
  }
}

/// `all`: all places of the question.
Table by_kind(const WrongInPlace& all) {
  Table table;
  table.title = title("Share of wrong answers by place and kind of body", all);
  table.key_columns = 2;
  table.header = {{"place", "kind"}};
  for (const WrongAnswers& row : all.methods) table.header[0].push_back(row.method);
  table.notes = {"a pair counts for the kinds of both of its bodies, but for \"any\""};
  return table;
}

void add_kind_rows(Table& table, const WrongInPlace& part) {
  const std::vector<std::string>& header = table.header[0];
  bool first = true;
  for (const auto& [kind, rows] : part.kinds) {
    TableRow line;
    line.starts_group = first;
    line.cells = {TableCell(first ? name_of(part.place) : ""), TableCell(kind)};
    line.cells.resize(header.size());
    for (const WrongAnswers& row : rows) {
      const auto column = std::find(header.begin(), header.end(), row.method) - header.begin();
      line.cells[static_cast<std::size_t>(column)] = share_cell(row);
    }
    table.rows.push_back(std::move(line));
    first = false;
  }
}

TableRow long_row(const WrongInPlace& part, const std::string& kind, const WrongAnswers& row) {
  TableRow line;
  line.cells = {number_cell(part.tolerance), TableCell(std::string(to_string(part.quantity))),
                TableCell(name_of(part.place)), TableCell(kind), TableCell(row.method)};
  for (const std::size_t number : {row.asked, row.wrong(), row.wrong_sign, row.gave_up, row.limits})
    line.cells.push_back(number_cell(static_cast<double>(number)));
  for (const double value : {row.wrong_share(), row.worst, 1e6 * row.median_seconds})
    line.cells.push_back(number_cell(value));
  return line;
}

}  // namespace

std::vector<Table> wrong_answers_tables(const WrongStudy& study) {
  std::vector<Table> tables;
  bool begins = true;
  for (auto part = study.places.begin(); part != study.places.end(); ++part) {
    if (begins) {
      const auto all = std::find_if(part, study.places.end(), [](const auto& p) { return p.place.empty(); });
      tables.push_back(by_method(*all));
      tables.push_back(by_kind(*all));
    }
    begins = part->place.empty();
    add_rows(tables[tables.size() - 2], *part);
    add_kind_rows(tables.back(), *part);
  }
  return tables;
}

Table wrong_answers_long_table(const WrongStudy& study) {
  Table table;
  table.title = "Who is wrong";
  table.key_columns = 5;
  table.header = {{"tolerance", "quantity", "place", "kind", "method", "asked", "wrong", "wrong_sign",
                   "gave_up", "limits", "wrong_share", "worst_error", "median_microseconds"}};
  for (const WrongInPlace& part : study.places) {
    for (const WrongAnswers& row : part.methods) table.rows.push_back(long_row(part, "all", row));
    for (const auto& [kind, rows] : part.kinds) {
      for (const WrongAnswers& row : rows) table.rows.push_back(long_row(part, kind, row));
    }
  }
  return table;
}

}  // namespace raygauge
