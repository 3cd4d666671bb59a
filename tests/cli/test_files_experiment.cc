// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// The generator `files`: a sweep over files of the user's.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "engine/sweep/parameter_text.h"
#include "results/run/results_file.h"
#include "tests/cli/program_fixture.h"

namespace raygauge::test_files_experiment {
namespace {

using testing::kDiamond;
using testing::kSquare;
using testing::ProgramResult;

constexpr double kTolerance = 1e-6;  // of the solves, relative

/// A square with its lower left corner at (2, 1): twice and once the unit balls away.
constexpr const char* kFarSquare = "2 1\n3 1\n2 2\n3 2\n";

class FilesExperiment : public testing::ProgramTest {
 protected:
  void SetUp() override {
    std::filesystem::create_directory(folder_.file("data"));
    write("data/far.csv", kFarSquare);
    write("data/square.csv", kSquare);
    write("data/diamond.csv", kDiamond);
    write("data/ball.toml", "shape = \"ball\"\ncenter = [0, 0]\nradius = 1\n");
  }

  void write_experiment(const std::string& generator, const std::string& rest = "") const {
    write("own.toml", "name = \"own\"\n[sweep]\nrepetitions = 2\n[[generator]]\nname = \"files\"\n" +
                          generator + "\n[[method]]\nname = \"column_generation\"\n" + rest);
  }

