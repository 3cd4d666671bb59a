// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/ladder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

namespace raygauge::test_ladder {
namespace {

TEST(Ladder, TableIsTheOneInTheReadme) {
  std::ifstream file(RAYGAUGE_QUERIES "/README.md");
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const std::string table = Ladder::table();
  EXPECT_NE(text.find(table), std::string::npos) << "engine/queries/README.md lacks this table:\n" << table;
}

}  // namespace
}  // namespace raygauge::test_ladder
