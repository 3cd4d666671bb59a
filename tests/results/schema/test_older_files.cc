// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Files that raygauge 1fb7acc wrote, of schema version 1: points_v1.h5 and smooth_v1.h5, by the experiments
// whose text is in them.
#include "results/schema/older_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include "results/merge/merge_parts.h"
#include "results/run/results_file.h"
#include "results/schema/encoding.h"
#include "results/schema/schema.h"
#include "scene/file/scene_file.h"
#include "tests/results/support.h"

namespace raygauge::test_older_files {
namespace {

const std::string kFolder = RAYGAUGE_SOURCE_DIR "/tests/results/files/";

using NameAndRole = std::pair<std::string, Role>;

std::map<std::string, NameAndRole> methods_of_file(const ResultsFile& file) {
  std::map<std::string, NameAndRole> methods;
  for (const Record& record : file.records)
    methods.emplace(record.method, NameAndRole{record.method_name, record.role});
  return methods;
}

TEST(OlderFiles, MethodsOfVersionOneAreKnownByTheExperimentNotByTheirLabels) {
  const std::map<std::string, NameAndRole> expected = {
      {"column_generation", {"column_generation", Role::engine}},
      {"zheng_yamane", {"zheng_yamane", Role::engine}},
      {"lp", {"glpk_dual", Role::baseline}},
      {"glpk_primal", {"glpk_primal", Role::baseline}},
      {"exact", {"exact", Role::oracle}}};
  const ResultsFile file = read_results(kFolder + "points_v1.h5");
  EXPECT_EQ(file.records.size(), 120U);
  EXPECT_TRUE(file.finished());
  EXPECT_EQ(methods_of_file(file), expected);
}

TEST(OlderFiles, ALabelThatTheExperimentGaveStays) {
  const auto methods = methods_of_file(read_results(kFolder + "smooth_v1.h5"));
  EXPECT_EQ(methods.at("ours"), NameAndRole("column_generation", Role::engine));
  EXPECT_EQ(methods.at("zheng_yamane_published"), NameAndRole("zheng_yamane", Role::engine));
  EXPECT_EQ(methods.at("nlopt_slsqp"), NameAndRole("nlopt_slsqp", Role::baseline));
}

TEST(OlderFiles, GeneratorsOfVersionOneHaveTheirRoundingAndTheirHardness) {
  int of_example1 = 0;
  int with_hardness = 0;
  for (const Record& record : read_results(kFolder + "smooth_v1.h5").records) {
    EXPECT_EQ(record.exact_distance_rounding, record.generator == "example1" ? 0x1p-45 : 0.0);
    of_example1 += record.generator == "example1" ? 1 : 0;
    if (record.generator != "hard_ellipsoid") continue;
    EXPECT_EQ(record.hardness_label, "aspect");
    EXPECT_EQ(record.hardness, 1e4);
    ++with_hardness;
  }
  EXPECT_EQ(of_example1, 96);
  EXPECT_EQ(with_hardness, 48);
}

TEST(OlderFiles, AFileOfVersionOneIsWrittenAgainInThisVersionWithTheSameRecords) {
  const ResultsFile old = read_results(kFolder + "points_v1.h5");
  testing::TemporaryFolder folder;
  const std::string path = folder.path() + "/again.h5";
  write_results(path, old);
  const ResultsFile again = read_results(path);
  ASSERT_EQ(again.records.size(), old.records.size());
  for (std::size_t i = 0; i < old.records.size(); ++i)
    EXPECT_EQ(testing::fingerprint(again.records[i]), testing::fingerprint(old.records[i]));
  EXPECT_EQ(again.provenance.identity, old.provenance.identity);
}

TEST(OlderFiles, AFileOfVersionOneIsMergedAsItIsRead) {
  const ResultsFile old = read_results(kFolder + "points_v1.h5");
  testing::TemporaryFolder folder;
  const std::string path = folder.path() + "/merged.h5";
  EXPECT_EQ(merge_parts({kFolder + "points_v1.h5"}, path, {}).records, old.records.size());
  const ResultsFile merged = read_results(path);
  ASSERT_EQ(merged.records.size(), old.records.size());
  for (std::size_t i = 0; i < old.records.size(); ++i)
    EXPECT_EQ(testing::fingerprint(merged.records[i]), testing::fingerprint(old.records[i]));
  EXPECT_TRUE(is_checked_of_this_version(path));
}

// killed_v1.h5.parts: what `kill -9` left of a run of version 1.
TEST(OlderFiles, AnUnfinishedRunOfVersionOneIsReadFromItsJournal) {
  const ResultsFile run = read_results(kFolder + "killed_v1.h5");
  EXPECT_EQ(run.cells().size(), 17U);
  EXPECT_EQ(run.records.size(), 34U);
  EXPECT_FALSE(run.finished());
  EXPECT_NE(run.provenance.identity.find("methods = [column_generation, glpk_dual as lp]"),
            std::string::npos);
  const std::map<std::string, NameAndRole> expected = {
      {"column_generation", {"column_generation", Role::engine}}, {"lp", {"glpk_dual", Role::baseline}}};
  EXPECT_EQ(methods_of_file(run), expected);
  EXPECT_TRUE(std::isnan(run.records.front().hardness));
}

// cluster_v2.h5: of version 2, by three MPI ranks; killed_v2.h5.parts: what `kill -9` left of such a run.
TEST(OlderFiles, RecordsOfVersionTwoHaveTheHostOfTheirSession) {
  for (const char* name : {"cluster_v2.h5", "killed_v2.h5", "points_v1.h5"}) {
    const ResultsFile file = read_results(kFolder + name);
    ASSERT_FALSE(file.records.empty());
    for (const Record& record : file.records) {
      const Session& session = file.provenance.sessions.at(static_cast<std::size_t>(record.session));
      EXPECT_FALSE(record.host.empty());
      EXPECT_EQ(record.host, session.machine.hostname);
      EXPECT_EQ(record.rank, 0);
      EXPECT_EQ(session.machine_row, 0);
      EXPECT_GT(session.machine.cores, 0);
      EXPECT_FALSE(session.machine.cpu_model.empty());
    }
  }
}

TEST(OlderFiles, AFileOfVersionTwoIsWrittenAgainWithEachMachineOnce) {
  const ResultsFile old = read_results(kFolder + "cluster_v2.h5");
  testing::TemporaryFolder folder;
  const std::string path = folder.path() + "/again.h5";
  write_results(path, old);
  const ResultsFile again = read_results(path);
  EXPECT_EQ(testing::fingerprints(again.records), testing::fingerprints(old.records));
  ASSERT_EQ(again.provenance.sessions.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const Session& session = again.provenance.sessions[i];
    EXPECT_EQ(session.machine_row, 0);
    EXPECT_EQ(session.machine.memory_bytes, old.provenance.sessions[i].machine.memory_bytes);
    EXPECT_EQ(session.machine.cores, old.provenance.sessions[i].machine.cores);
  }
}

TEST(OlderFiles, ASceneOfVersionOneHasTheMachinesOfItsSessions) {
  const SceneFile scene = read_scene_file(kFolder + "scene_of_version_1.h5");
  EXPECT_TRUE(scene.finished());
  ASSERT_EQ(scene.sessions.size(), 1U);
  EXPECT_EQ(scene.sessions[0].machine.cpu_model, "AMD EPYC");
  EXPECT_EQ(scene.sessions[0].machine.cores, 2);
  testing::TemporaryFolder folder;
  const std::string path = folder.path() + "/again.h5";
  testing::write_bytes(path, encode_scene(scene));
  EXPECT_EQ(scene_csv(read_scene_file(path)), scene_csv(scene));
  EXPECT_EQ(read_scene_file(path).sessions[0].machine.cpu_model, "AMD EPYC");
}

TEST(OlderFiles, WithoutAnIdentityTheLabelTellsTheMethod) {
  std::vector<Record> records(4);
  records[0].method = "direct";
  records[1].method = "glpk_dual_presolved";
  records[2].method = "exact";
  records[3].method = "mine";
  complete_older_records(records, "");
  EXPECT_EQ(records[0].method, "column_generation");
  EXPECT_EQ(records[1].method_name, "glpk_dual");
  EXPECT_EQ(records[1].role, Role::baseline);
  EXPECT_EQ(records[2].role, Role::oracle);
  EXPECT_EQ(records[3].method_name, "mine");
  EXPECT_EQ(records[3].role, Role::engine);
}

TEST(OlderFiles, NumbersAmongParametersAreWrittenAsToday) {
  std::vector<Record> records(3);
  for (Record& record : records) record.method_name = "newton";
  records[0].generator_parameters = records[1].generator_parameters = "delta=1e-08 k=0.001";
  records[2].generator_parameters = "delta=1e-8 k=1e-3";
  records[1].method_parameters = "size=1e+05";
  complete_older_records(records, "");
  for (const Record& record : records) EXPECT_EQ(record.generator_parameters, "delta=1e-8 k=1e-3");
  EXPECT_EQ(records[1].method_parameters, "size=100000");
}

// The tolerance of points_v1.h5 is stored as 1e-06.
TEST(OlderFiles, TheIdentityOfARunHasTodaysNumbersSoThatItCanBeResumed) {
  const std::string identity = read_results(kFolder + "points_v1.h5").provenance.identity;
  EXPECT_NE(identity.find("1e-6"), std::string::npos) << identity;
  EXPECT_EQ(identity.find("e-0"), std::string::npos) << identity;
}

TEST(OlderFiles, TheIdentityOfARunHasTodaysNamesSoThatItCanBeResumed) {
  EXPECT_EQ(
      current_identity("n = [3]\nmethods = [direct, direct as b {x=1, y=2}, glpk_dual as direct]\n"),
      "n = [3]\nmethods = [column_generation, column_generation as b {x=1, y=2}, glpk_dual as direct]\n");
  EXPECT_EQ(current_identity("seed = 1\n"), "seed = 1\n");
}

}  // namespace
}  // namespace raygauge::test_older_files
