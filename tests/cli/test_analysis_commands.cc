// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// `raygauge table`, `plot` and `export` as a user runs them.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "results/run/results_file.h"
#include "tests/analysis/records.h"
#include "tests/cli/program_fixture.h"

namespace raygauge::test_analysis_commands {
namespace {

using testing::expect_complaint;
using testing::ProgramResult;

class AnalysisCommands : public testing::ProgramTest {
 protected:
  void SetUp() override {
    ResultsFile results;
    for (const int N : {200, 400}) {
      testing::add_records(results.records, "column_generation", 3, N, {1, 2, 3});
      testing::add_records(results.records, "glpk_dual", 3, N, {10, 20, 30});
    }
    for (std::size_t i = 0; i < results.records.size(); ++i) results.records[i].cell = i / 6;
    results.provenance.cell_count = 2;
    results.provenance.sessions = {testing::sample_session()};
    results.provenance.sessions[0].timing = "serial";
    write_results(folder_.file("r.h5"), results);
  }

  std::string read(const std::string& name) const { return testing::read_bytes(folder_.file(name)); }

  bool exists(const std::string& name) const { return std::filesystem::exists(folder_.file(name)); }
};

TEST_F(AnalysisCommands, TablePrintsAPivot) {
  const ProgramResult outcome =
      run_raygauge({"table", "r.h5", "--rows", "n", "--cols", "N", "--value", "median ratio"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(outcome.out,
            "median ratio of time to the best of glpk_dual\n"
            "\n"
            "n  N=200  N=400\n"
            "---------------\n"
            "3  0.100  0.100\n");
}

TEST_F(AnalysisCommands, TablePrintsTheTableOfThePaper) {
  const ProgramResult outcome = run_raygauge({"table", "r.h5", "--paper", "table3"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find(
                "n=3  measured  2.00 (0.10)*  2.00 (0.10)*\n     paper      1.36 (0.19)   1.52 (0.15)\n"),
            std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("agreement: all 12 records agree, baselines included\n"), std::string::npos);
}

TEST_F(AnalysisCommands, TableSaysHowStableTheMethodsAre) {
  const ProgramResult outcome = run_raygauge(
      {"table", "r.h5", "--stability", "--where", "method==column_generation", "--format", "csv"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("\n1e-6,example2,column_generation,6,6,1,"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("\n1e-6,all,column_generation,6,6,1,"), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find("glpk"), std::string::npos);
}

TEST_F(AnalysisCommands, TableWritesAFileInTheFormatAskedFor) {
  const ProgramResult outcome = run_raygauge({"table", "r.h5", "--rows", "method,N", "--value", "max ms",
                                              "--where", "N==200", "--format", "csv", "-o", "t.csv"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(read("t.csv"), "method,N,max milliseconds\ncolumn_generation,200,3\nglpk_dual,200,30\n");
}

TEST_F(AnalysisCommands, TableKeepsTheIntervalsInCsv) {
  const ProgramResult text = run_raygauge({"table", "r.h5", "--rows", "method", "--intervals"});
  EXPECT_EQ(text.status, 0) << text.err;
  EXPECT_NE(text.out.find("["), std::string::npos) << text.out;
  const ProgramResult csv =
      run_raygauge({"table", "r.h5", "--rows", "method", "--intervals", "--format", "csv"});
  EXPECT_EQ(csv.status, 0) << csv.err;
  EXPECT_EQ(csv.out,
            "method,median milliseconds,median milliseconds lower,median milliseconds upper\n"
            "column_generation,2,1,3\nglpk_dual,20,10,30\n");
}

TEST_F(AnalysisCommands, TableRefusesWhatItCannotMake) {
  expect_complaint(run_raygauge({"table", "r.h5"}),
                   "raygauge: table: which table? r.h5 is read; add --paper table1|table2|table3, "
                   "--stability, --accuracy, --wrong, or --rows, "
                   "--cols and --value");
  expect_complaint(
      run_raygauge({"table", "r.h5", "--paper", "table3", "--rows", "n"}),
      "raygauge: table: --paper has its own rows, columns and value; drop --rows, --cols, --value");
  expect_complaint(
      run_raygauge({"table", "r.h5", "--stability", "--value", "count"}),
      "raygauge: table: --stability has its own rows, columns and value; drop --rows, --cols, --value");
  expect_complaint(run_raygauge({"table", "r.h5", "--paper", "table3", "--stability"}),
                   "raygauge: table: --paper or --stability, not both");
  expect_complaint(run_raygauge({"table", "r.h5", "--accuracy", "--stability"}),
                   "raygauge: table: --stability or --accuracy, not both");
  expect_complaint(run_raygauge({"table", "r.h5", "--paper", "table1"}),
                   "raygauge: the tables of Example 1 need records of generator example1 with "
                   "roles=cone_ellipsoid; there are none");
  expect_complaint(
      run_raygauge({"table", "r.h5", "--paper", "table9"}),
      "raygauge: unknown table of the paper 'table9'; did you mean 'table1'? (known: table1 table2 table3)");
  expect_complaint(run_raygauge({"table", "r.h5", "--rows", "n", "--where", "n=3"}),
                   "raygauge: filter 'n=3', character 2: unexpected '='; did you mean '=='?");
  expect_complaint(run_raygauge({"table", "r.h5", "--rows", "n", "--format", "html"}),
                   "raygauge: unknown table format 'html' (known: text markdown latex csv)");
  expect_complaint(run_raygauge({"table", "r.h5", "r.h5", "--rows", "n"}),
                   "raygauge: r.h5 holds the same run as r.h5");
}

TEST_F(AnalysisCommands, ExportWritesTheRecordsThatPass) {
  const ProgramResult outcome = run_raygauge(
      {"export", "r.h5", "--csv", "out.csv", "--where", "method==column_generation && repetition<2"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const std::string csv = read("out.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 4);
  EXPECT_TRUE(csv.starts_with("cell,session,generator,")) << csv;
  EXPECT_EQ(csv.find("glpk"), std::string::npos);
}

TEST_F(AnalysisCommands, ExportWritesNothingWhereNothingPasses) {
  expect_complaint(run_raygauge({"export", "r.h5", "--csv", "out.csv", "--where", "n==9"}),
                   "raygauge: no record passes the filter 'n==9'; nothing was written");
  EXPECT_FALSE(exists("out.csv"));
}

TEST_F(AnalysisCommands, PlotDrawsAFigure) {
  const ProgramResult outcome = run_raygauge({"plot", "r.h5", "--figure", "time_vs_N", "-o", "t.svg"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "t.svg\n");
  EXPECT_NE(read("t.svg").find("<svg"), std::string::npos);
}

TEST_F(AnalysisCommands, PlotWritesSvgToStandardOutput) {
  const ProgramResult outcome = run_raygauge({"plot", "r.h5", "--figure", "time_vs_N", "-o", "-"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(outcome.out.starts_with("<?xml")) << outcome.out.substr(0, 100);
  EXPECT_TRUE(outcome.out.ends_with("</svg>\n\n") || outcome.out.ends_with("</svg>\n"));
  expect_complaint(run_raygauge({"plot", "r.h5", "-o", "-"}),
                   "raygauge: -: is no folder; without --figure, -o is the folder for all figures");
  EXPECT_FALSE(exists("-"));
}

TEST_F(AnalysisCommands, PlotSaysWhereStandardOutputCannotTakeAllPages) {
  ResultsFile results = read_results(folder_.file("r.h5"));
  const std::vector<Record> records = results.records;
  for (Record record : records) {
    record.tolerance = 1e-3;
    record.cell += 2;
    results.records.push_back(record);
  }
  results.provenance.cell_count = 4;
  write_results(folder_.file("two.h5"), results);
  expect_complaint(run_raygauge({"plot", "two.h5", "--figure", "ratio_heatmap", "-o", "-"}),
                   "raygauge: figure ratio_heatmap has 2 pages, and standard output takes one: name a file "
                   "(-o ratio_heatmap.svg), or choose with --where");
  const ProgramResult files = run_raygauge({"plot", "two.h5", "--figure", "ratio_heatmap", "-o", "h.svg"});
  EXPECT_EQ(files.out, "h.svg\nh-2.svg\n") << files.err;
  EXPECT_EQ(
      run_raygauge({"plot", "two.h5", "--figure", "ratio_heatmap", "-o", "-", "--where", "tolerance==1e-3"})
          .status,
      0);
}

TEST_F(AnalysisCommands, PlotDrawsAllFiguresThatTheRecordsHaveTheDataOf) {
  std::filesystem::create_directory(folder_.file("pictures"));
  const ProgramResult outcome = run_raygauge({"plot", "r.h5", "-o", "pictures", "--where", "N<=400"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out,
            "pictures/time_vs_N.svg\npictures/time_vs_N.png\n"
            "pictures/ratio_heatmap.svg\npictures/ratio_heatmap.png\npictures/performance_profile.svg\n"
            "pictures/performance_profile.png\npictures/crossover.svg\npictures/crossover.png\n");
  EXPECT_EQ(outcome.err,
            "skipped: figure time_vs_dimension needs solved records at two or more values of n\n"
            "skipped: figure true_error needs answers of known truth at two or more values of a generator's "
            "measure of hardness, as aspect or 1/delta\n"
            "skipped: figure fig5 needs records of generator example1 in its roles at two tolerances\n"
            "skipped: figure fig7 needs records of generator example1 in its roles at two tolerances\n"
            "skipped: figure work_precision needs solves of known truth (a generator that knows it, or "
            "records of the "
            "method exact) at two or more tolerances\n"
            "skipped: figure wrong_share needs answers that do not agree with a proof\n");
  EXPECT_TRUE(read("pictures/ratio_heatmap.png").starts_with("\x89PNG"));
}

TEST_F(AnalysisCommands, PlotRefusesWhatItCannotDraw) {
  expect_complaint(run_raygauge({"plot", "r.h5", "--figure", "heatmap", "-o", "x.svg"}),
                   "raygauge: unknown figure 'heatmap' (known: time_vs_N time_vs_dimension ratio_heatmap "
                   "performance_profile "
                   "crossover true_error fig5 fig7 work_precision wrong_share)");
  expect_complaint(run_raygauge({"plot", "r.h5", "--figure", "time_vs_N", "-o", "x.jpg"}),
                   "raygauge: x.jpg: a figure is a file ending in .svg, .png, .pdf, .eps, .tikz or .tex");
  expect_complaint(
      run_raygauge({"plot", "r.h5", "--figure", "time_vs_N", "-o", "x.svg", "--where", "N==200"}),
      "raygauge: figure time_vs_N needs solved records at two or more values of N");
  expect_complaint(run_raygauge({"plot", "r.h5", "-o", "x.svg"}),
                   "raygauge: x.svg: is no folder; without --figure, -o is the folder for all figures");
  EXPECT_FALSE(exists("x.svg"));
}

/// Two runs of one grid with simulated times, the second of which may be slower.
class CompareCommand : public testing::ProgramTest {
 protected:
  void write_run(const std::string& name, double factor, const std::string& processor = "a processor") const {
    ResultsFile results;
    for (const int N : {200, 400, 800, 1600}) {
      std::vector<double> times;
      for (int i = 0; i < 20; ++i) times.push_back((1 + 0.1 * i) * N / 200 * (1 + 0.01 * ((i * 7) % 5 - 2)));
      testing::add_records(results.records, "glpk_dual", 3, N, times);
      for (double& time : times) time *= factor;
      testing::add_records(results.records, "column_generation", 3, N, times);
    }
    for (std::size_t i = 0; i < results.records.size(); ++i) results.records[i].cell = i / 40;
    results.provenance.cell_count = 4;
    results.provenance.sessions = {testing::sample_session()};
    results.provenance.sessions[0].machine.cpu_model = processor;
    write_results(folder_.file(name), results);
  }
};

TEST_F(CompareCommand, EndsWithOneWhereAMethodGotSlower) {
  write_run("base.h5", 1);
  write_run("new.h5", 3, "another processor");
  const ProgramResult outcome = run_raygauge({"compare", "base.h5", "new.h5"});
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_NE(outcome.out.find(
                "\nREGRESSION: of 8 cells 4 slower, 0 faster; column_generation slower over all cells\n"),
            std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("warning: processor: a processor; now another processor"), std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("3.00 [3.00, 3.00]"), std::string::npos) << outcome.out;
}

TEST_F(CompareCommand, SuspectsWhatMayBeTheMachine) {
  write_run("base.h5", 1);
  write_run("new.h5", 1.1);
  const ProgramResult outcome = run_raygauge({"compare", "base.h5", "new.h5"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(
      outcome.out.find(
          "\nsuspected regression: of 8 cells 0 slower, 0 faster, 4 suspected slower; column_generation "
          "suspected slower over all cells\n"),
      std::string::npos)
      << outcome.out;
}

TEST_F(CompareCommand, TakesSeveralFilesASide) {
  for (const int k : {0, 1, 2, 3}) {
    write_run("base" + std::to_string(k) + ".h5", 1 + 0.01 * k);
    write_run("new" + std::to_string(k) + ".h5", 1.1 + 0.01 * k);
  }
  const std::vector<std::string> base = {"base0.h5", "base1.h5", "base2.h5", "base3.h5"};
  const std::vector<std::string> fresh = {"new0.h5", "new1.h5", "new2.h5", "new3.h5"};
  const auto compare = [&](const std::vector<std::string>& first, const std::vector<std::string>& second) {
    std::vector<std::string> words = {"compare", "--base"};
    words.insert(words.end(), first.begin(), first.end());
    words.emplace_back("--new");
    words.insert(words.end(), second.begin(), second.end());
    return run_raygauge(words);
  };
  const ProgramResult outcome = compare(base, fresh);
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_NE(outcome.out.find("column_generation slower over all cells"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("4 runs of BASE, 4 runs of NEW"), std::string::npos) << outcome.out;
  EXPECT_EQ(compare(base, base).status, 0);
  expect_complaint(compare({"base0.h5", "base0.h5"}, fresh),
                   "raygauge: base0.h5 is given twice on one side: its run would count twice");
}

TEST_F(CompareCommand, RunsTwoBuildsInTurn) {
  const std::string program = RAYGAUGE_PROGRAM;
  write("e.toml",
        "name = 'e'\n[sweep]\nn = [2, 3]\nN = 20\nrepetitions = 3\n[[generator]]\nname = 'example2'\n"
        "[[method]]\nname = 'column_generation'\n");
  const ProgramResult outcome = run_raygauge({"compare", "--rerun", "e.toml", "--base-program", program,
                                              "--new-program", program, "--pairs", "2", "--json"});
  EXPECT_TRUE(outcome.status == 0 || outcome.status == 1)
      << outcome.err;  // two pairs are few on a busy machine
  EXPECT_EQ(outcome.err, "pair 1 of 2\npair 2 of 2\n");
  const auto json = nlohmann::ordered_json::parse(outcome.out);
  EXPECT_EQ(json["base_runs"], 2);
  EXPECT_TRUE(json["paired"].get<bool>());
  EXPECT_EQ(json["cells"].size(), 2U);
  EXPECT_EQ(json["cells"][0]["pairs"], 3);
  expect_complaint(run_raygauge({"compare", "--rerun", "e.toml", "--base-program", "/bin/false",
                                 "--new-program", program, "--quiet"}),
                   "raygauge: /bin/false failed: exit status 1");
  expect_complaint(run_raygauge({"compare", "--rerun", "e.toml", "--base-program", program}),
                   "raygauge: --rerun EXPERIMENT, --base-program and --new-program go together");
  expect_complaint(run_raygauge({"compare", "e.toml"}),
                   "raygauge: compare takes BASE.h5 NEW.h5, or --base FILES --new FILES, or --rerun "
                   "EXPERIMENT with two programs");
}

TEST_F(CompareCommand, EndsWithZeroForEqualRunsAndChangesBelowTheThreshold) {
  write_run("base.h5", 1);
  write_run("new.h5", 1.1);
  EXPECT_EQ(run_raygauge({"compare", "base.h5", "base.h5"}).status, 0);
  EXPECT_EQ(run_raygauge({"compare", "base.h5", "new.h5", "--threshold", "0.2"}).status, 0);
  EXPECT_EQ(run_raygauge({"compare", "base.h5", "new.h5", "--where", "method==glpk_dual"}).status, 0);
  EXPECT_EQ(run_raygauge({"compare", "new.h5", "base.h5"}).status, 0);
}

TEST_F(CompareCommand, PrintsJson) {
  write_run("base.h5", 1);
  write_run("new.h5", 2.5);
  const ProgramResult outcome = run_raygauge({"compare", "base.h5", "new.h5", "--json"});
  EXPECT_EQ(outcome.status, 1);
  const auto json = nlohmann::ordered_json::parse(outcome.out);
  EXPECT_TRUE(json["regression"].get<bool>());
  EXPECT_EQ(json["correction"], "Holm");
  EXPECT_EQ(json["cells"].size(), 8U);
  EXPECT_NEAR(json["cells"][1]["ratio"].get<double>() * json["cells"][0]["ratio"].get<double>(), 2.5, 1e-9);
}

TEST_F(CompareCommand, RefusesWhatItCannotCompare) {
  write_run("base.h5", 1);
  expect_complaint(run_raygauge({"compare", "base.h5", "base.h5", "--where", "n==9"}),
                   "raygauge: no record of base.h5 passes the filter 'n==9'");
  write_run("other.h5", 1);
  expect_complaint(run_raygauge({"compare", "base.h5", "other.h5", "--where", "session==0 && n==9"}),
                   "raygauge: no record of base.h5 passes the filter 'session==0 && n==9'");
  EXPECT_EQ(run_raygauge({"compare", "base.h5", "nowhere.h5"}).status, 2);
  expect_complaint(run_raygauge({"compare", "base.h5", "base.h5", "--threshold", "-1"}),
                   "raygauge: --threshold must be a number from 0 on, got -1");
  expect_complaint(run_raygauge({"compare", "nowhere.h5", "base.h5", "--threshold", "-1e300"}),
                   "raygauge: --threshold must be a number from 0 on, got -1e300");
  expect_complaint(run_raygauge({"compare", "base.h5", "base.h5", "--significance", "2"}),
                   "raygauge: --significance must lie in (0, 1), got 2");
}

TEST_F(AnalysisCommands, ReportWritesOnePage) {
  const ProgramResult outcome = run_raygauge({"report", "r.h5", "-o", "r.html", "--where", "N==200"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "r.html\n");
  EXPECT_TRUE(read("r.html").starts_with("<!doctype html>"));
  EXPECT_NE(read("r.html").find("Only records for which N==200."), std::string::npos);
}

TEST_F(AnalysisCommands, ReportWritesNothingWhereItHasNothingToSay) {
  expect_complaint(run_raygauge({"report", "r.h5", "-o", "r.html", "--where", "n==9"}),
                   "raygauge: no record passes the filter 'n==9'");
  expect_complaint(run_raygauge({"report", "r.h5", "-o", "r.html", "--baseline", "simplex"}),
                   "raygauge: unknown baseline 'simplex' (known: column_generation glpk_dual)");
  EXPECT_FALSE(exists("r.html"));
}

}  // namespace
}  // namespace raygauge::test_analysis_commands
