// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <string>

#include "engine/kernels/kernel.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

bool machine_has(InstructionSet isa) noexcept {
#if defined(__x86_64__)
  switch (isa) {
    case InstructionSet::avx2:
      return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    case InstructionSet::avx512:
      return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
             __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
    default:
      return true;
  }
#else
  return isa == InstructionSet::baseline || isa == InstructionSet::automatic;
#endif
}

const Kernels& kernels_of([[maybe_unused]] InstructionSet isa) noexcept {
#if defined(__x86_64__)
  if (isa == InstructionSet::avx512) return avx512::kKernels;
  if (isa == InstructionSet::avx2) return avx2::kKernels;
#endif
  return baseline::kKernels;
}

}  // namespace

InstructionSet best_instruction_set() noexcept {
  if (machine_has(InstructionSet::avx512)) return InstructionSet::avx512;
  if (machine_has(InstructionSet::avx2)) return InstructionSet::avx2;
  return InstructionSet::baseline;
}

const Kernels& kernels_for(InstructionSet isa) {
  if (!machine_has(isa)) {
    throw InvalidParameterError("instruction_set: this machine lacks " + std::string(to_string(isa)));
  }
  return kernels_of(isa == InstructionSet::automatic ? best_instruction_set() : isa);
}

const Kernels& best_kernels() noexcept {
  static const Kernels& best = kernels_of(best_instruction_set());
  return best;
}

}  // namespace raygauge
