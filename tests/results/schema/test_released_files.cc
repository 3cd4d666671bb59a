// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Files that released versions wrote, which every later version reads: of 0.2 a sweep, what `kill -9` left of
// a sweep, and a scene. The experiments are in the files.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "results/merge/merge_parts.h"
#include "results/run/encoding.h"
#include "results/run/results_file.h"
#include "scene/file/scene_file.h"
#include "tests/results/support.h"

namespace raygauge::test_released_files {
namespace {

const std::string kFolder = RAYGAUGE_SOURCE_DIR "/tests/results/files/";

using NameAndRole = std::pair<std::string, Role>;

std::map<std::string, NameAndRole> methods_of_file(const ResultsFile& file) {
  std::map<std::string, NameAndRole> methods;
  for (const Record& record : file.records)
    methods.emplace(record.method, NameAndRole{record.method_name, record.role});
  return methods;
}

TEST(ReleasedFiles, ASweepHasItsMethodsWithTheirRoles) {
  const ResultsFile file = read_results(kFolder + "sweep_0.2.h5");
  const std::map<std::string, NameAndRole> expected = {{"ours", {"column_generation", Role::engine}},
                                                       {"zheng_yamane", {"zheng_yamane", Role::engine}},
                                                       {"lp", {"glpk_dual", Role::baseline}},
                                                       {"exact", {"exact", Role::oracle}}};
  EXPECT_EQ(file.records.size(), 96U);
  EXPECT_TRUE(file.finished());
  EXPECT_TRUE(file.provenance.has_checksum);
  EXPECT_EQ(methods_of_file(file), expected);
}

TEST(ReleasedFiles, ASweepHasWhatItsGeneratorsPromised) {
  int unreachable = 0;
  int with_distance = 0;
  int with_hardness = 0;
  for (const Record& record : read_results(kFolder + "sweep_0.2.h5").records) {
    EXPECT_TRUE(record.agrees);
    EXPECT_LE(record.lower, record.upper);
    unreachable += record.status == DistanceStatus::unreachable ? 1 : 0;
    if (!std::isnan(record.exact_distance)) ++with_distance;
    if (record.generator != "hard_needle") continue;
    EXPECT_EQ(record.hardness_label, "aspect");
    EXPECT_EQ(record.hardness, 1e4);
    ++with_hardness;
  }
  EXPECT_EQ(unreachable, 4);
  EXPECT_EQ(with_distance, 48);
  EXPECT_EQ(with_hardness, 48);
}

TEST(ReleasedFiles, ASweepHasItsSessionMachineAndCalibration) {
  const ResultsFile file = read_results(kFolder + "sweep_0.2.h5");
  ASSERT_EQ(file.provenance.sessions.size(), 1U);
  const Session& session = file.provenance.sessions.front();
  EXPECT_EQ(session.build.raygauge_version, "0.2.0");
  EXPECT_EQ(session.threads, 2);
  EXPECT_EQ(session.calibration.entries.size(), 4U);
  EXPECT_FALSE(session.machine.cpu_model.empty());
  EXPECT_FALSE(session.versions.empty());
  for (const Record& record : file.records) EXPECT_EQ(record.host, session.machine.hostname);
}

TEST(ReleasedFiles, ASweepIsWrittenAgainWithTheSameRecords) {
  const ResultsFile old = read_results(kFolder + "sweep_0.2.h5");
  const testing::TemporaryFolder folder;
  const std::string path = folder.file("again.h5");
  write_results(path, old);
  const ResultsFile again = read_results(path);
  EXPECT_EQ(testing::fingerprints(again.records), testing::fingerprints(old.records));
  EXPECT_EQ(again.provenance.identity, old.provenance.identity);
}

TEST(ReleasedFiles, ASweepIsMergedAsItIsRead) {
  const ResultsFile old = read_results(kFolder + "sweep_0.2.h5");
  const testing::TemporaryFolder folder;
  const std::string path = folder.file("merged.h5");
  EXPECT_EQ(merge_parts({kFolder + "sweep_0.2.h5"}, path, {}).records, old.records.size());
  EXPECT_EQ(testing::fingerprints(read_results(path).records), testing::fingerprints(old.records));
  EXPECT_TRUE(is_checked_of_this_version(path));
}

TEST(ReleasedFiles, AnUnfinishedRunIsReadFromItsJournal) {
  const ResultsFile run = read_results(kFolder + "killed_0.2.h5");
  const std::set<std::uint64_t> cells = run.cells();
  EXPECT_GT(cells.size(), 0U);
  EXPECT_EQ(run.records.size(), 2 * cells.size());
  EXPECT_FALSE(run.finished());
  const std::map<std::string, NameAndRole> expected = {
      {"column_generation", {"column_generation", Role::engine}}, {"lp", {"glpk_dual", Role::baseline}}};
  EXPECT_EQ(methods_of_file(run), expected);
  EXPECT_TRUE(std::isnan(run.records.front().hardness));
}

TEST(ReleasedFiles, ASceneHasItsAnswersAndIsWrittenAgain) {
  const SceneFile scene = read_scene_file(kFolder + "scene_0.2.h5");
  EXPECT_TRUE(scene.finished());
  EXPECT_TRUE(scene.has_checksum);
  ASSERT_EQ(scene.sessions.size(), 1U);
  EXPECT_GT(scene.sessions[0].machine.cores, 0);
  EXPECT_FALSE(scene.sessions[0].machine.cpu_model.empty());
  EXPECT_FALSE(scene.records.empty());
  const testing::TemporaryFolder folder;
  const std::string path = folder.file("again.h5");
  testing::write_bytes(path, encode_scene(scene));
  EXPECT_EQ(scene_csv(read_scene_file(path)), scene_csv(scene));
}

}  // namespace
}  // namespace raygauge::test_released_files
