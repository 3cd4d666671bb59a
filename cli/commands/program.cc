// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/commands/program.h"

#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "cli/commands/commands.h"
#include "cli/usage_error.h"
#include "results/provenance/provenance.h"

namespace raygauge::cli {
namespace {

std::string version_text() {
  const BuildInfo build = build_info();
  return "raygauge " + build.raygauge_version + " (commit " + build.git_commit +
         (build.git_dirty ? ", modified" : "") + ", " + build.build_type + ")";
}

int fail(const std::string& message) {
  std::fprintf(stderr, "%s\n", on_one_line(message).c_str());
  return kBadInput;
}

int run_command(int argc, char** argv) {
  CLI::App app{"raygauge: by how much must the convex set Q be scaled until it touches the convex set A?",
               "raygauge"};
  app.set_version_flag("--version", version_text(), "Print version, commit and build type, and exit");
  app.require_subcommand(1);
  app.option_defaults()->always_capture_default();
  app.footer("raygauge COMMAND --help tells a command's options, with their defaults.");
  int status = kAnswered;
  add_run_command(app, status);
  add_scene_command(app, status);
  add_distance_command(app, status);
  add_table_command(app, status);
  add_plot_command(app, status);
  add_export_command(app, status);
  add_compare_command(app, status);
  add_report_command(app, status);
  add_info_command(app, status);
  add_merge_command(app, status);
  add_submit_command(app, status);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) return fail(usage_message(app, error));
    app.exit(error);
  }
  return status;
}

/// What was printed must have arrived: a full disk or a closed pipe is an error.
int flushed(int status) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
  return fail("raygauge: standard output cannot be written");
}

}  // namespace

int run_program(int argc, char** argv) {
  try {
    return flushed(run_command(argc, argv));
  } catch (const std::bad_alloc&) {
    return fail("raygauge: out of memory");
  } catch (const std::exception& error) {
    return fail(std::string("raygauge: ") + error.what());
  } catch (...) {
    return fail("raygauge: an unknown error");
  }
}

}  // namespace raygauge::cli
