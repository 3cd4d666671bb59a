// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "cluster/ranks.h"
#include "engine/sweep/share.h"
#include "results/provenance/machine.h"

namespace raygauge {

/// The numbers of the pieces of a sweep, from the counters of all ranks.
class RankCounter final : public PieceCounter {
 public:
  explicit RankCounter(Ranks& ranks) : ranks_(ranks) {}
  std::uint64_t next() override;
  std::uint64_t finish() override;
  void abandon() override;

 private:
  Ranks& ranks_;
};

/// What one rank tells the others of its machine.
struct RankPlace {
  std::string host;
  std::vector<int> cpus;  ///< that it may use
};

/// What a rank is to do on its machine.
struct RankDuty {
  int threads = 1;
  int concurrency = 1;      ///< threads of all ranks on the machine
  std::vector<int> cpus;    ///< where it pins its threads; empty: nowhere
  bool calibrates = false;  ///< the first rank of its machine
};

/// Deals out the CPUs of each machine: ranks that may use the same ones get different ones, as long as there
/// are enough; each gets `threads` threads, or with 0 its even part of the CPUs.
std::vector<RankDuty> rank_duties(const std::vector<RankPlace>& places, int threads, bool pin);

/// All that ranks tell each other as text, to send; and the inverses.
std::string to_text(const RankPlace& place);
RankPlace place_from_text(const std::string& text);
std::string to_text(const std::vector<RankDuty>& duties);
std::vector<RankDuty> duties_from_text(const std::string& text);
std::string to_text(const DoneCells& done);
DoneCells done_from_text(const std::string& text);
std::string to_text(const MachineInfo& machine);
MachineInfo machine_from_text(const std::string& text);
std::string to_text(const Calibration& calibration);
Calibration calibration_from_text(const std::string& text);

}  // namespace raygauge
