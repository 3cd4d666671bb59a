// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// A results file opens without raygauge: in h5py, by the very lines of the documentation, and in h5dump.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>

#include "results/run/run_writer.h"
#include "results/schema/schema.h"
#include "tests/results/support.h"

namespace raygauge::test_other_readers {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace): the helpers of this room's tests

/// What a shell command prints on both streams. It must succeed.
std::string output_of(const std::string& command) {
  std::FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  std::string output;
  std::array<char, 4096> buffer{};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe)) {
    output.append(buffer.data(), count);
  }
  const int status = pclose(pipe);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << command << "\n" << output;
  return output;
}

/// The first Python example of docs/file-format.md.
std::string documented_python() {
  const std::string page = read_bytes(RAYGAUGE_SOURCE_DIR "/docs/file-format.md");
  const std::string fence = "```python\n";
  const std::size_t begin = page.find(fence) + fence.size();
  return page.substr(begin, page.find("```", begin) - begin);
}

class OtherReaders : public ::testing::Test {
 protected:
  void SetUp() override { write_results(path_, sample_results(experiment_)); }
  std::string python(const std::string& program) const {
    write_bytes(folder_.file("program.py"), program);
    return output_of("cd " + folder_.path() + " && " RAYGAUGE_PYTHON " program.py");
  }

  TemporaryFolder folder_;
  std::string path_ = folder_.file("example2.h5");
  Experiment experiment_ = small_experiment();
};

TEST_F(OtherReaders, TheDocumentedPythonPrintsTheMedianOfTheSolvedAndAgreeing) {
  // Of 4 cells × 3 repetitions, the first of each cell is optimal and agrees: seconds = (cell + 1/3) / 7.
  EXPECT_EQ(python(documented_python()), "column_generation: 0.261905 s, seed 18446744073709551615\n");
}

TEST_F(OtherReaders, H5pyFindsEveryColumnWithUnitAndDescription) {
  std::string expected;
  std::string program = "import h5py\nf = h5py.File('example2.h5')\n";
  for (const Column<Record>& column : record_columns()) {
    program += "d = f['/records/" + column.name +
               "']\nprint(d.name, len(d), d.attrs['unit'], d.attrs['description'], sep='|')\n";
    expected += "/records/" + column.name + "|24|" + column.unit + "|" + column.description + "\n";
  }
  EXPECT_EQ(python(program), expected);
}

TEST_F(OtherReaders, H5pyReadsTextsBooleansAndNumbersAsSuch) {
  EXPECT_EQ(
      python("import h5py\n"
             "r = h5py.File('example2.h5')['records']\n"
             "print(r['method'].asstr()[1], r['status'].asstr()[2], r['agrees'].dtype, r['agrees'][4])\n"
             "print(r['distance'][2], r['lower'][4], r['n'].dtype, r['seed'].dtype, r['seconds'].dtype)\n"),
      "GLPK, \"primal\" unreachable bool False\n"
      "inf nan int32 uint64 float64\n");
}

TEST_F(OtherReaders, H5pyReadsTheExperimentAndTheSessions) {
  EXPECT_EQ(python("import h5py\n"
                   "f = h5py.File('example2.h5')\n"
                   "p = f['provenance']\n"
                   "print(f.attrs['format'], f.attrs['schema_version'])\n"
                   "print(p['experiment'].asstr()[()], end='')\n"
                   "print(p.attrs['cell_count'], p['machines/cpu_model'].asstr()[p['sessions/machine'][0]])\n"
                   "print(dict(zip(p['versions/name'].asstr()[:], p['versions/version'].asstr()[:])))\n"
                   "print(p['calibration/slowdown'][:])\n"),
            "raygauge-results 3\n" + experiment_.text +
                "4 A processor\n"
                "{'Eigen': '3.4.0', 'GLPK': '5.0'}\n"
                "[1.1 1. ]\n");
}

TEST_F(OtherReaders, H5dumpShowsTheStructure) {
  const std::string structure = output_of(RAYGAUGE_H5DUMP " -H " + path_);
  for (const Column<Record>& column : record_columns()) {
    EXPECT_NE(structure.find("DATASET \"" + column.name + "\""), std::string::npos) << column.name;
  }
  EXPECT_NE(output_of(RAYGAUGE_H5DUMP " -d /records/status " + path_).find("\"unreachable\""),
            std::string::npos);
}

TEST_F(OtherReaders, PythonReadsThePartsOfAnUnfinishedRun) {
  RunWriter run(folder_.file("going.h5"), experiment_, RunMode::create, sample_session());
  run.store(cell_result(experiment_, 2));
  EXPECT_EQ(
      python(
          "import h5py\nprint(h5py.File('going.h5.parts/session-0000.h5')['provenance/sessions/cores'][:])\n"
          "import csv\n"
          "rows = csv.DictReader(line for line in open('going.h5.parts/cells-0000.csv') if line[0] != '#')\n"
          "print([row['N'] for row in rows])\n"),
      "[2]\n['102', '102', '102', '102', '102', '102']\n");
}

}  // namespace
}  // namespace raygauge::test_other_readers
