// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/cli/program.h"
#include "tests/results/support.h"

namespace raygauge::testing {

/// The corners of the square [-1, 1]^2: the unit ball of the maximum norm.
inline constexpr const char* kSquare = "1 1\n1 -1\n-1 1\n-1 -1\n";
/// The unit ball of the 1-norm in the plane.
inline constexpr const char* kDiamond = "1 0\n-1 0\n0 1\n0 -1\n";

/// An experiment file: `head`, then `sweep` in the table [sweep], over Example 2 by column_generation and
/// zheng_yamane, then `tail`.
inline std::string example2_experiment(const std::string& head, const std::string& sweep,
                                       const std::string& tail = "") {
  return head + "[sweep]\n" + sweep +
         "[[generator]]\nname = \"example2\"\n[[method]]\nname = \"column_generation\"\n[[method]]\nname = "
         "\"zheng_yamane\"\n" +
         tail;
}

/// Runs raygauge in a folder of the test's own.
class ProgramTest : public ::testing::Test {
 protected:
  void write(const std::string& name, const std::string& bytes) const {
    write_bytes(folder_.file(name), bytes);
  }

  ProgramResult run_raygauge(const std::vector<std::string>& arguments, const std::string& input = "") const {
    return run_program(folder_.path(), arguments, input);
  }

  TemporaryFolder folder_;
};

/// Runs `raygauge distance` on sets written as text.
class DistanceProgram : public ProgramTest {
 protected:
  ProgramResult run(const std::string& A, const std::string& Q,
                    const std::vector<std::string>& options = {}) {
    write("A.csv", A);
    write("Q.csv", Q);
    std::vector<std::string> arguments = {"distance", "A.csv", "Q.csv"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_raygauge(arguments);
  }

  nlohmann::ordered_json run_json(const std::string& A, const std::string& Q,
                                  std::vector<std::string> options = {}) {
    options.emplace_back("--json");
    const ProgramResult outcome = run(A, Q, options);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return nlohmann::ordered_json::parse(outcome.out);
  }

  /// A number of the output: infinity is written as a string.
  static double number(const nlohmann::ordered_json& value) {
    if (value == "inf") return std::numeric_limits<double>::infinity();
    return value.get<double>();
  }
};

/// Expects bad input: status 2, nothing on standard output, and this one line on standard error.
inline void expect_complaint(const ProgramResult& outcome, const std::string& line) {
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, line + "\n");
}

}  // namespace raygauge::testing
