// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace raygauge {

/// Numbers of facets with a value each, of which the least is asked for: a row that is looked through, which
/// takes less time than a heap does.
class OpenFacets {
 public:
  static constexpr std::int32_t kNone = -1;
  static constexpr double kClosed = std::numeric_limits<double>::infinity();

  struct Least {
    double value = kClosed;
    std::int32_t facet = kNone;
  };

  void clear() noexcept { rows_.clear(); }

  /// Facets 0 to count - 1 have a place; new ones are closed.
  void resize(std::int32_t count) { rows_.resize((static_cast<std::size_t>(count) + kLanes - 1) / kLanes); }
  void open(std::int32_t i, double value) noexcept { place(i) = value; }
  void close(std::int32_t i) noexcept { place(i) = kClosed; }

  /// The open facet of the least value.
  Least least() const noexcept;

 private:
  static constexpr std::size_t kLanes = 8;
  struct alignas(64) Row {
    double value[kLanes] = {kClosed, kClosed, kClosed, kClosed, kClosed, kClosed, kClosed, kClosed};
  };

  double& place(std::int32_t i) noexcept {
    return rows_[static_cast<std::size_t>(i) / kLanes].value[static_cast<std::size_t>(i) % kLanes];
  }
  static Least find_least(const Row* rows, std::size_t count) noexcept;

  std::vector<Row> rows_;
};

}  // namespace raygauge
