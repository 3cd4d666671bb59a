// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cluster/ranks.h"

#include <cstdlib>

#include "results/run/own_module.h"

namespace raygauge {
namespace {

/// Whether the environment is that of a rank: what Open MPI, MPICH and the PMI of Slurm set.
bool started_as_rank() {
  for (const char* size : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MPI_LOCALNRANKS"}) {
    const char* value = std::getenv(size);
    if (value != nullptr && std::atoi(value) > 1) return true;
  }
  const char* tasks = std::getenv("SLURM_STEP_NUM_TASKS");
  return std::getenv("PMIX_RANK") != nullptr && tasks != nullptr && std::atoi(tasks) > 1;
}

}  // namespace

std::unique_ptr<Ranks> ranks_of_this_job() {
  if (!started_as_rank()) return nullptr;
  const OwnModule mpi{"raygauge_mpi.so", true,  // Open MPI's own parts look for its symbols
                      "started as one of several MPI ranks, but this raygauge was built without MPI: install "
                      "libopenmpi-dev and build again, or use --shard"};
  using Create = Ranks* (*)();
  const auto create = reinterpret_cast<Create>(function_of(mpi, "raygauge_create_ranks"));
  return std::unique_ptr<Ranks>(create());
}

}  // namespace raygauge
