// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/data/method_list.h"
#include "analysis/render/figures/figure.h"

namespace raygauge {

/// Where things are in a figure of equal panels, side by side and below each other, under a legend that goes
/// across. Lengths in inches.
struct PanelGrid {
  std::size_t columns = 1;
  std::size_t rows = 1;
  std::size_t legend_columns = 1;
  double width = 0;
  double legend = 0;                     ///< height of the legend
  double x_labels = 0;                   ///< height of what stands below each row but the last
  double gap = 0.12;                     ///< between columns
  std::string flaw;                      ///< what a crossed point means (PanelCurve::flaws); "" where none is
  static constexpr double kLeft = 0.66;  // the label of the axis and "10^{-15}" beside it
  static constexpr double kRight = 0.17;  // half of "10^{-10}" below the end of an axis
  static constexpr double kBottom = 0.42;
  static constexpr double kTitle = 0.2;

  double panel_width() const;
  double panel_height() const;
  double height() const;
  /// How many rows a page of paper holds, 9 inches high.
  std::size_t rows_a_page() const;

  /// Whether a panel stands in the first column.
  bool is_left(std::size_t panel) const { return panel % columns == 0; }
  /// Whether no panel of `count` stands below on its page.
  bool is_lowest(std::size_t panel, std::size_t count) const {
    return panel + columns >= count || (panel / columns + 1) % rows_a_page() == 0;
  }

  /// gnuplot's margins of a panel.
  std::string margins(std::size_t panel) const;
  /// The labels that all panels share.
  std::string axis_labels(const std::string& x, const std::string& y) const;
  /// The legend, a plot of its own across the whole width: inside a panel it would have to fit there. After
  /// it, borders and tics are set for the panels.
  std::string legend_plot(const MethodList& methods) const;
};

/// The grid for so many panels and a legend of the methods and the `flaw`, with at most `most_columns`.
PanelGrid panel_grid(std::size_t panels, const MethodList& methods, FigureSize size, std::size_t most_columns,
                     const std::string& flaw = "");

}  // namespace raygauge
