// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/data/cell_ratio.h"

namespace raygauge {

/// Coloured cells with numbers in them over the values of n (rows, from the top) and N (columns) that occur.
class CellMap {
 public:
  /// Rows and columns of `cells`; `width` in inches, `right` of it free for a scale of colours.
  CellMap(const std::vector<CellKey>& cells, double width, double right);

  double width() const { return width_; }
  /// Where the cells end, in inches from the left.
  double right_end() const { return width_ - right_; }
  /// Of the cells alone.
  double height() const;

  /// "column row": the place of a cell in gnuplot's coordinates.
  std::string place(const CellKey& cell) const;

  /// gnuplot's ranges, left and right margins, and the labels of n.
  std::string settings() const;
  /// gnuplot's top and bottom margin where the cells begin `top` inches above the bottom of a figure that is
  /// `figure_height` high.
  std::string margins(double top, double figure_height) const;
  /// gnuplot's labels of N below the cells, made to fit for texts of so many characters in each cell.
  std::string bottom_axis(double characters) const;
  /// "font ',SIZE'", so that so many characters fit into a cell; at most 7 points.
  std::string font(double characters) const;

  static constexpr double kBottom = 0.4;  ///< inches that bottom_axis() takes

 private:
  std::vector<int> n_;
  std::vector<int> N_;
  double width_;
  double right_;
};

/// Throws FigureNeedsError where the cells are fewer than two: one number is no map.
void require_two_cells(const std::string& figure, const std::vector<CellKey>& cells);

/// gnuplot's columns of the box of a cell at `place()`, for `with boxxyerror`.
inline constexpr const char* kCellBox = "1:2:($1-0.48):($1+0.48):($2-0.47):($2+0.47)";

}  // namespace raygauge
