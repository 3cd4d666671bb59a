// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/schema/session_tables.h"

#include <algorithm>
#include <cstddef>

#include "results/schema/column_io.h"
#include "results/schema/schema.h"
#include "results/schema/table_reader.h"

namespace raygauge {
namespace {

bool same_machine(const MachineInfo& a, const MachineInfo& b) {
  const std::vector<Column<MachineInfo>>& columns = machine_columns();
  return std::all_of(columns.begin(), columns.end(),
                     [&](const Column<MachineInfo>& column) { return column.get(a) == column.get(b); });
}

/// Row `number` of a table that another one refers to.
template <class Row>
Row& row_of(std::vector<Row>& rows, std::int32_t number, const std::string& place, const std::string& table) {
  if (number >= 0 && static_cast<std::size_t>(number) < rows.size()) {
    return rows[static_cast<std::size_t>(number)];
  }
  throw ResultsError(place + ": row " + std::to_string(number) + " is not in " + table);
}

/// Gives the session its machine; `cores` are the session's own.
void set_machine(Session& session, const MachineInfo& machine) {
  const std::int32_t cores = session.machine.cores;
  session.machine = machine;
  session.machine.cores = cores;
}

void read_machines(const H5::Group& group, const std::string& place, std::vector<Session>& sessions) {
  std::vector<MachineInfo> machines = hdf5::read_table(group, "machines", machine_columns(), place);
  for (Session& session : sessions) {
    set_machine(session, row_of(machines, session.machine_row, place + "/sessions", "machines"));
  }
}

}  // namespace

std::vector<MachineInfo> distinct_machines(std::vector<Session>& sessions) {
  std::vector<MachineInfo> machines;
  for (Session& session : sessions) {
    const auto known = std::find_if(machines.begin(), machines.end(), [&](const MachineInfo& machine) {
      return same_machine(machine, session.machine);
    });
    session.machine_row = static_cast<std::int32_t>(known - machines.begin());
    if (known == machines.end()) machines.push_back(session.machine);
  }
  return machines;
}

void write_sessions(H5::Group& group, std::vector<Session> sessions) {
  const std::vector<MachineInfo> machines = distinct_machines(sessions);
  std::vector<VersionRow> versions;
  for (std::size_t i = 0; i < sessions.size(); ++i) {
    for (const ComponentVersion& entry : sessions[i].versions) {
      versions.push_back({static_cast<std::int32_t>(i), entry.name, entry.version});
    }
  }
  hdf5::write_table(group, "sessions", session_columns(), sessions, hdf5::Layout::plain);
  hdf5::write_table(group, "machines", machine_columns(), machines, hdf5::Layout::plain);
  hdf5::write_table(group, "versions", version_columns(), versions, hdf5::Layout::plain);
}

std::vector<Session> read_sessions(const H5::Group& group, const std::string& place) {
  std::vector<Session> sessions = hdf5::read_table(group, "sessions", session_columns(), place);
  read_machines(group, place, sessions);
  for (const VersionRow& row : hdf5::read_table(group, "versions", version_columns(), place)) {
    row_of(sessions, row.session, place + "/versions", "sessions")
        .versions.push_back({row.name, row.version});
  }
  return sessions;
}

}  // namespace raygauge
