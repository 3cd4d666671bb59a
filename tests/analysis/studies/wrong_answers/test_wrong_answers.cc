// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/wrong_answers/wrong_answers.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "analysis/constants.h"
#include "raygauge/exceptions.h"
#include "tests/analysis/records.h"

namespace raygauge::test_wrong_answers {
namespace {

using testing::message_of;

/// An answer about a ball and a box of size 10 at a planted distance.
Record answer(const std::string& method, const std::string& place, int repetition, double distance,
              double planted) {
  Record record = testing::record(method, 3, 20, repetition, 1);
  record.generator = "bodies";
  record.generator_parameters = "kind_1=ball kind_2=box place=" + place + " scale=10";
  record.exact_distance = planted;
  record.exact_distance_rounding = 1e-14;
  record.distance = distance;
  record.status = distance > 0 ? DistanceStatus::optimal : DistanceStatus::contains_origin;
  record.lower = record.upper = planted;
  return record;
}

Verdict verdict(const Record& record) { return verdict_on(record, KnownDistances({record})(record)); }

TEST(WrongAnswers, AreOffByAMillionthOfTheSize) {
  EXPECT_EQ(verdict(answer("fcl_libccd", "near", 0, 2, 2)), Verdict::right);
  EXPECT_EQ(verdict(answer("fcl_libccd", "near", 0, 2 + 9e-6, 2)), Verdict::right);
  EXPECT_EQ(verdict(answer("fcl_libccd", "near", 0, 2 + 11e-6, 2)), Verdict::inexact);
  EXPECT_EQ(verdict(answer("fcl_libccd", "near", 0, 2 - 11e-6, 2)), Verdict::inexact);
  EXPECT_NEAR(error_in_sizes(answer("fcl_libccd", "near", 0, 3, 2), {2, 2}), 0.1, 1e-15);
}

TEST(WrongAnswers, HaveTheWrongSignWhereBodiesApartAreSaidToMeetOrTheReverse) {
  EXPECT_EQ(verdict(answer("fcl_libccd", "near", 0, 0, 1e-6)), Verdict::wrong_sign);
  EXPECT_EQ(verdict(answer("fcl_libccd", "overlap", 0, 1e-6, 0)), Verdict::wrong_sign);
  EXPECT_EQ(verdict(answer("fcl_libccd", "overlap", 0, 0, 0)), Verdict::right);
  EXPECT_EQ(verdict(answer("fcl_libccd", "overlap", 0, 1e-9, 0)), Verdict::right) << "1e-10 of the size";
}

TEST(WrongAnswers, AreNoneWhereThereIsNoAnswer) {
  Record record = answer("fcl_libccd", "near", 0, 0, 1);
  record.status = DistanceStatus::precision_limit;
  EXPECT_EQ(verdict(record), Verdict::gave_up);
  record.status = DistanceStatus::time_limit;
  EXPECT_EQ(verdict(record), Verdict::limit);
}

TEST(WrongAnswers, AreRefutedByProofsWhereNothingIsPlanted) {
  std::vector<Record> records = {answer("object_distance", "near", 0, 2, kNaN),
                                 answer("newton", "near", 0, 2, kNaN),
                                 answer("fcl_libccd", "near", 0, 3, kNaN)};
  records[0].lower = 2 - 1e-6;
  records[0].upper = 2.5;
  records[1].lower = kNaN;
  records[1].upper = 2 + 1e-6;
  records[2].lower = records[2].upper = 3;  // what a competitor proves is not asked
  const KnownDistance known = KnownDistances(records)(records[2]);
  EXPECT_EQ(known.lower, 2 - 1e-6);
  EXPECT_EQ(known.upper, 2 + 1e-6);
  EXPECT_EQ(verdict_on(records[2], known), Verdict::inexact);
}

std::vector<Record> sample() {
  std::vector<Record> records = {
      answer("object_distance", "near", 0, 2, 2),    answer("fcl_libccd", "near", 0, 2.5, 2),
      answer("object_distance", "near", 1, 2, 2),    answer("fcl_libccd", "near", 1, 0, 2),
      answer("object_distance", "overlap", 0, 0, 0), answer("fcl_libccd", "overlap", 0, 0, 0)};
  records[5].status = DistanceStatus::precision_limit;
  return records;
}

TEST(WrongAnswers, AreCountedByPlaceAndKind) {
  const WrongStudy study = wrong_answers(sample());
  ASSERT_EQ(study.places.size(), 3U);
  EXPECT_EQ(study.places[0].place, "near");
  EXPECT_EQ(study.places[2].place, "");
  const WrongAnswers& fcl = study.places[0].methods.at(1);
  EXPECT_EQ(fcl.method, "fcl_libccd");
  EXPECT_EQ(fcl.asked, 2U);
  EXPECT_EQ(fcl.inexact, 1U);
  EXPECT_EQ(fcl.wrong_sign, 1U);
  EXPECT_NEAR(fcl.worst, 0.2, 1e-12);
  EXPECT_EQ(study.places[1].methods.at(1).gave_up, 1U);
  EXPECT_EQ(study.places[2].methods.at(0).wrong(), 0U);
  EXPECT_NEAR(study.places[2].methods.at(1).wrong_share(), 2.0 / 3, 1e-15);
  ASSERT_EQ(study.places[0].kinds.size(), 2U);
  EXPECT_EQ(study.places[0].kinds[0].first, "ball");
  EXPECT_EQ(study.places[0].kinds[1].second.at(1).wrong(), 2U) << "the pair counts for both kinds";
}

TEST(WrongAnswers, AreReadAsTwoTables) {
  const std::vector<Table> tables = wrong_answers_tables(wrong_answers(sample()));
  ASSERT_EQ(tables.size(), 2U);
  EXPECT_NE(
      render(tables[0]).find("near     object_distance      2      0      0           0        0      0"),
      std::string::npos)
      << render(tables[0]);
  EXPECT_NE(
      render(tables[0]).find("         fcl_libccd           2      2  100 %           1        0      0"),
      std::string::npos);
  EXPECT_NE(render(tables[1]).find("near     ball                0       100 %"), std::string::npos)
      << render(tables[1]);
  const Table all = wrong_answers_long_table(wrong_answers(sample()));
  EXPECT_EQ(all.rows.size(), 3U * 3U * 2U);
}

TEST(WrongAnswers, OfOtherQuantitiesHaveTheirOwnSignAndTheirOwnTables) {
  const auto asked = [](const std::string& quantity, double found, double planted) {
    Record record = answer("object_distance", "near", 0, found, planted);
    record.generator_parameters = record.generator_parameters + " quantity=" + quantity;
    return record;
  };
  EXPECT_EQ(verdict(asked("growth", 1 - 1e-7, 1 + 1e-7)), Verdict::wrong_sign);
  EXPECT_EQ(verdict(asked("growth", 0.5, 0.7)), Verdict::inexact);
  EXPECT_EQ(verdict(asked("growth", 0.5 + 1.1e-6, 0.5)), Verdict::inexact) << "whatever the size";
  EXPECT_EQ(verdict(asked("growth", 3 + 2.9e-6, 3)), Verdict::right) << "relative to a larger one";
  EXPECT_EQ(verdict(asked("depth", 0, 0.1)), Verdict::wrong_sign);
  EXPECT_EQ(verdict(asked("depth", 0.1 + 9e-6, 0.1)), Verdict::right) << "of a size of 10";
  EXPECT_EQ(verdict(asked("separated", 1, 0)), Verdict::wrong_sign);
  EXPECT_EQ(verdict(asked("separated", 1, 1)), Verdict::right);
  const WrongStudy study = wrong_answers({asked("depth", 0.1, 0.1), answer("fcl_libccd", "near", 0, 2, 2)});
  const std::vector<Table> tables = wrong_answers_tables(study);
  ASSERT_EQ(tables.size(), 4U);
  EXPECT_EQ(tables[0].title, "Who is wrong at tolerance 1e-6");
  EXPECT_EQ(tables[2].title, "Who is wrong, quantity depth at tolerance 1e-6");
  EXPECT_EQ(tables[3].header[0].size(), 3U) << "the methods that answer it";
}

TEST(WrongAnswers, NeedRecordsOfTwoBodies) {
  EXPECT_EQ(message_of<EmptySetError>([] { wrong_answers({testing::record("fcl_libccd", 3, 20, 0, 1)}); }),
            "no record of the generator bodies passes the filter");
}

}  // namespace
}  // namespace raygauge::test_wrong_answers
