// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/provenance/machine.h"

#include <sched.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <string_view>
#include <thread>

namespace raygauge {
namespace {

constexpr const char* kUnknown = "unknown";

/// What follows `key` and `separator` on the first such line of a system file, without quotes; "unknown" if
/// there is none.
std::string value_in(const char* path, std::string_view key, char separator) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    const std::size_t split = line.find(separator);
    if (split == std::string::npos || !line.starts_with(key)) continue;
    const std::size_t begin = line.find_first_not_of(" \t\"", split + 1);
    const std::size_t end = line.find_last_not_of(" \t\"");
    if (begin != std::string::npos) return line.substr(begin, end - begin + 1);
  }
  return kUnknown;
}

std::string first_line(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  return line;
}

/// "48K", "2048K", "1M" in bytes.
std::int64_t bytes_of(const std::string& size) {
  if (size.empty()) return 0;
  const std::int64_t number = std::atoll(size.c_str());
  switch (size.back()) {
    case 'K':
      return number << 10;
    case 'M':
      return number << 20;
    case 'G':
      return number << 30;
    default:
      return number;
  }
}

void read_caches(MachineInfo& machine) {
  const std::string folder = "/sys/devices/system/cpu/cpu0/cache/index";
  for (int i = 0;; ++i) {
    const std::string cache = folder + std::to_string(i) + "/";
    const std::string level = first_line(cache + "level");
    if (level.empty()) return;
    if (first_line(cache + "type") == "Instruction") continue;
    const std::int64_t bytes = bytes_of(first_line(cache + "size"));
    if (level == "1") machine.l1d_bytes = bytes;
    if (level == "2") machine.l2_bytes = bytes;
    if (level == "3") machine.l3_bytes = bytes;
  }
}

std::int32_t usable_cores() {
  cpu_set_t cpus;
  CPU_ZERO(&cpus);
  if (sched_getaffinity(0, sizeof cpus, &cpus) == 0) return CPU_COUNT(&cpus);
  return static_cast<std::int32_t>(std::thread::hardware_concurrency());
}

void read_system_names(MachineInfo& machine) {
  utsname names{};
  const bool known = uname(&names) == 0;
  machine.kernel = known ? std::string(names.sysname) + " " + names.release + " " + names.machine : kUnknown;
  machine.hostname = known ? names.nodename : kUnknown;
}

}  // namespace

MachineInfo machine_info() {
  MachineInfo machine;
  machine.cpu_model = value_in("/proc/cpuinfo", "model name", ':');
  machine.cores = usable_cores();
  read_caches(machine);
  machine.memory_bytes = static_cast<std::int64_t>(sysconf(_SC_PHYS_PAGES)) * sysconf(_SC_PAGESIZE);
  machine.operating_system = value_in("/etc/os-release", "PRETTY_NAME", '=');
  read_system_names(machine);
  return machine;
}

}  // namespace raygauge
