// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Pairs of bodies of R^3: Euclidean and growth distance, first time and after a small motion, separation;
// beside FCL, or beside a library behind an adapter.
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "bench/library_rows.h"
#include "bench/pair_times.h"
#include "bench/program.h"

namespace raygauge::bench {
namespace {

using Row = std::pair<std::string, std::string>;

struct Ratio {
  const char* name;
  PairQuery ours, theirs;
};

constexpr Ratio kRatios[] = {{"points/ccd", PairQuery::points, PairQuery::fcl_libccd},
                             {"warm/ccd", PairQuery::warm, PairQuery::fcl_libccd},
                             {"growth/ccd", PairQuery::growth, PairQuery::fcl_libccd},
                             {"g warm/ccd", PairQuery::growth_warm, PairQuery::fcl_libccd},
                             {"apart/col", PairQuery::apart, PairQuery::fcl_collide},
                             {"deep/ccd", PairQuery::depth, PairQuery::fcl_depth},
                             {"dist/gen", PairQuery::distance, PairQuery::general},
                             {"grow/gen", PairQuery::growth, PairQuery::growth_general}};

void print_head() {
  std::printf("%-10s %-10s %-10s", "A1", "A2", "place");
  for (std::size_t q = 0; q < kPairQueries; ++q) std::printf(" %9s", name_of(static_cast<PairQuery>(q)));
  for (const Ratio& ratio : kRatios) std::printf(" %10s", ratio.name);
  std::printf(" %8s %8s %11s %11s %18s %18s %11s\n", "d/friend", "g/friend", "certified", "deep cert.",
              "libccd wrong", "indep wrong", "deep wrong");
}

void print_row(const Row& kinds, const std::string& place, const PairTally& tally,
               const PairTally* friendly) {
  std::printf("%-10s %-10s %-10s", kinds.first.c_str(), kinds.second.c_str(), place.c_str());
  for (std::size_t q = 0; q < kPairQueries; ++q)
    std::printf(" %9.3f", tally.median(static_cast<PairQuery>(q)));
  for (const Ratio& ratio : kRatios)
    std::printf(" %10.3f", tally.median(ratio.ours) / tally.median(ratio.theirs));
  for (const PairQuery query : {PairQuery::points, PairQuery::growth}) {
    std::printf(" %8.2f", friendly == nullptr ? std::nan("") : tally.median(query) / friendly->median(query));
  }
  std::printf(" %5d/%-5d %5d/%-5d", tally.certified, tally.pairs, tally.deep_certified, tally.deep);
  for (int i = 0; i < 2; ++i) {
    std::printf(" %4d/%-4d %8.1e", tally.wrong[i], tally.fcl_pairs, tally.worst[i]);
  }
  std::printf(" %5d/%-5d\n", tally.fcl_deep_wrong, tally.fcl_deep);
  std::fflush(stdout);
}

constexpr const char* kFriendly = "apart";

struct Settings {
  std::vector<std::string> kinds = body_kinds();
  std::vector<std::string> places = {"apart"};
  int pairs = 20;
  bool diagonal = false;
  std::string library;
  double tolerance = 1e-6;
};

// The pairs of a row, and beside each one its friendly twin: one after the other, as the clock wanders.
void measure_row(const Settings& settings, const Row& kinds, const std::string& place) {
  const bool smooth = !is_polytope(kinds.first) || !is_polytope(kinds.second);
  const bool is_friendly = place == kFriendly;
  const double of_friendly = smooth ? 1.5e-8 : 1e-6;
  PairTally tally, twin;
  for (int i = 0; i < settings.pairs; ++i) {
    measure_pair(make_pair(kinds.first, kinds.second, place, i), is_friendly ? of_friendly : 1e-6, tally);
    if (!is_friendly) measure_pair(make_pair(kinds.first, kinds.second, kFriendly, i), of_friendly, twin);
  }
  print_row(kinds, place, tally, is_friendly ? nullptr : &twin);
}

void measure_beside(const Settings& settings, LibraryTable& table, const Row& kinds,
                    const std::string& place) {
  LibraryTallies tallies;
  for (int i = 0; i < settings.pairs; ++i) {
    const PosedPair pair = make_pair(kinds.first, kinds.second, place, i);
    measure_beside(table.library(), pair, settings.tolerance, tallies);
  }
  table.print(kinds.first + " " + kinds.second + " " + place, tallies);
}

void run(const Settings& settings) {
  std::optional<LibraryTable> table;
  if (settings.library.empty())
    print_head();
  else
    table.emplace(settings.library);
  for (const std::string& place : settings.places) {
    for (std::size_t a = 0; a < settings.kinds.size(); ++a) {
      for (std::size_t b = a; b < (settings.diagonal ? a + 1 : settings.kinds.size()); ++b) {
        const Row kinds(settings.kinds[a], settings.kinds[b]);
        if (table)
          measure_beside(settings, *table, kinds, place);
        else
          measure_row(settings, kinds, place);
      }
    }
  }
  if (table) table->print_summary();
}

void add_options(CLI::App& app, Settings& settings) {
  app.add_option("--kinds", settings.kinds, "bodies, separated by commas")
      ->delimiter(',')
      ->check(CLI::IsMember(body_kinds()));
  app.add_option("--places", settings.places,
                 "how pairs stand; unfriendly ones are compared with 'apart', measured beside them")
      ->delimiter(',')
      ->check(CLI::IsMember(pair_places()));
  app.add_option("--pairs", settings.pairs, "random pairs of each kind")->check(CLI::Range(1, 10000));
  app.add_flag("--diagonal", settings.diagonal, "only pairs of two bodies of a kind");
  auto* library = app.add_option("--library", settings.library,
                                 "adapter of another library (see bench/pair_library.h): measure beside it")
                      ->check(CLI::ExistingFile);
  app.add_option("--tolerance", settings.tolerance, "relative, ours and the library's")
      ->check(CLI::Range(1e-12, 1e-2))
      ->needs(library);
}

}  // namespace
}  // namespace raygauge::bench

int main(int argc, char** argv) {
  return raygauge::bench::run_with_options(
      "raygauge_pairs",
      "Pairs of bodies of R^3 in poses: microseconds of each query, ours and FCL's, on one thread.",
      raygauge::bench::add_options, raygauge::bench::run, argc, argv);
}
