// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <sys/resource.h>

namespace raygauge::fuzz {

/// Under a sanitizer a program takes some twenty times as long, and more memory than any limit of ours
/// leaves: there only time is limited.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif
inline constexpr int kSlower = kSanitized ? 20 : 1;

/// Of this process and those that it becomes: so many bytes of memory, and no core.
inline void limit_memory(rlim_t bytes) {
  const rlimit memory{bytes, bytes}, core{0, 0};
  if (!kSanitized) ::setrlimit(RLIMIT_DATA, &memory);
  ::setrlimit(RLIMIT_CORE, &core);
}

}  // namespace raygauge::fuzz
