// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

#include "engine/queries/point_stream.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {

/// The hull of points that memory does not hold: Q or A of a distance that is found by passes over them
/// (StreamedDistance). Every other query reads all points for each support point.
class StreamedHull final : public ConvexSet {
 public:
  /// A new stream of the same points: each solve reads its own, so that threads may share the set.
  using Open = std::function<std::unique_ptr<PointStream>()>;

  /// Reads the beginning of the stream. Throws what the stream throws.
  explicit StreamedHull(Open open);

  std::unique_ptr<PointStream> stream() const { return open_(); }
  std::ptrdiff_t size() const noexcept { return size_; }  ///< points

  /// Some of the first points.
  const PointSet& beginning() const noexcept { return *beginning_; }

 private:
  double do_support(const double* u, double* point) const override;
  void do_center(double* point) const override { beginning_->center_unchecked(point); }
  void do_magnitude(double* magnitude) const override;
  SupportStructure do_structure() const noexcept override { return SupportStructure::polytope; }

  Open open_;
  std::ptrdiff_t size_ = 0;
  std::shared_ptr<const PointSet> beginning_;
};

/// nullptr for every other set.
const StreamedHull* as_streamed_hull(const ConvexSet& S) noexcept;

}  // namespace raygauge
