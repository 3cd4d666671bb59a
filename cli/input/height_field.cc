// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/height_field.h"

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <vector>

#include "cli/input/input_file.h"
#include "cli/input/mesh_file.h"
#include "cli/input/number_word.h"
#include "cli/input/point_source.h"
#include "cli/input/toml_refusal.h"
#include "raygauge/exceptions.h"
#include "raygauge/meshes/mesh.h"

namespace raygauge::cli {
namespace {

constexpr Eigen::Index kMostHeights = 500'000'000;  // of two triangles each, numbered in 32 bits

/// PGM, as netpbm's manual describes it.
class PgmReader {
 public:
  PgmReader(std::string_view bytes, const std::string& name) : left_(bytes), name_(name) {}

  /// A row of the picture is a column.
  Eigen::MatrixXd read() {
    const std::string_view kind = word();
    if (kind != "P2" && kind != "P5") fail("not a grey picture: it begins with neither P2 nor P5");
    const std::uint64_t width = count("width"), height = count("height"), most = count("greatest value");
    if (width == 0 || height == 0 || most == 0 || most > 65535)
      fail("a width, height or greatest value of 0, or more than 65535");
    const std::uint64_t each = kind == "P2" ? 2 : most > 255 ? 2 : 1;
    if (kind == "P5" && !left_.empty()) left_.remove_prefix(1);
    if (height > (left_.size() + (kind == "P2" ? 1 : 0)) / each / width)
      fail("the header promises " + std::to_string(width) + " x " + std::to_string(height) +
           " numbers, and " + std::to_string(left_.size()) + " bytes are left");
    Eigen::MatrixXd heights(static_cast<Eigen::Index>(width), static_cast<Eigen::Index>(height));
    for (Eigen::Index i = 0; i < heights.size(); ++i) {
      const std::uint64_t value = kind == "P2" ? count("number") : sample(each);
      if (value > most)
        fail("number " + std::to_string(i) + ", counted from 0, is more than " + std::to_string(most));
      heights.data()[i] = static_cast<double>(value);
    }
    if (kind == "P5" ? !left_.empty() : !word().empty())
      fail("the file goes on behind what its header promises");
    return heights;
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw InvalidParameterError(name_ + ": " + reason);
  }

  /// The next word that is not of a comment; "" at the end.
  std::string_view word() {
    constexpr std::string_view kBlanks = " \t\v\f\r\n";
    while (true) {
      left_.remove_prefix(std::min(left_.find_first_not_of(kBlanks), left_.size()));
      if (!left_.starts_with('#')) break;
      left_.remove_prefix(std::min(left_.find('\n'), left_.size()));
    }
    const std::string_view found = left_.substr(0, left_.find_first_of(kBlanks));
    left_.remove_prefix(found.size());
    return found;
  }

  std::uint64_t count(const char* what) {
    const std::string_view found = word();
    const auto value = integer_of(found);
    if (!value || *value < 0) fail(std::string(what) + ": " + quoted(found) + " is not a count");
    return static_cast<std::uint64_t>(*value);
  }

  std::uint64_t sample(std::uint64_t bytes) {
    if (left_.size() < bytes) fail("the file ends before what its header promises");
    std::uint64_t value = 0;
    for (std::uint64_t k = 0; k < bytes; ++k) value = value << 8 | static_cast<unsigned char>(left_[k]);
    left_.remove_prefix(bytes);
    return value;
  }

  std::string_view left_;
  const std::string& name_;
};

/// The closed surface about the solid below the heights.
class HeightSurface {
 public:
  /// heights(j, i) is that of row i and column j.
  HeightSurface(const Eigen::MatrixXd& heights, double spacing, double floor)
      : rows_(static_cast<std::int32_t>(heights.cols())),
        columns_(static_cast<std::int32_t>(heights.rows())) {
    const Eigen::Index all = heights.size(), rim = 2 * (Eigen::Index{rows_} + columns_ - 2);
    vertices.resize(3, all + rim + 1);
    for (std::int32_t i = 0; i < rows_; ++i)
      for (std::int32_t j = 0; j < columns_; ++j)
        vertices.col(at(i, j)) << j * spacing, i * spacing, heights(j, i);
    for (std::int32_t i = 0; i + 1 < rows_; ++i) {
      for (std::int32_t j = 0; j + 1 < columns_; ++j) {
        triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
        triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
      }
    }
    close(floor);
  }

  Eigen::Matrix3Xd vertices;
  std::vector<Triangle> triangles;

 private:
  std::int32_t at(std::int32_t i, std::int32_t j) const { return i * columns_ + j; }

  /// Walls from the rim down to the floor, and the floor as a fan.
  void close(double floor) {
    std::vector<std::int32_t> rim;  // counterclockwise from above
    for (std::int32_t j = 0; j + 1 < columns_; ++j) rim.push_back(at(0, j));
    for (std::int32_t i = 0; i + 1 < rows_; ++i) rim.push_back(at(i, columns_ - 1));
    for (std::int32_t j = columns_ - 1; j > 0; --j) rim.push_back(at(rows_ - 1, j));
    for (std::int32_t i = rows_ - 1; i > 0; --i) rim.push_back(at(i, 0));
    const std::int32_t first = rows_ * columns_, count = static_cast<std::int32_t>(rim.size()),
                       middle = first + count;
    for (std::int32_t k = 0; k < count; ++k) {
      vertices.col(first + k) = vertices.col(rim[static_cast<std::size_t>(k)]);
      vertices(2, first + k) = floor;
      const std::int32_t next = (k + 1) % count, p = rim[static_cast<std::size_t>(k)],
                         q = rim[static_cast<std::size_t>(next)];
      triangles.push_back({q, p, first + k});
      triangles.push_back({q, first + k, first + next});
      triangles.push_back({first + next, first + k, middle});
    }
    vertices.col(middle) = 0.5 * vertices.col(at(rows_ - 1, columns_ - 1));
    vertices(2, middle) = floor;
  }

  std::int32_t rows_, columns_;
};

}  // namespace

std::shared_ptr<const ConvexSet> read_height_field(const std::string& source, double spacing, double unit,
                                                   double floor) {
  if (!(spacing > 0)) throw InvalidParameterError("the spacing of a height field must be positive");
  const bool picture = content_extension(source) == "pgm";
  const Eigen::MatrixXd heights =
      unit * (picture ? PgmReader(read_input(source), source).read() : read_point_source(source));
  if (heights.rows() < 2 || heights.cols() < 2)
    throw InvalidParameterError(source + ": a height field needs 2 rows and columns or more");
  if (heights.size() > kMostHeights) throw InvalidParameterError(source + ": more than 5e8 heights");
  for (Eigen::Index k = 0; k < heights.size(); ++k) {
    if (heights.data()[k] > floor) continue;
    throw InvalidParameterError(source + ": the height in row " + std::to_string(k / heights.rows()) +
                                " and column " + std::to_string(k % heights.rows()) +
                                ", counted from 0, is not above the floor");
  }
  const HeightSurface surface(heights, spacing, floor);
  return placed(source, [&] {
    return std::make_shared<MeshObject>(Mesh(surface.vertices, surface.triangles, MeshKind::solid));
  });
}

}  // namespace raygauge::cli
