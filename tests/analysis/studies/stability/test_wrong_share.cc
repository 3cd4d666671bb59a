// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/figures.h"
#include "analysis/studies/stability/wrong_share.h"

#include <gtest/gtest.h>

#include <regex>
#include <string>

#include "raygauge/exceptions.h"
#include "tests/analysis/records.h"

namespace raygauge::test_wrong_share {
namespace {

std::string picture_of(const std::vector<Record>& records) {
  return draw(figure_named("wrong_share"), records, {}, ImageFormat::svg).front();
}

/// Ten plans of each method; of the second three are wrong.
std::vector<Record> plans() {
  std::vector<Record> records;
  for (int k = 0; k < 10; ++k) {
    records.push_back(testing::record("column_generation", 7, 11, k, 100));
    records.push_back(testing::record("glpk_dual", 7, 11, k, 10));
    records.back().agrees = k >= 3;
    records.push_back(testing::record("exact", 7, 11, k, 1));
  }
  return records;
}

// Wilson (1927); the values of 3 of 10 and 0 of 10 are those of R's prop.test(correct = FALSE).
TEST(ShareInterval, IsWilsonsInterval) {
  EXPECT_NEAR(share_interval(3, 10).lower, 0.1077913, 1e-7);
  EXPECT_NEAR(share_interval(3, 10).upper, 0.6032219, 1e-7);
  EXPECT_EQ(share_interval(0, 10).lower, 0);
  EXPECT_NEAR(share_interval(0, 10).upper, 0.2775328, 1e-7);
  EXPECT_EQ(share_interval(10, 10).upper, 1);
  EXPECT_THROW(share_interval(0, 0), InvalidParameterError);
  EXPECT_THROW(share_interval(2, 1), InvalidParameterError);
}

TEST(WrongShare, DrawsAPointForEachMethodButOracles) {
  const std::string picture = picture_of(plans());
  for (const char* once :
       {"column_generation", "glpk_dual", "wrong answers, %", "median time of a solve, ms"})
    EXPECT_NE(picture.find(once), std::string::npos) << once;
  EXPECT_EQ(picture.find("exact"), std::string::npos);
  static const std::regex kMarker("<use xlink:href='#gpPt[0-9]+' transform='translate");
  EXPECT_EQ(
      std::distance(std::sregex_iterator(picture.begin(), picture.end(), kMarker), std::sregex_iterator()),
      2 + 2);  // and one for each in the legend
}

TEST(WrongShare, NeedsAnAnswerThatDoesNotAgree) {
  std::vector<Record> records = plans();
  for (Record& record : records) record.agrees = true;
  EXPECT_THROW(picture_of(records), FigureNeedsError);
  for (Record& record : records) {  // a search that found nothing is not wrong
    record.status = DistanceStatus::time_limit;
    record.agrees = false;
  }
  EXPECT_THROW(picture_of(records), FigureNeedsError);
}

}  // namespace
}  // namespace raygauge::test_wrong_share
