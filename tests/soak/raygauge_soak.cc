// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Solves random variants of every hard family and checks every certificate against a distance known exactly;
// `raygauge_soak sets`, `bodies`, `placed`, `overlaps`, `used`, `depths`, `meshes`, `motions`, `edges`,
// `scenes` and `simulations` check random pairs of convex sets, posed bodies, bodies at known distances,
// overlaps, used solvers, depths, meshes, moving bodies, edges of robots, scenes and simulations:
// docs/soak.md.
#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <exception>
#include <fstream>
#include <string>

#include "results/provenance/provenance.h"
#include "tests/soak/overlaps.h"
#include "tests/soak/placed_bodies.h"
#include "tests/soak/posed_bodies.h"
#include "tests/soak/random_depths.h"
#include "tests/soak/random_edges.h"
#include "tests/soak/random_meshes.h"
#include "tests/soak/random_motions.h"
#include "tests/soak/random_scenes.h"
#include "tests/soak/random_simulations.h"
#include "tests/soak/run.h"
#include "tests/soak/set_pairs.h"
#include "tests/soak/used_solvers.h"

namespace raygauge::soak {
namespace {

volatile std::sig_atomic_t interrupted = 0;

extern "C" void note_interrupt(int /*signal*/) { interrupted = 1; }

struct CommandLine {
  RunOptions run;
  std::string log;
};

struct PairsCommandLine {
  std::int64_t pairs = 100000;
  std::int64_t first = 0;
  std::uint64_t seed = 1;
};

// To standard output and, if there is one, to the log.
class Log {
 public:
  explicit Log(const std::string& path) {
    if (path.empty()) return;
    file_.open(path, std::ios::app);
    if (!file_) throw std::runtime_error("cannot write " + path);
  }
  void write(const std::string& text) {
    std::fputs(text.c_str(), stdout);
    std::fflush(stdout);
    if (file_.is_open()) file_ << text << std::flush;
  }

 private:
  std::ofstream file_;
};

std::string headline(const RunOptions& options) {
  const BuildInfo build = build_info();
  return "raygauge_soak " + build.raygauge_version + ", commit " + build.git_commit +
         (build.git_dirty ? " (changed)" : "") + ", " + build.compiler + ", seed " +
         std::to_string(options.seed) + ", first base " + std::to_string(options.first_base) + ", threads " +
         std::to_string(options.threads) + "\n";
}

std::string line(const Progress& progress, const RunOptions& options) {
  const FamilyTally total = progress.tally.total();
  const double rate = static_cast<double>(total.solves) / std::max(progress.seconds, 1e-3);
  const double left = static_cast<double>(options.solves - total.solves) / rate;
  std::array<char, 200> text{};
  std::snprintf(text.data(), text.size(),
                "%9.0f s  %12lld solves  %9lld bases  %8.4f %% certified  %8.0f solves/s  %s\n",
                progress.seconds, static_cast<long long>(total.solves),
                static_cast<long long>(progress.bases),
                100.0 * static_cast<double>(total.certified()) /
                    static_cast<double>(std::max<std::int64_t>(1, total.solves)),
                rate, left < 1e7 ? (std::to_string(static_cast<long long>(left)) + " s left").c_str() : "");
  return text.data();
}

int soak(const CommandLine& asked) {
  Log log(asked.log);
  log.write(headline(asked.run));
  const RunResult result = run(
      asked.run, [] { return interrupted != 0; },
      [&](const Progress& progress) { log.write(line(progress, asked.run)); });
  log.write(line(result.progress, asked.run) + "\n" + to_string(result.progress.tally) + "\n");
  if (!result.violation) {
    log.write("violations: 0\n");
    return 0;
  }
  const std::string folder = (asked.log.empty() ? std::string("raygauge_soak") : asked.log) + ".violation";
  save(*result.violation, asked.run, folder);
  log.write("violation: " + result.violation->what + " (" + result.violation->family + "), saved in " +
            folder + "\n");
  return 1;
}

void declare(CLI::App& app, CommandLine& asked) {
  app.add_option("--solves", asked.run.solves, "end after so many solves")->check(CLI::PositiveNumber);
  app.add_option("--seconds", asked.run.seconds, "end after so many seconds")->check(CLI::PositiveNumber);
  app.add_option("--threads", asked.run.threads, "threads")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app.add_option("--seed", asked.run.seed, "seed of all random numbers")->capture_default_str();
  app.add_option("--first-base", asked.run.first_base, "number of the first base instance")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--report-every", asked.run.seconds_between_reports, "seconds between lines of progress")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--log", asked.log, "append what is printed to this file");
}

template <class Soak>
int soak_pairs(const PairsCommandLine& asked) {
  Soak soak(asked.seed);
  for (std::int64_t i = asked.first; i < asked.first + asked.pairs && interrupted == 0; ++i) {
    if (const auto violation = soak.check(i)) {
      std::printf("%sviolation: %s\n", to_string(soak.tally()).c_str(), violation->c_str());
      return 1;
    }
  }
  std::printf("seed %llu: %sviolations: 0\n", static_cast<unsigned long long>(asked.seed),
              to_string(soak.tally()).c_str());
  return 0;
}

// Options of the program itself mean nothing to its subcommands, which have their own.
void refuse_options_before_subcommand(const CLI::App& app) {
  if (app.get_subcommands().empty()) return;
  for (const CLI::Option* option : app.get_options()) {
    if (option->count() == 0) continue;
    throw std::runtime_error(option->get_name() + " is not of " + app.get_subcommands().front()->get_name() +
                             "; options of a subcommand stand after it");
  }
}

CLI::App* declare(CLI::App& app, const std::string& name, const std::string& description,
                  PairsCommandLine& asked) {
  CLI::App* command = app.add_subcommand(name, description);
  command->option_defaults()->always_capture_default();
  command->add_option("--pairs", asked.pairs, "how many pairs, motions, robots or scenes")
      ->check(CLI::PositiveNumber);
  command->add_option("--first", asked.first, "number of the first one")->check(CLI::NonNegativeNumber);
  command->add_option("--seed", asked.seed, "seed of all random numbers");
  return command;
}

}  // namespace
}  // namespace raygauge::soak

