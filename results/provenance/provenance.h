// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "raygauge/sweep.h"
#include "raygauge/sweep/experiment.h"
#include "results/provenance/machine.h"

namespace raygauge {

/// How the running program was built.
struct BuildInfo {
  std::string raygauge_version;
  std::string git_commit;  ///< "unknown" where the sources were no git checkout
  bool git_dirty = false;  ///< sources differed from the commit when they were compiled
  std::string compiler;    ///< "GNU 12.2.0"
  std::string compiler_flags;
  std::string build_type;
};

/// The build of this program.
BuildInfo build_info();

/// A library or solver and its version.
struct ComponentVersion {
  std::string name;
  std::string version;
};

/// Versions of the libraries that every raygauge has: Eigen, HDF5, OpenMP (the date of its specification).
std::vector<ComponentVersion> library_versions();

/// One uninterrupted stretch of a run: a run that was killed and resumed has several.
struct Session {
  BuildInfo build;
  MachineInfo machine;
  std::int32_t machine_row = -1;  ///< of the table of machines; set where sessions are written or read
  std::int32_t rank = 0;          ///< MPI rank of the process; 0 without MPI
  std::int32_t threads = 1;
  std::string timing;                      ///< "serial" or "parallel"
  std::string started_at;                  ///< ISO 8601, UTC: "2026-01-31T12:00:00Z"
  std::string finished_at;                 ///< "" for a session that was killed, or still runs
  std::vector<ComponentVersion> versions;  ///< libraries and solvers
  Calibration calibration;                 ///< empty where none was measured
};

/// A session that starts now on this machine. `solvers` are the versions of the baselines present; the
/// library versions are added.
Session describe_session(const Experiment& experiment, int threads,
                         const std::vector<ComponentVersion>& solvers);

/// Where the records of a run come from.
struct Provenance {
  std::string experiment_text;   ///< the TOML source
  std::string identity;          ///< experiment_identity() of the experiment
  std::uint64_t cell_count = 0;  ///< cells of the whole grid, whether done or not
  std::vector<Session> sessions;
  bool has_checksum = true;  ///< of the file that it was read from (results/hdf5/checksum.h)
};

/// What readers say of a file without one.
inline constexpr const char* kNoChecksum = "no checksum: changed by another program; damage may go unnoticed";

/// The current time in ISO 8601, UTC, to the second.
std::string utc_now();

}  // namespace raygauge
