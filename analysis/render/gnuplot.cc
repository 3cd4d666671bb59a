// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/render/gnuplot.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "analysis/render/tikz.h"
#include "engine/numerics/number_text.h"
#include "results/disk/atomic_file.h"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX leaves it to the program

namespace raygauge {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

/// A nameless file: the program reads and writes whole files and waits for nobody, as it could with pipes.
using TemporaryFile = std::unique_ptr<std::FILE, CloseFile>;

TemporaryFile temporary_file(const std::string& content = "") {
  TemporaryFile file(std::tmpfile());
  if (!file) throw GnuplotError("gnuplot: no temporary file: " + system_reason(errno));
  if (std::fwrite(content.data(), 1, content.size(), file.get()) != content.size() ||
      std::fflush(file.get()) != 0)
    throw GnuplotError("gnuplot: a temporary file cannot be written: " + system_reason(errno));
  std::rewind(file.get());
  return file;
}

std::string content_of(std::FILE* file) {
  std::rewind(file);
  std::string content;
  std::array<char, 65536> buffer{};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), file))
    content.append(buffer.data(), count);
  return content;
}

class FileActions {
 public:
  FileActions() { posix_spawn_file_actions_init(&actions_); }
  ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;

  void connect(std::FILE* file, int descriptor) {
    posix_spawn_file_actions_adddup2(&actions_, fileno(file), descriptor);
  }

  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

/// gnuplot's complaint without its quotation of the script: the last line that is not blank.
std::string complaint(const std::string& messages) {
  std::string last;
  std::size_t begin = 0;
  while (begin < messages.size()) {
    const std::size_t end = std::min(messages.find('\n', begin), messages.size());
    const std::string line = messages.substr(begin, end - begin);
    if (line.find_first_not_of(" \t^") != std::string::npos)
      last = line.substr(line.find_first_not_of(" \t"));
    begin = end + 1;
  }
  return last;
}

int run_gnuplot(std::FILE* in, std::FILE* out, std::FILE* messages) {
  FileActions actions;
  actions.connect(in, STDIN_FILENO);
  actions.connect(out, STDOUT_FILENO);
  actions.connect(messages, STDERR_FILENO);
  std::string name = "gnuplot";
  std::string no_settings = "-d";  // not the user's own defaults: they would change the picture
  std::array<char*, 3> arguments = {name.data(), no_settings.data(), nullptr};
  pid_t child = 0;
  const int failure = posix_spawnp(&child, name.c_str(), actions.get(), nullptr, arguments.data(), environ);
  if (failure == ENOENT)
    throw GnuplotError("gnuplot is not installed, figures need it: apt-get install gnuplot-nox");
  if (failure != 0) throw GnuplotError("gnuplot cannot be started: " + system_reason(failure));
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw GnuplotError("gnuplot cannot be waited for: " + system_reason(errno));
  }
  return status;
}

std::string sizes(double width, double height, double scale) {
  return rounded_text(width * scale, 6) + "," + rounded_text(height * scale, 6);
}

std::string terminal(ImageFormat format, double width, double height) {
  constexpr double kPointsPerInch = 72;
  constexpr double kCairoPoints = 96;  // of a font to the inch
  constexpr double kScreenPixels = 96;
  const std::string inches = rounded_text(width, 6) + "in," + rounded_text(height, 6) + "in";
  switch (format) {
    case ImageFormat::svg: {
      const std::string scale = rounded_text(kScreenPixels / kPointsPerInch, 6);
      return "set terminal svg size " + sizes(width, height, kScreenPixels) +
             " fixed enhanced font 'sans-serif,8' fontscale " + scale + " background 'white'\n";
    }
    case ImageFormat::png: {
      const std::string scale = rounded_text(kPrintPixelsAnInch / kCairoPoints, 6);
      return "set terminal pngcairo size " + sizes(width, height, kPrintPixelsAnInch) +
             " enhanced font 'Sans,8' fontscale " + scale + " linewidth " + scale + " pointscale " + scale +
             " background 'white'\n";
    }
    case ImageFormat::tikz:
      return "set terminal tikz size " + inches + " font '\\scriptsize'\n";
    case ImageFormat::eps:
    case ImageFormat::pdf:
      break;
  }
  return std::string("set terminal ") + (format == ImageFormat::eps ? "epscairo" : "pdfcairo") + " size " +
         inches + " enhanced font 'Sans,8' fontscale " + rounded_text(kPointsPerInch / kCairoPoints, 6) +
         " linewidth 1 background 'white'\n";
}

}  // namespace

const std::vector<std::string>& image_extensions() {
  static const std::vector<std::string> kExtensions = {".svg", ".png", ".pdf", ".eps", ".tikz", ".tex"};
  return kExtensions;
}

ImageFormat image_format_of(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension();
  if (extension == ".svg") return ImageFormat::svg;
  if (extension == ".png") return ImageFormat::png;
  if (extension == ".pdf") return ImageFormat::pdf;
  if (extension == ".eps") return ImageFormat::eps;
  if (extension == ".tikz" || extension == ".tex") return ImageFormat::tikz;
  throw InvalidParameterError(path + ": a figure is a file ending in .svg, .png, .pdf, .eps, .tikz or .tex");
}

std::string draw_with_gnuplot(const std::string& script, ImageFormat format, double width, double height) {
  // No text of ours has these; language::gnuplot() writes none. gnuplot would hand what follows to a shell.
  if (script.find('`') != std::string::npos || script.find("\n!") != std::string::npos)
    throw GnuplotError("gnuplot: not drawn: the script would run a command");
  const TemporaryFile in = temporary_file(terminal(format, width, height) + script);
  const TemporaryFile out = temporary_file();
  const TemporaryFile messages = temporary_file();
  const int status = run_gnuplot(in.get(), out.get(), messages.get());
  std::string picture = content_of(out.get());
  const std::string reason = complaint(content_of(messages.get()));
  if (status != 0) throw GnuplotError("gnuplot failed: " + (reason.empty() ? "it gave no reason" : reason));
  if (picture.empty()) throw GnuplotError("gnuplot drew nothing: " + reason);
  return format == ImageFormat::tikz ? with_tex_texts(picture) : picture;
}

}  // namespace raygauge
