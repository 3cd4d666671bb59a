// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Outputs never destroy: every command that writes, against everything that may already be where it writes.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <filesystem>
#include <ostream>
#include <string>
#include <thread>
#include <vector>

#include "results/run/results_file.h"
#include "tests/analysis/records.h"
#include "tests/cli/program_fixture.h"

namespace raygauge::test_outputs {
namespace {

namespace fs = std::filesystem;
using testing::expect_complaint;
using testing::ProgramResult;

constexpr const char* kForeign = "notes of somebody else\n";

/// A command that writes one file, whose name comes last.
struct Writer {
  const char* name;
  std::vector<std::string> arguments;
  const char* extension;  ///< of the files it writes
  const char* beginning;  ///< of what it writes; "" where any will do
  bool text = true;       ///< may go to standard output
  bool derived = true;    ///< not measurements
  bool chooses_by_extension = false;
  const char* input = "m.h5";
};

void PrintTo(const Writer& writer, std::ostream* out) { *out << writer.name; }

const std::vector<Writer> kWriters = {
    {"export", {"export", "m.h5", "--csv"}, ".csv", "cell,session,"},
    {"refutations",
     {"export", "b.h5", "--refutations"},
     ".jsonl",
     "{\"method\": \"fcl",
     true,
     true,
     false,
     "b.h5"},
    {"table_text", {"table", "m.h5", "--rows", "n", "-o"}, ".txt", "median"},
    {"table_markdown", {"table", "m.h5", "--rows", "n", "--format", "markdown", "-o"}, ".md", ""},
    {"table_latex", {"table", "m.h5", "--rows", "n", "--format", "latex", "-o"}, ".tex", ""},
    {"table_csv", {"table", "m.h5", "--rows", "n", "--format", "csv", "-o"}, ".csv", "method,n,"},
    {"report", {"report", "m.h5", "-o"}, ".html", "<!doctype html>"},
    {"plot_svg", {"plot", "m.h5", "--figure", "time_vs_N", "-o"}, ".svg", "<?xml", false, true, true},
    {"plot_png", {"plot", "m.h5", "--figure", "time_vs_N", "-o"}, ".png", "\x89PNG", false, true, true},
    {"plot_pdf", {"plot", "m.h5", "--figure", "time_vs_N", "-o"}, ".pdf", "%PDF", false, true, true},
    {"plot_eps", {"plot", "m.h5", "--figure", "time_vs_N", "-o"}, ".eps", "%!PS", false, true, true},
    {"plot_tikz", {"plot", "m.h5", "--figure", "time_vs_N", "-o"}, ".tikz", "\\begin", false, true, true},
    {"run", {"run", "e.toml", "-q", "-o"}, ".h5", "\x89HDF", false, false, false, "e.toml"},
};

class Outputs : public testing::ProgramTest, public ::testing::WithParamInterface<Writer> {
 protected:
  void SetUp() override {
    write_measurements("m.h5", 1);
    write_measurements("other.h5", 2);
    write_wrong_answer("b.h5");
    write("e.toml", testing::example2_experiment("name = \"e\"\n", "n = [2]\nN = [10]\nrepetitions = 1\n"));
  }

  /// Two balls that are a thousandth apart, and an answer of 1.
  void write_wrong_answer(const std::string& name) const {
    ResultsFile results;
    testing::add_records(results.records, "fcl_libccd", 3, 20, {1});
    Record& record = results.records.front();
    record.generator = "bodies";
    record.generator_parameters = "kind_1=ball kind_2=ball place=near scale=1";
    record.exact_distance = 1e-3;
    record.distance = 1;
    results.provenance.cell_count = 1;
    store(name, results);
  }

  void write_measurements(const std::string& name, double factor) const {
    ResultsFile results;
    for (const int N : {200, 400}) {
      testing::add_records(results.records, "column_generation", 3, N, {factor, 2, 3});
      testing::add_records(results.records, "glpk_dual", 3, N, {10, 20, 30});
    }
    for (std::size_t i = 0; i < results.records.size(); ++i) results.records[i].cell = i / 6;
    results.provenance.cell_count = 2;
    store(name, results);
  }

  void store(const std::string& name, ResultsFile& results) const {
    results.provenance.sessions = {testing::sample_session()};
    write_results(folder_.file(name), results);
  }

