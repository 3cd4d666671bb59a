// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/prepared_set.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <typeinfo>
#include <utility>
#include <vector>

#include "engine/numerics/vector_kernels.h"
#include "engine/sets/cluster_tree.h"
#include "engine/sets/direction_table.h"
#include "engine/sets/hull_3d.h"
#include "engine/sets/place_shape.h"

namespace raygauge {
namespace {

constexpr int kLanes = PointSet::kLanes;
constexpr int kCells = 16;  // of directions, per edge of the cube, that points are sorted by
constexpr double kRadiusRounding = 1 + 1e-12;

using Order = std::vector<std::ptrdiff_t>;

// Points that are seen from the centre in nearby directions stand nearby in memory.
void sort_by_direction(const Eigen::Ref<const Eigen::MatrixXd>& points, const Vector& center, Order& order) {
  const auto cell = [&](std::ptrdiff_t i) {
    const Vector v = points.col(i) - center;
    return DirectionTable::cell({v[0], v[1], v[2]}, kCells);
  };
  std::vector<int> cells(static_cast<std::size_t>(points.cols()));
  for (const std::ptrdiff_t i : order) cells[static_cast<std::size_t>(i)] = cell(i);
  std::stable_sort(order.begin(), order.end(), [&](std::ptrdiff_t a, std::ptrdiff_t b) {
    return cells[static_cast<std::size_t>(a)] < cells[static_cast<std::size_t>(b)];
  });
}

// Indices of points as those of their places in the order.
std::vector<int> in_order(const Order& order, std::vector<int> indices) {
  std::vector<int> place(
      indices.empty() ? 0 : 1 + static_cast<std::size_t>(*std::max_element(order.begin(), order.end())));
  for (std::size_t i = 0; i < order.size() && !place.empty(); ++i)
    place[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
  for (int& index : indices) index = place[static_cast<std::size_t>(index)];
  return indices;
}

}  // namespace

bool PreparedSet::has_hulls() noexcept { return has_hull_3d(); }

PreparedSet::PreparedSet(const PointSet& points) : PreparedSet(points.points()) {}

PreparedSet::PreparedSet(const Eigen::Ref<const Eigen::MatrixXd>& points)
    : ConvexSet(static_cast<int>(points.rows())) {
  const PointSet checked(points);
  center_ = checked.center();
  Hull3 hull;
  if (dimension() == 3 && points.cols() > 4) hull = hull_3d(points, center_);
  inner_radius_ = hull.inner_radius;
  Order order(hull.kept);
  if (!hull.found) {
    order.resize(static_cast<std::size_t>(points.cols()));
    std::iota(order.begin(), order.end(), 0);
  }
  if (hull.found) sort_by_direction(points, center_, order);
  keep(points(Eigen::all, order));
  if (dimension() == 3) {
    HullSurface surface;
    if (points_->tree() == nullptr)  // which has another order
      surface = HullSurface(points_->points(), in_order(order, hull.triangles), extent_);
    table_ = std::make_shared<const DirectionTable>(points_->points(), std::move(surface));
    SpatialShape shape = *points_->spatial_shape();
    place(shape, center_, 3);
    shape.extent = extent_;
    shape.inner_radius = inner_radius_;
    shape.table = table_.get();
    set_spatial_shape(std::make_shared<const SpatialShape>(shape));
  } else if (const SpatialShape* shape = points_->spatial_shape()) {
    set_spatial_shape(std::make_shared<const SpatialShape>(*shape));
  }
  if (!hull.found) return;

  for (auto edge = hull.edges.begin(); edge != hull.edges.end(); ++edge) {
    const bool next = edge == hull.edges.begin() || std::prev(edge)->first != edge->first;
    vertex_count_ += next ? 1 : 0;
  }
}

void PreparedSet::keep(const Eigen::Ref<const Eigen::MatrixXd>& points) {
  points_ = PointSet::clustered(points);
  extent_ = points.colwise().norm().maxCoeff() * kRadiusRounding;
}

double PreparedSet::do_support(const double* u, double* point) const {
  const std::int32_t i = table_ == nullptr ? -1 : table_->highest({u[0], u[1], u[2]});
  if (i < 0) return points_->support_unchecked(u, point);
  points_->copy_point(i, point);
  return dot(u, point, 3);
}

void PreparedSet::do_center(double* point) const { Vector::Map(point, dimension()) = center_; }

void PreparedSet::do_magnitude(double* magnitude) const { points_->magnitude_unchecked(magnitude); }

double PreparedSet::do_inner_radius(const double* c) const {
  const double away = distance_between(center_.data(), c, dimension());
  return proven_length(inner_radius_ - away, extent_ + 2 * away, dimension());
}

SupportStructure PreparedSet::do_structure() const noexcept { return points_->structure(); }

std::ptrdiff_t PreparedSet::memory() const noexcept {
  const std::ptrdiff_t numbers = points_->block_count() * kLanes * dimension();
  const std::ptrdiff_t single = points_->single_data() == nullptr
                                    ? 0
                                    : points_->single_block_count() * PointSet::kSingleLanes * dimension();
  const std::ptrdiff_t tree = points_->tree() == nullptr ? 0 : points_->tree()->memory();
  return numbers * 8 + single * 4 + tree +
         (table_ == nullptr ? 0 : static_cast<std::ptrdiff_t>(table_->memory()));
}

const PointSet* as_point_set(const ConvexSet& S) noexcept {
  if (typeid(S) == typeid(PointSet)) return static_cast<const PointSet*>(&S);
  return typeid(S) == typeid(PreparedSet) ? &static_cast<const PreparedSet&>(S).points() : nullptr;
}

}  // namespace raygauge
