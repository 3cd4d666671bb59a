// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "analysis/data/filter.h"
#include "analysis/render/gnuplot.h"
#include "raygauge/exceptions.h"
#include "raygauge/sweep/record.h"

namespace raygauge {

/// The records lack what a figure shows. The message says which figure needs what.
class FigureNeedsError : public Error {
 public:
  using Error::Error;
};

/// Widths of the columns of a printed page.
enum class FigureSize : std::uint8_t {
  single,      ///< 3.5 inches
  double_wide  ///< 7.16 inches
};

/// "single" or "double". Throws UnknownNameError.
FigureSize figure_size_from_string(const std::string& name);

/// In inches.
double width_of(FigureSize size);

struct FigureOptions {
  FigureSize size = FigureSize::double_wide;
  Filter filter;
  std::vector<std::string> baselines;  ///< of ratios; empty: default_baselines()
};

/// A figure before it is drawn.
struct Drawing {
  std::string script;  ///< for gnuplot, without the terminal
  double width = 0;    ///< inches
  double height = 0;
  std::vector<Drawing> next_pages;  ///< where the panels do not fit on one page of paper
};

struct Figure {
  std::string name;
  std::string description;
  /// Throws FigureNeedsError.
  std::function<Drawing(const std::vector<Record>&, const FigureOptions&)> make;
};

/// The picture as the bytes of a file, one for each page. An SVG bears the figure's name and description, a
/// PNG its pixels an inch. Throws FigureNeedsError and GnuplotError.
std::vector<std::string> draw(const Figure& figure, const std::vector<Record>& records,
                              const FigureOptions& options, ImageFormat format);

}  // namespace raygauge
