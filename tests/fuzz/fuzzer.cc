// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// What libFuzzer calls: compiled once for each target, RAYGAUGE_FUZZ_CHECK being its check_TARGET.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/harness.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  raygauge::fuzz::RAYGAUGE_FUZZ_CHECK({reinterpret_cast<const char*>(data), size});
  return 0;
}
