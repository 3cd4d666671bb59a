// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>

namespace raygauge::paper {

// What Zheng and Yamane published in "An Efficient Algorithm for a Generalized Distance Measure": MATLAB on a
// laptop with an Intel Core i7 at 2.67 GHz and 3 GB.

/// The grid of Table III.
inline constexpr std::array<int, 8> kTable3Dimensions = {3, 4, 5, 6, 7, 8, 9, 10};
inline constexpr std::array<int, 10> kTable3Points = {200, 400, 600, 800, 1000, 1200, 1400, 1600, 1800, 2000};
inline constexpr double kTable3Tolerance = 1e-6;

/// A cell of Table III.
struct Table3Cell {
  double milliseconds = 0;  ///< of the paper's algorithm
  double ratio = 0;         ///< that time over MATLAB's simplex, 2 decimals
};

/// The cell of Table III for dimension n and N points in each set; nothing outside the table.
std::optional<Table3Cell> table3_cell(int n, int N);

/// A row of Table I (A a truncated cone, Q an ellipsoid) or Table II (swapped): averages over 9000 pairs.
struct AccuracyRow {
  double tolerance = 0;  ///< ε
  double error = 0;      ///< mean |d - true d|
  double milliseconds = 0;
  double K = 0;
  double N_rs = 0;
  double active_set_error = 0;
  double active_set_milliseconds = 0;
};

inline constexpr std::size_t kAccuracyRows = 9;
const std::array<AccuracyRow, kAccuracyRows>& table1();
const std::array<AccuracyRow, kAccuracyRows>& table2();

}  // namespace raygauge::paper
