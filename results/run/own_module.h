// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace raygauge {

/// A part of the program in a file of its own, because of what its libraries bring along; it is loaded where
/// it is needed and stays. It stands beside the program (as built), or in ../lib/raygauge (as installed). No
/// other folder is searched.
struct OwnModule {
  std::string file;       ///< "raygauge_mpi.so"
  bool shares_its_names;  ///< whether libraries that it loads later may look up its symbols
  std::string without;    ///< what to say where the file is missing: "...: install ..., and build again"
};

/// The function of that name. Throws Error if the file is missing, cannot be loaded, or has no such function.
void* function_of(const OwnModule& module, const char* name);

}  // namespace raygauge
