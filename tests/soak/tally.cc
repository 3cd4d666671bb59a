// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "tests/soak/tally.h"

#include <algorithm>
#include <cstdio>

#include "raygauge/methods/options.h"

namespace raygauge::soak {
namespace {

std::int64_t count(const FamilyTally& tally, DistanceStatus status) {
  return tally.by_status[static_cast<std::size_t>(status)];
}

double microseconds(const FamilyTally& tally, DistanceMethod method) {
  const std::size_t i = place_of(method);
  return 1e6 * tally.seconds[i] / static_cast<double>(std::max<std::int64_t>(1, tally.by_method[i]));
}

std::string row(const std::string& name, const FamilyTally& tally) {
  const double share =
      tally.solves > 0 ? 100.0 * static_cast<double>(tally.certified()) / static_cast<double>(tally.solves)
                       : 0.0;
  std::array<char, 256> line{};
  std::snprintf(line.data(), line.size(),
                "%-26s %9lld %11lld %9.4f %8lld %8lld %10lld %10lld %11lld %9lld %7lld %8.1e %9.1f %9.1f\n",
                name.c_str(), static_cast<long long>(tally.bases), static_cast<long long>(tally.solves),
                share, static_cast<long long>(count(tally, DistanceStatus::precision_limit)),
                static_cast<long long>(count(tally, DistanceStatus::iteration_limit) +
                                       count(tally, DistanceStatus::time_limit)),
                static_cast<long long>(count(tally, DistanceStatus::contains_origin)),
                static_cast<long long>(count(tally, DistanceStatus::unreachable)),
                static_cast<long long>(tally.settled_exactly), static_cast<long long>(tally.normals_short),
                static_cast<long long>(tally.exact_checks), tally.worst_width,
                microseconds(tally, DistanceMethod::column_generation),
                microseconds(tally, DistanceMethod::zheng_yamane));
  return line.data();
}

std::string head(const std::string& what) {
  std::array<char, 256> line{};
  std::snprintf(line.data(), line.size(), "%-26s %9s %11s %9s %8s %8s %10s %10s %11s %9s %7s %8s %9s %9s\n",
                what.c_str(), "bases", "solves", "certif. %", "precis.", "limits", "contains 0",
                "unreachable", "exact", "short n", "oracle", "width", "c.g. us", "z.y. us");
  return line.data();
}

}  // namespace

std::int64_t FamilyTally::certified() const {
  return count(*this, DistanceStatus::optimal) + count(*this, DistanceStatus::contains_origin) +
         count(*this, DistanceStatus::unreachable);
}

void FamilyTally::add(const FamilyTally& other) {
  bases += other.bases;
  solves += other.solves;
  for (std::size_t i = 0; i < by_status.size(); ++i) by_status[i] += other.by_status[i];
  settled_exactly += other.settled_exactly;
  normals_checked += other.normals_checked;
  normals_short += other.normals_short;
  exact_checks += other.exact_checks;
  for (std::size_t i = 0; i < seconds.size(); ++i) {
    seconds[i] += other.seconds[i];
    by_method[i] += other.by_method[i];
  }
  worst_width = std::max(worst_width, other.worst_width);
}

FamilyTally Tally::total() const {
  FamilyTally sum;
  for (const auto& entry : families) sum.add(entry.second);
  return sum;
}

void Tally::add(const Tally& other) {
  for (const auto& [name, tally] : other.families) families[name].add(tally);
  for (const auto& [n, tally] : other.dimensions) dimensions[n].add(tally);
}

std::string to_string(const Tally& tally) {
  std::string text = head("family");
  for (const auto& [name, family] : tally.families) text += row(name, family);
  text += row("all", tally.total()) + "\n" + head("dimension");
  for (const auto& [n, dimension] : tally.dimensions) text += row("n = " + std::to_string(n), dimension);
  return text;
}

}  // namespace raygauge::soak
