// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "cli/output/json_text.h"
#include "results/provenance/machine.h"

namespace raygauge::cli {

/// What `raygauge info` tells of this program and this machine: the build, the machine, libraries and solvers
/// with their versions, the instruction sets, and every method, generator and shape
/// with its parameters.
Json build_json();
std::string build_text();

/// The machine as an object: cpu_model, cores, l1d_bytes, …
Json machine_json(const MachineInfo& machine);

/// One line of a report for people: a label, padded, and its text.
std::string labelled(const std::string& label, const std::string& text);

}  // namespace raygauge::cli
