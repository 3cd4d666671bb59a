// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/piecewise_motion.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "raygauge/exceptions.h"

namespace raygauge {

MotionPiece::MotionPiece(double begin, const Placement& first, const TwistMotion::Rates& rates)
    : start(begin),
      dimension(first.dimension()),
      R(in_space(first.R)),
      x(in_space(first.t)),
      velocity(in_space(rates.velocity)),
      acceleration(in_space(rates.acceleration)),
      spin(rates.spin) {}

Placement MotionPiece::first() const {
  return {SmallMatrix(R.topLeftCorner(dimension, dimension)), SmallVector(x.head(dimension))};
}

TwistMotion::Rates MotionPiece::rates() const {
  TwistMotion::Rates rates{SmallVector(velocity.head(dimension)), {}, spin};
  if (!acceleration.isZero(0)) rates.acceleration = acceleration.head(dimension);
  return rates;
}

PiecewiseMotion::PiecewiseMotion(std::vector<MotionPiece> pieces, double stop)
    : Motion(pieces.empty() ? 1 : pieces.front().dimension, pieces.empty() ? 0 : pieces.front().start, stop),
      pieces_(std::move(pieces)) {
  if (pieces_.empty()) throw InvalidParameterError("motion: it needs a piece");
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const double end = i + 1 < pieces_.size() ? pieces_[i + 1].start : stop;
    if (!(pieces_[i].start <= end)) throw InvalidParameterError("motion: pieces must rise");
    TwistMotion(pieces_[i].first(), pieces_[i].rates(), pieces_[i].start);  // which checks the numbers
  }
}

const MotionPiece& PiecewiseMotion::piece_of(double t) const {
  const auto after =
      std::upper_bound(pieces_.begin() + 1, pieces_.end(), t,
                       [](double time, const MotionPiece& piece) { return time < piece.start; });
  return *(after - 1);
}

TwistMotion PiecewiseMotion::motion_of(double t) const {
  const MotionPiece& piece = piece_of(t);
  return {piece.first(), piece.rates(), piece.start};
}

double PiecewiseMotion::do_next_break(double t) const {
  const auto next =
      std::upper_bound(pieces_.begin(), pieces_.end(), t,
                       [](double time, const MotionPiece& piece) { return time < piece.start; });
  return next == pieces_.end() ? std::numeric_limits<double>::infinity() : next->start;
}

Eigen::Vector3d PiecewiseMotion::velocity(double t) const {
  const MotionPiece& piece = piece_of(t);
  return piece.velocity + (t - piece.start) * piece.acceleration;
}

Eigen::Vector3d PiecewiseMotion::spin(double t) const { return piece_of(t).spin; }

}  // namespace raygauge
