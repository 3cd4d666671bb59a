// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Prints what a method certifies of every hard family: the table of docs/numerics.md.
//
//   raygauge_stability_table [METHOD [TOLERANCE [POINTS [REPETITIONS [SEED]]]]]
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "raygauge/queries/solver.h"
#include "tests/generators/points_of.h"
#include "tests/hard/hard_cases.h"

namespace raygauge {
namespace {

struct Settings {
  DistanceOptions options;
  int points = 100;
  int repetitions = 5;
  std::uint64_t seed = 3;
};

struct Row {
  int solves = 0;
  int certified = 0;
  int false_certificates = 0;
  int settled_exactly = 0;
  double worst_width = 0;
  std::vector<double> microseconds;
};

bool is_false(const DistanceResult& result, const Instance& instance, bool rounded) {
  if (!instance.exact_distance) return false;
  const double exact = *instance.exact_distance;
  const double above = rounded ? std::nextafter(exact, std::numeric_limits<double>::infinity()) : exact;
  const double below = rounded ? std::nextafter(exact, 0.0) : exact;
  return !(result.lower <= above && below <= result.upper);
}

bool is_certified(DistanceStatus status) {
  return status == DistanceStatus::optimal || status == DistanceStatus::contains_origin ||
         status == DistanceStatus::unreachable;
}

void measure(const HardCase& tested, int n, const Settings& settings, Row& row) {
  DistanceSolver solver(settings.options);
  for (int repetition = 0; repetition < settings.repetitions; ++repetition) {
    const Instance instance =
        generate(tested.generator, {settings.seed, n, settings.points, repetition}, tested.parameters);
    const auto begin = std::chrono::steady_clock::now();
    const DistanceResult& result = solver.solve(*instance.A, *instance.Q);
    const std::chrono::duration<double, std::micro> elapsed = std::chrono::steady_clock::now() - begin;
    row.microseconds.push_back(elapsed.count());
    ++row.solves;
    row.certified += is_certified(result.status) ? 1 : 0;
    row.false_certificates += is_false(result, instance, tested.rounded) ? 1 : 0;
    row.settled_exactly += result.counters.exact_pivots > 0 ? 1 : 0;
    if (result.status == DistanceStatus::optimal)
      row.worst_width = std::max(row.worst_width, (result.upper - result.lower) / result.upper);
  }
}

void print(const std::string& name, Row row) {
  std::sort(row.microseconds.begin(), row.microseconds.end());
  std::printf("| %-62s | %6d | %9d | %5d | %5d | %8.1e | %9.1f | %9.0f |\n", name.c_str(), row.solves,
              row.certified, row.false_certificates, row.settled_exactly, row.worst_width,
              row.microseconds[row.microseconds.size() / 2], row.microseconds.back());
}

void run(const Settings& settings) {
  constexpr int kLargestDimension = 50;
  std::printf("| %-62s | solves | certified | false | exact | width    | median us | worst us  |\n",
              "family");
  std::printf("| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  Row total;
  for (const auto& cases : {hard_cases(), hard_cases_of_unknown_distance(), smooth_hard_cases()}) {
    for (const HardCase& tested : cases) {
      Row row;
      for (const int n : dimensions_of(tested, kLargestDimension)) measure(tested, n, settings, row);
      print(label(tested), row);
      total.solves += row.solves;
      total.certified += row.certified;
      total.false_certificates += row.false_certificates;
      total.settled_exactly += row.settled_exactly;
      total.worst_width = std::max(total.worst_width, row.worst_width);
      total.microseconds.insert(total.microseconds.end(), row.microseconds.begin(), row.microseconds.end());
    }
  }
  print("all", total);
}

DistanceMethod method_from(const std::string& name) {
  for (const auto method :
       {DistanceMethod::column_generation, DistanceMethod::zheng_yamane, DistanceMethod::newton}) {
    if (to_string(method) == name) return method;
  }
  throw std::invalid_argument("no such method: " + name);
}

Settings settings_from(int count, char** arguments) {
  Settings settings;
  settings.options.tolerance = 1e-12;
  settings.options.time_limit = 60;
  if (count > 1) settings.options.method = method_from(arguments[1]);
  if (count > 2) settings.options.tolerance = std::stod(arguments[2]);
  if (count > 3) settings.points = std::stoi(arguments[3]);
  if (count > 4) settings.repetitions = std::stoi(arguments[4]);
  if (count > 5) settings.seed = std::stoull(arguments[5]);
  return settings;
}

}  // namespace
}  // namespace raygauge

int main(int count, char** arguments) {
  try {
    raygauge::run(raygauge::settings_from(count, arguments));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "raygauge_stability_table: %s\n", error.what());
    return 2;
  }
}
