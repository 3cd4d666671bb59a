// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/console/rank_job.h"

#include <exception>
#include <string>

#include "engine/threads/thread_pin.h"
#include "raygauge/exceptions.h"

namespace raygauge::cli {

void all_or_none(Ranks& ranks, const std::function<void()>& work) {
  std::string failure;
  try {
    work();
  } catch (const std::exception& error) {
    failure = error.what();
    if (failure.empty()) failure = "an unknown error";
  }
  const std::vector<std::string> failures = ranks.gather(failure);
  for (std::size_t i = 0; i < failures.size(); ++i) {
    if (failures[i].empty()) continue;
    ranks.broadcast("failed");
    throw Error(i == 0 ? failures[i] : "rank " + std::to_string(i) + ": " + failures[i]);
  }
  if (!ranks.broadcast("").empty()) throw JobFailed();
}

RankMachines gather_machines(Ranks& ranks) {
  const MachineInfo machine = machine_info();
  RankMachines all;
  for (const std::string& text : ranks.gather(to_text(machine))) {
    all.machines.push_back(machine_from_text(text));
  }
  for (const std::string& text : ranks.gather(to_text(RankPlace{machine.hostname, allowed_cpus()}))) {
    all.places.push_back(place_from_text(text));
  }
  return all;
}

}  // namespace raygauge::cli
