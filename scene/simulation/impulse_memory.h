// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "scene/simulation/contact_problem.h"
#include "scene/simulation/near_pair.h"

namespace raygauge {

/// The impulses of a contact problem, from which the next one begins.
class ImpulseMemory {
 public:
  /// The contacts of a problem that was asked for dt.
  void remember(const std::vector<ContactUnknown>& contacts, double dt);

  /// The impulse at this point of the pair in the problem before, of the last substep or as this one was
  /// asked first; of a shorter time a smaller one, as blows do not grow with it. The nearest point within
  /// `near` is the same; 0 where there was none.
  Eigen::Vector3d guess(const NearPair& pair, const GapPoint& point, double near, double dt) const;

  /// By their bodies.
  const std::vector<ContactUnknown>& contacts() const noexcept { return contacts_; }

 private:
  std::vector<ContactUnknown> contacts_;
  double dt_ = 0;
};

}  // namespace raygauge
