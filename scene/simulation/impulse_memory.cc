// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/impulse_memory.h"

#include <algorithm>
#include <utility>

namespace raygauge {
namespace {

constexpr auto kByBodies = [](const auto& one, const auto& other) {
  return std::pair(one.a, one.b) < std::pair(other.a, other.b);
};

}  // namespace

void ImpulseMemory::remember(const std::vector<ContactUnknown>& contacts, double dt) {
  contacts_ = contacts;
  dt_ = dt;
  if (!std::is_sorted(contacts_.begin(), contacts_.end(), kByBodies))
    std::stable_sort(contacts_.begin(), contacts_.end(), kByBodies);
}

Eigen::Vector3d ImpulseMemory::guess(const NearPair& pair, const GapPoint& point, double near,
                                     double dt) const {
  const auto [first, end] = std::equal_range(contacts_.begin(), contacts_.end(), pair, kByBodies);
  const auto away = [&point](const ContactUnknown& one) { return (one.at - point.at).squaredNorm(); };
  const auto before = std::min_element(
      first, end, [&](const auto& one, const auto& other) { return away(one) < away(other); });
  if (before == end || !(away(*before) < near * near)) return Eigen::Vector3d::Zero();
  return std::min(1.0, dt / dt_) * before->impulse;
}

}  // namespace raygauge
