// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/scene/motion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "engine/numerics/double_double.h"
#include "engine/numerics/floating_point.h"
#include "raygauge/exceptions.h"
#include "raygauge/sets/pose.h"

namespace raygauge {
namespace {

// What the sums and products below may lose, with room to spare.
constexpr double kOutward = 1 + 1e-13;

// Squares of speeds above this may overflow; nothing is proven of them.
constexpr double kFastest = 1e150;

// What turned_by() loses, about 80 u: sines and cosines, the entries made of them, and a product.
constexpr double kTurnRounding = 1e-14;

// `frame`, turned by |turn| about that vector.
SmallMatrix turned_by(const Eigen::Vector3d& turn, const SmallMatrix& frame) {
  if (frame.rows() == 3) {
    const double angle = turn.norm();
    if (angle == 0) return frame;
    const Eigen::Matrix3d R = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
    return R * Eigen::Matrix3d::Map(frame.data());
  }
  if (frame.rows() == 2) return plane_rotation(turn[2]) * frame;
  return frame;
}

// r with turned_by(r, R0) = R1, the shorter way.
Eigen::Vector3d turn_between(const SmallMatrix& R0, const SmallMatrix& R1) {
  const SmallMatrix D = R1 * R0.transpose();
  if (D.rows() == 2) return {0, 0, std::atan2(D(1, 0), D(0, 0))};
  if (D.rows() == 3) {
    const Eigen::AngleAxisd turn(Eigen::Quaterniond(Eigen::Matrix3d(D)).normalized());
    const double angle = turn.angle() > EIGEN_PI ? turn.angle() - 2 * EIGEN_PI : turn.angle();
    return angle * turn.axis();
  }
  if (!D.isIdentity(1e-9)) {
    throw InvalidParameterError("motion: rotations between keyframes need 2 or 3 dimensions");
  }
  return Eigen::Vector3d::Zero();
}

void check_finite(bool finite, const char* what) {
  if (!finite) throw NonFiniteError(std::string("motion: ") + what + " is not finite");
}

}  // namespace

SmallVector MotionBound::velocity_of(const SmallVector& arm) const {
  if (arm.size() == 3) return velocity + SmallVector(spin.cross(Eigen::Vector3d(arm)));
  if (arm.size() == 2) return velocity + spin[2] * SmallVector(Eigen::Vector2d(-arm[1], arm[0]));
  return velocity;
}

double MotionBound::turning(const SmallVector& u) const {
  if (u.size() == 3) return spin.cross(Eigen::Vector3d(u)).norm();
  return spin.norm() * u.norm();
}

MotionBound MotionBound::unknown(int n) {
  return {SmallVector::Zero(n), kInfinity, Eigen::Vector3d::Zero(), kInfinity};
}

double MotionBound::speed_along(const SmallVector& u, double reach) const {
  if (!(velocity_error < kInfinity)) return kInfinity;
  const double size = u.norm();
  const double turned = turning(u) + spin_error * size;
  const double spread = velocity_error * size + (turned > 0 ? turned * reach : 0);
  return velocity.dot(u) + spread * kOutward + (kOutward - 1) * velocity.lpNorm<1>() * size;
}

double MotionBound::speed(double reach) const {
  if (!(velocity_error < kInfinity)) return kInfinity;
  const double turned = spin.norm() + spin_error;
  return (velocity.norm() + velocity_error + (turned > 0 ? turned * reach : 0)) * kOutward;
}

Placement Motion::at(double t) const {
  if (!(t >= start_ && t <= stop_)) {
    throw InvalidParameterError("motion: time " + std::to_string(t) + " is outside [" +
                                std::to_string(start_) + ", " + std::to_string(stop_) + "]");
  }
  return do_at(t);
}

MotionBound Motion::bound(double from, double to) const {
  const MotionBound found = do_bound(from, to);
  const double fastest =
      found.velocity.lpNorm<1>() + found.velocity_error + found.spin.lpNorm<1>() + found.spin_error;
  return fastest <= kFastest ? found : MotionBound::unknown(dimension());  // unknown where it is NaN, too
}

PlacementError Motion::error_at(double t) const {
  const PlacementError found = do_error_at(t);
  return found.place + found.turn <= kFastest * kUnitRoundoff ? found : PlacementError{kInfinity, kInfinity};
}

bool Motion::keeps_rotation(double from, double to) const {
  for (double t = from;;) {
    const double end = std::min(to, next_break(t));
    const MotionBound bounds = bound(t, end);
    if (bounds.spin_error > 0 || bounds.spin != Eigen::Vector3d::Zero() || error_at(end).turn > 0)
      return false;
    if (end >= to) return true;
    t = end;
  }
}

double Motion::do_next_break(double) const { return std::numeric_limits<double>::infinity(); }

MotionBound StaticMotion::do_bound(double, double) const {
  return {SmallVector::Zero(dimension()), 0, Eigen::Vector3d::Zero(), 0};
}

KeyframeMotion::KeyframeMotion(std::vector<double> times, std::vector<Placement> frames)
    : Motion(frames.empty() ? 1 : frames.front().dimension(), times.empty() ? 0 : times.front(),
             times.empty() ? 0 : times.back()),
      times_(std::move(times)),
      frames_(std::move(frames)) {
  if (times_.size() != frames_.size() || times_.size() < 2) {
    throw InvalidParameterError("motion: keyframes need two times at least, and a pose for each");
  }
  for (std::size_t i = 0; i < times_.size(); ++i) {
    check_finite(std::isfinite(times_[i]), "a time");
    check_finite(frames_[i].t.allFinite() && frames_[i].R.allFinite(), "a pose");
    if (frames_[i].dimension() != dimension()) {
      throw DimensionMismatchError("motion: keyframes of different dimensions");
    }
    if (i == 0) continue;
    if (!(times_[i - 1] < times_[i])) {
      throw InvalidParameterError("motion: times must rise, but " + std::to_string(times_[i]) +
                                  " comes after " + std::to_string(times_[i - 1]));
    }
    add_piece(frames_[i - 1], frames_[i]);
  }
}

// The turn of a piece loses kTurnRounding, so that the motion whose speeds do_bound() bounds is so far from
// the one that meets the next frame; each placement loses as much again. The origin (1 - s) t0 + s t1 with s
// off by 3 u loses 6 u |t0| + 5 u |t1|.
void KeyframeMotion::add_piece(const Placement& first, const Placement& last) {
  const bool turns = first.R != last.R;
  turns_.push_back(turns ? turn_between(first.R, last.R) : Eigen::Vector3d::Zero());
  PlacementError error;
  if (first.t != last.t) {
    error.place = 8 * kUnitRoundoff * (first.t.lpNorm<1>() + last.t.lpNorm<1>()) + kUnderflow;
  }
  if (turns) {
    error.turn = 2 * kTurnRounding + Pose::defect_of(first.R.data(), dimension()) +
                 Pose::defect_of(last.R.data(), dimension());
  }
  errors_.push_back(error);
}

std::size_t KeyframeMotion::piece_of(double t) const {
  const auto after = std::upper_bound(times_.begin() + 1, times_.end() - 1, t);
  return static_cast<std::size_t>(after - times_.begin()) - 1;
}

Placement KeyframeMotion::do_at(double t) const {
  const std::size_t i = piece_of(t);
  if (t == times_[i]) return frames_[i];
  if (t == times_[i + 1]) return frames_[i + 1];
  const double s = (t - times_[i]) / (times_[i + 1] - times_[i]);
  if (errors_[i].place == 0) return {turned_by(s * turns_[i], frames_[i].R), frames_[i].t};
  return {turned_by(s * turns_[i], frames_[i].R), (1 - s) * frames_[i].t + s * frames_[i + 1].t};
}

// Velocity and angular velocity are constant within a piece.
MotionBound KeyframeMotion::do_bound(double from, double) const {
  const std::size_t i = piece_of(from);
  const double rate = 1 / (times_[i + 1] - times_[i]);
  if (errors_[i].place + errors_[i].turn == 0) return {SmallVector::Zero(dimension())};
  return {(frames_[i + 1].t - frames_[i].t) * rate, 0, turns_[i] * rate, 0};
}

double KeyframeMotion::do_next_break(double t) const {
  const auto next = std::upper_bound(times_.begin(), times_.end(), t);
  return next == times_.end() ? std::numeric_limits<double>::infinity() : *next;
}

TwistMotion::TwistMotion(Placement first, Rates rates, double start, double stop)
    : Motion(first.dimension(), start, stop), first_(std::move(first)), rates_(std::move(rates)) {
  const int n = dimension();
  if (rates_.acceleration.size() == 0) rates_.acceleration.setZero(n);
  if (rates_.velocity.size() != n || rates_.acceleration.size() != n) {
    throw DimensionMismatchError("motion: a velocity or an acceleration is not of " + std::to_string(n) +
                                 " numbers");
  }
  check_finite(rates_.velocity.allFinite() && rates_.acceleration.allFinite() && rates_.spin.allFinite(),
               "a rate");
  check_finite(std::isfinite(start), "the first time");
  const bool plane = n == 2 && rates_.spin[0] == 0 && rates_.spin[1] == 0;
  if (n != 3 && !plane && !rates_.spin.isZero(0)) {
    throw InvalidParameterError("motion: a spin needs 3 dimensions, or 2 and (0, 0, ω)");
  }
  path_ = rates_.velocity.isZero(0) ? Path::none : Path::straight;
  if (!rates_.acceleration.isZero(0)) path_ = Path::curved;
}

// With an acceleration the origin is computed in twice the digits: where the body comes to rest its terms
// cancel for a time.
Placement TwistMotion::do_at(double t) const {
  const DoubleDouble s = two_sum(t, -start());
  if (path_ != Path::curved) {
    return {turned_by(s.high * rates_.spin, first_.R), first_.t + s.high * rates_.velocity};
  }
  Placement here{turned_by(s.high * rates_.spin, first_.R), first_.t};
  const DoubleDouble half_square = s * s * 0.5;
  for (Eigen::Index k = 0; k < here.t.size(); ++k) {
    here.t[k] = (s * rates_.velocity[k] + half_square * rates_.acceleration[k] + first_.t[k]).rounded();
  }
  return here;
}

// An angle loses 8 u of itself, an origin on a straight path 3 u of its terms. On a curved one it is rounded
// once and loses 2⁻⁹⁵ of its terms before; computed in doubles below it is within 8 u of them.
PlacementError TwistMotion::do_error_at(double t) const {
  const double s = std::fabs(t - start());
  PlacementError error;
  if (rates_.spin != Eigen::Vector3d::Zero()) {
    error.turn = kTurnRounding * (1 + s * rates_.spin.lpNorm<1>());
  }
  if (path_ == Path::none) return error;
  const double terms =
      first_.t.lpNorm<1>() + s * rates_.velocity.lpNorm<1>() + s * s / 2 * rates_.acceleration.lpNorm<1>();
  error.place = 4 * kUnitRoundoff * terms + kUnderflow;
  if (path_ == Path::straight) return error;
  const double size =
      (first_.t + s * rates_.velocity + s * s / 2 * rates_.acceleration).lpNorm<1>() + 1e-15 * terms;
  error.place = 1.01 * kUnitRoundoff * size + 1e-28 * terms + kUnderflow;
  return error;
}

// Over [from, to] the velocity is within half the time times |a| of that of the middle, which loses 4 u of
// its terms.
MotionBound TwistMotion::do_bound(double from, double to) const {
  const double acceleration = rates_.acceleration.norm();
  if (path_ != Path::curved) return {rates_.velocity, 0, rates_.spin, 0};
  const double middle = (from + to) / 2 - start();
  const double spread = acceleration * (to - from) / 2;
  const double terms =
      rates_.velocity.norm() + (std::fabs(from) + std::fabs(to) + std::fabs(start())) * acceleration;
  return {rates_.velocity + middle * rates_.acceleration, spread * kOutward + 8 * kUnitRoundoff * terms,
          rates_.spin, 0};
}

}  // namespace raygauge
