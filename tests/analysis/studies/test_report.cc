// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "analysis/render/report/blocks_json.h"
#include "analysis/render/report/deflate.h"
#include "raygauge/exceptions.h"
#include "tests/analysis/records.h"

namespace raygauge::test_report {
namespace {

using raygauge::testing::add_records;
using report::Json;

MergedResults results_of(std::vector<Record> records) {
  MergedResults merged;
  merged.records = std::move(records);
  merged.files.resize(1);
  merged.files[0].path = "out/a<b.h5";
  merged.files[0].provenance.experiment_text = "name = \"x\" # </script><b>";
  merged.files[0].provenance.sessions.resize(1);
  return merged;
}

std::vector<Record> small_grid() {
  std::vector<Record> records;
  for (const int n : {3, 4, 5}) {
    for (const int N : {200, 400, 800}) {
      const double ms = 1e-3 * n * N;
      add_records(records, "column_generation", n, N, {ms, 1.1 * ms, 0.9 * ms});
      add_records(records, "glpk_dual", n, N, {4 * ms, 4.4 * ms, 3.6 * ms});
    }
  }
  return records;
}

/// The data inside a page.
Json data_of(const std::string& page) {
  const std::string mark = "id=\"data\">";
  const std::size_t begin = page.find(mark) + mark.size();
  return Json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

std::vector<std::string> section_ids(const std::string& page) {
  std::vector<std::string> ids;
  const Json data = data_of(page);
  for (const Json& section : data["sections"]) ids.push_back(section["id"]);
  return ids;
}

TEST(Report, HasTheSectionsThatTheRecordsHaveTheDataOf) {
  EXPECT_EQ(section_ids(report::make_page(results_of(small_grid()), {}, {})),
            (std::vector<std::string>{"summary", "stability", "ratios", "scaling", "profiles", "crossover",
                                      "provenance", "records"}));
  std::vector<Record> one_method;
  add_records(one_method, "column_generation", 3, 200, {1, 2});
  for (Record& record : one_method) record.exact_distance = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(section_ids(report::make_page(results_of(one_method), {}, {})),
            (std::vector<std::string>{"summary", "provenance", "records"}));
  std::vector<Record> tolerances = small_grid();
  for (Record record : small_grid()) {
    record.tolerance = 1e-3;
    tolerances.push_back(record);
  }
  for (Record& record : tolerances) record.counters.outer_iterations = 3;
  const std::vector<std::string> ids = section_ids(report::make_page(results_of(tolerances), {}, {}));
  for (const char* id : {"work_precision", "iterations", "accuracy"})
    EXPECT_NE(std::find(ids.begin(), ids.end(), id), ids.end()) << id;
  EXPECT_EQ(std::find(ids.begin(), ids.end(), "example1"), ids.end());
}

TEST(Report, ComparesMethodsOnEachOfSeveralMachines) {
  std::vector<Record> records = small_grid();
  for (Record& record : records) record.host = record.n == 5 ? "b" : "a";
  const std::string page = report::make_page(results_of(records), {}, {});
  const std::vector<std::string> ids = section_ids(page);
  const auto place = std::find(ids.begin(), ids.end(), "machines") - ids.begin();
  ASSERT_LT(static_cast<std::size_t>(place), ids.size());
  const std::string text = data_of(page)["sections"][static_cast<std::size_t>(place)].dump();
  EXPECT_NE(text.find("The times come from 2 machines."), std::string::npos);
  EXPECT_NE(text.find("0.250 (6)"), std::string::npos) << text;
  EXPECT_NE(text.find("0.250 (3)"), std::string::npos) << text;
}

TEST(Report, SaysInThreeLinesWhatCameOut) {
  const Json data = data_of(report::make_page(results_of(small_grid()), {}, {}));
  EXPECT_EQ(data["sections"][0]["blocks"][0]["type"], "heatmap") << "the picture comes first";
  const Json verdict = data["sections"][0]["blocks"][1]["paragraphs"];
  ASSERT_EQ(verdict.size(), 3U);
  EXPECT_EQ(verdict[1], "Answers: all methods agree on every instance; everything was solved.");
  EXPECT_EQ(verdict[0],
            "Speed: column_generation is 4 times faster than the best baseline (geometric mean of 9 cells; "
            "at worst 4 times "
            "faster), significantly faster in 9.");
  EXPECT_EQ(verdict[2].get<std::string>().find("Precision: column_generation certified 27 of 27 distances"),
            0U);
}

/// The three lines of the summary.
Json verdict_on(const std::vector<Record>& records, const Filter& filter = {}) {
  const Json data = data_of(report::make_page(results_of(records), filter, {}));
  for (const Json& block : data["sections"][0]["blocks"])
    if (block["type"] == "text" && block["lead"]) return block["paragraphs"];
  return nullptr;
}

/// The picture that the page begins with.
Json picture_of(const std::vector<Record>& records) {
  return data_of(report::make_page(results_of(records), {}, {}))["sections"][0]["blocks"][0];
}

TEST(Report, BeginsWithAPictureOfWhoIsFastestWhere) {
  std::vector<Record> records = small_grid();
  for (Record& record : records) {
    if (record.n == 5 && record.method == "column_generation") record.seconds *= 8;
    if (record.n == 3 && record.N == 200 && record.method == "glpk_dual" && record.repetition == 0)
      record.agrees = false;
  }
  const Json picture = picture_of(records);
  EXPECT_EQ(picture["row"], "n");
  EXPECT_EQ(picture["column"], "N");
  EXPECT_EQ(picture["columns"], (Json{"200", "400", "800"}));
  ASSERT_EQ(picture["cells"].size(), 9U);
  EXPECT_EQ(picture["cells"][0]["group"], "column_generation");
  EXPECT_EQ(picture["cells"][0]["text"].get<std::string>().back(), '!');
  EXPECT_NE(picture["cells"][0]["remark"].get<std::string>().find("1 answers of glpk_dual are refuted"),
            std::string::npos);
  EXPECT_EQ(picture["cells"][1]["text"], "4.0×");
  EXPECT_EQ(picture["cells"][8]["group"], "glpk_dual");
  EXPECT_EQ(picture["cells"][8]["text"], "2.0×");
}

TEST(Report, PutsWhatVariesMostOnTheAxesOfItsPicture) {
  std::vector<Record> records;
  for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
    for (const char* method : {"column_generation", "glpk_dual"}) {
      add_records(records, method, 3, 200, {1, 2});
      for (auto record = records.end() - 2; record != records.end(); ++record) record->tolerance = tolerance;
    }
  }
  EXPECT_EQ(picture_of(records)["column"], "tolerance");
  EXPECT_EQ(picture_of(records)["cells"].size(), 3U);
}

TEST(Report, SaysWhoseAnswersDisagreeAndThatTimesAreEqual) {
  std::vector<Record> records = small_grid();
  records[3].agrees = records[4].agrees = false;
  for (Record& record : records)
    if (record.method == "column_generation") record.seconds *= 4.05;
  records[0].status = DistanceStatus::time_limit;
  const Json verdict = verdict_on(records);
  EXPECT_EQ(
      verdict[1],
      "Answers: disagree with other methods' proofs or the known distance: 2 of glpk_dual; stopped at a "
      "limit: 1 of column_generation.");
  EXPECT_NE(verdict[0].get<std::string>().find("column_generation is as fast as the best baseline"),
            std::string::npos)
      << verdict[0];
}

TEST(Report, LeavesRecordsOutThatAreTooManyForAPageAndPacksItsData) {
  std::vector<Record> records;
  for (int n = 3; n < 14; ++n)
    for (int N = 10; N < 110; ++N)
      for (const char* method : {"column_generation", "glpk_dual"})
        add_records(records, method, n, N, std::vector<double>(10, 1.0 + 0.001 * N));
  ASSERT_GT(records.size(), 20000U);
  const std::string page = report::make_page(results_of(records), {}, {});
  EXPECT_LT(page.size(), 1'000'000U);
  EXPECT_NE(page.find(R"(<script type="application/gzip" id="data">H4sI)"), std::string::npos);
  records.resize(20);
  const Json data = data_of(report::make_page(results_of(records), {}, {}));
  EXPECT_FALSE(data["sections"].back()["blocks"][0]["gzip"].get<std::string>().empty());
}

TEST(Report, SaysNothingOfAgreementWhereThereIsOneMethod) {
  EXPECT_EQ(verdict_on(small_grid(), Filter("method==column_generation"))[1],
            "Answers: everything was solved.");
}

TEST(Report, SaysInHowManyCellsAMethodIsUnsolved) {
  std::vector<Record> records = small_grid();
  for (Record& record : records)
    if (record.method == "column_generation" && record.n == 3) record.status = DistanceStatus::time_limit;
  EXPECT_EQ(verdict_on(records)[0],
            "Speed: column_generation is 4 times faster than the best baseline (geometric mean of 6 cells; "
            "at worst 4 times "
            "faster), significantly faster in 6, unsolved in 3 cells.");
  for (Record& record : records)
    if (record.method == "column_generation") record.status = DistanceStatus::time_limit;
  EXPECT_EQ(verdict_on(records)[0], "Speed: column_generation is unsolved in 9 cells.");
}

TEST(Report, CountsAsCertifiedOnlyWhatIsSolvedAndBounded) {
  std::vector<Record> records = small_grid();
  records[0].status = DistanceStatus::precision_limit;
  records[1].lower = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(verdict_on(records)[2],
            "Precision: column_generation certified 25 of 27 distances to the tolerance asked for (some "
            "without a bound).");
}

/// One section of a page.
Json section_of(const std::vector<Record>& records, const std::string& id) {
  const Json data = data_of(report::make_page(results_of(records), {}, {}));
  for (const Json& section : data["sections"])
    if (section["id"] == id) return section;
  return nullptr;
}

/// column_generation at two tolerances: off by ε / 2 and proven to ε, in 1 and 4 ms, K = 2 and 6.
std::vector<Record> two_tolerances() {
  std::vector<Record> records;
  for (const double tolerance : {0.25, 0.0625}) {
    add_records(records, "column_generation", 3, 200,
                tolerance == 0.25 ? std::vector{1.0, 1.0} : std::vector{4.0, 4.0});
    for (auto record = records.end() - 2; record != records.end(); ++record) {
      record->tolerance = tolerance;
      record->distance = record->upper = 2 * (1 + tolerance / 2);
      record->lower = record->upper * (1 - tolerance);
      record->counters.outer_iterations = tolerance == 0.25 ? 2 : 6;
    }
  }
  return records;
}

TEST(Report, DrawsWorkAgainstPrecision) {
  const Json points = section_of(two_tolerances(), "work_precision")["blocks"][0]["series"][0]["points"];
  EXPECT_EQ(points[0][0], 4) << "time, as in the figure, at the tighter tolerance";
  EXPECT_EQ(points[0][1], 0.03125) << "the mean relative error";
  EXPECT_EQ(points[1][0], 1);
  EXPECT_EQ(points[1][1], 0.125);
}

TEST(Report, DrawsIterationsAgainstTheTolerance) {
  const Json points = section_of(two_tolerances(), "iterations")["blocks"][0]["series"][0]["points"];
  EXPECT_EQ(points[0], (Json{0.0625, 6}));
  EXPECT_EQ(points[1], (Json{0.25, 2}));
}

TEST(Report, TabulatesAccuracy) {
  const Json rows = section_of(two_tolerances(), "accuracy")["blocks"][0]["rows"];
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0]["cells"][1], "0.25");
  EXPECT_EQ(rows[0]["cells"][2], "0.12") << "mean relative error";
  EXPECT_EQ(rows[0]["cells"][4], "0.25") << "mean gap";
  EXPECT_EQ(rows[0]["cells"][6], "1000") << "µs";
}

