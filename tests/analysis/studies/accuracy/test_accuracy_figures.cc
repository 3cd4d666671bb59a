// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// fig5, fig7 and work_precision.
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "analysis/studies/figures.h"
#include "tests/analysis/records.h"

namespace raygauge::test_accuracy_figures {
namespace {

using testing::message_of;
using testing::record;

std::vector<Record> solves(const std::string& roles) {
  std::vector<Record> records;
  for (const char* method : {"zheng_yamane", "nlopt_slsqp"}) {
    for (const double tolerance : {1e-2, 1e-6, 1e-10}) {
      Record each = record(method, 3, 1, 0, 1e-3 / tolerance);
      each.generator = "example1";
      each.generator_parameters = "distance=2 roles=" + roles;
      each.tolerance = tolerance;
      each.distance = each.upper = 2 + tolerance;
      each.lower = 2;
      if (each.method == "zheng_yamane") each.counters.ray_iterations = 20;
      records.push_back(each);
    }
  }
  return records;
}

std::string picture_of(const std::string& figure, const std::vector<Record>& records) {
  return draw(figure_named(figure), records, {}, ImageFormat::svg).front();
}

void expect_texts(const std::string& picture, std::initializer_list<const char*> texts) {
  for (const char* text : texts) EXPECT_NE(picture.find(text), std::string::npos) << text;
}

std::size_t count_of(const std::string& picture, const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = picture.find(text); at != std::string::npos; at = picture.find(text, at + 1)) ++count;
  return count;
}

TEST(Example1Figures, HaveThePapersThreePanelsAndItsNumbers) {
  for (const auto& [figure, roles] : {std::pair{"fig5", "cone_ellipsoid"}, {"fig7", "ellipsoid_cone"}}) {
    const std::string picture = picture_of(figure, solves(roles));
    expect_texts(picture, {"(a) mean error", "(b) mean time, s", "(c) mean N_rs", "tolerance ε",
                           "zheng_yamane", "nlopt_slsqp", "paper"});
    for (const char* exponent : {">-10<", ">-6<", ">-2<"})
      EXPECT_GE(count_of(picture, exponent), 3U) << "a tolerance under each panel: " << exponent;
  }
}

TEST(Example1Figures, NameEveryMethodInTheLegendHoweverLongTheNames) {
  std::vector<Record> records = solves("cone_ellipsoid");
  for (const char* method : {"zheng_yamane_published", "newton", "column_generation", "clp_dual"}) {
    for (Record each : solves("cone_ellipsoid")) {
      each.method = method;
      records.push_back(each);
    }
  }
  FigureOptions options;
  options.size = FigureSize::single;
  const std::string picture = draw(figure_named("fig5"), records, options, ImageFormat::svg).front();
  expect_texts(picture, {">zheng_yamane<", ">zheng_yamane_published<", ">clp_dual<", ">paper<"});
  EXPECT_EQ(picture.find("translate(-"), std::string::npos) << "something stands outside the picture";
}

TEST(Example1Figures, SayWhatTheyNeed) {
  EXPECT_EQ(message_of<FigureNeedsError>([] { picture_of("fig7", solves("cone_ellipsoid")); }),
            "figure fig7 needs records of generator example1 in its roles at two tolerances");
}

TEST(WorkPrecision, DrawsErrorAndGapOfEachGroup) {
  const std::string picture = picture_of("work_precision", solves("cone_ellipsoid"));
  expect_texts(picture, {"example1, n = 3, N = 1: error", "example1, n = 3, N = 1: gap",
                         "median time of a solve, s", "zheng_yamane", "nlopt_slsqp"});
}

TEST(WorkPrecision, PutsErrorsAndGapsBeyondTheScaleAtInfinity) {
  std::vector<Record> records = solves("cone_ellipsoid");
  records[0].distance = 1e6;
  records[1].lower = std::numeric_limits<double>::quiet_NaN();
  const std::string picture = picture_of("work_precision", records);
  expect_texts(picture, {">∞<"});
  const std::string whole = picture_of("work_precision", solves("cone_ellipsoid"));
  const auto markers = [](const std::string& text) {
    std::size_t count = 0;
    for (std::size_t at = text.find("<use xlink"); at != std::string::npos;
         at = text.find("<use xlink", at + 1))
      ++count;
    return count;
  };
  EXPECT_EQ(markers(picture), markers(whole) + 2 + 1)
      << "no point vanishes; the wrong one is crossed in both panels, and the legend says so";
}

TEST(AccuracyFigures, SayThatNothingPassesAFilter) {
  FigureOptions options;
  options.filter = Filter("n==7");
  for (const char* name : {"fig5", "work_precision"}) {
    EXPECT_EQ(message_of<FigureNeedsError>(
                  [&] { draw(figure_named(name), solves("cone_ellipsoid"), options, ImageFormat::svg); }),
              std::string("figure ") + name + ": no record passes the filter 'n==7'");
  }
}

TEST(WorkPrecision, NeedsATruth) {
  std::vector<Record> records = solves("cone_ellipsoid");
  for (Record& each : records) each.exact_distance = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(message_of<FigureNeedsError>([&] { picture_of("work_precision", records); }),
            "no such exception");
  EXPECT_NE(message_of<FigureNeedsError>([&] { picture_of("work_precision", {}); }), "no such exception");
}

}  // namespace
}  // namespace raygauge::test_accuracy_figures
