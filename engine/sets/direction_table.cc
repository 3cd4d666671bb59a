// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/direction_table.h"

#include <array>
#include <numeric>

namespace raygauge {
namespace {

constexpr int kLeastCells = 4, kMostCells = 32;  // along an edge of the cube, powers of two
constexpr std::int32_t kFew = 2;                 // points of a list that is not worth dividing
constexpr std::size_t kLongest = 24;             // beyond, a pass over all points is as fast
constexpr double kMargin = 1e-14;  // of the size of the set: more than the rounding errors of two heights
constexpr double kRim = 1e-9;      // cells are wider by this than v's cell is known to rounding

using Points = std::vector<std::int32_t>;

// Cells about half as wide as the points are apart where these are spread over a sphere.
int cells_for(std::ptrdiff_t count) {
  const double wanted = std::sqrt(static_cast<double>(count));
  int cells = kLeastCells;
  while (cells < wanted && cells < kMostCells) cells *= 2;
  return cells;
}

Vector3 direction(int face, double first, double second) {
  const double sign = face % 2 == 0 ? 1 : -1;
  if (face < 2) return {sign, first, second};
  return face < 4 ? Vector3{first, sign, second} : Vector3{first, second, sign};
}

// Of points that are the same the first alone.
Points different_points(const Eigen::Ref<const Eigen::Matrix3Xd>& points) {
  Points order(static_cast<std::size_t>(points.cols()));
  std::iota(order.begin(), order.end(), 0);
  const auto coordinates = [&](std::int32_t i) {
    return std::array<double, 3>{points(0, i), points(1, i), points(2, i)};
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::int32_t a, std::int32_t b) { return coordinates(a) < coordinates(b); });
  const auto same = [&](std::int32_t a, std::int32_t b) { return coordinates(a) == coordinates(b); };
  order.erase(std::unique(order.begin(), order.end(), same), order.end());
  return order;
}

}  // namespace

// Squares of a face are divided into four as long as their lists are worth it; a list of a square is chosen
// from that of the square around it.
class DirectionTable::Builder {
 public:
  Builder(DirectionTable& table, double size) : table_(table), margin_(kMargin * size) {}

  void divide(const Points& around, int face, int i, int j, int size) {
    const Points points = candidates(around, face, i, j, size);
    const auto count = static_cast<std::int32_t>(points.size());
    if (size > 1 && count > kFew) {
      const int half = size / 2;
      for (const int di : {0, half}) {
        for (const int dj : {0, half}) divide(points, face, i + di, j + dj, half);
      }
      return;
    }
    if (points.size() > kLongest) return;
    const List list{static_cast<std::int32_t>(table_.candidates_.size()), count};
    table_.candidates_.insert(table_.candidates_.end(), points.begin(), points.end());
    const int cells = table_.cells_;
    for (int k = i; k < i + size; ++k) {
      for (int l = j; l < j + size; ++l)
        table_.lists_[static_cast<std::size_t>((face * cells + k) * cells + l)] = list;
    }
  }

 private:
  using Heights = std::array<double, 5>;  // at the four corners of a square, and in its middle

  static bool is_hidden(const Heights& p, const Heights& q, double margin) {
    return q[0] - p[0] > margin && q[1] - p[1] > margin && q[2] - p[2] > margin && q[3] - p[3] > margin;
  }

  // Those of `around` that may be highest in the square.
  Points candidates(const Points& around, int face, int i, int j, int size) {
    const double unit = 2.0 / table_.cells_;
    const double low_i = i * unit - 1 - kRim, high_i = (i + size) * unit - 1 + kRim;
    const double low_j = j * unit - 1 - kRim, high_j = (j + size) * unit - 1 + kRim;
    const std::array<Vector3, 5> directions = {
        direction(face, low_i, low_j), direction(face, low_i, high_j), direction(face, high_i, low_j),
        direction(face, high_i, high_j), direction(face, (low_i + high_i) / 2, (low_j + high_j) / 2)};
    heights_.resize(around.size());
    std::array<std::size_t, 5> highest{};
    for (std::size_t k = 0; k < around.size(); ++k) {
      const Vector3 point = table_.point(around[k]);
      for (std::size_t d = 0; d < 5; ++d) {
        heights_[k][d] = dot(directions[d], point);
        if (heights_[k][d] > heights_[highest[d]][d]) highest[d] = k;
      }
    }
    Points chosen;
    for (std::size_t k = 0; k < around.size(); ++k) {
      const bool hidden = std::any_of(highest.begin(), highest.end(), [&](std::size_t q) {
        return is_hidden(heights_[k], heights_[q], margin_);
      });
      if (!hidden) chosen.push_back(around[k]);
    }
    return chosen;
  }

  DirectionTable& table_;
  double margin_;
  std::vector<Heights> heights_;
};

DirectionTable::DirectionTable(const Eigen::Ref<const Eigen::Matrix3Xd>& points)
    : cells_(cells_for(points.cols())) {
  const auto count = static_cast<std::size_t>(points.cols());
  points_.assign(4 * count, 0.0);
  Eigen::Map<Eigen::Matrix4Xd>(points_.data(), 4, points.cols()).topRows<3>() = points;
  lists_.resize(static_cast<std::size_t>(6) * static_cast<std::size_t>(cells_) *
                static_cast<std::size_t>(cells_));
  const Points all = different_points(points);
  Builder builder(*this, points.colwise().norm().maxCoeff());
  for (int face = 0; face < 6; ++face) builder.divide(all, face, 0, 0, cells_);
}

}  // namespace raygauge
