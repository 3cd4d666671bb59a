// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

namespace raygauge {

/// Instruction set of the vector kernels.
enum class InstructionSet : std::uint8_t { automatic, baseline, avx2, avx512 };

std::string_view to_string(InstructionSet isa) noexcept;

}  // namespace raygauge
