// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/data/parameter_columns.h"

#include <gtest/gtest.h>

#include "analysis/data/filter.h"
#include "analysis/studies/pivot/pivot.h"
#include "raygauge/exceptions.h"
#include "tests/analysis/records.h"

namespace raygauge::test_parameter_columns {
namespace {

using testing::message_of;
using testing::record;

Record with(const std::string& generator, const std::string& parameters, const std::string& of_method = "") {
  Record result = record("glpk", 3, 200, 0, 1);
  result.generator = generator;
  result.generator_parameters = parameters;
  result.method_parameters = of_method;
  return result;
}

const std::vector<Record> kRecords = {with("example2", "separation=1.2", "presolve=true"),
                                      with("example2", "separation=3", "presolve=true"),
                                      with("example1", "distance=2 roles=cone_ellipsoid", "presolve=false")};

std::size_t count(const std::string& expression) { return filtered(kRecords, Filter(expression)).size(); }

TEST(ParameterColumns, AreNamedShortUnlessAColumnHasTheName) {
  EXPECT_EQ(parameter_names(kRecords),
            (std::vector<std::string>{"presolve", "roles", "separation", "generator.distance"}));
}

TEST(ParameterColumns, FilterAsNumbersAndAsTexts) {
  EXPECT_EQ(count("separation==3"), 1U);
  EXPECT_EQ(count("separation == 3.0"), 1U);
  EXPECT_EQ(count("separation<3"), 1U);
  EXPECT_EQ(count("separation!=3"), 2U) << "a record without the parameter passes != alone";
  EXPECT_EQ(count("presolve==true && separation>1"), 2U);
  EXPECT_EQ(count("roles=='cone_ellipsoid'"), 1U);
  EXPECT_EQ(count("generator.distance==2"), 1U);
  EXPECT_EQ(count("method.presolve==false"), 1U);
}

TEST(ParameterColumns, AnUnknownOneIsRefusedWithTheNamesThatThereAre) {
  const std::string message = message_of<UnknownNameError>([] { count("seperation==3"); });
  EXPECT_EQ(
      message.rfind(
          "filter 'seperation==3', character 1: unknown column 'seperation'; did you mean 'separation'?", 0),
      0U)
      << message;
}

TEST(ParameterColumns, MakeRowsInTheOrderOfNumbers) {
  std::vector<Record> records = {with("example2", "separation=10"), with("example2", "separation=3")};
  PivotOptions options;
  options.rows = {"separation"};
  const Pivot pivot = make_pivot(records, options);
  EXPECT_TRUE(pivot.split_by.empty());
  EXPECT_EQ(pivot.row_keys, (std::vector<std::vector<Value>>{{3.0}, {10.0}}));
}

TEST(ParameterColumns, VaryingOnesTellRecordsApart) {
  const VaryingParameters varying(kRecords);
  EXPECT_EQ(varying.of_generator(kRecords[0]), "separation=1.2");
  EXPECT_EQ(varying.of_generator(kRecords[2]), "");
  EXPECT_EQ(varying.of_method(kRecords[2]), "presolve=false");
}

TEST(ParameterColumns, FilesOfAPairAreToldApartByItsName) {
  const std::vector<Record> records = {with("files", "A=a.off Q=q.off content_A=0f pair=a-q scale_A=1"),
                                       with("files", "A=a.off Q=q.off content_A=0f pair=a-q scale_A=2"),
                                       with("files", "A=b.off Q=q.off content_A=1f pair=b-q scale_A=1")};
  const VaryingParameters varying(records);
  EXPECT_EQ(varying.of_generator(records[1]), "pair=a-q scale_A=2");
  EXPECT_EQ(varying.of_generator(records[2]), "pair=b-q scale_A=1");
}

TEST(TidyCsv, HasAColumnForEachParameter) {
  const std::string csv = tidy_csv({with("files", "A=\"a,b.csv\" pair=x", "k=1")});
  const std::string heading = csv.substr(0, csv.find('\n'));
  EXPECT_TRUE(heading.starts_with("cell,session,generator,")) << heading;
  EXPECT_TRUE(heading.ends_with(",A,k,pair")) << heading;
  EXPECT_TRUE(csv.ends_with(",\"a,b.csv\",1,x\n")) << csv;
}

}  // namespace
}  // namespace raygauge::test_parameter_columns