TEST(Report, DrawsTheShareOfRightAnswersOfEachFamily) {
  std::vector<Record> records = small_grid();
  records[0].distance = 17;
  const Json picture = section_of(records, "stability")["blocks"][0];
  EXPECT_EQ(picture["rows"], (Json{"example2"}));
  EXPECT_EQ(picture["columns"], (Json{"column_generation", "glpk_dual"}));
  EXPECT_EQ(picture["cells"][0]["text"], "96 %!");
  EXPECT_EQ(picture["cells"][1]["text"], "100 %");
  EXPECT_EQ(picture["log"], false);
}

TEST(Report, DrawsProfilesAndCrossover) {
  const Json profiles = section_of(small_grid(), "profiles")["blocks"][0]["series"];
  ASSERT_EQ(profiles.size(), 2U);
  EXPECT_EQ(profiles[0]["points"][0], (Json{1, 1})) << "column_generation is fastest everywhere";
  EXPECT_EQ(profiles[1]["points"][0], (Json{1, 0}));
  EXPECT_EQ(profiles[1]["points"].back()[1], 1);
  const Json cells = section_of(small_grid(), "crossover")["blocks"][0]["cells"];
  ASSERT_EQ(cells.size(), 9U);
  EXPECT_EQ(cells[0]["group"], "column_generation");
  EXPECT_EQ(cells[0]["text"], "4.0×");
}

