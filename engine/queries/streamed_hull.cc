// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/streamed_hull.h"

#include <algorithm>
#include <typeinfo>
#include <utility>

#include "engine/numerics/floating_point.h"
#include "engine/queries/streamed_set.h"

namespace raygauge {

StreamedHull::StreamedHull(Open open) : ConvexSet(open()->dimension()), open_(std::move(open)) {
  StreamedSet streamed(open_());
  size_ = streamed.size();
  beginning_ = streamed.working_set();
}

double StreamedHull::do_support(const double* u, double* point) const {
  StreamedSet streamed(open_());
  double level = -kInfinity;
  streamed.stream().pass([&](const StreamedPoints& part) {
    level = std::max(level, streamed.look(part, u, level, 0));
    return true;
  });
  return streamed.working_set()->support_unchecked(u, point);
}

void StreamedHull::do_magnitude(double* magnitude) const {
  StreamedSet streamed(open_());
  const Vector nothing = Vector::Zero(dimension());
  streamed.stream().pass([&](const StreamedPoints& part) {
    streamed.look(part, nothing.data(), 0, 0);
    return true;
  });
  std::copy_n(streamed.magnitude(), dimension(), magnitude);
}

const StreamedHull* as_streamed_hull(const ConvexSet& S) noexcept {
  return typeid(S) == typeid(StreamedHull) ? &static_cast<const StreamedHull&>(S) : nullptr;
}

}  // namespace raygauge
