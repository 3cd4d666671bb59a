// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/cluster_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "engine/numerics/decompositions.h"
#include "engine/numerics/floating_point.h"
#include "engine/numerics/splitmix64.h"
#include "engine/sets/tuning.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {
namespace {

constexpr std::ptrdiff_t kLanes = PointSet::kLanes;
constexpr Eigen::Index kSample = 4096;  // points that the map is made from
constexpr double kFlattest = 1e-12;     // axes of F, of the longest
constexpr double kLargestMagnitude = 0x1p200, kSmallestMagnitude = 0x1p-200;
constexpr double kLeastSquare = 0x1p-800, kMostSquare = 0x1p800;  // of |w|
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

constexpr int kTrials = 16;

// The axes of the points about their centre, by a QR factorisation (which does not square) and the singular
// values of its triangle.
void isotropic_axes(const Eigen::MatrixXd& centred, DenseMatrix& F, DenseMatrix& inverse) {
  const Eigen::Index n = centred.rows(), count = std::min(centred.cols(), kSample);
  Eigen::MatrixXd sample(count, n);
  for (Eigen::Index i = 0; i < count; ++i)
    sample.row(i) = centred.col(i * centred.cols() / count).transpose() / std::sqrt(double(count));
  const auto [values, V] = right_singular(qr_triangle(sample));
  const Eigen::VectorXd axes = values.cwiseMax(kFlattest * values[0]);
  F = V * axes.asDiagonal();
  inverse = axes.cwiseInverse().asDiagonal() * V.transpose();
}

// max_i |δ_ik|, what F y_i leaves of p_i - c in coordinate k.
Vector residuals(const ClusterTree::Points& points, const Vector& center, const DenseMatrix& F,
                 const Eigen::MatrixXd& y) {
  using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
  using LongVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
  const LongMatrix long_F = F.cast<long double>();
  const LongVector long_center = center.cast<long double>();
  Vector largest = Vector::Zero(points.rows());
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const LongVector delta =
        points.col(i).cast<long double>() - long_center - long_F * y.col(i).cast<long double>();
    largest = largest.cwiseMax(delta.cwiseAbs().cast<double>());
  }
  return largest * (1 + 4 * kEpsilon);
}

}  // namespace

// Ranges of the order are halved across their longest axis, at whole blocks, until they are leaves.
class ClusterTree::Builder {
 public:
  Builder(ClusterTree& tree, const Eigen::MatrixXd& y, Order& order) : tree_(tree), y_(y), order_(order) {}

  // Of `blocks` blocks from `first` on; its number.
  std::int32_t node(std::ptrdiff_t first, std::ptrdiff_t blocks) {
    const auto index = static_cast<std::int32_t>(tree_.nodes_.size());
    tree_.nodes_.emplace_back();
    const auto numbers = static_cast<std::size_t>(tree_.n_) * kChildren;
    const std::size_t needed = tree_.nodes_.size() * numbers;
    if (needed > tree_.axes_.capacity()) tree_.axes_.reserve(std::max(needed, 2 * tree_.axes_.capacity()));
    std::fill_n(axes(index), numbers, 0.0);
    divide(index, first, blocks, kChildren);
    return index;
  }

 private:
  double* axes(std::int32_t node) { return tree_.axes_.data() + std::ptrdiff_t{node} * tree_.n_ * kChildren; }

  Order::iterator at(std::ptrdiff_t block) {
    return order_.begin() + std::min(block * kLanes, static_cast<std::ptrdiff_t>(order_.size()));
  }

  // Up to `parts` children of `node`.
  void divide(std::int32_t node, std::ptrdiff_t first, std::ptrdiff_t blocks, int parts) {
    if (parts == 1 || blocks <= tuned::kBlocksOfLeaf) return add_child(node, first, blocks);
    const std::ptrdiff_t half = blocks / 2;
    const auto axis = longest_axis(first, blocks);
    std::nth_element(at(first), at(first + half), at(first + blocks),
                     [&](std::ptrdiff_t a, std::ptrdiff_t b) {
                       return y_(axis, a) < y_(axis, b) || (y_(axis, a) == y_(axis, b) && a < b);
                     });
    divide(node, first, half, parts / 2);
    divide(node, first + half, blocks - half, parts / 2);
  }