  ProgramResult run(const std::vector<std::string>& options = {}) const {
    std::vector<std::string> arguments = {"run", "own.toml", "-o", "own.h5"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_raygauge(arguments);
  }

  /// The records of a run that must succeed.
  std::vector<Record> records() const {
    const ProgramResult result = run();
    EXPECT_EQ(result.status, 0) << result.err;
    return read_results(folder_.file("own.h5")).records;
  }

  /// Runs a statement of Python on `f`, the HDF5 file inst.h5 opened by h5py.
  void python(const std::string& statement) const {
    const std::string program =
        "import h5py; f = h5py.File('" + folder_.file("inst.h5") + "', 'a'); " + statement;
    ASSERT_EQ(std::system((RAYGAUGE_PYTHON " -c \"" + program + "\"").c_str()), 0);
  }

  /// The one line of a run that must be refused, and leaves nothing.
  std::string refusal() const {
    const ProgramResult result = run();
    EXPECT_EQ(result.status, 2) << result.out;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder_.file("own.h5")));
    return result.err;
  }
};

std::string parameter(const Record& record, const std::string& name) {
  for (const auto& [key, value] : split_parameters(record.generator_parameters)) {
    if (key == name) return value;
  }
  return "absent";
}

TEST_F(FilesExperiment, MeasuresEveryAWithEveryQ) {
  write_experiment("A = \"data/far.csv\"\nQ = [\"data/square.csv\", \"data/d*.csv\"]");
  const std::vector<Record> all = records();
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(parameter(all[0], "pair"), "far-square");
  EXPECT_EQ(parameter(all[2], "pair"), "far-diamond");
  EXPECT_EQ(all[0].n, 2);
  EXPECT_EQ(all[0].N, 4);
  EXPECT_NEAR(all[0].distance, 2, 1e-6);  // the nearest corner is (2, 1)
  EXPECT_NEAR(all[2].distance, 3, 1e-6);
  EXPECT_EQ(all[0].distance, all[1].distance);
}

TEST_F(FilesExperiment, MovesAndScalesTheSets) {
  write_experiment(
      "A = \"data/square.csv\"\nQ = \"data/square.csv\"\nscale_Q = [1, 2]\n"
      "pose_A = { translation = [9, 0] }");
  const std::vector<Record> all = records();
  ASSERT_EQ(all.size(), 4U);
  EXPECT_NEAR(all[0].distance, 8, 1e-6);
  EXPECT_NEAR(all[2].distance, 4, 1e-6);
  EXPECT_EQ(parameter(all[2], "scale_Q"), "2");
  EXPECT_EQ(parameter(all[2], "pose_A"), "{translation=[9,0]}");
}

TEST_F(FilesExperiment, MovesTheCentreBeforeItTurns) {
  // The far square about its centre has the half width 1/2; turned by 45 degrees its corner is at √2/2.
  write_experiment(
      "A = \"data/far.csv\"\nQ = \"data/square.csv\"\ncenter_A = true\n"
      "pose_A = { translation = [5, 0], angle = 0.7853981633974483 }");
  EXPECT_NEAR(records()[0].distance, 5 - 0.7071067811865476, 1e-6);
}

TEST_F(FilesExperiment, TakesEveryOrderedPairOfAList) {
  write_experiment("files = \"data/*.csv\"\npose_A = { translation = [9, 0] }");
  const std::vector<Record> all = records();
  ASSERT_EQ(all.size(), 12U);
  std::vector<std::string> pairs;
  for (std::size_t i = 0; i < all.size(); i += 2) pairs.push_back(parameter(all[i], "pair"));
  EXPECT_EQ(pairs, (std::vector<std::string>{"diamond-far", "diamond-square", "far-diamond", "far-square",
                                             "square-diamond", "square-far"}));
}

TEST_F(FilesExperiment, TakesThePairsOfACsvFile) {
  write("data/pairs.csv",
        "# from last week\npair, A, Q, scale_Q, pose_A\n"
        "near, far.csv, ball.toml, , \n"
        "\"far, turned\", far.csv, square.csv, 0.5, \"{ translation = [0, 0], angle = 1.5707963267948966 "
        "}\"\n");
  write_experiment("pairs = \"data/pairs.csv\"");
  const std::vector<Record> all = records();
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(parameter(all[0], "pair"), "near");
  EXPECT_NEAR(all[0].distance, std::sqrt(5.0), kTolerance * std::sqrt(5.0));
  EXPECT_EQ(parameter(all[2], "pair"), "far, turned");
  EXPECT_NEAR(all[2].distance, 4, 1e-6);  // (-1, 2) … against the square of half width 1/2
}

TEST_F(FilesExperiment, NamesOfFilesMayHoldBlanksAndBrackets) {
  write("data/my [best] set.csv", kFarSquare);
  write_experiment("A = \"data/my [best] set.csv\"\nQ = \"data/square.csv\"");
  const std::vector<Record> all = records();
  EXPECT_EQ(parameter(all[0], "A"), "data/my [best] set.csv");
  const ProgramResult table = run_raygauge(
      {"table", "own.h5", "--rows", "pair", "--where", "A=='data/my [best] set.csv'", "--value", "count"});
  EXPECT_EQ(table.status, 0) << table.err;
  EXPECT_NE(table.out.find("my [best] set-square"), std::string::npos) << table.out;
}

TEST_F(FilesExperiment, ParametersAreColumnsOfTablesFiltersAndTidyCsv) {
  write_experiment("A = \"data/far.csv\"\nQ = \"data/square.csv\"\nscale_A = [1, 2]");
  ASSERT_EQ(run().status, 0);
  const ProgramResult table =
      run_raygauge({"table", "own.h5", "--rows", "scale_A", "--value", "max distance", "--format", "csv"});
  EXPECT_EQ(table.out, "scale_A,max distance\n1,2\n2,4\n") << table.err;
  const ProgramResult one = run_raygauge(
      {"table", "own.h5", "--rows", "n", "--value", "count", "--where", "scale_A == 2", "--format", "csv"});
  EXPECT_EQ(one.out, "n,count\n2,2\n") << one.err;
  const ProgramResult wrong = run_raygauge({"table", "own.h5", "--rows", "n", "--where", "scale_B == 2"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_NE(wrong.err.find("unknown column 'scale_B'; did you mean 'scale_A'?"), std::string::npos)
      << wrong.err;
  const ProgramResult tidy = run_raygauge({"export", "own.h5", "--csv", "-", "--tidy"});
  const std::string heading = tidy.out.substr(0, tidy.out.find('\n'));
  EXPECT_NE(heading.find(",pair,"), std::string::npos) << heading;
  EXPECT_NE(tidy.out.find(",far-square,"), std::string::npos);
}

TEST_F(FilesExperiment, CarriesColumnsOfItsOwnAndTheKnownDistance) {
  write("data/pairs.csv",
        "pair,A,Q,family,difficulty,exact_distance,exact_distance_rounding\n"
        "near,far.csv,ball.toml,round,1.50,2.236,1e-4\n"
        "far,far.csv,square.csv,\"flat, old\",2,2,\n"
        "wrong,far.csv,diamond.csv,flat,3,2.9,\n");
  write_experiment("pairs = \"data/pairs.csv\"");
  const std::vector<Record> all = records();
  ASSERT_EQ(all.size(), 6U);
  EXPECT_EQ(parameter(all[0], "difficulty"), "1.50");
  EXPECT_EQ(parameter(all[2], "family"), "flat, old");
  EXPECT_EQ(all[0].exact_distance, 2.236);
  EXPECT_EQ(all[0].exact_distance_rounding, 1e-4);
  EXPECT_TRUE(all[0].agrees);
  EXPECT_TRUE(all[2].agrees);
  EXPECT_FALSE(all[4].agrees) << "the distance is 3";
  const ProgramResult table =
      run_raygauge({"table", "own.h5", "--rows", "difficulty", "--value", "count", "--format", "csv"});
  EXPECT_EQ(table.out, "difficulty,count\n1.5,2\n2,2\n3,2\n") << table.err;
}

TEST_F(FilesExperiment, MatchesTheDatasetsOfAFile) {
  python(
      "f['0001/A'] = [[2., 1], [3, 1]]; f['0002/A'] = [[4., 1], [5, 1]]; f['0001/Q'] = f['0002/Q'] = "
      "[[1., 1], [1, -1], [-1, 1], [-1, -1]]; f['0001/name'] = 'first'; f['0002/weights'] = [1., 2]");
  write_experiment("A = \"inst.h5:/*/A\"\nQ = \"data/square.csv\"");
  std::vector<Record> all = records();
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(parameter(all[2], "A"), "inst.h5:/0002/A");
  EXPECT_NEAR(all[2].distance, 4, 1e-6);
  std::filesystem::remove(folder_.file("own.h5"));
  write_experiment("A = \"inst.h5:/*/A\"\nQ = \"inst.h5:/*/Q\"\npaired = true");
  all = records();
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(parameter(all[0], "pair"), "0001");
  EXPECT_EQ(parameter(all[2], "Q"), "inst.h5:/0002/Q");
  std::filesystem::remove(folder_.file("own.h5"));
  python("f['0003/A'] = [[4., 1], [5, 1]]");
  EXPECT_NE(refusal().find("own.toml:7: no Q for 'inst.h5:/0003/A'"), std::string::npos);
  write_experiment("A = \"inst.h5:/*/B\"\nQ = \"data/square.csv\"");
  EXPECT_NE(refusal().find("own.toml:6: inst.h5: no dataset of points matches '/*/B'"), std::string::npos);
}

TEST_F(FilesExperiment, RefusesToResumeWithOtherContents) {
  write_experiment("files = \"data/*.csv\"\npose_A = { translation = [9, 0] }");
  ASSERT_EQ(run().status, 0);
  EXPECT_EQ(run({"--resume"}).status, 0);
  write("data/far.csv", "2 1\n3 1\n2 2\n3 2.5\n");
  const ProgramResult changed = run({"--resume"});
  EXPECT_EQ(changed.status, 2);
  EXPECT_EQ(std::count(changed.err.begin(), changed.err.end(), '\n'), 1) << changed.err;
  EXPECT_NE(changed.err.find("own.h5: holds another experiment: generators = files {A=data/diamond.csv "
                             "Q=data/far.csv content_A="),
            std::string::npos)
      << changed.err;
}

TEST_F(FilesExperiment, RefusesToResumeWithAnotherMeshInASetFile) {
  const std::string faces = "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  write("data/tetra.obj", "v 2 0 0\nv 3 0 0\nv 2 1 0\nv 2 0 1\n" + faces);
  write("data/tetra.toml", "shape = \"mesh\"\nfile = \"tetra.obj\"\nas = \"hull\"\n");
  write("data/ball3.toml", "shape = \"ball\"\ncenter = [0, 0, 0]\nradius = 1\n");
  write_experiment("A = \"data/tetra.toml\"\nQ = \"data/ball3.toml\"");
  ASSERT_EQ(run().status, 0);
  EXPECT_EQ(run({"--resume"}).status, 0);
  write("data/tetra.obj", "v 1.5 0 0\nv 3 0 0\nv 2 1 0\nv 2 0 1\n" + faces);
  const ProgramResult changed = run({"--resume"});
  EXPECT_EQ(changed.status, 2);
  EXPECT_NE(changed.err.find("own.h5: holds another experiment"), std::string::npos) << changed.err;
}

TEST_F(FilesExperiment, TellsPlaceAndCauseOfWhatItCannotTake) {
  struct Mistake {
    const char* generator;
    const char* message;
  };
  write("data/space.csv", "0 0 1\n1 0 0\n");
  write("data/empty.csv", "A,Q\n");
  write("data/short.csv", "A,Q\nfar.csv\n");
  write("data/open.csv", "A,Q\n\"far.csv,square.csv\n");
  write("data/wrong.csv", "A,R\nfar.csv,square.csv\n");
  write("data/scale.csv", "A,Q,scale_A\nfar.csv,square.csv,big\n");
  write("data/slip.csv", "A,Q,scale_B\nfar.csv,square.csv,1\n");
  write("data/case.csv", "A,Q,Pair\nfar.csv,square.csv,1\n");
  write("data/truth.csv", "A,Q,exact_distance\nfar.csv,square.csv,nan\n");
  const std::vector<Mistake> mistakes = {
      {"A = \"data/far.csv\"", "own.toml:4: generator 'files' needs A and Q, or files, or pairs"},
      {"A = \"gone.csv\"\nQ = \"data/far.csv\"", "own.toml:6: gone.csv: No such file or directory"},
      {"A = \"gone*.csv\"\nQ = \"data/far.csv\"", "own.toml:6: no file matches 'gone*.csv'"},
      {"A = \"-\"\nQ = \"data/far.csv\"", "own.toml:6: standard input cannot be a file of a sweep"},
      {"A = \"data/far.csv\"\nQ = \"data/space.csv\"",
       "own.toml:6: A, 'data/far.csv', is in 2 dimensions, Q, 'data/space.csv', in 3"},
      {"files = \"data/far.csv\"", "own.toml:6: a pair needs two files, there is one"},
      {"A = 3\nQ = 4", "own.toml:6: generator.A must be a string"},
      {"A = \"data/far.csv\"\nQ = \"data/square.csv\"\nn = 3",
       "own.toml:8: generator 'files' takes n from its files"},
      {"A = \"data/far.csv\"\nQ = \"data/square.csv\"\nscale_A = 0", "parameter 'scale_A' must lie in"},
      {"A = \"data/far.csv\"\nQ = \"data/square.csv\"\npose_A = [1]",
       "own.toml:8: generator.pose_A must be a table"},
      {"A = \"data/far.csv\"\nQ = \"data/square.csv\"\npose_A = {translation = [1]}",
       "pose.translation must have 2 numbers"},
      {"A = \"data/far.csv\"\nQ = \"data/square.csv\"\nscale = 2",
       "unknown key of generator 'files' 'scale'"},
      {"pairs = \"data/gone.csv\"", "own.toml:6: data/gone.csv: No such file or directory"},
      {"pairs = \"data/empty.csv\"", "data/empty.csv: no lines below one that names the columns"},
      {"pairs = \"data/short.csv\"", "data/short.csv:2: 1 cell where the first line names 2 columns"},
      {"pairs = \"data/open.csv\"", "data/open.csv:2: a quote that opens here is never closed"},
      {"pairs = \"data/wrong.csv\"", "data/wrong.csv: there is no column 'Q'"},
      {"pairs = \"data/slip.csv\"", "data/slip.csv: unknown column 'scale_B'; did you mean 'scale_A'?"},
      {"pairs = \"data/case.csv\"", "data/case.csv: unknown column 'Pair'; did you mean 'pair'?"},
      {"pairs = \"data/truth.csv\"", "data/truth.csv:2: exact_distance must be a distance"},
      {"files = \"data/*.csv\"\npaired = true", "own.toml:7: generator.paired is for A and Q"},
      {"A = \"data/far.csv\"\nQ = \"data/*.csv\"\npaired = true",
       "own.toml:6: generator.A must be a pattern where paired = true"},
      {"pairs = \"data/scale.csv\"", "data/scale.csv:2: scale_A must be a number, got 'big'"},
      {"pairs = \"data/far.csv\"", "data/far.csv: the column '2 1' needs a name of letters"},
      {"A = \"data/far.csv\"\nQ = [\"data/square.csv\", \"data/square.csv\"]",
       "the pair 'far-square' appears twice"},
      {"A = \"data/far.csv\"\nQ = \"data\"", "data: Is a directory"},
  };
  for (const Mistake& mistake : mistakes) {
    write_experiment(mistake.generator);
    const std::string message = refusal();
    EXPECT_NE(message.find(mistake.message), std::string::npos) << mistake.generator << "\n" << message;
  }
}

TEST_F(FilesExperiment, ADryRunTellsThePairs) {
  write_experiment("files = \"data/*.csv\"\npose_A = { translation = [9, 0] }");
  const ProgramResult result = run({"--dry-run"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("pair=diamond-far"), std::string::npos) << result.out;
  EXPECT_FALSE(std::filesystem::exists(folder_.file("own.h5")));
}

}  // namespace
}  // namespace raygauge::test_files_experiment
