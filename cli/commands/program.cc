// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/commands/program.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>

#include "cli/commands/commands.h"
#include "cli/console/command_line.h"
#include "results/provenance/provenance.h"
#include "results/text/language.h"
#include "scene/commands/command_scene.h"

namespace raygauge::cli {
namespace {

std::string version_text() {
  const BuildInfo build = build_info();
  return "raygauge " + build.raygauge_version + " (commit " + build.git_commit +
         (build.git_dirty ? ", modified" : "") + ", " + build.build_type + ")";
}

/// The message without line breaks, as an error message must be.
int fail(std::string message) {
  std::replace_if(
      message.begin(), message.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  std::fprintf(stderr, "%s\n", language::printable(message).c_str());
  return kBadInput;
}

int run_command(int argc, char** argv) {
  CommandLine command_line(
      "raygauge", "raygauge: by how much must the convex set Q be scaled until it touches the convex set A?",
      version_text(), "raygauge COMMAND --help tells a command's options, with their defaults.");
  Command program = command_line.program();
  int status = kAnswered;
  add_run_command(program, status);
  add_scene_command(program, status);
  add_distance_command(program, status);
  add_table_command(program, status);
  add_plot_command(program, status);
  add_export_command(program, status);
  add_compare_command(program, status);
  add_report_command(program, status);
  add_info_command(program, status);
  add_merge_command(program, status);
  add_submit_command(program, status);
  command_line.parse(argc, argv);
  return status;
}

/// Ends a process that has failed. HDF5's own clean-up, which the end of main() starts, crashes after some
/// errors of damaged files and of memory.
int ended(int status) {
  if (status != kBadInput) return status;
  std::fflush(nullptr);
  std::_Exit(status);
}

/// What was printed must have arrived: a full disk or a closed pipe is an error.
int flushed(int status) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
  return fail("raygauge: standard output cannot be written");
}

int status_of_program(int argc, char** argv) {
  try {
    return flushed(run_command(argc, argv));
  } catch (const UsageError& error) {
    return fail(error.what());
  } catch (const std::bad_alloc&) {
    return fail("raygauge: out of memory");
  } catch (const std::exception& error) {
    return fail(std::string("raygauge: ") + error.what());
  } catch (...) {
    return fail("raygauge: an unknown error");
  }
}

}  // namespace

int run_program(int argc, char** argv) { return ended(status_of_program(argc, argv)); }

}  // namespace raygauge::cli
