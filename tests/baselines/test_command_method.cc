// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/command_method.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

#include "raygauge/exceptions.h"
#include "raygauge/sets/point_set.h"

namespace raygauge::test_command_method {
namespace {

const std::string kPython = std::string(RAYGAUGE_PYTHON) + " " + RAYGAUGE_EXAMPLES + "/my_solver.py";

Instance instance(const Eigen::MatrixXd& A, const Eigen::MatrixXd& Q) {
  return {std::make_shared<PointSet>(A), std::make_shared<PointSet>(Q), std::nullopt};
}

/// A triangle and the unit ball of the 1-norm: d = 3.5.
Instance triangle() {
  return instance(Eigen::MatrixXd{{3, 4, 5}, {1, -1, 2}}, Eigen::MatrixXd{{1, -1, 0, 0}, {0, 0, 1, -1}});
}

std::unique_ptr<SolveMethod> method(const std::string& program, double load_limit = 60) {
  MethodRegistry registry("method");
  register_command_method(registry);
  return registry.make("command", {{"program", program}, {"load_limit", load_limit}});
}

DistanceResult answer_of(const std::string& program, const Instance& problem, double time_limit = 60) {
  const auto solver = method(program);
  solver->load(problem);
  solver->solve({1e-6, time_limit});
  return solver->result();
}

/// A program of the shell that takes three and four points of the plane and answers with `answer`.
std::string answering(const std::string& answer) {
  return "sh -c 'read h; for i in 1 2 3 4 5 6 7; do read p; done; echo ready; while read s; do " + answer +
         "; done'";
}

TEST(CommandMethod, CertifiesTheAnswerOfTheExampleInPython) {
  const DistanceResult result = answer_of(kPython, triangle());
  EXPECT_EQ(result.status, DistanceStatus::optimal);
  EXPECT_DOUBLE_EQ(result.distance, 3.5);
  EXPECT_NEAR(result.lower, 3.5, 1e-12);
  EXPECT_LE(result.lower, 3.5);
}

TEST(CommandMethod, CertifiesTheAnswerOfTheExampleInCxx) {
  const Eigen::MatrixXd A{{3, 4, 5}};
  const Eigen::MatrixXd Q{{-1, 2}};
  const DistanceResult result = answer_of(RAYGAUGE_MY_SOLVER, instance(A, Q));
  EXPECT_DOUBLE_EQ(result.distance, 1.5);
  EXPECT_NEAR(result.lower, 1.5, 1e-12);
}

TEST(CommandMethod, CertifiesTheUpperBoundFromThePointsThatMeet) {
  const DistanceResult result = answer_of(answering("echo 3.5 u -1 -0.5 a 0 1 q 0"), triangle());
  EXPECT_NEAR(result.lower, 3.5, 1e-12);
  EXPECT_NEAR(result.upper, 3.5, 1e-12);
  EXPECT_GE(result.upper, 3.5);
}

TEST(CommandMethod, AProgramMayStopWithTheBoundsThatItProves) {
  const DistanceResult result = answer_of(answering("echo time_limit 4 u -1 0 a 0 1 q 0"), triangle());
  EXPECT_EQ(result.status, DistanceStatus::time_limit);
  EXPECT_EQ(result.distance, 4);
  EXPECT_NEAR(result.lower, 3, 1e-12);  // the triangle lies right of x = 3
  EXPECT_NEAR(result.upper, 3.5, 1e-12);
  const DistanceResult nothing = answer_of(answering("echo iteration_limit inf"), triangle());
  EXPECT_EQ(nothing.status, DistanceStatus::iteration_limit);
  EXPECT_TRUE(std::isnan(nothing.lower));
}

TEST(CommandMethod, BelievesNoBoundThatIsNotProven) {
  const DistanceResult result = answer_of(answering("echo 9 u -0.5 0"), triangle());
  EXPECT_EQ(result.distance, 9);
  EXPECT_LE(result.lower, 3.5);
  EXPECT_TRUE(std::isnan(result.upper));
}

TEST(CommandMethod, EndsAtTheTimeLimitAndIsStartedAnew) {
  const auto solver = method(answering("sleep 30; echo 3.5"));
  for (int turn = 0; turn < 2; ++turn) {
    solver->load(triangle());
    const auto start = std::chrono::steady_clock::now();
    solver->solve({1e-6, 0.2});
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    EXPECT_EQ(solver->result().status, DistanceStatus::time_limit);
    EXPECT_LT(seconds, 5) << "and not 30";
  }
}

/// Whether the process has ended; one that nobody has waited for yet has.
bool has_ended(const std::string& process) {
  std::ifstream file("/proc/" + process + "/stat");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  return text.empty() || text.find(") Z ") != std::string::npos;
}

// Left running it would take a core from all solves that are timed after it.
// Bytes without a line end, for ever; and a program that, started anew, takes the points no sooner.
TEST(CommandMethod, EndsAtTheTimeLimitWhateverAProgramSends) {
  for (const std::string& late :
       {answering("cat /dev/zero"), answering("yes 2>/dev/null | tr -d \"\\n\" 2>/dev/null")}) {
    const auto solver = method(late);
    solver->load(triangle());
    const auto begin = std::chrono::steady_clock::now();
    solver->solve({1e-6, 0.3});
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
    EXPECT_EQ(solver->result().status, DistanceStatus::time_limit);
    EXPECT_LT(spent.count(), 2);
  }
}

TEST(CommandMethod, AProgramThatIsStartedAnewHasTheTimeLimitToTakeThePoints) {
  const std::filesystem::path mark =
      std::filesystem::temp_directory_path() / ("raygauge_command_" + std::to_string(::getpid()));
  const auto solver =
      method("sh -c 'if test -e " + mark.string() + "; then sleep 60; fi; touch " + mark.string() +
             "; for i in 0 1 2 3 4 5 6 7; do read p; done; echo ready; sleep 60'");
  solver->load(triangle());
  solver->solve({1e-6, 0.2});
  const auto begin = std::chrono::steady_clock::now();
  solver->solve({1e-6, 0.2});
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
  std::filesystem::remove(mark);
  EXPECT_EQ(solver->result().status, DistanceStatus::time_limit);
  EXPECT_LT(spent.count(), 5);
}

TEST(CommandMethod, WhatAProgramHasStartedEndsWithIt) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("raygauge_child_" + std::to_string(::getpid()));
  const auto solver = method(answering("sleep 30 & echo $! >" + path.string() + "; wait; echo 3.5"));
  solver->load(triangle());
  solver->solve({1e-6, 0.5});
  EXPECT_EQ(solver->result().status, DistanceStatus::time_limit);
  std::string process;
  std::ifstream(path) >> process;
  std::filesystem::remove(path);
  ASSERT_FALSE(process.empty());
  for (int look = 0; look < 500 && !has_ended(process); ++look)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_TRUE(has_ended(process));
}

TEST(CommandMethod, AProgramThatEndsHasNotSolved) {
  const DistanceResult result = answer_of(answering("exit 3"), triangle());
  EXPECT_EQ(result.status, DistanceStatus::precision_limit);
  EXPECT_TRUE(std::isnan(result.distance));
}

TEST(CommandMethod, SaysWhatIsWrongWithAProgram) {
  EXPECT_THROW(method(""), InvalidParameterError);
  EXPECT_THROW(method("/nowhere/solver 2>/dev/null")->load(triangle()), Error);
  EXPECT_THROW(method("sleep 30", 0.1)->load(triangle()), Error);
  for (const char* answer : {"echo soon", "echo -1", "echo 3.5 u 1", "echo 3.5 a 3", "echo 3.5 q 0.5",
                             "echo nan", "echo time_limit", "echo optimal 3.5", "echo precision_limit nan"})
    EXPECT_THROW(answer_of(answering(answer), triangle()), Error) << answer;
}

}  // namespace
}  // namespace raygauge::test_command_method
