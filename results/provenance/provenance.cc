// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/provenance/provenance.h"

#include <H5Cpp.h>

#include <Eigen/Core>
#include <chrono>
#include <ctime>

#include "results/build_info.h"
#include "results/git_revision.h"

namespace raygauge {
namespace {

std::string dotted(unsigned a, unsigned b, unsigned c) {
  return std::to_string(a) + "." + std::to_string(b) + "." + std::to_string(c);
}

std::string hdf5_version() {
  unsigned major = 0, minor = 0, release = 0;
  H5get_libversion(&major, &minor, &release);
  return dotted(major, minor, release);
}

}  // namespace

BuildInfo build_info() {
  return {.raygauge_version = RAYGAUGE_VERSION_TEXT,
          .git_commit = RAYGAUGE_GIT_COMMIT,
          .git_dirty = RAYGAUGE_GIT_DIRTY,
          .compiler = RAYGAUGE_COMPILER,
          .compiler_flags = RAYGAUGE_COMPILER_FLAGS,
          .build_type = RAYGAUGE_BUILD_TYPE};
}

std::vector<ComponentVersion> library_versions() {
  return {{"Eigen", dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"HDF5", hdf5_version()},
          {"OpenMP", RAYGAUGE_OPENMP_DATE}};
}

Session describe_session(const Experiment& experiment, int threads,
                         const std::vector<ComponentVersion>& solvers) {
  Session session;
  session.build = build_info();
  session.machine = machine_info();
  session.threads = threads;
  session.timing = experiment.timing == TimingMode::serial ? "serial" : "parallel";
  session.started_at = utc_now();
  session.versions = library_versions();
  session.versions.insert(session.versions.end(), solvers.begin(), solvers.end());
  return session;
}

std::string utc_now() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[sizeof "2026-01-31T12:00:00Z"];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

}  // namespace raygauge
