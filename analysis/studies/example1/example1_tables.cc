// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "analysis/constants.h"
#include "analysis/data/cell_ratio.h"
#include "analysis/studies/example1/example1_table.h"
#include "analysis/studies/table3/paper.h"
#include "engine/numerics/number_text.h"
#include "results/text/number_words.h"

namespace raygauge {
namespace {

std::string title_of(Example1Roles roles) {
  return roles == Example1Roles::cone_ellipsoid ? "Table I" : "Table II";
}

/// The paper's row for a tolerance; its numbers are NaN where it has none.
paper::AccuracyRow paper_row(Example1Roles roles, double tolerance) {
  constexpr double kRounding = 1e-9;
  const auto& rows = roles == Example1Roles::cone_ellipsoid ? paper::table1() : paper::table2();
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const paper::AccuracyRow& row) {
    return std::abs(row.tolerance - tolerance) <= kRounding * tolerance;
  });
  if (found != rows.end()) return *found;
  return {tolerance, kNaN, kNaN, kNaN, kNaN, kNaN, kNaN};
}

TableCell published(double value, int digits) {
  TableCell cell = padded_cell(value, digits);
  cell.emphasis = Emphasis::muted;
  return cell;
}

TableCell error_of(const AccuracyPoint& point) {
  TableCell cell = padded_cell(point.mean_error, 3);
  if (!(point.mean_error <= point.tolerance)) cell.emphasis = Emphasis::alarm;
  return cell;
}

/// Per cent of the solves, so that a rare failure still shows.
TableCell share_cell(std::size_t count, std::size_t solves) {
  if (count == 0) return {"0"};
  const double per_cent = 100 * static_cast<double>(count) / static_cast<double>(solves);
  return {rounded_text(per_cent, 2) + " %", static_cast<double>(count), Emphasis::alarm};
}

TableRow engine_row(const Example1Table& table, const AccuracyPoint& point) {
  const paper::AccuracyRow paper = paper_row(table.roles, point.tolerance);
  TableRow row;
  row.cells = {{rounded_text(point.tolerance, 6)},
               error_of(point),
               padded_cell(1e6 * point.mean_seconds, 3),
               padded_cell(point.K, 3),
               padded_cell(point.N_rs, 4),
               padded_cell(point.supports, 3),
               padded_cell(table.time_ratio(point), 2),
               share_cell(point.failures, point.solves),
               share_cell(point.wrong, point.solves),
               published(paper.error, 3),
               published(paper.milliseconds, 3),
               published(paper.K, 3),
               published(paper.N_rs, 4),
               published(paper.milliseconds / paper.active_set_milliseconds, 2)};
  return row;
}

TableRow competitor_row(const Example1Table& table, const AccuracyPoint& point) {
  const paper::AccuracyRow paper = paper_row(table.roles, point.tolerance);
  TableRow row;
  row.cells = {{rounded_text(point.tolerance, 6)},       error_of(point),
               padded_cell(1e6 * point.mean_seconds, 3), padded_cell(table.time_ratio(point), 2),
               share_cell(point.failures, point.solves), share_cell(point.wrong, point.solves),
               published(paper.active_set_error, 3),     published(paper.active_set_milliseconds, 4)};
  return row;
}

Table method_table(const Example1Table& table, const AccuracyCurve& curve) {
  Table result;
  const bool competitor = curve.facts.is_competitor();
  result.title = title_of(table.roles) + ", " + curve.method;
  if (competitor) {
    result.header = {{"ε", "error", "µs", "ratio", "failed", "wrong", "active-set:", "ms"}};
  } else {
    result.header = {{"ε", "error", "µs", "K", "N_rs", "supports", "ratio", "failed", "wrong", "paper: error",
                      "ms", "K", "N_rs", "ratio"}};
  }
  for (const AccuracyPoint& point : curve.points) {
    result.rows.push_back(competitor ? competitor_row(table, point) : engine_row(table, point));
  }
  return result;
}

/// The extremes of measured/paper - 1 over the tolerances that the paper has, as "-10 … +25 %": for its own
/// algorithm, an alarm where it also stops as the paper's does.
TableCell deviation_cell(const Example1Table& table, const AccuracyCurve& curve, double AccuracyPoint::*ours,
                         double paper::AccuracyRow::*theirs) {
  double least = kInfinity;
  double most = -least;
  for (const AccuracyPoint& point : curve.points) {
    const double deviation = 100 * (point.*ours / paper_row(table.roles, point.tolerance).*theirs - 1);
    if (std::isnan(deviation)) continue;
    least = std::min(least, deviation);
    most = std::max(most, deviation);
  }
  if (curve.facts.name != "zheng_yamane" || least > most) return {""};
  constexpr int kLength = 48;
  constexpr double kSameAlgorithm = 40;
  char text[kLength];
  std::snprintf(text, kLength, "%+.0f … %+.0f %%", least, most);
  const bool stops_as_published =
      curve.facts.parameters.find("stop_rule=published_sigma") != std::string::npos;
  const bool far = stops_as_published && std::max(-least, most) > kSameAlgorithm;
  return {text, far ? Emphasis::alarm : Emphasis::none};
}

