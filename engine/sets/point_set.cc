// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/point_set.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <string>
#include <utility>

#include "engine/kernels/kernel.h"
#include "engine/numerics/vector_kernels.h"
#include "engine/sets/cluster_tree.h"
#include "engine/sets/highest_points.h"
#include "engine/sets/isotropic_map.h"
#include "engine/sets/place_shape.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

constexpr std::align_val_t kAlignment{64};

void check_points(const Eigen::Ref<const Eigen::MatrixXd>& points) {
  if (points.cols() == 0) throw EmptySetError("a point set needs at least one point");
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    for (Eigen::Index k = 0; k < points.rows(); ++k) {
      if (!std::isfinite(points(k, i))) {
        throw NonFiniteError("coordinate " + std::to_string(k) + " of point " + std::to_string(i) +
                             " is not a finite number");
      }
    }
  }
}

}  // namespace

void PointSet::AlignedDelete::operator()(void* p) const noexcept { ::operator delete[](p, kAlignment); }

PointSet::PointSet(const Eigen::Ref<const Eigen::MatrixXd>& points)
    : ConvexSet(static_cast<int>(points.rows())),
      size_(points.cols()),
      block_count_((size_ + kLanes - 1) / kLanes) {
  check_points(points);
  const std::ptrdiff_t n = dimension();
  const std::ptrdiff_t count = block_count_ * n * kLanes;
  data_.reset(
      static_cast<double*>(::operator new[](static_cast<std::size_t>(count) * sizeof(double), kAlignment)));
  for (std::ptrdiff_t slot = 0; slot < block_count_ * kLanes; ++slot) {
    const std::ptrdiff_t i = std::min(slot, size_ - 1);
    double* block = data_.get() + (slot / kLanes) * n * kLanes + slot % kLanes;
    for (std::ptrdiff_t k = 0; k < n; ++k) block[k * kLanes] = points(k, i);
  }
  round_to_single();
  magnitude_ = points.cwiseAbs().rowwise().maxCoeff();
  const auto nonzero = [](double x) {
    return x != 0 ? std::fabs(x) : std::numeric_limits<double>::infinity();
  };
  smallest_magnitude_ = points.unaryExpr(nonzero).rowwise().minCoeff();
  spacing_ = n > 1 ? std::pow(static_cast<double>(size_), -1.0 / static_cast<double>(n - 1)) : 1.0;
  // The mean of points divided by N beforehand, so that no partial sum overflows.
  center_ = (points / static_cast<double>(size_)).rowwise().sum();
  center_ = center_.cwiseMax(points.rowwise().minCoeff()).cwiseMin(points.rowwise().maxCoeff());
  if (auto map = isotropic_map(points)) isotropic_ = std::make_unique<const IsotropicMap>(std::move(*map));
  SpatialShape shape;
  if (!place(shape, center_, dimension())) return;
  shape.kind = SpatialShape::Kind::points;
  shape.extent = std::sqrt(dot(magnitude_.data(), magnitude_.data(), dimension()));
  shape.coordinates = dimension();
  shape.blocks = data_.get();
  shape.block_count = block_count_;
  shape.size = size_;
  set_spatial_shape(std::make_shared<const SpatialShape>(shape));
}

PointSet::~PointSet() = default;

std::unique_ptr<const PointSet> PointSet::clustered(const Eigen::Ref<const Eigen::MatrixXd>& points) {
  check_points(points);
  ClusterTree::Order order;
  auto tree = std::make_unique<const ClusterTree>(points, order);
  if (tree->empty()) return std::make_unique<const PointSet>(points);
  auto set = std::make_unique<PointSet>(points(Eigen::all, order));
  if (!tree->pays(set->data())) return std::make_unique<const PointSet>(points);
  set->tree_ = std::move(tree);
  return set;
}

void PointSet::round_to_single() {
  const std::ptrdiff_t n = dimension();
  const std::ptrdiff_t count = single_block_count() * kSingleLanes * n;
  if (size_ * n > single_numbers(dimension())) return;
  single_data_.reset(
      static_cast<float*>(::operator new[](static_cast<std::size_t>(count) * sizeof(float), kAlignment)));
  for (std::ptrdiff_t slot = 0; slot < single_block_count() * kSingleLanes; ++slot) {
    const std::ptrdiff_t i = std::min(slot, size_ - 1);
    const double* from = data_.get() + (i / kLanes) * n * kLanes + i % kLanes;
    float* to = single_data_.get() + (slot / kSingleLanes) * n * kSingleLanes + slot % kSingleLanes;
    for (std::ptrdiff_t k = 0; k < n; ++k) to[k * kSingleLanes] = static_cast<float>(from[k * kLanes]);
  }
}

Vector PointSet::point(std::ptrdiff_t i) const {
  if (i < 0 || i >= size_) {
    throw InvalidParameterError("point index must lie in [0, " + std::to_string(size_ - 1) + "], got " +
                                std::to_string(i));
  }
  Vector out(dimension());
  copy_point(i, out.data());
  return out;
}

DenseMatrix PointSet::points() const {
  DenseMatrix all(dimension(), size_);
  for (std::ptrdiff_t i = 0; i < size_; ++i) copy_point(i, all.col(i).data());
  return all;
}

double PointSet::do_support(const double* u, double* point) const {
  const Highest highest = highest_point(best_kernels(), *this, u);
  copy_point(highest.index, point);
  return highest.value;
}

void PointSet::do_center(double* point) const { Vector::Map(point, dimension()) = center_; }

void PointSet::do_magnitude(double* magnitude) const { Vector::Map(magnitude, dimension()) = magnitude_; }

SupportStructure PointSet::do_structure() const noexcept {
  return size_ == 1 ? SupportStructure::point : SupportStructure::polytope;
}

// Those of a single point.
template <class Real>
void PointSet::list_pieces(const Real* u, BasicSupportPieces<Real>& pieces, int capacity) const {
  if (capacity < 1) return;
  const int n = dimension();
  for (int k = 0; k < n; ++k) pieces.point(0)[k] = data_[static_cast<std::size_t>(k) * kLanes];
  pieces.value[0] = dot(u, pieces.point(0), n);
  std::fill_n(pieces.hessian(0), static_cast<std::ptrdiff_t>(n) * n, Real{0});
  pieces.count = 1;
}

void PointSet::do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const {
  list_pieces(u, pieces, capacity);
}

void PointSet::do_quad_pieces(const Quad* u, QuadSupportPieces& pieces, int capacity) const {
  list_pieces(u, pieces, capacity);
}

}  // namespace raygauge