  Eigen::Index longest_axis(std::ptrdiff_t first, std::ptrdiff_t blocks) {
    Vector low = y_.col(*at(first)), high = low;
    for (auto i = at(first); i != at(first + blocks); ++i) {
      low = low.cwiseMin(y_.col(*i));
      high = high.cwiseMax(y_.col(*i));
    }
    Eigen::Index axis = 0;
    (high - low).maxCoeff(&axis);
    return axis;
  }

  void add_child(std::int32_t node, std::ptrdiff_t first, std::ptrdiff_t blocks) {
    const bool is_leaf = blocks <= tuned::kBlocksOfLeaf;
    const auto child = static_cast<std::size_t>(tree_.nodes_[static_cast<std::size_t>(node)].count++);
    bound(node, child, first, blocks);
    const std::int32_t target = is_leaf ? static_cast<std::int32_t>(first) : this->node(first, blocks);
    Node& parent = tree_.nodes_[static_cast<std::size_t>(node)];
    parent.first[child] = target;
    parent.blocks[child] = is_leaf ? static_cast<std::int32_t>(blocks) : 0;
    if (is_leaf) std::sort(at(first), at(first + blocks));
  }

  void bound(std::int32_t node, std::size_t child, std::ptrdiff_t first, std::ptrdiff_t blocks) {
    Vector d = Vector::Zero(tree_.n_);
    for (auto i = at(first); i != at(first + blocks); ++i) d += y_.col(*i);
    if (!(d.norm() > kSmallestMagnitude)) d[0] = 1;
    d.normalize();
    double low = kInfinity, high = -kInfinity, radius = 0;
    for (auto i = at(first); i != at(first + blocks); ++i) {
      const double along = d.dot(y_.col(*i));
      low = std::min(low, along);
      high = std::max(high, along);
      radius = std::max(radius, (y_.col(*i) - along * d).norm());
    }
    Node& parent = tree_.nodes_[static_cast<std::size_t>(node)];
    parent.low[child] = low;
    parent.high[child] = high;
    parent.radius[child] = radius;
    for (int k = 0; k < tree_.n_; ++k) axes(node)[static_cast<std::size_t>(k) * kChildren + child] = d[k];
  }

  ClusterTree& tree_;
  const Eigen::MatrixXd& y_;
  Order& order_;
};

ClusterTree::ClusterTree(const Points& points, Order& order) : n_(static_cast<int>(points.rows())) {
  const double largest = points.cwiseAbs().maxCoeff();
  if (n_ < 2 || n_ > kMostDimensions || points.size() < tuned::kFewestNumbersOfTree) return;
  if (!(largest < kLargestMagnitude && largest > kSmallestMagnitude)) return;
  block_count_ = (points.cols() + kLanes - 1) / kLanes;
  center_ = (points / static_cast<double>(points.cols())).rowwise().sum();
  const Eigen::MatrixXd centred = points.colwise() - center_;
  isotropic_axes(centred, map_, inverse_);
  if (!map_.allFinite() || !inverse_.allFinite()) return;
  const Eigen::MatrixXd y = inverse_ * centred;
  // Twice the rounding errors of a height, those of u·c, of w and of a bound, and δ.
  const double farthest = y.colwise().norm().maxCoeff();
  slack_ = 4 * ConvexSet::rounding_error(n_) * points.cwiseAbs().rowwise().maxCoeff() +
           16 * (n_ + 8) * kEpsilon * farthest * map_.cwiseAbs().rowwise().sum() +
           residuals(points, center_, map_, y);
  order.resize(static_cast<std::size_t>(points.cols()));
  std::iota(order.begin(), order.end(), 0);
  Builder(*this, y, order).node(0, block_count_);
}

struct ClusterTree::Query {
  const Kernels& kernels;
  alignas(64) std::array<double, kMostDimensions> w;
  double square;  // |w|²; 0: no bound is known
  double base;    // u·c and the allowance
};

ClusterTree::Query ClusterTree::query(const Kernels& kernels, const double* u) const {
  Query q{kernels, {}, 0, kUnderflow};
  for (int k = 0; k < n_; ++k) q.base += u[k] * center_[k] + std::fabs(u[k]) * slack_[k];
  for (int j = 0; j < n_; ++j) {
    double sum = 0;
    for (int k = 0; k < n_; ++k) sum += map_(k, j) * u[k];
    q.w[static_cast<std::size_t>(j)] = sum;
    q.square += sum * sum;
  }
  if (!(q.square > kLeastSquare && q.square < kMostSquare)) q.square = 0;
  return q;
}

