// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "results/provenance/provenance.h"

namespace raygauge {

/// "GLPK 5.0, NLopt 2.7.1"
std::string versions_text(const Session& session);

/// What besides the code under test may have changed the times: one sentence for each of processor, cores,
/// machine, operating system, kernel, compiler, flags, build type, modified sources, timing mode, threads and
/// library versions in which the sessions of two runs differ; and for an experiment of another identity.
std::vector<std::string> circumstance_differences(const Provenance& base, const Provenance& fresh);

}  // namespace raygauge