TEST(Report, ShowsTheTablesOfExample1BesideThePapers) {
  std::vector<Record> records = two_tolerances();
  for (Record& record : records) {
    record.generator = "example1";
    record.generator_parameters = "distance=2 roles=ellipsoid_cone";
  }
  const Json blocks = section_of(records, "example1")["blocks"];
  ASSERT_EQ(blocks.size(), 2U);
  EXPECT_EQ(blocks[0]["title"], "Table II, column_generation");
}

TEST(Report, DrawsTheNumbersOfTheStatistics) {
  const Json data = data_of(report::make_page(results_of(small_grid()), Filter("n==3"), {}));
  const Json chart = data["sections"][3]["blocks"][0];
  EXPECT_EQ(chart["series"].size(), 2U);
  EXPECT_EQ(chart["series"][0]["name"], "column_generation (exponent 1.0)");
  EXPECT_EQ(chart["series"][0]["points"][0][0], 200);
  EXPECT_EQ(chart["series"][0]["points"][0][1], 0.6);
  EXPECT_EQ(chart["series"][0]["points"][0][2], 0.54);
}

TEST(Report, StandsAloneAndLetsNoTextBecomeMarkup) {
  const std::string page = report::make_page(results_of(small_grid()), {}, {});
  EXPECT_EQ(page.find("src="), std::string::npos);
  EXPECT_EQ(page.find("<link rel=\"stylesheet"), std::string::npos);
  EXPECT_EQ(page.find("</script><b>"), std::string::npos);
  EXPECT_NE(page.find("<title>raygauge: a&lt;b.h5</title>"), std::string::npos);
  EXPECT_NE(page.find("Released under the MIT License"), std::string::npos);  // Chart.js's notice
}

TEST(Report, RefusesAFilterThatNothingPassesAndAnUnknownBaseline) {
  EXPECT_THROW(report::make_page(results_of(small_grid()), Filter("n==9"), {}), EmptySetError);
  EXPECT_THROW(report::make_page(results_of({}), {}, {}), EmptySetError);
  EXPECT_THROW(report::make_page(results_of(small_grid()), {}, {"simplex"}), UnknownNameError);
}

TEST(Base64, FollowsTheVectorsOfRfc4648) {
  EXPECT_EQ(report::base64(""), "");
  EXPECT_EQ(report::base64("f"), "Zg==");
  EXPECT_EQ(report::base64("fo"), "Zm8=");
  EXPECT_EQ(report::base64("foobar"), "Zm9vYmFy");
}

TEST(Gzip, IsAGzipMember) {
  const std::string packed = report::gzip(std::string(1000, 'x'));
  EXPECT_LT(packed.size(), 50U);
  EXPECT_TRUE(packed.starts_with("\x1f\x8b\x08"));
}

}  // namespace
}  // namespace raygauge::test_report