ClusterTree::Children ClusterTree::bounds(const Query& query, std::int32_t node) const {
  const Node& N = nodes_[static_cast<std::size_t>(node)];
  alignas(64) Children along;
  query.kernels.products(axes_.data() + std::ptrdiff_t{node} * n_ * kChildren, 1, n_, query.w.data(),
                         along.data());
  // What rounding takes from |w|² - (d·w)² would count most where that is next to 0.
  const double square = query.square * (1 + 16 * (n_ + 8) * kEpsilon);
  Children out;
  for (std::size_t j = 0; j < kChildren; ++j) {
    const double across = std::sqrt(std::max(square - along[j] * along[j], 0.0));
    const double height = std::max(along[j] * N.high[j], along[j] * N.low[j]);
    const double bound = query.base + height + N.radius[j] * across;
    out[j] =
        bound >= -std::numeric_limits<double>::max() ? bound : kInfinity;  // what overflows bounds nothing
  }
  return out;
}

template <class Leaf>
void ClusterTree::search(const Query& query, std::int32_t node, double& height, const Leaf& leaf) const {
  const Node& N = nodes_[static_cast<std::size_t>(node)];
  Children bound = bounds(query, node);
  for (int turn = 0; turn < N.count; ++turn) {
    std::size_t best = 0;
    for (std::size_t j = 1; j < static_cast<std::size_t>(N.count); ++j) {
      if (bound[j] > bound[best]) best = j;
    }
    if (bound[best] < height) return;
    bound[best] = -kInfinity;
    if (N.blocks[best] > 0) {
      height = leaf(N.first[best], N.first[best] + N.blocks[best]);
    } else {
      search(query, N.first[best], height, leaf);
    }
  }
}

Highest ClusterTree::highest(const Kernels& kernels, const double* blocks, const double* u) const {
  Highest found{-kInfinity, 0, 0};
  const auto read = [&](std::ptrdiff_t first, std::ptrdiff_t last) {
    std::ptrdiff_t index = 0;
    const double value = kernels.price(blocks + first * kLanes * n_, last - first, n_, u, &index);
    index += first * kLanes;
    if (value > found.value || (value == found.value && index < found.index)) {
      found.value = value;
      found.index = index;
    }
    found.compared += (last - first) * kLanes;
    return found.value;
  };
  const Query q = query(kernels, u);
  if (q.square > 0) {
    double height = -kInfinity;
    search(q, 0, height, read);
  } else {
    read(0, block_count_);
  }
  return found;
}

double ClusterTree::collect(const Kernels& kernels, const double* blocks, const double* u,
                            Collection& found) const {
  double highest = -kInfinity;
  const auto read = [&](std::ptrdiff_t first, std::ptrdiff_t last) {
    highest = std::max(highest, kernels.collect(blocks, first, last, n_, u, &found));
    return std::min(highest, found.threshold);
  };
  const Query q = query(kernels, u);
  if (!(q.square > 0)) return kernels.collect(blocks, 0, block_count_, n_, u, &found);
  double height = -kInfinity;
  search(q, 0, height, read);
  return highest;
}

// Directions that are spread evenly where the points are round.
bool ClusterTree::pays(const double* blocks) const {
  std::uint64_t drawn = 0;
  const auto uniform = [&] { return static_cast<double>(splitmix64(++drawn) >> 11U) * 0x1p-53 - 0.5; };
  std::ptrdiff_t compared = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    Vector w(n_);
    for (double& x : w) x = uniform() + uniform() + uniform() + uniform();
    const Vector u = inverse_.transpose() * w;
    compared += highest(best_kernels(), blocks, u.data()).compared;
  }
  const std::ptrdiff_t points = block_count_ * kLanes;
  const bool beyond_cache = points * n_ >= tuned::kNumbersBeyondCache;
  const double share = beyond_cache ? tuned::kTreePaysBeyondCache : tuned::kTreePays;
  return static_cast<double>(compared) <= share * kTrials * static_cast<double>(points);
}

std::ptrdiff_t ClusterTree::memory() const noexcept {
  return static_cast<std::ptrdiff_t>(nodes_.size() * sizeof(Node) + axes_.capacity() * sizeof(double));
}

}  // namespace raygauge
