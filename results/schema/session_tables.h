// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "results/provenance/provenance.h"

namespace H5 {
class Group;
}

namespace raygauge {

/// The machines of the sessions, each once, in the order of their first sessions; the sessions' machine_row
/// is set. Machines are the same if all they say of themselves is, but for the cores that a process may use.
std::vector<MachineInfo> distinct_machines(std::vector<Session>& sessions);

/// Writes the tables `sessions`, `machines` and `versions` of a group.
void write_sessions(H5::Group& group, std::vector<Session> sessions);

/// The inverse. `place` names the group in messages. Throws ResultsError.
std::vector<Session> read_sessions(const H5::Group& group, const std::string& place);

}  // namespace raygauge