  std::vector<std::string> arguments(const std::string& output, bool force = false) const {
    std::vector<std::string> result = GetParam().arguments;
    result.push_back(output);
    if (force) result.emplace_back("--force");
    return result;
  }
  ProgramResult write_to(const std::string& output, bool force = false) const {
    return run_raygauge(arguments(output, force));
  }

  /// A name of the kind that the command writes.
  static std::string named(const std::string& stem) { return stem + GetParam().extension; }

  std::string read(const std::string& name) const { return testing::read_bytes(folder_.file(name)); }

  void expect_written(const ProgramResult& outcome, const std::string& name) const {
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(read(name).starts_with(GetParam().beginning)) << read(name).substr(0, 40);
    EXPECT_NE(read(name), kForeign);
  }

  /// Bad usage: one line that begins with the path; `name` is as it was and nothing is left beside it.
  void expect_refused(const std::string& output, const std::string& name, bool force) const {
    const std::string before = read(name);
    const std::vector<std::string> folder_before = names();
    const ProgramResult outcome = write_to(output, force);
    EXPECT_EQ(outcome.status, 2) << output;
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(outcome.err.starts_with("raygauge: " + output + ": ")) << outcome.err;
    EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
    EXPECT_TRUE(read(name) == before) << name << " was changed";
    EXPECT_EQ(names(), folder_before);
  }

