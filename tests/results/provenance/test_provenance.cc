// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/provenance/provenance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "tests/results/support.h"

namespace raygauge::test_provenance {
namespace {

TEST(Provenance, TheBuildIsKnown) {
  const BuildInfo build = build_info();
  EXPECT_TRUE(std::regex_match(build.raygauge_version, std::regex(R"(\d+\.\d+\.\d+)")))
      << build.raygauge_version;
  EXPECT_TRUE(std::regex_match(build.git_commit, std::regex("[0-9a-f]{40}|unknown"))) << build.git_commit;
  EXPECT_TRUE(std::regex_match(build.compiler, std::regex(R"(\w+ [\d.]+)"))) << build.compiler;
  EXPECT_FALSE(build.build_type.empty());
}

TEST(Provenance, TheMachineIsKnown) {
  const MachineInfo machine = machine_info();
  EXPECT_FALSE(machine.cpu_model.empty());
  EXPECT_GE(machine.cores, 1);
  EXPECT_GT(machine.memory_bytes, std::int64_t{1} << 26);
  EXPECT_FALSE(machine.operating_system.empty());
  EXPECT_EQ(machine.kernel.rfind("Linux ", 0), 0U) << machine.kernel;
}

TEST(Provenance, TheVersionsOfTheLibrariesPrecedeThoseOfTheSolvers) {
  const Session session = describe_session(Experiment(), 2, {{"GLPK", "5.0"}});
  std::vector<std::string> names;
  for (const ComponentVersion& entry : session.versions) {
    names.push_back(entry.name);
    EXPECT_FALSE(entry.version.empty()) << entry.name;
  }
  EXPECT_EQ(names, (std::vector<std::string>{"Eigen", "HDF5", "OpenMP", "GLPK"}));
}

TEST(Provenance, ASessionTellsThreadsTimingAndStart) {
  Experiment experiment;
  experiment.timing = TimingMode::serial;
  const Session session = describe_session(experiment, 3, {});
  EXPECT_EQ(session.threads, 3);
  EXPECT_EQ(session.timing, "serial");
  EXPECT_TRUE(std::regex_match(session.started_at, std::regex(R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ)")))
      << session.started_at;
  EXPECT_EQ(session.finished_at, "");
}

}  // namespace
}  // namespace raygauge::test_provenance
