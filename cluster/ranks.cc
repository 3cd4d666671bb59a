// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cluster/ranks.h"

#include <dlfcn.h>

#include <cstdlib>
#include <filesystem>

#include "raygauge/exceptions.h"

namespace raygauge {
namespace fs = std::filesystem;
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

/// Beside the program (as built), or in ../lib/raygauge (as installed). No other folder is searched.
fs::path module_path() {
  std::error_code error;
  const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (const fs::path& path :
       {folder / "raygauge_mpi.so", folder.parent_path() / "lib" / "raygauge" / "raygauge_mpi.so"}) {
    if (fs::exists(path, error)) return path;
  }
  throw Error("started as one of several MPI ranks, but this raygauge was built without MPI (" +
              (folder / "raygauge_mpi.so").string() +
              " is missing): install libopenmpi-dev and build again, or use --shard");
}

}  // namespace

std::unique_ptr<Ranks> ranks_of_this_job() {
  if (!started_as_rank()) return nullptr;
  const fs::path path = module_path();
  void* module = ::dlopen(path.c_str(), RTLD_NOW | RTLD_GLOBAL);  // Open MPI's own parts look for its symbols
  if (module == nullptr) throw Error(path.string() + ": cannot be loaded: " + ::dlerror());
  using Create = Ranks* (*)();
  const auto create = reinterpret_cast<Create>(::dlsym(module, "raygauge_create_ranks"));
  if (create == nullptr) throw Error(path.string() + ": not a part of raygauge");
  return std::unique_ptr<Ranks>(create());
}

}  // namespace raygauge
