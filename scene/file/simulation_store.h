// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "scene/simulation/simulation_part.h"

namespace raygauge {

/// A part of a simulation on its way to the disk, and what it cost.
struct StoredSimulationPart {
  std::int32_t simulation = 0;  ///< its number among those of the scene
  double seconds = 0;           ///< wall time, of this part alone
  SimulationPart part;
};

/// The bytes of such a part, an HDF5 file of numbers in the order of their declaration, and their inverse.
/// Throws ResultsError for damaged files and for those of another scene.
std::string encode_part(const StoredSimulationPart& stored, const std::string& identity);
StoredSimulationPart decode_part(const std::filesystem::path& path, const std::string& identity);

/// The parts of the simulations of a scene whose results `target` are unfinished, simulation-000000.h5 and so
/// on in its folder of parts, in the order in which they were stored.
std::vector<std::filesystem::path> list_simulation_parts(const std::filesystem::path& target);

/// Parts of simulations in the folder of a run, which its SceneWriter has locked. A run that is killed loses
/// what it did since the last part; a part is stored each second, or less often where storing takes longer.
class SimulationStore {
 public:
  /// Throws ResultsError for parts that cannot be read, OtherExperimentError for those of another scene.
  SimulationStore(std::filesystem::path target, std::string identity);

  /// What earlier sessions have stored of a simulation, and the seconds that they took.
  std::vector<SimulationPart> parts_of(std::int32_t simulation) const;
  double seconds_of(std::int32_t simulation) const;

  bool due() const { return Clock::now() >= due_; }
  void store(std::int32_t simulation, const SimulationPart& part);

  /// Removes all parts.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  std::filesystem::path target_;
  std::string identity_;
  std::vector<StoredSimulationPart> before_;
  std::uint64_t next_ = 0;
  Clock::time_point last_ = Clock::now(), due_ = last_;
};

}  // namespace raygauge
