// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstddef>
#include <iterator>
#include <regex>
#include <set>
#include <string>

#include "analysis/constants.h"
#include "analysis/studies/figures.h"
#include "tests/analysis/records.h"

namespace raygauge::test_figures {
namespace {

using testing::add_records;
using testing::message_of;

/// Three methods, n = 3 and 4, N = 200, 400 and 800.
std::vector<Record> grid() {
  std::vector<Record> records;
  for (const int n : {3, 4}) {
    for (const int N : {200, 400, 800}) {
      const double ms = n * N / 1000.0;
      add_records(records, "column_generation", n, N, {0.9 * ms, ms, 1.1 * ms});
      add_records(records, "zheng_yamane", n, N, {2 * ms, 3 * ms, 4 * ms});
      add_records(records, "glpk_dual", n, N, {9 * ms, 10 * ms, 11 * ms});
    }
  }
  return records;
}

std::string svg(const std::string& figure, const std::vector<Record>& records,
                const FigureOptions& options = {}) {
  return draw(figure_named(figure), records, options, ImageFormat::svg).front();
}

/// The texts of a picture, in order.
std::multiset<std::string> labels(const std::string& picture) {
  static const std::regex kText("<tspan[^>]*>([^<]*)</tspan>");
  std::multiset<std::string> result;
  for (std::sregex_iterator it(picture.begin(), picture.end(), kText), end; it != end; ++it)
    result.insert((*it)[1].str());
  return result;
}

/// How many markers are drawn, those of the legend included.
std::ptrdiff_t markers(const std::string& picture) {
  static const std::regex kMarker("<use xlink:href='#gpPt[0-9]+' transform='translate");
  return std::distance(std::sregex_iterator(picture.begin(), picture.end(), kMarker), std::sregex_iterator());
}

TEST(TimeVsN, DrawsEveryPointLabelsEveryPanelAndNamesEveryMethodOnce) {
  const std::string picture = svg("time_vs_N", grid());
  const std::multiset<std::string> texts = labels(picture);
  for (const char* once : {"n = 3", "n = 4", "column_generation", "zheng_yamane", "glpk_dual",
                           "N, points in each set", "median time of a solve (ms)"})
    EXPECT_EQ(texts.count(once), 1U) << once;
  // A marker for each point of 2 panels × 3 sizes × 3 methods, and one for each method in the legend.
  EXPECT_EQ(markers(picture), 2 * 3 * 3 + 3);
}

TEST(TimeVsN, IsFilteredAndLeavesUnsolvedAndDisagreeingOut) {
  std::vector<Record> records = grid();
  for (Record& record : records) {
    if (record.method == "column_generation" && record.N == 800) record.agrees = false;
    if (record.method == "glpk_dual" && record.N == 800) record.status = DistanceStatus::time_limit;
  }
  FigureOptions options;
  options.filter = Filter("n==3");
  const std::string picture = svg("time_vs_N", records, options);
  EXPECT_EQ(labels(picture).count("n = 4"), 0U);
  EXPECT_EQ(markers(picture), 2 + 3 + 2 + 3);
}

TEST(TimeVsN, CrossesPointsBehindWhichAnswersAreWrongOrMissing) {
  std::vector<Record> records = grid();
  const auto of_one = [&](const std::string& method) {
    return std::find_if(records.begin(), records.end(),
                        [&](const Record& each) { return each.method == method; });
  };
  of_one("glpk_dual")->agrees = false;
  of_one("column_generation")->status = DistanceStatus::time_limit;
  const std::string picture = svg("time_vs_N", records);
  EXPECT_EQ(labels(picture).count("some answers wrong or missing"), 1U);
  EXPECT_EQ(markers(picture), 2 * 3 * 3 + 3 + 2 + 1);
}

TEST(TimeVsN, LabelsTheLastSizeAndDrawsNoPanelOfOneSize) {
  std::vector<Record> records = grid();
  add_records(records, "column_generation", 7, 200, {1, 2, 3});
  const std::multiset<std::string> texts = labels(svg("time_vs_N", records));
  EXPECT_EQ(texts.count("800"), 2U) << "below each panel";
  EXPECT_EQ(texts.count("n = 7"), 0U);
}

TEST(TimeVsN, HasTheWidthOfThePagesColumns) {
  FigureOptions options;
  EXPECT_NE(svg("time_vs_N", grid(), options).find("width=\"687\""), std::string::npos);
  options.size = FigureSize::single;
  EXPECT_NE(svg("time_vs_N", grid(), options).find("width=\"336\""), std::string::npos);
}

TEST(TimeVsDimension, HasAPanelForEachNumberOfPoints) {
  const std::string picture = svg("time_vs_dimension", grid());
  const std::multiset<std::string> texts = labels(picture);
  for (const char* once : {"N = 200", "N = 400", "N = 800", "n, dimension"})
    EXPECT_EQ(texts.count(once), 1U) << once;
  for (const char* each : {"3", "4"}) EXPECT_EQ(texts.count(each), 3U) << "under each panel: " << each;
  EXPECT_EQ(markers(picture), 3 * 2 * 3 + 3);
}

TEST(WrongShare, HasAPanelForEachPlaceAndAPointForEachMethod) {
  std::vector<Record> records;
  for (const char* place : {"near", "overlap"}) {
    for (const char* method : {"column_generation", "fcl_libccd"}) {
      for (int repetition = 0; repetition < 3; ++repetition) {
        records.push_back(testing::record(method, 3, 20, repetition, 1e-3));
        records.back().generator = "bodies";
        records.back().generator_parameters =
            std::string("kind_1=ball kind_2=ball place=") + place + " scale=1";
      }
    }
  }
  records.back().status = DistanceStatus::precision_limit;
  const std::string picture = svg("wrong_share", records);
  const std::multiset<std::string> texts = labels(picture);
  for (const char* once :
       {"near", "overlap", "all places", "wrong answers, %", "some solves without an answer"})
    EXPECT_EQ(texts.count(once), 1U) << once;
  // A point of each method in each of 3 panels and in the legend; crosses in two panels and in the legend.
  EXPECT_EQ(markers(picture), 3 * 2 + 2 + 2 + 1);
  EXPECT_EQ(message_of<FigureNeedsError>([] { svg("wrong_share", grid()); }),
            "figure wrong_share needs answers that do not agree with a proof");
}

TEST(PerformanceProfileFigure, NamesEveryMethodAndDrawsTheShareFromZeroToOne) {
  const std::multiset<std::string> texts = labels(svg("performance_profile", grid()));
  for (const char* once : {"column_generation", "zheng_yamane", "glpk_dual", "share of instances solved"})
    EXPECT_EQ(texts.count(once), 1U) << once;
}

TEST(CrossoverFigure, WritesTheLeadIntoEachCellAndNamesTheWinner) {
  const std::multiset<std::string> texts = labels(svg("crossover", grid()));
  EXPECT_EQ(texts.count("3.0"), 6U)
      << "column_generation leads zheng_yamane by the median of 2.2, 3 and 3.6 times";
  EXPECT_EQ(texts.count("column_generation"), 1U) << "in the key";
  EXPECT_EQ(texts.count("glpk_dual"), 0U) << "wins nowhere";
}

TEST(PerformanceProfileFigure, HasFewTicksHoweverLongItsAxisIs) {
  std::vector<Record> records = grid();
  for (Record& record : records)
    if (record.method == "glpk_dual") record.seconds *= 1e6;
  const std::multiset<std::string> texts = labels(svg("performance_profile", records));
  std::ptrdiff_t powers = 0;
  for (const std::string& text : texts)
    powers += text.starts_with("1") && text.find("0") != std::string::npos ? 1 : 0;
  EXPECT_LE(powers, 9);
  EXPECT_EQ(texts.count("2"), 0U);
}

TEST(CrossoverFigure, TellsSeveralWinnersApartByLetters) {
  std::vector<Record> records = grid();
  for (Record& record : records)
    if (record.method == "glpk_dual" && record.N == 800) record.seconds = 1e-6;
  const std::multiset<std::string> texts = labels(svg("crossover", records));
  EXPECT_EQ(texts.count("a 3.0"), 4U);
  EXPECT_EQ(texts.count("a column_generation"), 1U);
  EXPECT_EQ(texts.count("b glpk_dual"), 1U);
}

TEST(RatioHeatmap, WritesThePercentageIntoEachCell) {
  const std::string picture = svg("ratio_heatmap", grid());
  const std::multiset<std::string> texts = labels(picture);
  EXPECT_EQ(texts.count("10"), 6U + 1) << "six cells of column_generation, and a tick of the scale";
  EXPECT_EQ(texts.count("30"), 6U) << "six cells of zheng_yamane";
  EXPECT_EQ(texts.count("column_generation"), 1U);
  EXPECT_EQ(texts.count("zheng_yamane"), 1U);
  EXPECT_EQ(texts.count("time, % of glpk_dual"), 1U);
}

/// Two families with a parameter that makes them harder, one without; column_generation is right, glpk_dual
/// is off by the parameter's millionth, and by an infinity once.
std::vector<Record> hard_records() {
  std::vector<Record> records;
  for (const char* family : {"thin aspect", "big offset", "plain kind"}) {
    const std::string words = family;
    for (const double value : {1.0, 100.0, 10000.0}) {
      add_records(records, "column_generation", 3, 200, {1});
      add_records(records, "glpk_dual", 3, 200, {1});
      add_records(records, "exact", 3, 200, {1});
      records.end()[-2].distance = 2 + 1e-6 * value;
      for (auto record = records.end() - 3; record != records.end(); ++record) {
        record->generator = words.substr(0, words.find(' '));
        record->generator_parameters = words.substr(words.find(' ') + 1) + "=" + std::to_string(value);
        *record = testing::with_facts(*record);
      }
    }
  }
  records[1].status = DistanceStatus::unreachable;
  return records;
}

TEST(TrueError, HasAPanelForEachFamilyWithAConditioningAndACurveForEachMethodButExact) {
  const std::string picture = svg("true_error", hard_records());
  const std::multiset<std::string> texts = labels(picture);
  for (const char* once :
       {"big: offset", "thin: aspect", "column_generation", "glpk_dual", "largest true error"})
    EXPECT_EQ(texts.count(once), 1U) << once;
  EXPECT_EQ(texts.count("exact"), 0U);
  // A marker for each point of 2 panels × 2 methods × 3 values, and one for each method in the legend.
  EXPECT_EQ(markers(picture), 2 * 2 * 3 + 2);
}

TEST(TrueError, HasNoPointWhereAMethodCameToNoAnswer) {
  std::vector<Record> records = hard_records();
  records[0].status = DistanceStatus::precision_limit;
  EXPECT_EQ(markers(svg("true_error", records)), 2 * 2 * 3 + 2 - 1);
}

TEST(TrueError, HasAPlaceForAnInfiniteParameter) {
  std::vector<Record> records = hard_records();
  for (Record& each : records)
    if (each.generator == "thin" && each.hardness == 10000) each.hardness = kInfinity;
  const std::string picture = svg("true_error", records);
  EXPECT_EQ(markers(picture), 2 * 2 * 3 + 2);
  EXPECT_EQ(labels(picture).count("∞"), 1U + 1U) << "of the errors, and of one panel's parameter";
}

TEST(TrueError, HasPanelsForEachTolerance) {
  std::vector<Record> records = hard_records();
  for (Record each : hard_records()) {
    each.tolerance = 1e-9;
    records.push_back(each);
  }
  const std::multiset<std::string> texts = labels(svg("true_error", records));
  for (const char* once : {"big: offset, ε = 1e-9", "big: offset, ε = 1e-6", "thin: aspect, ε = 1e-6"})
    EXPECT_EQ(texts.count(once), 1U) << once;
}

TEST(RatioHeatmap, TheScaleOfSimilarRatiosHasTwoNumbers) {
  std::vector<Record> records;
  for (const int N : {200, 400}) {
    add_records(records, "column_generation", 3, N, {N == 200 ? 0.331 : 0.497});
    add_records(records, "glpk_dual", 3, N, {1});
  }
  const std::multiset<std::string> texts = labels(svg("ratio_heatmap", records));
  EXPECT_EQ(texts.count("32"), 1U);
  EXPECT_EQ(texts.count("52"), 1U);
}

TEST(Figures, SayWhatTheyNeed) {
  const auto complaint = [](const std::string& figure, const std::vector<Record>& records,
                            const FigureOptions& options = {}) {
    return message_of<FigureNeedsError>([&] { svg(figure, records, options); });
  };
  std::vector<Record> records;
  add_records(records, "column_generation", 3, 200, {1, 2, 3});
  EXPECT_EQ(complaint("time_vs_N", records),
            "figure time_vs_N needs solved records at two or more values of N");
  EXPECT_EQ(complaint("ratio_heatmap", records),
            "figure ratio_heatmap needs a method that is a baseline; or name one with --baseline");
  EXPECT_EQ(complaint("true_error", records),
            "figure true_error needs answers of known truth at two or more values of a generator's measure "
            "of hardness, as aspect or 1/delta");
  EXPECT_EQ(complaint("time_vs_dimension", records),
            "figure time_vs_dimension needs solved records at two or more values of n");
  EXPECT_EQ(complaint("performance_profile", records),
            "figure performance_profile needs records of two or more methods");
  EXPECT_EQ(complaint("crossover", records), "figure crossover needs solved records of two or more methods");
  add_records(records, "glpk_dual", 3, 200, {1, 2, 3});
  for (const char* map : {"ratio_heatmap", "crossover"})
    EXPECT_NE(complaint(map, records).find("there is one cell"), std::string::npos) << map;
  EXPECT_EQ(complaint("time_vs_N", {}), "figure time_vs_N: no records");
  FigureOptions options;
  options.filter = Filter("n==7");
  EXPECT_EQ(complaint("time_vs_N", records, options), "figure time_vs_N: no record passes the filter 'n==7'");
  records = grid();
  for (std::size_t i = 0; i < 9; ++i) records[i].tolerance = 1e-3 * static_cast<double>(1 + i);
  EXPECT_EQ(
      complaint("ratio_heatmap", records),
      "figure ratio_heatmap draws a page for each generator, its parameters and tolerance, and there are 10 "
      "(ε = 1e-3; ε = 2e-3; ε = 3e-3; …); choose with --where");
}

TEST(Maps, HaveAPageForEachProblem) {
  std::vector<Record> records = grid();
  for (Record record : grid()) {
    record.generator_parameters = "separation=3";
    records.push_back(record);
  }
  for (const char* name : {"ratio_heatmap", "crossover"}) {
    const std::vector<std::string> pages = draw(figure_named(name), records, {}, ImageFormat::svg);
    ASSERT_EQ(pages.size(), 2U) << name;
    EXPECT_NE(pages[0].find("separation=1.5: "), std::string::npos) << name;
    EXPECT_NE(pages[1].find("separation=3: "), std::string::npos) << name;
    EXPECT_NE(pages[1].find("page 2 of 2"), std::string::npos) << name;
    FigureOptions options;
    options.filter = Filter("separation==3");
    EXPECT_EQ(draw(figure_named(name), records, options, ImageFormat::svg).size(), 1U) << name;
  }
}

TEST(Figures, AreFoundByName) {
  EXPECT_EQ(figure_named("time_vs_N").name, "time_vs_N");
  EXPECT_NE(message_of<UnknownNameError>([] { figure_named("ratio_heat_map"); })
                .find("unknown figure 'ratio_heat_map'; did you mean 'ratio_heatmap'? (known: time_vs_N "
                      "time_vs_dimension ratio_heatmap performance_profile crossover true_error fig5 fig7 "
                      "work_precision wrong_share)"),
            std::string::npos);
  EXPECT_EQ(figure_size_from_string("double"), FigureSize::double_wide);
  EXPECT_THROW(figure_size_from_string("huge"), UnknownNameError);
}

TEST(TimeVsN, HasAPanelForEveryGenerator) {
  std::vector<Record> records = grid();
  for (Record record : grid()) {
    record.generator = "clusters";
    records.push_back(record);
  }
  const std::multiset<std::string> texts = labels(svg("time_vs_N", records));
  for (const char* once : {"clusters (separation=1.5), n = 3", "example2 (separation=1.5), n = 4"})
    EXPECT_EQ(texts.count(once), 1U) << once;
}

TEST(Figures, SayWhatTheyShowAndHowLargeTheyAre) {
  const std::string picture = svg("time_vs_N", grid());
  EXPECT_NE(picture.find("<title>time_vs_N</title>"), std::string::npos);
  EXPECT_NE(picture.find("<desc>median time of a solve against N"), std::string::npos);
  EXPECT_NE(picture.find("<svg role=\"img\""), std::string::npos);
  const std::string png = draw(figure_named("time_vs_N"), grid(), {}, ImageFormat::png).front();
  // 300 pixels an inch are 11811 a metre: 0x2E23.
  EXPECT_EQ(png.substr(33, 21),
            std::string("\0\0\0\x09pHYs\0\0\x2E\x23\0\0\x2E\x23\x01", 17) + png.substr(50, 4));
}

TEST(Figures, ThatAreHigherThanAPageGoOnOnTheNext) {
  std::vector<Record> records;
  for (int n = 3; n < 60; ++n)
    for (const int N : {200, 400}) add_records(records, "column_generation", n, N, {1, 2, 3});
  const std::vector<std::string> pages = draw(figure_named("time_vs_N"), records, {}, ImageFormat::svg);
  ASSERT_GE(pages.size(), 2U);
  EXPECT_NE(pages[1].find(", page 2 of "), std::string::npos);
  std::size_t panels = 0;
  for (const std::string& page : pages) {
    for (const std::string& text : labels(page)) panels += text.starts_with("n = ") ? 1 : 0;
    EXPECT_EQ(labels(page).count("column_generation"), 1U);
  }
  EXPECT_EQ(panels, 57U);
}

}  // namespace
}  // namespace raygauge::test_figures
