// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// What the C interface adds to a call: the same queries by C++ and by raygauge_c, in turn, nanoseconds of CPU
// time. The engine is the same code, linked once into this program and once into the library.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/raygauge_c.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"

namespace {

using namespace raygauge;
using Eigen::Vector3d;

constexpr int kCalls = 20'000;
constexpr int kRounds = 31;

double nanoseconds() {
  std::timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

template <class Call>
double time_of(const Call& call) {
  const double start = nanoseconds();
  for (int i = 0; i < kCalls; ++i) call();
  return (nanoseconds() - start) / kCalls;
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + kRounds / 2, values.end());
  return values[kRounds / 2];
}

/// Prints the medians of both, and of their difference.
template <class Cpp, class C>
void row(const char* name, const Cpp& in_cpp, const C& in_c) {
  std::vector<double> cpp, c, more;
  for (int round = 0; round < kRounds; ++round) {
    const bool c_first = round % 2 == 1;
    double one = c_first ? time_of(in_c) : time_of(in_cpp);
    double two = c_first ? time_of(in_cpp) : time_of(in_c);
    cpp.push_back(c_first ? two : one);
    c.push_back(c_first ? one : two);
    more.push_back(c.back() - cpp.back());
  }
  std::printf("%-28s C++ %7.1f ns   C %7.1f ns   %+6.1f ns a call\n", name, median(cpp), median(c),
              median(more));
}

void check(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "raygauge_c_calls: %s: %s\n", what, rg_last_message());
  std::exit(1);
}

void pair_rows(const char* name, const ConvexSet& A, const ConvexSet& B, const rg_pair& pair) {
  const Ball Q(Vector3d::Zero(), 1);
  ObjectDistanceSolver objects;
  GrowthDistanceSolver growth;
  WarmStart warm;
  rg_solver* solver = nullptr;
  rg_warm* c_warm = nullptr;
  check(rg_solver_create(&solver) == RG_OK && rg_warm_create(1, &c_warm) == RG_OK, "a solver");
  rg_answer answer{};
  double sum = 0;
  const auto title = [&](const char* query) {
    static std::array<char, 64> text;
    std::snprintf(text.data(), text.size(), "%s, %s", name, query);
    return text.data();
  };
  row(
      title("distance"), [&] { sum += objects.solve({A}, {B}, Q).distance.distance; },
      [&] {
        rg_object_distance(solver, &pair, nullptr, 0, nullptr, &answer);
        sum -= answer.distance;
      });
  row(
      title("warm"), [&] { sum += objects.solve({A}, {B}, Q, ObjectEffects::none, &warm).distance.distance; },
      [&] {
        rg_object_distance(solver, &pair, nullptr, 0, c_warm, &answer);
        sum -= answer.distance;
      });
  row(
      title("growth"), [&] { sum += growth.solve_about_centers({A}, {B}).distance; },
      [&] {
        rg_growth_distance(solver, &pair, nullptr, &answer);
        sum -= answer.distance;
      });
  check(std::abs(sum) < 1e-3, "C and C++ differ");
  rg_warm_free(c_warm);
  rg_solver_free(solver);
}

}  // namespace

int main() {
  const Vector3d o(0, 0, 0), up(0.2, 0.3, 2), low(3, -1, -1), high(4, 1, 1), far(5, 1, 0);
  rg_set *ball = nullptr, *other = nullptr, *capsule = nullptr, *box = nullptr;
  check(rg_set_ball(3, o.data(), 1, &ball) == RG_OK && rg_set_ball(3, far.data(), 2, &other) == RG_OK &&
            rg_set_capsule(3, o.data(), up.data(), 0.5, &capsule) == RG_OK &&
            rg_set_box(3, low.data(), high.data(), &box) == RG_OK,
        "a set");
  pair_rows("ball-ball", Ball(o, 1), Ball(far, 2), {ball, nullptr, other, nullptr});
  pair_rows("capsule-box", Capsule(o, up, 0.5), Box(low, high), {capsule, nullptr, box, nullptr});
  for (rg_set* set : {ball, other, capsule, box}) rg_set_free(set);
  return 0;
}
