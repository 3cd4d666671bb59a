// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include "results/exceptions.h"
#include "scene/simulation/simulation_part.h"

namespace raygauge {

/// Walks over all numbers of a part of a simulation: one text says in which order they are written and read.
/// `Way` has `number(double&)` and `size(std::size_t)`, which is the size that a list is to have.
template <class Way>
class NumberArchive {
 public:
  void pass(double& x) { way().number(x); }
  template <class Integer>
  requires std::is_integral_v<Integer>
  void pass(Integer& x) {
    auto number = static_cast<double>(x);
    way().number(number);
    x = static_cast<Integer>(number);
  }
  template <class Number, int rows, int columns, int options, int most_rows, int most_columns>
  void pass(Eigen::Matrix<Number, rows, columns, options, most_rows, most_columns>& M) {
    if constexpr (rows == Eigen::Dynamic) {
      const auto height = static_cast<Eigen::Index>(way().size(static_cast<std::size_t>(M.rows())));
      const Eigen::Index width = columns == 1 ? 1 : height;
      if (height > kMostSceneDimensions) throw ResultsError("simulation: a part is damaged");
      M.resize(height, width);
    }
    for (Eigen::Index k = 0; k < M.size(); ++k) pass(M.data()[k]);
  }
  template <class Row>
  void pass(std::vector<Row>& rows) {
    rows.resize(way().size(rows.size()));
    for (Row& row : rows) pass(row);
  }
  void pass(StepRecord& s) {
    all(s.time, s.substeps, s.impacts, s.contacts, s.residual, s.least_distance, s.kinetic, s.potential);
    all(s.momentum, s.angular_momentum);
  }
  void pass(ContactRecord& c) {
    all(c.step, c.time, c.body_a, c.body_b, c.impact, c.point, c.normal, c.gap, c.impulse);
  }
  void pass(MotionPiece& p) {
    Placement first = p.first();
    TwistMotion::Rates rates = p.rates();
    all(p.start, first.R, first.t, rates.velocity, rates.acceleration, rates.spin);
    const Eigen::Index n = first.t.size(), more = rates.acceleration.size();
    if (n < 1 || n > 3 || first.R.rows() != n || rates.velocity.size() != n || (more != 0 && more != n))
      throw ResultsError("simulation: a part is damaged");
    p = {p.start, first, rates};
  }
  void pass(SimulationCounters& c) {
    all(c.ball_tests, c.contact_queries, c.motion_proofs, c.friction_problems, c.frictionless_problems);
    all(c.impact_problems, c.damped_velocities);
  }
  void pass(BodyBetweenSteps& b) { all(b.x, b.R, b.v, b.L); }
  void pass(KnownImpulse& k) { all(k.a, k.b, k.at, k.impulse); }
  void pass(KnownNormal& k) { all(k.part_a, k.part_b, k.normal); }
  void pass(SimulationState& s) { all(s.time, s.bodies, s.impulses, s.normals); }
  void pass(SimulationPart& p) { all(p.first_step, p.steps, p.contacts, p.pieces, p.counters, p.state); }

 private:
  Way& way() { return static_cast<Way&>(*this); }
  template <class... Things>
  void all(Things&... things) {
    (pass(things), ...);
  }
};

class NumberWriter : public NumberArchive<NumberWriter> {
 public:
  std::vector<double> numbers;
  void number(double& x) { numbers.push_back(x); }
  std::size_t size(std::size_t count) {
    numbers.push_back(static_cast<double>(count));
    return count;
  }
};

/// Throws ResultsError where numbers are missing or left over.
class NumberReader : public NumberArchive<NumberReader> {
 public:
  explicit NumberReader(std::string place) : place_(std::move(place)) {}

  std::vector<double> numbers;
  void number(double& x) {
    if (at_ >= numbers.size()) damaged();
    x = numbers[at_++];
  }
  std::size_t size(std::size_t /*count*/) {
    double count = 0;
    number(count);
    if (!(count >= 0 && count <= static_cast<double>(numbers.size() - at_))) damaged();
    return static_cast<std::size_t>(count);
  }
  void require_end() const {
    if (at_ != numbers.size()) damaged();
  }

 private:
  [[noreturn]] void damaged() const { throw ResultsError(place_ + ": a damaged part of a simulation"); }

  std::string place_;
  std::size_t at_ = 0;
};

}  // namespace raygauge
