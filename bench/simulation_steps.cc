// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// What does a step of a simulation cost, beside one of another engine? Boxes, balls and capsules dropped into
// a bin. By stretches of time: falling, packing, at rest.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "bench/bin.h"
#include "bench/program.h"
#include "raygauge/simulation.h"
#include "scene/engines/loaded_engine.h"
#include "scene/friction/loaded_friction.h"

namespace raygauge::bench {
namespace {

struct Settings {
  int bodies = 200;
  double seconds = 1;  ///< of simulated time
  double step = 1e-3;
  double tolerance = 1e-4;
  int stretch = 100;  ///< steps that a row is the mean of
  std::string engine = "bullet";
  int threads = 1;
};

double seconds_of(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Of the whole process: threads count by what they work.
double processor_seconds() { return seconds_of(CLOCK_PROCESS_CPUTIME_ID); }

// Threads of a library that was just loaded (OpenBLAS, of Siconos) look for work for a tenth of a second.
void wait_for_idle_threads() {
  constexpr int kMost = 40;
  constexpr double kIdle = 1e-3;  // of the tenth of a second
  for (int k = 0; k < kMost; ++k) {
    const double before = processor_seconds();
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    if (processor_seconds() - before < kIdle) return;
  }
}

/// Seconds at the end of each step, from the beginning: of all processors together, and on the clock.
struct Run {
  Simulation found;
  std::vector<double> ends, walls;
};

Run timed(const Bin& bin, FrictionSolver* friction, SimulationHooks hooks) {
  Run run;
  const double begin = processor_seconds(), start = seconds_of(CLOCK_MONOTONIC);
  hooks.progress = [&run, begin, start](double /*share*/) {
    run.ends.push_back(processor_seconds() - begin);
    run.walls.push_back(seconds_of(CLOCK_MONOTONIC) - start);
  };
  run.found = simulate(bin.scene(), bin.dynamics(), friction, hooks);
  return run;
}

// Its steps alone: their proof is not its work.
Run timed_engine(const Bin& bin, const std::string& name) {
  EngineSteps steps(name, bin.scene(), bin.dynamics());
  std::vector<double> ends;
  double all = 0;
  SimulationHooks hooks;
  hooks.advance = [&](double end, std::vector<BodyState>& bodies) {
    const double begin = processor_seconds();
    steps.advance(end, bodies);
    ends.push_back(all += processor_seconds() - begin);
  };
  Run run = timed(bin, nullptr, hooks);
  run.ends = ends;
  return run;
}

double mean_milliseconds(const std::vector<double>& ends, std::size_t first, std::size_t count) {
  const double before = first == 0 ? 0 : ends[first - 1];
  return 1e3 * (ends[first + count - 1] - before) / static_cast<double>(count);
}

void print_rows(const Run& own, const Run& engine, std::size_t stretch) {
  std::printf("%8s %10s %10s %10s %8s %10s %10s %10s\n", "until", "own ms", "wall ms", "engine ms", "ratio",
              "contacts", "substeps", "residual");
  for (std::size_t first = 0; first < own.ends.size(); first += stretch) {
    const std::size_t count = std::min(stretch, own.ends.size() - first);
    double contacts = 0, substeps = 0, residual = 0;
    for (std::size_t k = first; k < first + count; ++k) {
      const StepRecord& row = own.found.steps[k];
      contacts += static_cast<double>(row.contacts) / static_cast<double>(row.substeps);
      substeps += static_cast<double>(row.substeps);
      residual = std::max(residual, row.residual);
    }
    const double mine = mean_milliseconds(own.ends, first, count);
    const double its = engine.ends.empty() ? 0 : mean_milliseconds(engine.ends, first, count);
    std::printf("%8.3f %10.3f %10.3f %10.3f %8.2f %10.1f %10.2f %10.1e\n",
                own.found.steps[first + count - 1].time, mine, mean_milliseconds(own.walls, first, count),
                its, its > 0 ? mine / its : 0, contacts / static_cast<double>(count),
                substeps / static_cast<double>(count), residual);
  }
}

void options(CLI::App& app, Settings& settings) {
  app.add_option("--bodies", settings.bodies, "Boxes, balls and capsules, in turn");
  app.add_option("--seconds", settings.seconds, "Simulated time");
  app.add_option("--step", settings.step, "Of time");
  app.add_option("--tolerance", settings.tolerance, "How deep bodies may overlap, relative to the smallest");
  app.add_option("--stretch", settings.stretch, "Steps that a row is the mean of")
      ->check(CLI::PositiveNumber);
  app.add_option("--threads", settings.threads, "Of the own steps; own ms are those of all threads together");
  app.add_option("--engine", settings.engine, "Beside it: bullet, ode, mujoco, or none");
}

double least_distance(const Run& run) {
  double least = 0;
  for (const StepRecord& row : run.found.steps) least = std::min(least, row.least_distance);
  return least;
}

void run(const Settings& settings) {
  const Bin bin(settings.bodies, settings.seconds, settings.step, settings.tolerance);
  const auto friction = loaded_friction();
  SimulationHooks hooks;
  hooks.threads = settings.threads;
  wait_for_idle_threads();
  const Run own = timed(bin, friction.get(), hooks);
  const Run engine = settings.engine == "none" ? Run() : timed_engine(bin, settings.engine);
  print_rows(own, engine, static_cast<std::size_t>(settings.stretch));
  const SimulationCounters& c = own.found.counters;
  std::printf("contact queries %lld, motion proofs %lld, friction problems %lld\n",
              static_cast<long long>(c.contact_queries), static_cast<long long>(c.motion_proofs),
              static_cast<long long>(c.friction_problems));
  std::printf("proven: own %.3g, %s %.3g\n", least_distance(own), settings.engine.c_str(),
              least_distance(engine));
}

}  // namespace
}  // namespace raygauge::bench

int main(int argc, char** argv) {
  using namespace raygauge::bench;
  return run_with_options<Settings>("raygauge_simulation_steps",
                                    "Times of steps of a simulation beside another engine's", options, run,
                                    argc, argv);
}