/// The largest value of a quantity over the tolerances.
template <class Quantity>
double largest_of(const AccuracyCurve& curve, const Quantity& quantity) {
  double largest = kNaN;
  for (const AccuracyPoint& point : curve.points) largest = std::fmax(largest, quantity(point));
  return largest;
}

TableCell count_of(const AccuracyCurve& curve, std::size_t AccuracyPoint::*count,
                   std::size_t AccuracyPoint::*of) {
  std::size_t sum = 0;
  std::size_t total = 0;
  for (const AccuracyPoint& point : curve.points) {
    sum += point.*count;
    total += point.*of;
  }
  if (total == 0) return {"no bounds"};
  return {std::to_string(sum) + " of " + std::to_string(total), sum == 0 ? Emphasis::none : Emphasis::alarm};
}

Table summary_of(const Example1Table& table) {
  Table result = summary_table(title_of(table.roles) + ", summary", table.curves,
                               [](const AccuracyCurve& curve) { return curve.method; });
  const auto row = [&](const std::string& what, const auto& cell_of) {
    add_summary_row(result, what, table.curves, cell_of);
  };
  row("largest mean error / ε", [](const AccuracyCurve& curve) {
    const double worst = largest_of(curve, [](const AccuracyPoint& p) { return p.mean_error / p.tolerance; });
    return TableCell{padded_significant(worst, 2), worst, worst <= 1 ? Emphasis::none : Emphasis::alarm};
  });
  row("true error beyond the reported gap", [](const AccuracyCurve& curve) {
    return count_of(curve, &AccuracyPoint::beyond_gap, &AccuracyPoint::bounded);
  });
  row("K against the paper's", [&](const AccuracyCurve& curve) {
    return deviation_cell(table, curve, &AccuracyPoint::K, &paper::AccuracyRow::K);
  });
  row("N_rs against the paper's", [&](const AccuracyCurve& curve) {
    return deviation_cell(table, curve, &AccuracyPoint::N_rs, &paper::AccuracyRow::N_rs);
  });
  row("largest ratio of times", [&](const AccuracyCurve& curve) {
    return padded_cell(largest_of(curve, [&](const AccuracyPoint& p) { return table.time_ratio(p); }), 2);
  });
  row("failed", [](const AccuracyCurve& curve) {
    return count_of(curve, &AccuracyPoint::failures, &AccuracyPoint::solves);
  });
  row("wrong", [](const AccuracyCurve& curve) {
    return count_of(curve, &AccuracyPoint::wrong, &AccuracyPoint::solves);
  });
  result.notes = {
      "error: mean |d - true d| over all solves that left a number; ratio: mean time / that of the best "
      "baseline at "
      "the same ε; supports: mean support queries of a pair (A, Q)"};
  return result;
}

}  // namespace

std::vector<Table> example1_tables(const Example1Table& table) {
  std::vector<Table> tables;
  for (const AccuracyCurve& curve : table.curves) tables.push_back(method_table(table, curve));
  tables.push_back(summary_of(table));
  return tables;
}

Table example1_long_table(const Example1Table& table) {
  Table result;
  result.title = title_of(table.roles);
  result.key_columns = 2;
  result.header = {{"method", "tolerance", "solves", "error", "microseconds", "K", "N_rs", "supports",
                    "ratio", "failed", "wrong", "beyond_gap", "paper_error", "paper_milliseconds", "paper_K",
                    "paper_N_rs", "paper_active_set_error", "paper_active_set_milliseconds"}};
  for (const AccuracyCurve& curve : table.curves) {
    for (const AccuracyPoint& point : curve.points) {
      const paper::AccuracyRow paper = paper_row(table.roles, point.tolerance);
      TableRow row{{{curve.method}}, false};
      for (const double value :
           {point.tolerance, static_cast<double>(point.solves), point.mean_error, 1e6 * point.mean_seconds,
            point.K, point.N_rs, point.supports, table.time_ratio(point), static_cast<double>(point.failures),
            static_cast<double>(point.wrong), static_cast<double>(point.beyond_gap), paper.error,
            paper.milliseconds, paper.K, paper.N_rs, paper.active_set_error, paper.active_set_milliseconds}) {
        row.cells.push_back(number_cell(value));
      }
      result.rows.push_back(std::move(row));
    }
  }
  return result;
}

}  // namespace raygauge
