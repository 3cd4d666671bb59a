// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "cluster/ranks.h"
#include "cluster/share.h"
#include "results/provenance/machine.h"

namespace raygauge::cli {

/// Thrown at all ranks but 0 when the job has failed: rank 0 tells why.
struct JobFailed {};

/// Runs `work` at every rank; if it fails at any, all of them leave: rank 0 by the first error.
void all_or_none(Ranks& ranks, const std::function<void()>& work);

/// Every rank's machine and CPUs; at rank 0, nothing elsewhere.
struct RankMachines {
  std::vector<MachineInfo> machines;
  std::vector<RankPlace> places;
};
RankMachines gather_machines(Ranks& ranks);

}  // namespace raygauge::cli
