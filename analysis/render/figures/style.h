// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "analysis/data/filter.h"
#include "analysis/data/method_list.h"
#include "raygauge/sweep/record.h"

namespace raygauge::figure_style {

// What figures have in common: looks, and the checks of what they need.

/// In the place of a method: what the paper published. Grey, with crosses.
inline constexpr const char* kPaperCurve = "paper";

/// A cross over a point whose cell has wrong or missing answers.
inline constexpr const char* kFlawStyle = "pt 2 ps 0.8 lw 1.2 lc rgb '#B3261E'";

/// How the curve of a method looks (look_of_method()), for gnuplot; by its label among `methods`.
std::string line_style(const std::string& method, const MethodList& methods);

/// The same without markers, for step functions.
std::string step_style(const std::string& method, const MethodList& methods);

/// "#D55E00": the colour in line_style().
std::string line_color(const std::string& method, const MethodList& methods);

/// A fraction of the width or height of the whole picture, for gnuplot's "screen".
std::string screen(double fraction);

/// Tick marks 1, 2, 5, 10, … within [low, high], as gnuplot's list "(200, 500, 1000)"; of more than `most`,
/// whose labels would run into each other, powers of ten alone; where there are fewer than two of them, the
/// ends with two digits.
std::string one_two_five_ticks(double low, double high, std::size_t most = 9);

/// About four powers of ten within [low, high], as gnuplot's list.
std::string decade_ticks(double low, double high);

/// The records that pass the filter, pairs of the user's own as a Pool. Throws FigureNeedsError where none
/// does.
std::vector<Record> comparable_records(const std::string& figure, const std::vector<Record>& records,
                                       const Filter& filter);

}  // namespace raygauge::figure_style
