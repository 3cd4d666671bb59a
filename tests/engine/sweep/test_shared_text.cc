// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <vector>

#include "raygauge/sweep/record.h"

namespace raygauge {
namespace {

TEST(SharedText, IsTheTextThatItWasMadeOf) {
  const SharedText text = std::string("separation=1.5");
  EXPECT_EQ(text.str(), "separation=1.5");
  EXPECT_TRUE(text == "separation=1.5");
  EXPECT_FALSE(text == std::string("separation=2"));
  EXPECT_EQ("[" + text, "[separation=1.5");
  EXPECT_TRUE(SharedText().empty());
  EXPECT_EQ(SharedText(), SharedText(""));
}

TEST(SharedText, IsKeptOnce) {
  EXPECT_EQ(&SharedText("glpk_dual").str(), &SharedText(std::string("glpk_") + "dual").str());
  EXPECT_FALSE(SharedText("a") == SharedText("b"));
  EXPECT_TRUE(SharedText("a") < SharedText("b"));
  EXPECT_FALSE(SharedText("a") < SharedText("a"));
  EXPECT_EQ(sizeof(SharedText), sizeof(void*));
}

TEST(SharedText, IsKeptOnceByManyThreads) {
  std::vector<const std::string*> places(8);
  std::vector<std::thread> threads;
  for (const std::string*& place : places) {
    threads.emplace_back([&place] {
      for (int i = 0; i < 1000; ++i) place = &SharedText("of many threads " + std::to_string(i)).str();
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::string* place : places) EXPECT_EQ(place, places.front());
}

}  // namespace
}  // namespace raygauge
