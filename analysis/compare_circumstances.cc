// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/compare_circumstances.h"

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

#include "results/identity.h"

namespace raygauge {
namespace {

using Property = std::pair<const char*, std::function<std::string(const Session&)>>;

std::string versions_text(const Session& session) {
  std::string text;
  for (const ComponentVersion& each : session.versions)
    text += (text.empty() ? "" : ", ") + each.name + " " + each.version;
  return text;
}

const std::vector<Property>& properties() {
  static const std::vector<Property> kProperties = {
      {"processor", [](const Session& s) { return s.machine.cpu_model; }},
      {"cores", [](const Session& s) { return std::to_string(s.machine.cores); }},
      {"machine", [](const Session& s) { return s.machine.hostname; }},
      {"operating system", [](const Session& s) { return s.machine.operating_system; }},
      {"kernel", [](const Session& s) { return s.machine.kernel; }},
      {"compiler", [](const Session& s) { return s.build.compiler; }},
      {"compiler flags", [](const Session& s) { return s.build.compiler_flags; }},
      {"build type", [](const Session& s) { return s.build.build_type; }},
      {"modified sources", [](const Session& s) { return s.build.git_dirty ? "yes" : "no"; }},
      {"timing", [](const Session& s) { return s.timing; }},
      {"threads", [](const Session& s) { return std::to_string(s.threads); }},
      {"library versions", versions_text},
  };
  return kProperties;
}

/// The values that a property takes over the sessions of a run.
std::string values_of(const Property& property, const Provenance& provenance) {
  std::set<std::string> values;
  for (const Session& session : provenance.sessions) values.insert(property.second(session));
  std::string text;
  for (const std::string& value : values)
    text += (text.empty() ? "" : " and ") + (value.empty() ? "unknown" : value);
  return text;
}

}  // namespace

std::vector<std::string> circumstance_differences(const Provenance& base, const Provenance& fresh) {
  std::vector<std::string> notes;
  const std::string experiment = identity_difference(base.identity, fresh.identity);
  if (!experiment.empty()) notes.push_back("the experiments: " + experiment);
  for (const Property& property : properties()) {
    const std::string before = values_of(property, base);
    const std::string after = values_of(property, fresh);
    if (before != after) notes.push_back(std::string(property.first) + ": " + before + "; now " + after);
  }
  return notes;
}

}  // namespace raygauge