int main(int count, char** arguments) {
  CLI::App app("Solves random hard instances and checks every certificate; stops at the first false one.");
  raygauge::soak::CommandLine asked;
  raygauge::soak::declare(app, asked);
  raygauge::soak::PairsCommandLine asked_pairs;
  const CLI::App* sets = raygauge::soak::declare(
      app, "sets",
      "Random pairs of convex sets by every method; stops where two proofs contradict each other.",
      asked_pairs);
  const CLI::App* bodies = raygauge::soak::declare(
      app, "bodies", "Random posed bodies of R^2 and R^3, warm and cold, against the general methods.",
      asked_pairs);
  const CLI::App* placed = raygauge::soak::declare(
      app, "placed", "Bodies of R^2 and R^3 placed at known distances, 250 poses a pair, warm and cold.",
      asked_pairs);
  const CLI::App* overlaps = raygauge::soak::declare(
      app, "overlaps",
      "Polytopes with integer and quarter coordinates, overlapping and touching, against integer arithmetic.",
      asked_pairs);
  const CLI::App* used = raygauge::soak::declare(
      app, "used", "Queries of every kind by solvers that have answered others and by new ones, bit for bit.",
      asked_pairs);
  const CLI::App* depths = raygauge::soak::declare(
      app, "depths", "Depths of overlapping bodies of R^2 and R^3, 20 poses a pair, warm and cold.",
      asked_pairs);
  const CLI::App* meshes = raygauge::soak::declare(
      app, "meshes",
      "Pairs of meshes, 50 poses and 5 motions each, against all pairs of triangles in quadruple precision.",
      asked_pairs);
  const CLI::App* motions = raygauge::soak::declare(
      app, "motions", "Times of impact of random moving bodies, against distances at single moments.",
      asked_pairs);
  const CLI::App* edges = raygauge::soak::declare(
      app, "edges", "Edges of random robots, 10 a robot, against distances at 41 moments.", asked_pairs);
  const CLI::App* scenes = raygauge::soak::declare(
      app, "scenes", "Random scenes with every effect, against brute force.", asked_pairs);
  const CLI::App* simulations = raygauge::soak::declare(
      app, "simulations", "Random scenes of bodies that react: proofs, depths and energy.", asked_pairs);
  CLI11_PARSE(app, count, arguments);
  std::signal(SIGINT, raygauge::soak::note_interrupt);
  std::signal(SIGTERM, raygauge::soak::note_interrupt);
  try {
    raygauge::soak::refuse_options_before_subcommand(app);
    if (*sets) return raygauge::soak::soak_pairs<raygauge::soak::SetPairs>(asked_pairs);
    if (*bodies) return raygauge::soak::soak_pairs<raygauge::soak::PosedBodies>(asked_pairs);
    if (*placed) return raygauge::soak::soak_pairs<raygauge::soak::PlacedBodies>(asked_pairs);
    if (*overlaps) return raygauge::soak::soak_pairs<raygauge::soak::Overlaps>(asked_pairs);
    if (*used) return raygauge::soak::soak_pairs<raygauge::soak::UsedSolvers>(asked_pairs);
    if (*depths) return raygauge::soak::soak_pairs<raygauge::soak::RandomDepths>(asked_pairs);
    if (*meshes) return raygauge::soak::soak_pairs<raygauge::soak::RandomMeshes>(asked_pairs);
    if (*motions) return raygauge::soak::soak_pairs<raygauge::soak::RandomMotions>(asked_pairs);
    if (*edges) return raygauge::soak::soak_pairs<raygauge::soak::RandomEdges>(asked_pairs);
    if (*scenes) return raygauge::soak::soak_pairs<raygauge::soak::RandomScenes>(asked_pairs);
    if (*simulations) return raygauge::soak::soak_pairs<raygauge::soak::RandomSimulations>(asked_pairs);
    return raygauge::soak::soak(asked);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "raygauge_soak: %s\n", error.what());
    return 2;
  }
}
