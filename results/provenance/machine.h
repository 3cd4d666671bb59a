// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace raygauge {

/// The machine a session runs on. What the system does not tell is "unknown" or 0.
struct MachineInfo {
  std::string cpu_model;
  std::int32_t cores = 0;      ///< logical cores this process may use
  std::int64_t l1d_bytes = 0;  ///< data cache of one core
  std::int64_t l2_bytes = 0;   ///< unified caches as core 0 sees them
  std::int64_t l3_bytes = 0;
  std::int64_t memory_bytes = 0;
  std::string operating_system;  ///< "Debian GNU/Linux 12 (bookworm)"
  std::string kernel;            ///< "Linux 6.1.0 x86_64"
  std::string hostname;
};

/// The machine this program runs on.
MachineInfo machine_info();

}  // namespace raygauge
