// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "analysis/render/figures/description.h"
#include "analysis/studies/figures.h"
#include "cli/commands/analysis_options.h"
#include "cli/commands/commands.h"
#include "cli/output/output_file.h"
#include "raygauge/exceptions.h"
#include "results/text/language.h"
#include "scene/page/cost_figure.h"
#include "scene/page/scene_figure.h"

namespace raygauge::cli {
namespace {

constexpr const char* kSceneFigure = "timelines";
constexpr const char* kSceneDescription =
    "distances of a scene over time with their certified bands, and its contacts";
constexpr const char* kCostFigure = "cost";
constexpr const char* kCostDescription =
    "error, proven overlap, rise of energy and residual against seconds, for its steps and tolerances";

struct PlotArguments {
  AnalysisArguments analysis;
  std::string figure;
  std::string output;
  std::string size = "double";
  std::vector<std::string> baselines;
  bool force = false;
};

constexpr const char* kStandardOutput = "-";

/// Standard output takes SVG, which is text.
ImageFormat format_of(const std::string& path) {
  return path == kStandardOutput ? ImageFormat::svg : image_format_of(path);
}

Output picture_output(const PlotArguments& arguments, const std::string& path) {
  if (path == kStandardOutput)
    return output_of(path, OutputKind::text, {".svg"}, arguments.analysis, arguments.force);
  return output_of(path, OutputKind::image, image_extensions(), arguments.analysis, arguments.force);
}

FigureOptions figure_options(const PlotArguments& arguments) {
  FigureOptions options;
  options.size = figure_size_from_string(arguments.size);
  options.filter = filter_of(arguments.analysis);
  options.baselines = arguments.baselines;
  return options;
}

/// "fig.svg" becomes "fig-2.svg": where the second page of a figure goes.
std::string page_path(const std::filesystem::path& path, std::size_t page) {
  const std::string name = path.stem().string() + "-" + std::to_string(page) + path.extension().string();
  return (path.parent_path() / name).string();
}

/// Draws the pages of a figure and decides where each of them goes.
void add_figure(const PlotArguments& arguments, const Figure& figure, const std::vector<Record>& records,
                const FigureOptions& options, const Output& output, std::vector<Written>& all) {
  std::vector<std::string> pages = draw(figure, records, options, format_of(output.path));
  if (output.path == kStandardOutput && pages.size() > 1) {
    throw InvalidParameterError("figure " + figure.name + " has " + std::to_string(pages.size()) +
                                " pages, and standard output takes one: name a file (-o " + figure.name +
                                ".svg), or choose with --where");
  }
  for (std::size_t p = 0; p < pages.size(); ++p) {
    all.push_back(
        {p == 0 ? output : picture_output(arguments, page_path(output.path, p + 1)), std::move(pages[p])});
  }
}

bool is_image_name(const std::string& path) {
  try {
    image_format_of(path);
    return true;
  } catch (const Error&) {
    return false;
  }
}

/// The files that all figures are to be written to, by figure. Throws where one of them may not be.
std::map<std::string, std::vector<Output>> all_outputs(const PlotArguments& arguments) {
  const std::filesystem::path folder = arguments.output;
  const bool is_folder = std::filesystem::is_directory(folder);
  if (!is_folder &&
      (folder == "-" || folder.empty() || std::filesystem::exists(folder) || is_image_name(folder)))
    throw InvalidParameterError(arguments.output +
                                ": is no folder; without --figure, -o is the folder for all figures");
  std::map<std::string, std::vector<Output>> outputs;
  for (const Figure& figure : figures())
    for (const char* extension : {".svg", ".png"})
      outputs[figure.name].push_back(
          picture_output(arguments, (folder / (figure.name + extension)).string()));
  return outputs;
}

/// Every figure that the records have the data of, as SVG and PNG.
std::vector<Written> draw_all_figures(const PlotArguments& arguments, const FigureOptions& options) {
  const auto outputs = all_outputs(arguments);
  const std::vector<Record> records = read_files(arguments.analysis).records;
  std::vector<Written> all;
  for (const Figure& figure : figures()) {
    try {
      for (const Output& output : outputs.at(figure.name))
        add_figure(arguments, figure, records, options, output, all);
    } catch (const FigureNeedsError& missing) {
      std::fprintf(stderr, "skipped: %s\n", language::printable(missing.what()).c_str());
    }
  }
  return all;
}

/// A scene's results have one picture.
int plot_scene(const PlotArguments& arguments) {
  refuse_options_of_scene(arguments.analysis, {{"--baseline", !arguments.baselines.empty()}});
  if (!arguments.figure.empty() && arguments.figure != kSceneFigure && arguments.figure != kCostFigure)
    throw UnknownNameError("figure of a scene", arguments.figure, {kSceneFigure, kCostFigure});
  const ImageFormat format = image_format_of(arguments.output);
  const Output output = picture_output(arguments, arguments.output);
  const SceneFile file = read_scene(arguments.analysis);
  const FigureSize size = figure_size_from_string(arguments.size);
  const SimulationTables simulated = file.simulation.value_or(SimulationTables());
  const bool costs =
      arguments.figure == kCostFigure || (arguments.figure.empty() && simulated.simulations.size() > 1);
  const Drawing drawing = costs ? draw_costs(simulated, size) : draw_scene(file, size);
  write_to(output, described(draw_with_gnuplot(drawing.script, format, drawing.width, drawing.height), format,
                             file.name, costs ? kCostDescription : kSceneDescription));
  print_path(output);
  return kAnswered;
}

int plot(const PlotArguments& arguments) {
  require_files(arguments.analysis);
  if (arguments.analysis.files.size() == 1 && is_scene_file(arguments.analysis.files.front()))
    return plot_scene(arguments);
  const FigureOptions options = figure_options(arguments);
  if (arguments.figure.empty()) {
    write_all(draw_all_figures(arguments, options));
    return kAnswered;
  }
  const Figure& figure = figure_named(arguments.figure);
  format_of(arguments.output);  // complains before the files are read
  const Output output = picture_output(arguments, arguments.output);
  std::vector<Written> all;
  add_figure(arguments, figure, read_files(arguments.analysis).records, options, output, all);
  write_all(all);
  return kAnswered;
}

std::string figure_help() {
  std::string text = "Default: every one that the records have the data of. One of";
  for (const Figure& figure : figures()) text += "\n  " + figure.name + ": " + figure.description;
  return text + "\n  " + kSceneFigure + ": of the results of a scene, " + kSceneDescription + "\n  " +
         kCostFigure + ": of several simulations of a scene, " + kCostDescription;
}

}  // namespace

void add_plot_command(Command& app, int& status) {
  const auto arguments = std::make_shared<PlotArguments>();
  Command command = app.add_subcommand("plot", "Draw a figure of the records, through gnuplot");
  add_analysis_options(command, arguments->analysis);
  command.add_option("--figure", arguments->figure, figure_help()).type_name("NAME");
  command
      .add_option("-o,--output", arguments->output,
                  "File to write: .svg, .png, .pdf, .eps, or .tikz or .tex for TikZ; - for SVG on standard "
                  "output; without --figure the "
                  "folder for all figures, as SVG and PNG")
      .required()
      .type_name("FILE");
  command
      .add_option("--size", arguments->size,
                  "Column of the page it is for: single (3.5 in) or double (7.16 in)")
      .type_name("SIZE");
  add_baseline_option(command, arguments->baselines);
  add_force_option(command, arguments->force);
  command.footer(
      "Examples:\n"
      "  raygauge plot out/example2.h5 -o out\n"
      "  raygauge plot out/example2.h5 --figure ratio_heatmap --size single -o out/ratios.pdf");
  command.callback([arguments, &status] { status = plot(*arguments); });
}

}  // namespace raygauge::cli
