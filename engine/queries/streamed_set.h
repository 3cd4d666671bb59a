// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <unordered_set>
#include <vector>

#include "engine/proof/certificate.h"
#include "engine/queries/point_stream.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {

/// The hull of the points of a stream, as far as a solve needs to know it: some of them, the working set,
/// which passes add to.
class StreamedSet {
 public:
  /// Reads the beginning of the stream, for a first working set.
  explicit StreamedSet(std::unique_ptr<PointStream> stream);

  /// Those at hand, in R^n. Valid until the next call; what grow() has found is among them from then on.
  std::shared_ptr<const PointSet> working_set();

  /// Points along u (n numbers) of a part of the stream: the best of those above `level - reach` join the
  /// working set. Returns max u·p over the part. Throws NonFiniteError.
  double look(const StreamedPoints& part, const double* u, double level, double reach);

  /// |u·p as computed - u·p| for every point looked at so far: ConvexSet::rounding_error, and the size of the
  /// coordinates.
  double rounding(const double* u) const;

  /// max |p_k| over the points looked at so far, n numbers.
  const double* magnitude() const noexcept { return magnitude_.data(); }

  /// Of a point of the working set, where it is in the stream.
  std::ptrdiff_t number_of(std::ptrdiff_t i) const { return numbers_[static_cast<std::size_t>(i)]; }

  PointStream& stream() const noexcept { return *stream_; }
  std::ptrdiff_t size() const noexcept { return stream_->size(); }
  int dimension() const noexcept { return n_; }

 private:
  template <class Real>
  double look_at(const Real* points, const StreamedPoints& part, const double* u, double threshold);
  template <class Real>
  void measure(const Real* points, const StreamedPoints& part);
  template <class Real>
  void keep(const Real* point, std::ptrdiff_t number);

  struct Candidate {
    double value;
    std::ptrdiff_t at;
  };

  std::unique_ptr<PointStream> stream_;
  int n_;
  std::vector<double> points_;  // of the working set, one after the other
  std::vector<std::ptrdiff_t> numbers_;
  std::unordered_set<std::ptrdiff_t> known_;
  std::vector<double> magnitude_;  // max |p_k| of the points measured
  std::ptrdiff_t measured_ = 0;    // points from the first one on
  std::vector<Candidate> candidates_;
};

}  // namespace raygauge
