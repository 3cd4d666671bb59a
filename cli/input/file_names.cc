// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/file_names.h"

#include <fnmatch.h>
#include <glob.h>

#include <algorithm>
#include <set>
#include <utility>

#include "cli/input/input_file.h"
#include "raygauge/exceptions.h"
#include "results/schema/dataset.h"

namespace raygauge::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSpecial = "*?[\\";

/// The file of a source, and what follows it: ":/DATASET" or nothing.
std::pair<std::string, std::string> split(const std::string& source) {
  const auto dataset = parse_dataset_reference(source);
  if (!dataset) return {source, ""};
  return {dataset->file, source.substr(dataset->file.size())};
}

/// As a pattern that matches just this text.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (std::string(kSpecial).find(c) != std::string::npos) result += '\\';
    result += c;
  }
  return result;
}

/// What glob(3) finds.
class Matches {
 public:
  explicit Matches(const std::string& pattern) { ::glob(pattern.c_str(), 0, nullptr, &found_); }
  ~Matches() { ::globfree(&found_); }
  Matches(const Matches&) = delete;
  Matches& operator=(const Matches&) = delete;

  std::vector<std::string> files() const {
    std::vector<std::string> files;
    std::error_code ignored;
    for (std::size_t i = 0; i < found_.gl_pathc; ++i) {
      if (!fs::is_directory(found_.gl_pathv[i], ignored)) files.emplace_back(found_.gl_pathv[i]);
    }
    std::sort(files.begin(), files.end());
    return files;
  }

 private:
  glob_t found_{};
};

bool is_pattern(const std::string& text) { return text.find_first_of(kSpecial) != std::string::npos; }

/// The sources FILE:/DATASET of the datasets in the file that match; FILE:/DATASET itself if it is no
/// pattern.
std::vector<std::string> matching_datasets(const std::string& file, const std::string& dataset,
                                           const std::string& prefix) {
  const std::string pattern = dataset.empty() ? "" : dataset.substr(1);  // without the colon
  if (!is_pattern(pattern)) return {file + dataset};
  std::vector<std::string> sources;
  for (const std::string& name : point_datasets(prefix + file)) {
    if (name == pattern) return {file + dataset};
    if (::fnmatch(pattern.c_str(), name.c_str(), FNM_PATHNAME) == 0) sources.push_back(file + ":" + name);
  }
  if (sources.empty())
    throw InvalidParameterError(prefix + file + ": no dataset of points matches '" + pattern + "'");
  return sources;
}

std::string short_name(const std::string& source) {
  const auto [file, dataset] = split(source);
  fs::path path = fs::path(file).filename();
  if (path.extension() == ".gz") path = path.stem();
  const std::string stem = path.stem().string();
  return dataset.empty() ? stem : stem + ":" + fs::path(dataset).filename().string();
}

}  // namespace

std::vector<std::string> matching_sources(const std::string& pattern, const fs::path& folder) {
  if (pattern == kStandardInput)
    throw InvalidParameterError("standard input cannot be a file of a sweep: it can be read once only");
  const auto [file, dataset] = split(pattern);
  std::error_code ignored;
  const bool below = !folder.empty() && fs::path(file).is_relative();
  const std::string prefix = below ? (folder / "").string() : "";
  if (!is_pattern(file) || fs::exists(folder / file, ignored))
    return matching_datasets(file, dataset, prefix);
  const std::vector<std::string> files = Matches(escaped(prefix) + file).files();
  if (files.empty()) throw InvalidParameterError("no file matches '" + prefix + file + "'");
  std::vector<std::string> sources;
  for (const std::string& found : files) {
    for (std::string& source : matching_datasets(found.substr(prefix.size()), dataset, prefix))
      sources.push_back(std::move(source));
  }
  return sources;
}

std::string matched_text(const std::string& pattern, const std::string& source) {
  const std::size_t first = pattern.find_first_of(kSpecial);
  if (first == std::string::npos || pattern == source) return "";
  const std::size_t last = std::min(pattern.find_last_of("*?]\\") + 1, pattern.size());
  const std::size_t behind = pattern.size() - last;
  return source.substr(first, source.size() - first - behind);
}

std::map<std::string, std::string> short_names(const std::vector<std::string>& sources) {
  std::map<std::string, std::set<std::string>> owners;
  for (const std::string& source : sources) owners[short_name(source)].insert(source);
  std::map<std::string, std::string> names;
  for (const auto& [name, of] : owners) {
    for (const std::string& source : of) names[source] = of.size() == 1 ? name : source;
  }
  return names;
}

}  // namespace raygauge::cli
