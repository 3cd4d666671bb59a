// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/prepared_set.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <typeinfo>

#include "engine/numerics/vector_kernels.h"
#include "engine/sets/hull_3d.h"
#include "engine/sets/hull_climb.h"

namespace raygauge {
namespace {

constexpr int kLanes = PointSet::kLanes;
constexpr std::ptrdiff_t kFewest = 16;  // points that a graph is worth having for
constexpr int kMostCells = 16;          // per edge of the cube of directions
constexpr double kRadiusRounding = 1 + 1e-12;

using Order = std::vector<std::ptrdiff_t>;

// Points that are seen from the centre in nearby directions stand nearby in memory: a climb stays in few
// cache lines.
void sort_by_direction(const Eigen::Ref<const Eigen::MatrixXd>& points, const Vector& center, Order& order) {
  const auto cell = [&](std::ptrdiff_t i) {
    const Vector v = points.col(i) - center;
    return direction_cell({v[0], v[1], v[2]}, kMostCells);
  };
  std::vector<int> cells(static_cast<std::size_t>(points.cols()));
  for (const std::ptrdiff_t i : order) cells[static_cast<std::size_t>(i)] = cell(i);
  std::stable_sort(order.begin(), order.end(), [&](std::ptrdiff_t a, std::ptrdiff_t b) {
    return cells[static_cast<std::size_t>(a)] < cells[static_cast<std::size_t>(b)];
  });
}

}  // namespace

bool PreparedSet::has_hulls() noexcept { return has_hull_3d(); }

PreparedSet::PreparedSet(const PointSet& points) : PreparedSet(points.points()) {}

PreparedSet::PreparedSet(const Eigen::Ref<const Eigen::MatrixXd>& points)
    : ConvexSet(static_cast<int>(points.rows())) {
  const PointSet checked(points);
  center_ = checked.center();
  Hull3 hull;
  if (dimension() == 3 && points.cols() >= kFewest) hull = hull_3d(points, center_);
  inner_radius_ = hull.inner_radius;
  Order order(hull.kept);
  if (!hull.found) {
    order.resize(static_cast<std::size_t>(points.cols()));
    std::iota(order.begin(), order.end(), 0);
  }
  if (hull.found) sort_by_direction(points, center_, order);
  keep(points(Eigen::all, order));
  if (!hull.found) return;

  std::vector<std::int32_t> place(static_cast<std::size_t>(points.cols()), -1);
  for (std::size_t i = 0; i < order.size(); ++i)
    place[static_cast<std::size_t>(order[i])] = static_cast<std::int32_t>(i);
  std::vector<std::vector<std::int32_t>> around(order.size());
  for (const auto& [from, to] : hull.edges) {
    around[static_cast<std::size_t>(place[static_cast<std::size_t>(from)])].push_back(
        place[static_cast<std::size_t>(to)]);
  }
  const std::int32_t some_vertex = place[static_cast<std::size_t>(hull.edges.front().first)];
  first_.push_back(0);
  for (auto& neighbours : around) {
    if (neighbours.empty()) {
      neighbours.push_back(some_vertex);  // near a face, no vertex: a way back to the graph
    } else {
      ++vertex_count_;
    }
    neighbours_.insert(neighbours_.end(), neighbours.begin(), neighbours.end());
    first_.push_back(static_cast<std::int32_t>(neighbours_.size()));
  }
  fill_start_table();
}

void PreparedSet::keep(const Eigen::Ref<const Eigen::MatrixXd>& points) {
  points_ = std::make_unique<const PointSet>(points);
  extent_ = points.colwise().norm().maxCoeff() * kRadiusRounding;
  if (dimension() != 3) return;
  vertices_.assign(static_cast<std::size_t>(points.cols()) * 4, 0.0);
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    Eigen::Vector3d::Map(&vertices_[static_cast<std::size_t>(i) * 4]) = points.col(i);
}

void PreparedSet::fill_start_table() {
  graph_.vertices = vertices_.data();
  graph_.first = first_.data();
  graph_.neighbours = neighbours_.data();
  const double spread = std::sqrt(static_cast<double>(vertex_count_) / 6);
  graph_.cells = std::clamp(static_cast<int>(spread), 2, kMostCells);
  const int cells = graph_.cells;
  std::int32_t vertex = neighbours_.front();
  const auto cells_of_a_face = static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells);
  start_.resize(6 * cells_of_a_face);
  auto entry = start_.begin();
  for (int face = 0; face < 6; ++face) {
    for (int i = 0; i < cells; ++i) {
      for (int j = 0; j < cells; ++j) {
        const double first = (i + 0.5) * 2 / cells - 1, second = (j + 0.5) * 2 / cells - 1;
        const double sign = face % 2 == 0 ? 1 : -1;
        const Vector3 v = face < 2   ? Vector3{sign, first, second}
                          : face < 4 ? Vector3{first, sign, second}
                                     : Vector3{first, second, sign};
        vertex = climb(graph_, v, vertex);
        *entry++ = vertex;
      }
    }
  }
  graph_.start = start_.data();
}

double PreparedSet::do_support(const double* u, double* point) const {
  return points_->support_unchecked(u, point);
}

void PreparedSet::do_center(double* point) const { Vector::Map(point, dimension()) = center_; }

void PreparedSet::do_magnitude(double* magnitude) const { points_->magnitude_unchecked(magnitude); }

double PreparedSet::do_inner_radius(const double* c) const {
  const double away = distance_between(center_.data(), c, dimension());
  return proven_length(inner_radius_ - away, extent_ + 2 * away, dimension());
}

SupportStructure PreparedSet::do_structure() const noexcept { return points_->structure(); }

bool PreparedSet::do_spatial_shape(SpatialShape& shape) const {
  const int n = dimension();
  if (n != 3) return points_->spatial_shape_unchecked(shape);
  shape.kind = SpatialShape::Kind::points;
  shape.center = {center_[0], center_[1], center_[2]};
  shape.extent = extent_;
  shape.inner_radius = inner_radius_;
  shape.coordinates = 3;
  shape.blocks = points_->data();
  shape.block_count = points_->block_count();
  shape.size = points_->size();
  if (vertex_count_ > 0) shape.graph = &graph_;
  return true;
}

std::ptrdiff_t PreparedSet::memory() const noexcept {
  const auto numbers =
      static_cast<std::ptrdiff_t>(vertices_.size()) + points_->block_count() * kLanes * dimension();
  const auto indices = static_cast<std::ptrdiff_t>(first_.size() + neighbours_.size() + start_.size());
  const std::ptrdiff_t single = points_->single_data() == nullptr
                                    ? 0
                                    : points_->single_block_count() * PointSet::kSingleLanes * dimension();
  return numbers * 8 + (indices + single) * 4;
}

const PointSet* as_point_set(const ConvexSet& S) noexcept {
  if (typeid(S) == typeid(PointSet)) return static_cast<const PointSet*>(&S);
  return typeid(S) == typeid(PreparedSet) ? &static_cast<const PreparedSet&>(S).points() : nullptr;
}

}  // namespace raygauge