  /// Everything in the folder but the streams of the program.
  std::vector<std::string> names() const {
    std::vector<std::string> result = testing::entries_of(folder_.path());
    std::erase_if(result, [](const std::string& name) { return name.starts_with(".program-"); });
    return result;
  }
};

INSTANTIATE_TEST_SUITE_P(OfEveryCommand, Outputs, ::testing::ValuesIn(kWriters),
                         [](const auto& parameters) { return std::string(parameters.param.name); });

TEST_P(Outputs, DoNotReplaceAnInput) {
  const std::string input = GetParam().input;
  fs::create_symlink(input, folder_.file(named("link")));
  fs::create_hard_link(folder_.file(input), folder_.file(named("hard")));
  for (const bool force : {false, true}) {
    if (!GetParam().chooses_by_extension) expect_refused(input, input, force);
    expect_refused(named("link"), input, force);
    expect_refused(named("./hard"), input, force);
  }
}

TEST_P(Outputs, DoNotReplaceOtherMeasurements) {
  if (!GetParam().derived) {
    expect_refused("other.h5", "other.h5", false);
    expect_written(write_to("other.h5", true), "other.h5");
    return;
  }
  fs::copy(folder_.file("other.h5"), folder_.file(named("disguised")));
  for (const bool force : {false, true}) {
    if (!GetParam().chooses_by_extension) expect_refused("other.h5", "other.h5", force);
    expect_refused(named("disguised"), "other.h5", force);
    expect_refused(named("disguised"), named("disguised"), force);
  }
}

TEST_P(Outputs, DoNotReplaceThePartsOfARun) {
  fs::create_directory(folder_.file("other.h5.parts"));
  for (const char* part : {"cells-0000.csv", "session-0000.h5"})
    write("other.h5.parts/" + std::string(part), "1");
  for (const bool force : {false, true}) {
    if (GetParam().chooses_by_extension) continue;  // no part has the name of a picture
    expect_refused("other.h5.parts/cells-0000.csv", "other.h5.parts/cells-0000.csv", force);
    expect_refused("other.h5.parts/session-0000.h5", "other.h5.parts/session-0000.h5", force);
  }
}

TEST_P(Outputs, ReplaceAnEarlierOneOfTheirKind) {
  expect_written(write_to(named("out")), named("out"));
  if (!GetParam().derived) return expect_refused(named("out"), named("out"), false);
  write(named("out"), kForeign);
  ASSERT_EQ(chmod(folder_.file(named("out")).c_str(), 0640), 0);
  expect_written(write_to(named("out")), named("out"));
  EXPECT_EQ(fs::status(folder_.file(named("out"))).permissions(), fs::perms(0640)) << "the mode is kept";
}

TEST_P(Outputs, ReplaceAFileOfAnotherKindUnderForceOnly) {
  if (GetParam().chooses_by_extension) return;  // a name of another kind is no name of a picture
  write("notes.text", kForeign);
  expect_refused("notes.text", "notes.text", false);
  if (!GetParam().derived) return expect_refused("notes.text", "notes.text", true);
  expect_written(write_to("notes.text", true), "notes.text");
}

TEST_P(Outputs, GoIntoADeviceThatStaysOne) {
  // A node of our own, where that is allowed: the machine's own null device is not to be risked.
  const std::string device = folder_.file(named("null"));
  if (mknod(device.c_str(), S_IFCHR | 0666, makedev(1, 3)) != 0) fs::create_symlink("/dev/null", device);
  const ProgramResult outcome = write_to(named("null"), true);
  EXPECT_EQ(outcome.status, GetParam().derived ? 0 : 2) << outcome.err;
  EXPECT_EQ(fs::status(device).type(), fs::file_type::character);
  EXPECT_FALSE(fs::exists(device + ".parts"));
}

TEST_P(Outputs, SayWhereADeviceIsFull) {
  if (!GetParam().derived) return;
  fs::create_symlink("/dev/full", folder_.file(named("full")));
  const ProgramResult outcome = write_to(named("full"));
  expect_complaint(outcome, "raygauge: " + named("full") + ": cannot write: No space left on device");
  EXPECT_EQ(fs::status(folder_.file(named("full"))).type(), fs::file_type::character);
}

TEST_P(Outputs, GoIntoAFifoThatStaysOne) {
  const std::string fifo = folder_.file(named("fifo"));
  ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
  if (!GetParam().derived) return expect_refused(named("fifo"), "e.toml", true);
  std::string received;
  std::thread reader([&] { received = testing::read_bytes(fifo); });
  const ProgramResult outcome = write_to(named("fifo"));
  if (outcome.status != 0) close(open(fifo.c_str(), O_WRONLY | O_NONBLOCK));  // lets the reader go
  reader.join();
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(received.starts_with(GetParam().beginning)) << received.substr(0, 40);
  EXPECT_FALSE(received.empty());
  EXPECT_EQ(fs::status(fifo).type(), fs::file_type::fifo);
}

TEST_P(Outputs, GoThroughALinkToAFile) {
  fs::create_directory(folder_.file("far"));
  expect_written(write_to(named("far/first")), named("far/first"));
  const std::string target = named("far/second");
  fs::copy(folder_.file(named("far/first")), folder_.file(target));
  if (GetParam().derived) write(target, kForeign);
  fs::create_symlink(named("far/second"), folder_.file(named("link")));
  expect_written(write_to(named("link"), true), target);
  EXPECT_TRUE(fs::is_symlink(folder_.file(named("link"))));
  EXPECT_FALSE(fs::is_symlink(folder_.file(target)));
}

TEST_P(Outputs, GoThroughADanglingLink) {
  fs::create_symlink(named("far/away/target"), folder_.file(named("link")));
  expect_written(write_to(named("link")), named("far/away/target"));
  EXPECT_TRUE(fs::is_symlink(folder_.file(named("link"))));
}

TEST_P(Outputs, DoNotGoInCirclesAlongLinks) {
  fs::create_symlink(named("circle"), folder_.file(named("circle")));
  expect_refused(named("circle"), "e.toml", true);
}

TEST_P(Outputs, DoNotReplaceAFolder) {
  fs::create_directory(folder_.file(named("folder")));
  for (const bool force : {false, true}) expect_refused(named("folder"), "e.toml", force);
  EXPECT_TRUE(fs::is_directory(folder_.file(named("folder"))));
  expect_refused(named("new") + "/", "e.toml", false);
}

TEST_P(Outputs, MakeTheFolderThatIsMissing) {
  expect_written(write_to(named("one/two/out")), named("one/two/out"));
}

TEST_P(Outputs, AreWholeOrAsTheyWereOnAFullDisk) {
  const std::string name = named("out");
  expect_written(write_to(name), name);
  const std::string before = read(name);
  const std::vector<std::string> folder_before = names();
  constexpr std::size_t kTooSmall = 16;
  testing::Program program(folder_.path(), arguments(name, true), kTooSmall);
  const ProgramResult outcome = program.wait();
  EXPECT_EQ(outcome.status, 2);
  EXPECT_TRUE(read(name) == before);
  EXPECT_EQ(names(), folder_before);
}

TEST_P(Outputs, GoToStandardOutputWhereTheyAreText) {
  // A figure without an extension is SVG.
  const bool is_figure = GetParam().chooses_by_extension;
  if (GetParam().text || is_figure) {
    const ProgramResult outcome = write_to("-");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(outcome.out.starts_with(is_figure ? "<?xml" : GetParam().beginning))
        << outcome.out.substr(0, 40);
    EXPECT_FALSE(outcome.out.empty());
  } else {
    EXPECT_EQ(write_to("-").status, 2);
  }
  EXPECT_FALSE(fs::exists(folder_.file("-")));
}

TEST_P(Outputs, OfAnotherKindAreNotGivenTheNameOfMeasurements) {
  if (!GetParam().derived) return;
  EXPECT_EQ(write_to("new.h5").status, 2);
  EXPECT_FALSE(fs::exists(folder_.file("new.h5")));
}

TEST_P(Outputs, UnderAnUnusualNameAreDecidedOnceBeforeTheyAreWritten) {
  if (GetParam().chooses_by_extension || !GetParam().derived) return;
  expect_written(write_to("new.odd"), "new.odd");
  expect_refused("new.odd", "new.odd", false);
}

/// A figure of two pages, the second of which has the name of somebody else's file.
class FigurePages : public testing::ProgramTest {};

TEST_F(FigurePages, AreAllDecidedBeforeTheFirstIsWritten) {
  ResultsFile results;
  for (const double tolerance : {1e-6, 1e-9}) {
    const std::size_t first = results.records.size();
    for (const int N : {200, 400}) {
      testing::add_records(results.records, "column_generation", 3, N, {1, 2, 3});
      testing::add_records(results.records, "glpk_dual", 3, N, {10, 20, 30});
    }
    for (std::size_t i = first; i < results.records.size(); ++i) results.records[i].tolerance = tolerance;
  }
  for (std::size_t i = 0; i < results.records.size(); ++i) results.records[i].cell = i / 6;
  results.provenance.cell_count = 4;
  results.provenance.sessions = {testing::sample_session()};
  write_results(folder_.file("m.h5"), results);
  write_results(folder_.file("fig-2.svg"), results);
  const std::vector<std::string> command = {"plot", "m.h5", "--figure", "ratio_heatmap", "-o", "fig.svg"};
  expect_complaint(
      run_raygauge(command),
      "raygauge: fig-2.svg: holds HDF5 data, which nothing derived replaces; nothing was written");
  EXPECT_FALSE(fs::exists(folder_.file("fig.svg")));
  fs::remove(folder_.file("fig-2.svg"));
  EXPECT_EQ(run_raygauge(command).out, "fig.svg\nfig-2.svg\n");
}

/// All figures into a folder: the rules hold for each file in it.
class FigureFolder : public Outputs {};
INSTANTIATE_TEST_SUITE_P(OfPlot, FigureFolder,
                         ::testing::Values(Writer{"plot", {"plot", "m.h5", "-o"}, "", "", false}));

TEST_P(FigureFolder, IsMadeAndFilledAgain) {
  for (int turn = 0; turn < 2; ++turn) {
    const ProgramResult outcome = write_to("new/pictures");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(read("new/pictures/time_vs_N.png").starts_with("\x89PNG"));
  }
}

TEST_P(FigureFolder, KeepsMeasurementsUnderTheNameOfAPicture) {
  fs::create_directory(folder_.file("pictures"));
  fs::copy(folder_.file("other.h5"), folder_.file("pictures/time_vs_N.png"));
  const ProgramResult outcome = write_to("pictures", true);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_TRUE(read("pictures/time_vs_N.png") == read("other.h5"));
  EXPECT_EQ(testing::entries_of(folder_.file("pictures")).size(), 1U) << "nothing was begun";
}

TEST_P(FigureFolder, IsNoFileAndNoStream) {
  write("notes.text", kForeign);
  expect_refused("notes.text", "notes.text", true);
  expect_refused("-", "e.toml", true);
  expect_refused("figure.svg", "e.toml", true);
}

class RunThroughALink : public Outputs {};

/// A run through a link keeps its parts beside the file that the link names, and is read through the link.
TEST_F(RunThroughALink, IsWrittenResumedAndRead) {
  fs::create_directory(folder_.file("far"));
  fs::create_symlink("far/x.h5", folder_.file("link.h5"));
  EXPECT_EQ(run_raygauge({"run", "e.toml", "-q", "-o", "link.h5"}).status, 0);
  EXPECT_TRUE(fs::is_symlink(folder_.file("link.h5")));
  EXPECT_EQ(testing::entries_of(folder_.file("far")), std::vector<std::string>{"x.h5"});
  EXPECT_EQ(run_raygauge({"run", "e.toml", "-q", "-o", "link.h5", "--resume"}).status, 0);
  EXPECT_EQ(run_raygauge({"info", "link.h5"}).status, 0);
}

}  // namespace
}  // namespace raygauge::test_outputs
