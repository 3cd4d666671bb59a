// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/compare/compare_circumstances.h"

#include <algorithm>
#include <array>
#include <functional>
#include <set>
#include <utility>

#include "analysis/data/columns.h"
#include "results/run/identity.h"
#include "results/schema/schema.h"
#include "results/text/words.h"

namespace raygauge {
namespace {

/// The columns of a machine that change times, and what readers call them.
constexpr std::array<std::pair<const char*, const char*>, 4> kMachineColumns = {
    {{"cpu_model", "processor"},
     {"hostname", "machine"},
     {"operating_system", "operating system"},
     {"kernel", "kernel"}}};

/// The same of a session.
constexpr std::array<std::pair<const char*, const char*>, 7> kSessionColumns = {
    {{"cores", "cores"},
     {"compiler", "compiler"},
     {"compiler_flags", "compiler flags"},
     {"build_type", "build type"},
     {"git_dirty", "modified sources"},
     {"timing", "timing"},
     {"threads", "threads"}}};

template <class Row>
std::string text_in(const std::vector<Column<Row>>& columns, const std::string& name, const Row& row) {
  const auto column =
      std::find_if(columns.begin(), columns.end(), [&](const auto& each) { return each.name == name; });
  return text_of(column->get(row));
}

/// The values that a property takes over the sessions of a run.
std::string values_of(const std::function<std::string(const Session&)>& property,
                      const Provenance& provenance) {
  std::set<std::string> values;
  for (const Session& session : provenance.sessions) {
    const std::string value = property(session);
    values.insert(value.empty() ? "unknown" : value);
  }
  return joined(values, " and ");
}

}  // namespace

std::string versions_text(const Session& session) {
  std::vector<std::string> words;
  for (const ComponentVersion& each : session.versions) words.push_back(each.name + " " + each.version);
  return joined(words);
}

std::vector<std::string> circumstance_differences(const Provenance& base, const Provenance& fresh) {
  std::vector<std::string> notes;
  const std::string experiment = identity_difference(base.identity, fresh.identity);
  if (!experiment.empty()) notes.push_back("the experiments: " + experiment);
  const auto compare = [&](const std::string& label,
                           const std::function<std::string(const Session&)>& property) {
    const std::string before = values_of(property, base);
    const std::string after = values_of(property, fresh);
    if (before != after) notes.push_back(label + ": " + before + "; now " + after);
  };
  for (const auto& [name, label] : kMachineColumns) {
    compare(label, [name = name](const Session& session) {
      return text_in(machine_columns(), name, session.machine);
    });
  }
  for (const auto& [name, label] : kSessionColumns) {
    compare(label,
            [name = name](const Session& session) { return text_in(session_columns(), name, session); });
  }
  compare("library versions", versions_text);
  return notes;
}

}  // namespace raygauge
