// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/direction_table.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "engine/numerics/decompositions.h"
#include "engine/sets/tuning.h"

namespace raygauge {
namespace {

constexpr int kLeastCells = 4;
constexpr double kMargin = 1e-14;  // of the size of the set: more than the rounding errors of two heights
constexpr double kRim = 1e-9;      // cells are wider by this than v's cell is known to rounding

using Points = std::vector<std::int32_t>;

// Cells about half as wide as the points are apart where these are spread over a sphere.
int cells_for(std::ptrdiff_t count) {
  const double wanted = std::sqrt(static_cast<double>(count));
  int cells = kLeastCells;
  while (cells < wanted && cells < tuned::kMostCells) cells *= 2;
  return cells;
}

Vector3 direction(int face, double first, double second) {
  const double sign = face % 2 == 0 ? 1 : -1;
  if (face < 2) return {sign, first, second};
  return face < 4 ? Vector3{first, sign, second} : Vector3{first, second, sign};
}

// ‖F‖ ‖F⁻¹‖ (Frobenius; 3 for a sphere) of the sets that are long or flat enough to be mapped, and of those
// that are too flat for it.
constexpr double kLong = 15, kTooFlat = 1e9;

using LongVector = Eigen::Matrix<long double, 3, 1>;

// The points as the cells see them, y_i with p_i - c = F y_i + δ_i.
struct RoundPoints {
  Eigen::Matrix3Xd y;
  double margin = 0;  // a difference of heights v'·y that is one of v·p
  double rim = kRim;
  Eigen::Matrix3d F = Eigen::Matrix3d::Identity();
  bool is_mapped = false;
};

// F from a QR factorisation of the points about their centre: isotropic_map squares, is about the origin and
// refuses needles of 1e6 : 1.
//
// v·(q - p) = v'·(y_q - y_p) + v·(δ_q - δ_p), v' = Fᵀv and |v| <= ‖F⁻¹‖ |v'|, |v'| <= √3 (1 + rim) in a cell.
RoundPoints round_points(const Eigen::Ref<const Eigen::Matrix3Xd>& points) {
  RoundPoints plain{points, kMargin * points.colwise().norm().maxCoeff()};
  if (points.cols() < 4) return plain;
  const Eigen::Vector3d center = points.rowwise().sum() / static_cast<double>(points.cols());
  const Eigen::Matrix3Xd centred = points.colwise() - center;
  const Eigen::Matrix3d triangle = qr_triangle(centred.transpose());
  RoundPoints mapped;
  mapped.F = triangle.transpose() / std::sqrt(static_cast<double>(points.cols()));
  const Eigen::Matrix3d inverse = mapped.F.inverse();
  const double condition = mapped.F.norm() * inverse.norm();
  if (!(condition > kLong && condition < kTooFlat)) return plain;
  mapped.is_mapped = true;
  mapped.y = inverse * centred;
  mapped.rim += 16 * std::numeric_limits<double>::epsilon() * condition;
  double residual = 0;
  const auto long_F = mapped.F.cast<long double>();
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const LongVector p = points.col(i).cast<long double>() - center.cast<long double>();
    const LongVector delta = p - long_F * mapped.y.col(i).cast<long double>();
    residual = std::max(residual, static_cast<double>(delta.norm()));
  }
  residual += 1e-18 * points.colwise().norm().maxCoeff();  // what long doubles round
  // 2 √3 |δ| ‖F⁻¹‖, and as much again for the rim and for what is rounded here.
  mapped.margin = kMargin * mapped.y.colwise().norm().maxCoeff() + 8 * inverse.norm() * residual;
  return mapped;
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
  Builder(DirectionTable& table, RoundPoints points) : table_(table), points_(std::move(points)) {}

  void divide(const Points& around, int face, int i, int j, int size) {
    const Points points = candidates(around, face, i, j, size);
    const auto count = static_cast<std::int32_t>(points.size());
    if (size > 1 && count > tuned::kShortList) {
      const int half = size / 2;
      for (const int di : {0, half}) {
        for (const int dj : {0, half}) divide(points, face, i + di, j + dj, half);
      }
      return;
    }
    if (points.size() > tuned::kLongestList) return;
    const List list{static_cast<std::int32_t>(table_.candidates_.size()), count};
    table_.candidates_.insert(table_.candidates_.end(), points.begin(), points.end());
    const std::ptrdiff_t cells = table_.cells_;
    for (int k = i; k < i + size; ++k) {
      List* const row = table_.lists_.data() + (face * cells + k) * cells;
      std::fill(row + j, row + j + size, list);
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
    const double rim = points_.rim;
    const double low_i = i * unit - 1 - rim, high_i = (i + size) * unit - 1 + rim;
    const double low_j = j * unit - 1 - rim, high_j = (j + size) * unit - 1 + rim;
    const std::array<Vector3, 5> directions = {
        direction(face, low_i, low_j), direction(face, low_i, high_j), direction(face, high_i, low_j),
        direction(face, high_i, high_j), direction(face, (low_i + high_i) / 2, (low_j + high_j) / 2)};
    heights_.resize(around.size());
    std::array<std::size_t, 5> highest{};
    for (std::size_t k = 0; k < around.size(); ++k) {
      const auto y = points_.y.col(around[k]);
      const Vector3 point{y[0], y[1], y[2]};
      for (std::size_t d = 0; d < 5; ++d) {
        heights_[k][d] = dot(directions[d], point);
        if (heights_[k][d] > heights_[highest[d]][d]) highest[d] = k;
      }
    }
    Points chosen;
    for (std::size_t k = 0; k < around.size(); ++k) {
      const bool hidden = std::any_of(highest.begin(), highest.end(), [&](std::size_t q) {
        return is_hidden(heights_[k], heights_[q], points_.margin);
      });
      if (!hidden) chosen.push_back(around[k]);
    }
    return chosen;
  }

  DirectionTable& table_;
  RoundPoints points_;
  std::vector<Heights> heights_;
};

DirectionTable::DirectionTable(const Eigen::Ref<const Eigen::Matrix3Xd>& points, HullSurface surface)
    : cells_(cells_for(points.cols())), surface_(std::move(surface)) {
  const auto count = static_cast<std::size_t>(points.cols());
  points_.assign(4 * count, 0.0);
  Eigen::Map<Eigen::Matrix4Xd>(points_.data(), 4, points.cols()).topRows<3>() = points;
  lists_.resize(static_cast<std::size_t>(6) * static_cast<std::size_t>(cells_) *
                static_cast<std::size_t>(cells_));
  const Points all = different_points(points);
  RoundPoints round = round_points(points);
  is_mapped_ = round.is_mapped;
  for (int j = 0; j < 3; ++j) map_.column[j] = {round.F(0, j), round.F(1, j), round.F(2, j)};
  Builder builder(*this, std::move(round));
  for (int face = 0; face < 6; ++face) builder.divide(all, face, 0, 0, cells_);
}

}  // namespace raygauge
