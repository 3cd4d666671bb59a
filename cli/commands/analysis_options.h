// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "analysis/data/filter.h"
#include "analysis/data/merge.h"
#include "cli/console/command_line.h"
#include "cli/output/output_file.h"
#include "scene/file/scene_file.h"

namespace raygauge::cli {

/// What every command that reads results takes: the files and a filter.
struct AnalysisArguments {
  std::vector<std::string> files;
  std::string where;
};

void add_analysis_options(Command& command, AnalysisArguments& arguments);

/// --baseline, for commands that show ratios.
void add_baseline_option(Command& command, std::vector<std::string>& baselines);

/// Throws ResultsError where one of the files is missing, no HDF5 file or damaged: said before anything else.
void require_files(const AnalysisArguments& arguments);

/// The records of the files, all of them: ratios need more than what passes the filter.
MergedResults read_files(const AnalysisArguments& arguments);

/// The scene's results in the one file.
SceneFile read_scene(const AnalysisArguments& arguments);

/// Says on standard error of a file that was read that it has no checksum.
void note_checksum(const std::string& path, bool has_checksum);

/// --where as a filter; without it, the one that passes everything.
Filter filter_of(const AnalysisArguments& arguments);

/// An option, and whether it was given another value than its default.
using GivenOption = std::pair<std::string, bool>;

/// Throws InvalidParameterError where an option that is for the records of sweeps is given for those of a
/// scene: `--where` or one of `others`.
void refuse_options_of_scene(const AnalysisArguments& arguments, std::vector<GivenOption> others);

/// Decides where an output of a command that reads these files goes. Throws OutputRefusedError where it may
/// not, so that this is known before the files are read.
Output output_of(const std::string& path, OutputKind kind, std::vector<std::string> extensions,
                 const AnalysisArguments& arguments, bool force);

}  // namespace raygauge::cli
