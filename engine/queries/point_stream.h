// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

namespace raygauge {

/// Points one after the other, n coordinates each, as doubles or (where `doubles` is nullptr) as floats.
struct StreamedPoints {
  const double* doubles = nullptr;
  const float* floats = nullptr;
  std::ptrdiff_t first = 0;  ///< the number of the first one
  std::ptrdiff_t count = 0;
};

/// N points of R^n too many for memory, which are read from the first to the last as often as wanted.
class PointStream {
 public:
  virtual ~PointStream() = default;
  PointStream(const PointStream&) = delete;
  PointStream& operator=(const PointStream&) = delete;

  virtual int dimension() const noexcept = 0;
  virtual std::ptrdiff_t size() const noexcept = 0;

  /// visit(points) for all points in order, in parts that stay in place until it returns. Ends early where it
  /// returns false. Throws what `visit` throws, and an exception of its own where reading fails.
  virtual void pass(const std::function<bool(const StreamedPoints&)>& visit) = 0;

 protected:
  PointStream() = default;
};

}  // namespace raygauge
