// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// The table of speed targets, measured in one run: ratios to the best LP solver and to a streaming read.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include <string>
#include <utility>
#include <vector>

#include "bench/program.h"
#include "bench/ratio_rows.h"
#include "engine/kernels/kernel.h"

namespace raygauge::bench {
namespace {

using PrintRow = void (*)(const Variant&, const Effort&);
using Rows = std::vector<std::pair<std::string, PrintRow>>;
const Rows kRows = {{"grid", print_grid},
                    {"large", print_large},
                    {"n50", print_n50},
                    {"n100", print_n100},
                    {"high", print_high},
                    {"certified", print_certified},
                    {"degenerate", print_degenerate},
                    {"euclidean", print_euclidean},
                    {"shapes", print_shapes},
                    {"threads", print_threads},
                    {"memory", print_memory},
                    {"growth", print_growth}};

void add_degenerate_options(CLI::App& app, Effort& effort) {
  std::vector<std::string> families;
  for (const Variant& family : planted_variants()) families.push_back(family.name);
  app.add_option("--limit", effort.limits,
                 "limits in seconds, separated by commas: the row degenerate shows the bounds of solves that "
                 "end there, without competitors; none: a minute, with them")
      ->delimiter(',')
      ->check(CLI::Range(1e-3, 1e4));
  app.add_option("--families", effort.families,
                 "families of the row degenerate, separated by commas; none: all of them")
      ->delimiter(',')
      ->check(CLI::IsMember(families));
  app.add_option("--points", effort.points,
                 "points of the row degenerate, separated by commas; none: n + 2, 1.5 n, 2 n")
      ->delimiter(',')
      ->check(CLI::Range(2, 100000));
}

int run(int argc, char** argv) {
  std::vector<std::string> row_names;
  std::vector<std::string> variant_names;
  for (const auto& row : kRows) row_names.push_back(row.first);
  for (const Variant& variant : variants()) variant_names.push_back(variant.name);

  std::vector<std::string> rows = {"grid"};
  std::string variant = "random";
  Effort effort;
  CLI::App app{
      "Ratios of raygauge's solve times to the best LP solver and to a streaming read of the points."};
  app.option_defaults()->always_capture_default();
  app.add_option("--rows", rows, "rows to measure, separated by commas")
      ->delimiter(',')
      ->check(CLI::IsMember(row_names));
  app.add_option("--variant", variant, "kind of instances")->check(CLI::IsMember(variant_names));
  app.add_option("--instances", effort.instances, "instances a cell")->check(CLI::Range(1, 10000));
  app.add_option("--dimensions", effort.dimensions,
                 "dimensions of the rows high and degenerate, separated by commas; none: their own")
      ->delimiter(',')
      ->check(CLI::Range(2, 2000));
  app.add_flag("--processor-time", effort.processor_time,
               "the rows high, degenerate, shapes and euclidean in processor time, for machines that other "
               "work keeps busy");
  add_degenerate_options(app, effort);
  app.add_flag("--quick", effort.quick, "fewer cells, and 5 instances unless --instances is given");
  CLI11_PARSE(app, argc, argv);
  if (effort.quick && app.count("--instances") == 0) effort.instances = 5;

  std::printf("variant %s, %d instances a cell, %s, tolerance 1e-6\n", variant.c_str(), effort.instances,
              std::string(to_string(best_instruction_set())).c_str());
  for (const auto& [name, print] : kRows) {
    if (std::find(rows.begin(), rows.end(), name) == rows.end()) continue;
    std::printf("\n== %s ==\n", name.c_str());
    print(find_variant(variant), effort);
  }
  return 0;
}

}  // namespace
}  // namespace raygauge::bench

int main(int argc, char** argv) {
  return raygauge::bench::run_program("raygauge_ratios", raygauge::bench::run, argc, argv);
}
