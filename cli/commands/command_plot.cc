// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "analysis/render/figures/figure.h"
#include "cli/commands/analysis_options.h"
#include "cli/commands/commands.h"
#include "engine/exceptions.h"
#include "results/run/atomic_file.h"

namespace raygauge::cli {
namespace {

struct PlotArguments {
  AnalysisArguments analysis;
  std::string figure;
  std::string output;
  std::string size = "double";
  std::vector<std::string> baselines;
};

FigureOptions figure_options(const PlotArguments& arguments) {
  FigureOptions options;
  options.size = figure_size_from_string(arguments.size);
  options.filter = filter_of(arguments.analysis);
  options.baselines = arguments.baselines;
  return options;
}

void write_figure(const Figure& figure, const std::vector<Record>& records, const FigureOptions& options,
                  const std::string& path) {
  write_atomically(path, draw(figure, records, options, image_format_of(path)));
  std::printf("%s\n", path.c_str());
}

/// Every figure that the records have the data of, as SVG and PNG.
void write_all_figures(const std::vector<Record>& records, const FigureOptions& options,
                       const std::string& folder) {
  if (!std::filesystem::is_directory(folder))
    throw InvalidParameterError(folder + " is no folder; without --figure, -o is the folder for all figures");
  for (const Figure& figure : figures()) {
    try {
      for (const char* extension : {".svg", ".png"})
        write_figure(figure, records, options,
                     (std::filesystem::path(folder) / (figure.name + extension)).string());
    } catch (const FigureNeedsError& missing) {
      std::fprintf(stderr, "skipped: %s\n", missing.what());
    }
  }
}

int plot(const PlotArguments& arguments) {
  const FigureOptions options = figure_options(arguments);
  if (arguments.figure.empty()) {
    write_all_figures(read_files(arguments.analysis).records, options, arguments.output);
    return kAnswered;
  }
  const Figure& figure = figure_named(arguments.figure);
  image_format_of(arguments.output);  // complains before the files are read
  write_figure(figure, read_files(arguments.analysis).records, options, arguments.output);
  return kAnswered;
}

std::string figure_help() {
  std::string text = "Default: every one that the records have the data of. One of";
  for (const Figure& figure : figures()) text += "\n  " + figure.name + ": " + figure.description;
  return text;
}

}  // namespace

void add_plot_command(CLI::App& app, int& status) {
  const auto arguments = std::make_shared<PlotArguments>();
  CLI::App* command = app.add_subcommand("plot", "Draw a figure of the records, through gnuplot");
  add_analysis_options(*command, arguments->analysis);
  command->add_option("--figure", arguments->figure, figure_help())->type_name("NAME");
  command
      ->add_option(
          "-o,--output", arguments->output,
          "File to write, .svg, .png or .pdf; without --figure the folder for all figures, as SVG and PNG")
      ->required()
      ->type_name("FILE");
  command
      ->add_option("--size", arguments->size,
                   "Column of the page it is for: single (3.5 in) or double (7.16 in)")
      ->type_name("SIZE");
  add_baseline_option(*command, arguments->baselines);
  command->footer(
      "Examples:\n"
      "  raygauge plot out/example2.h5 -o out\n"
      "  raygauge plot out/example2.h5 --figure ratio_heatmap --size single -o out/ratios.pdf");
  command->callback([arguments, &status] { status = plot(*arguments); });
}

}  // namespace raygauge::cli
