// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/report/report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "analysis/report/deflate.h"
#include "engine/exceptions.h"
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
      add_records(records, "direct", n, N, {ms, 1.1 * ms, 0.9 * ms});
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
            (std::vector<std::string>{"summary", "ratios", "scaling", "profiles", "crossover", "stability",
                                      "accuracy", "provenance", "records"}));
  std::vector<Record> one_method;
  add_records(one_method, "direct", 3, 200, {1, 2});
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
  EXPECT_NE(std::find(ids.begin(), ids.end(), "work_precision"), ids.end());
  EXPECT_NE(std::find(ids.begin(), ids.end(), "iterations"), ids.end());
}

TEST(Report, SaysInThreeLinesWhatCameOut) {
  const Json data = data_of(report::make_page(results_of(small_grid()), {}, {}));
  const Json verdict = data["sections"][0]["blocks"][0]["paragraphs"];
  ASSERT_EQ(verdict.size(), 3U);
  EXPECT_EQ(verdict[0], "Answers: all methods agree on every instance; everything was solved.");
  EXPECT_EQ(verdict[1],
            "Speed: direct takes 0.25 of the best baseline's time (geometric mean of 9 cells, worst 0.25), "
            "significantly faster in 9.");
  EXPECT_EQ(verdict[2].get<std::string>().find("Precision: direct certified 27 of 27 distances"), 0U);
}

TEST(Report, DrawsTheNumbersOfTheStatistics) {
  const Json data = data_of(report::make_page(results_of(small_grid()), Filter("n==3"), {}));
  const Json chart = data["sections"][2]["blocks"][0];
  EXPECT_EQ(chart["series"].size(), 2U);
  EXPECT_EQ(chart["series"][0]["name"], "direct (exponent 1.0)");
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
