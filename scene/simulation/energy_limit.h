// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <utility>
#include <vector>

#include "scene/simulation/contact_problem.h"
#include "scene/simulation/simulated_body.h"

namespace raygauge {

/// Contacts that ask for more than rest (a rebound, or that an overlap goes) may add energy: Newton's law of
/// restitution does where bodies rub (Kane 1984), and so does the way out of an overlap. Of each island of
/// contacts
///     gain = Σ K(v after) - Σ allowed - Σ p · u,
/// with K the kinetic energy of its bodies, and p · u the work of those that are driven, is to be at most 0.
class EnergyLimit {
 public:
  /// `free`: the bodies without the impulses. `allowed`: the energy that each may have.
  EnergyLimit(const std::vector<SimulatedBody>& free, std::vector<double> allowed)
      : free_(free), allowed_(std::move(allowed)) {}

  /// The contacts of the islands that gain energy by their impulses, in rising order.
  std::vector<std::size_t> broken(const std::vector<ContactUnknown>& contacts) const;

  /// Of each island the impulses p = q + s (p - q) of the largest s in [0, 1] that keeps the limit; `rest`
  /// are the impulses q of the same contacts where they ask for nothing. Impulses in friction cones stay in
  /// them.
  void keep(std::vector<ContactUnknown>& contacts, const std::vector<ContactUnknown>& rest) const;

  /// Bodies that the impulses have pushed, and that gain energy even so because gravity has worked on their
  /// way out of an overlap, pay for it by their speed, where they touch what stands.
  void slow_down(const std::vector<ContactUnknown>& contacts, std::vector<SimulatedBody>& pushed) const;

 private:
  double gain(const std::vector<std::size_t>& island, const std::vector<ContactUnknown>& contacts) const;
  double slack(const std::vector<std::size_t>& island, const std::vector<ContactUnknown>& contacts) const;
  double share(const std::vector<std::size_t>& island, const std::vector<ContactUnknown>& contacts,
               const std::vector<ContactUnknown>& rest) const;
  bool touches_what_stands(const std::set<std::size_t>& bodies) const;

  const std::vector<SimulatedBody>& free_;
  std::vector<double> allowed_;
};

}  // namespace raygauge
