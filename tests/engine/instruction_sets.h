// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "raygauge/methods/options.h"

namespace raygauge {

/// The instruction sets that this machine runs, the widest last; asked of the processor, not of the engine.
inline std::vector<InstructionSet> instruction_sets_here() {
  std::vector<InstructionSet> here = {InstructionSet::baseline};
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) here.push_back(InstructionSet::avx2);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl")) {
    here.push_back(InstructionSet::avx512);
  }
#endif
  return here;
}

}  // namespace raygauge
