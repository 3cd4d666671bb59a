// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// A mesh file, its format chosen by the first byte: what is accepted has finite vertices, and no more of them
// than the file has bytes. Those of a text are what a second, simple reader finds there with strtod.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "cli/input/mesh_file.h"
#include "tests/fuzz/harness.h"
#include "tests/fuzz/scratch_file.h"

namespace raygauge::fuzz::mesh_file {
namespace {

using Points = std::vector<std::array<double, 3>>;

/// The words of each line that has some, comments left out.
std::vector<std::vector<std::string>> lines_of(std::string text, bool comments) {
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  std::replace(text.begin(), text.end(), '\r', '\n');
  std::istringstream stream(text);
  std::vector<std::vector<std::string>> lines;
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(comments ? line.substr(0, line.find('#')) : line);
    std::vector<std::string> found;
    for (std::string word; words >> word;) found.push_back(word);
    if (!found.empty()) lines.push_back(found);
  }
  return lines;
}

void append(Points& points, const std::vector<std::string>& words, std::size_t first) {
  require(words.size() >= first + 3, "accepted vertices have three coordinates");
  std::array<double, 3> point{};
  for (std::size_t i = 0; i < 3; ++i) {
    char* end = nullptr;
    point[i] = std::strtod(words[first + i].c_str(), &end);
    require(*end == '\0', "accepted coordinates are numbers");
  }
  points.push_back(point);
}

Points keyword_points(const std::string& text, const std::string& keyword, bool comments) {
  Points points;
  for (const std::vector<std::string>& words : lines_of(text, comments)) {
    std::string first = words[0];
    if (keyword == "vertex")
      std::transform(first.begin(), first.end(), first.begin(),
                     [](unsigned char c) { return std::tolower(c); });
    if (first == keyword) append(points, words, 1);
  }
  return points;
}

Points off_points(const std::string& text) {
  std::vector<std::vector<std::string>> lines = lines_of(text, true);
  std::vector<std::string>& head = lines.at(0);
  head[0].erase(0, head[0].find("OFF") + 3);
  if (head[0].empty()) head.erase(head.begin());
  const std::size_t first = head.empty() ? 2 : 1;
  const std::size_t count = std::stoull(head.empty() ? lines.at(1).at(0) : head[0]);
  require(lines.size() >= first + count, "accepted files have the lines that they promise");
  Points points;
  for (std::size_t i = 0; i < count; ++i) append(points, lines[first + i], 0);
  return points;
}

void require_same(const Eigen::MatrixXd& vertices, Points points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  require(points.size() == static_cast<std::size_t>(vertices.cols()), "every vertex is read, and no other");
  for (Eigen::Index i = 0; i < vertices.cols(); ++i) {
    for (Eigen::Index k = 0; k < 3; ++k)
      require(vertices(k, i) == points[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)],
              "vertices are read as they stand");
  }
}

void check_text(const std::string& format, const std::string& text, const Eigen::MatrixXd& vertices) {
  if (text.find('\0') != std::string::npos) return;  // binary, or not for a reader of C strings
  if (format == ".obj" && text.find('\\') == std::string::npos)
    require_same(vertices, keyword_points(text, "v", true));
  if (format == ".stl") require_same(vertices, keyword_points(text, "vertex", false));
  if (format == ".off" && text.find("BINARY") == std::string::npos) require_same(vertices, off_points(text));
}

}  // namespace
}  // namespace raygauge::fuzz::mesh_file

namespace raygauge::fuzz {

void check_mesh_file(std::string_view input) {
  if (input.empty()) return;
  static const std::string formats[] = {".off", ".ply", ".stl", ".obj", ".dae", ".gltf"};
  static const ScratchFile files[] = {ScratchFile(".off"), ScratchFile(".ply"), ScratchFile(".stl"),
                                      ScratchFile(".obj"), ScratchFile(".dae"), ScratchFile(".gltf")};
  const std::size_t chosen = static_cast<unsigned char>(input[0]) % std::size(formats);
  files[chosen].write(input.substr(1));
  expect_success_or_error([&] {
    const Eigen::MatrixXd vertices = cli::distinct_vertices(cli::read_mesh(files[chosen].path()));
    require(vertices.rows() == 3 && vertices.cols() > 0, "accepted meshes have vertices");
    require(vertices.allFinite(), "accepted vertices are finite");
    if (formats[chosen] != ".gltf")  // where nodes show one mesh many times
      require(static_cast<std::size_t>(vertices.cols()) <= input.size(), "vertices take bytes");
    mesh_file::check_text(formats[chosen], std::string(input.substr(1)), vertices);
  });
}

}  // namespace raygauge::fuzz
