// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <zlib.h>

#include "tests/cli/program_fixture.h"

namespace raygauge::testing::test_distance_errors {
namespace {

class DistanceErrors : public DistanceProgram {};

TEST_F(DistanceErrors, AMissingFileIsNamed) {
  write("Q.csv", kSquare);
  expect_complaint(run_raygauge({"distance", "A.csv", "Q.csv"}),
                   "raygauge: A.csv: No such file or directory");
}

TEST_F(DistanceErrors, AFolderIsNotAFile) {
  write("Q.csv", kSquare);
  expect_complaint(run_raygauge({"distance", ".", "Q.csv"}), "raygauge: .: Is a directory");
}

TEST_F(DistanceErrors, ACompressedInputHasALimit) {
  write("Q.csv", kSquare);
  write("plain.csv", "3 0\n" + std::string(1100000, '\n'));
  const std::string name = folder_.file("A.csv.gz");
  const gzFile file = gzopen(name.c_str(), "wb");
  const std::string bytes = "3 0\n" + std::string(1100000, '\n');
  gzwrite(file, bytes.data(), static_cast<unsigned>(bytes.size()));
  gzclose(file);
  EXPECT_EQ(run_raygauge({"distance", "A.csv.gz", "Q.csv"}).status, 0);
  expect_complaint(run_raygauge({"distance", "A.csv.gz", "Q.csv", "--max-input", "1"}),
                   "raygauge: A.csv.gz: compressed data of more than 1 MiB; --max-input sets another limit");
  EXPECT_EQ(run_raygauge({"distance", "plain.csv", "Q.csv", "--max-input", "1"}).status, 0);
  expect_complaint(run_raygauge({"distance", "A.csv.gz", "Q.csv", "--max-input", "0"}),
                   "raygauge: --max-input takes a number of MiB, as in 4096; got '0'");
}

TEST_F(DistanceErrors, RaggedRowsAreNamed) {
  expect_complaint(run("1 2 3\n1 2 3\n1 2\n", kSquare),
                   "raygauge: A.csv: line 3 has 2 coordinates, line 1 has 3");
}

TEST_F(DistanceErrors, NanAndInfinityAreNamedWithFileAndLine) {
  expect_complaint(run("1 2\nnan 2\n", kSquare), "raygauge: A.csv:2:1: 'nan' is not a finite number");
  expect_complaint(run("1 2\n", "1 1\n\n1 inf\n"), "raygauge: Q.csv:3:3: 'inf' is not a finite number");
  expect_complaint(run("1 1e999\n", kSquare),
                   "raygauge: A.csv:1:3: '1e999' is too large for double precision");
}

TEST_F(DistanceErrors, AnEmptySetIsNamed) {
  expect_complaint(run("# nothing\n", kSquare),
                   "raygauge: A.csv: no points (the file is empty, or holds comments only)");
}

TEST_F(DistanceErrors, SetsOfDifferentDimensionAreBothNamed) {
  expect_complaint(run("1 2 3\n", kSquare),
                   "raygauge: A and Q must have the same dimension: A.csv has n = 3, Q.csv has n = 2");
}

TEST_F(DistanceErrors, AnUnknownMethodIsAnsweredWithTheKnownOnes) {
  const ProgramResult outcome = run("3 0\n", kSquare, {"--method", "nweton"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err.rfind("raygauge: unknown method 'nweton'; did you mean 'newton'? (known: ", 0), 0U)
      << outcome.err;
}

TEST_F(DistanceErrors, UnknownChoicesAreAnsweredWithTheKnownOnes) {
  expect_complaint(
      run("3 0\n", kSquare, {"--stop-rule", "publishd_sigma"}),
      "raygauge: unknown stop rule 'publishd_sigma'; did you mean 'published_sigma'? (known: certified_gap "
      "published_sigma)");
  const ProgramResult outcome = run("3 0\n", kSquare, {"--instruction-set", "avx1"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("did you mean 'avx2'?"), std::string::npos) << outcome.err;
}

TEST_F(DistanceErrors, OptionsOutsideTheirRangeAreNamed) {
  for (const char* tolerance : {"0", "1", "-1e-3", "nan", "2"}) {
    const ProgramResult outcome = run("3 0\n", kSquare, {"--tolerance", tolerance});
    expect_complaint(outcome, std::string("raygauge: --tolerance must lie in (0, 1), got ") +
                                  (std::string(tolerance) == "-1e-3" ? "-1e-3" : tolerance));
  }
  expect_complaint(run("3 0\n", kSquare, {"--time-limit", "-1"}),
                   "raygauge: --time-limit must not be negative, got -1");
  expect_complaint(run("3 0\n", kSquare, {"--max-iterations", "-1"}),
                   "raygauge: --max-iterations must not be negative, got -1");
  expect_complaint(run("3 0\n", kSquare, {"--threads", "0"}),
                   "raygauge: --threads must lie in 1 … 64, got 0");
}

#ifdef RAYGAUGE_HAS_GLPK
TEST_F(DistanceErrors, OptionsThatAMethodDoesNotHaveAreRefused) {
  expect_complaint(
      run("3 0\n", kSquare, {"--method", "glpk", "--witness"}),
      "raygauge: method 'glpk_dual' computes no contact point: --witness needs column_generation, "
      "zheng_yamane or newton");
  expect_complaint(run("3 0\n", kSquare, {"--method", "glpk", "--max-iterations", "5"}),
                   "raygauge: --max-iterations, --stop-rule, --instruction-set and --threads are for "
                   "column_generation, zheng_yamane and newton; "
                   "method 'glpk_dual' has no such options");
}
#endif

TEST_F(DistanceErrors, BothSetsCannotComeFromStandardInput) {
  expect_complaint(run_raygauge({"distance", "-", "-"}, kSquare),
                   "raygauge: only one of A and Q can come from standard input");
}

TEST_F(DistanceErrors, AnHdf5FileNeedsADataset) {
  write("Q.csv", kSquare);
  expect_complaint(run_raygauge({"distance", "A.h5", "Q.csv"}),
                   "raygauge: A.h5: name the dataset, as in A.h5:/points");
  const ProgramResult outcome = run_raygauge({"distance", "A.h5:/points", "Q.csv"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err.rfind("raygauge: A.h5", 0), 0U) << outcome.err;
}

}  // namespace
}  // namespace raygauge::testing::test_distance_errors
