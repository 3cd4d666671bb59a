// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/threads/thread_pin.h"

#ifdef __linux__
#include <sched.h>
#endif

#include <algorithm>
#include <fstream>
#include <map>
#include <string>
#include <utility>

namespace raygauge {

#ifdef __linux__

namespace {

/// The first CPU of the core that `cpu` belongs to; `cpu` itself where the topology is not published.
int first_cpu_of_core(int cpu) {
  std::ifstream list("/sys/devices/system/cpu/cpu" + std::to_string(cpu) + "/topology/thread_siblings_list");
  int first = cpu;
  if (!(list >> first)) return cpu;
  return first;
}

}  // namespace

struct ThreadPin::Affinity {
  cpu_set_t cpus;
};

std::vector<int> allowed_cpus() {
  cpu_set_t mask;
  CPU_ZERO(&mask);
  if (sched_getaffinity(0, sizeof mask, &mask) != 0) return {};
  std::map<int, int> used_of_core;
  std::vector<std::pair<int, int>> rank_and_cpu;
  for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu) {
    if (CPU_ISSET(cpu, &mask)) rank_and_cpu.emplace_back(used_of_core[first_cpu_of_core(cpu)]++, cpu);
  }
  std::sort(rank_and_cpu.begin(), rank_and_cpu.end());
  std::vector<int> cpus;
  cpus.reserve(rank_and_cpu.size());
  for (const auto& entry : rank_and_cpu) cpus.push_back(entry.second);
  return cpus;
}

std::vector<int> allowed_cpus_from_here() {
  std::vector<int> cpus = allowed_cpus();
  const auto here = std::find(cpus.begin(), cpus.end(), sched_getcpu());
  if (here != cpus.end()) std::rotate(cpus.begin(), here, cpus.end());
  return cpus;
}

ThreadPin::ThreadPin(int cpu) {
  auto previous = std::make_unique<Affinity>();
  if (sched_getaffinity(0, sizeof previous->cpus, &previous->cpus) != 0) return;
  cpu_set_t mask;
  CPU_ZERO(&mask);
  CPU_SET(cpu, &mask);
  if (sched_setaffinity(0, sizeof mask, &mask) == 0) previous_ = std::move(previous);
}

ThreadPin::~ThreadPin() {
  if (previous_ != nullptr) sched_setaffinity(0, sizeof previous_->cpus, &previous_->cpus);
}

#else

struct ThreadPin::Affinity {};
std::vector<int> allowed_cpus() { return {}; }
std::vector<int> allowed_cpus_from_here() { return {}; }
ThreadPin::ThreadPin(int) {}
ThreadPin::~ThreadPin() = default;

#endif

}  // namespace raygauge
