// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/methods/result.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "raygauge/exceptions.h"
#include "raygauge/methods/options.h"

namespace raygauge {
namespace {

constexpr std::array<std::string_view, 6> kStatusNames = {"optimal",         "contains_origin", "unreachable",
                                                          "precision_limit", "iteration_limit", "time_limit"};
constexpr std::array<std::string_view, 4> kMethodNames = {"automatic", "column_generation", "zheng_yamane",
                                                          "newton"};
constexpr std::array<std::string_view, 4> kInstructionSetNames = {"automatic", "baseline", "avx2", "avx512"};

}  // namespace

std::string_view to_string(DistanceStatus status) noexcept {
  return kStatusNames[static_cast<std::size_t>(status)];
}

std::string_view to_string(DistanceMethod method) noexcept {
  return kMethodNames[static_cast<std::size_t>(method)];
}

std::string_view to_string(InstructionSet isa) noexcept {
  return kInstructionSetNames[static_cast<std::size_t>(isa)];
}

DistanceStatus distance_status_from_string(std::string_view name) {
  for (std::size_t i = 0; i < kStatusNames.size(); ++i) {
    if (kStatusNames[i] == name) return static_cast<DistanceStatus>(i);
  }
  throw UnknownNameError("status", std::string(name), {kStatusNames.begin(), kStatusNames.end()});
}

const double* recorded_normal(const PairStart& warm, int n) noexcept {
  const auto size = static_cast<std::size_t>(n);
  if (warm.dimension != n || (n > 3 && warm.long_normal.size() != size)) return nullptr;
  const double* normal = n <= 3 ? warm.normal.data() : warm.long_normal.data();
  const bool finite = std::all_of(normal, normal + n, [](double u_k) { return std::isfinite(u_k); });
  const bool zero = std::all_of(normal, normal + n, [](double u_k) { return u_k == 0; });
  return finite && !zero ? normal : nullptr;
}

void record_normal(const Vector& normal, PairStart& warm) {
  const auto n = static_cast<int>(normal.size());
  warm.dimension = n;
  warm.count = 0;
  if (n > 3) warm.long_normal.resize(static_cast<std::size_t>(n));
  std::copy_n(normal.data(), n, n <= 3 ? warm.normal.data() : warm.long_normal.data());
}

}  // namespace raygauge
