// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/meshes/box_tree.h"
#include "engine/meshes/tuning.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace raygauge {
namespace {

constexpr std::ptrdiff_t kLeast = 4096;  // triangles of a subtree that another thread is asked for

float up(double x) {
  const auto rounded = static_cast<float>(x);
  return double{rounded} < x ? std::nextafter(rounded, std::numeric_limits<float>::infinity()) : rounded;
}

double coordinate(const Vector3& v, int k) { return k == 0 ? v.x : k == 1 ? v.y : v.z; }

void set_axis(BoxNode& box, int k, const Vector3& v) {
  for (int i = 0; i < 3; ++i) box.axis[k][i] = static_cast<float>(coordinate(v, i));
}

// About the axes as they are: with z the lengths along them, x - center = Aᵀ(AAᵀ)⁻¹z.
void set_halves(BoxNode& box, const double* z) {
  const double size = std::sqrt(z[0] * z[0] + z[1] * z[1] + z[2] * z[2]);
  for (int k = 0; k < 3; ++k)
    box.half[k] = up(z[k] + BoxNode::kAxisError * size + double{std::numeric_limits<float>::denorm_min()});
}

double measure_of(const BoxNode& box) {
  const double a = double{box.half[0]}, b = double{box.half[1]}, c = double{box.half[2]};
  return a * b + b * c + c * a;
}

using Triangles = std::span<const TriangleCorners>;

// Along the mean normal and, across it, the direction in which the triangles' corners are spread most. False
// where there is no such normal.
bool lay_along(Triangles triangles, const Vector3& o, BoxNode& box) {
  Vector3 n;
  for (const TriangleCorners& t : triangles) n = n + t.normal();
  const double size = length(n);
  if (!(size > 0) || !std::isfinite(size)) return false;
  n = n * (1 / size);
  const Vector3 x = any_orthogonal(n), y = cross(n, x);
  double xx = 0, xy = 0, yy = 0, mean_x = 0, mean_y = 0;
  for (const TriangleCorners& t : triangles) {
    for (const Vector3& p : t.corner) {
      const double a = dot(x, p - o), b = dot(y, p - o);
      mean_x += a;
      mean_y += b;
      xx += a * a;
      xy += a * b;
      yy += b * b;
    }
  }
  const double count = 3 * static_cast<double>(triangles.size());
  xx -= mean_x * mean_x / count;
  xy -= mean_x * mean_y / count;
  yy -= mean_y * mean_y / count;
  const double turn = 0.5 * std::atan2(2 * xy, xx - yy);
  const Vector3 along = x * std::cos(turn) + y * std::sin(turn);
  set_axis(box, 0, n);
  set_axis(box, 1, along);
  set_axis(box, 2, cross(n, along));
  return true;
}

// The least box with the axes that it has.
void fit(Triangles triangles, const Vector3& o, BoxNode& box) {
  const Vector3 axis[3] = {vector_of(box.axis[0]), vector_of(box.axis[1]), vector_of(box.axis[2])};
  double low[3], high[3], z[3] = {0, 0, 0};
  std::fill_n(low, 3, std::numeric_limits<double>::infinity());
  std::fill_n(high, 3, -std::numeric_limits<double>::infinity());
  for (const TriangleCorners& t : triangles) {
    for (const Vector3& p : t.corner) {
      for (int k = 0; k < 3; ++k) {
        const double along = dot(axis[k], p - o);
        low[k] = std::min(low[k], along);
        high[k] = std::max(high[k], along);
      }
    }
  }
  Vector3 center = o;
  for (int k = 0; k < 3; ++k) center = center + axis[k] * (0.5 * (low[k] + high[k]));
  for (int i = 0; i < 3; ++i) box.center[i] = static_cast<float>(coordinate(center, i));
  const Vector3 c = vector_of(box.center);
  for (const TriangleCorners& t : triangles) {
    for (const Vector3& p : t.corner) {
      for (int k = 0; k < 3; ++k) z[k] = std::max(z[k], std::fabs(dot(axis[k], p - c)));
    }
  }
  set_halves(box, z);
}

std::ptrdiff_t leaves_of(std::ptrdiff_t triangles) {
  return (triangles + BoxTree::kLeaf - 1) / BoxTree::kLeaf;
}

}  // namespace

/// Items [begin, end) and the place of their node.
struct BoxTree::Span {
  std::ptrdiff_t begin, end;
  std::int32_t node;
  std::ptrdiff_t size() const { return end - begin; }
};

/// low <= x <= high.
struct BoxTree::Limits {
  double low[3], high[3];

  Limits() {
    std::fill_n(low, 3, std::numeric_limits<double>::infinity());
    std::fill_n(high, 3, -std::numeric_limits<double>::infinity());
  }
  void add(const Vector3& v) {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], coordinate(v, k));
      high[k] = std::max(high[k], coordinate(v, k));
    }
  }
  void add(const Limits& other) {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], other.low[k]);
      high[k] = std::max(high[k], other.high[k]);
    }
  }
};

BoxNode BoxNode::around(const double* low, const double* high) noexcept {
  BoxNode box{};
  double z[3];
  for (int k = 0; k < 3; ++k) {
    box.axis[k][k] = 1;
    box.center[k] = static_cast<float>(0.5 * low[k] + 0.5 * high[k]);
    z[k] = std::max(high[k] - double{box.center[k]}, double{box.center[k]} - low[k]);
  }
  set_halves(box, z);
  return box;
}

BoxTree::BoxTree(const Eigen::Ref<const Eigen::Matrix3Xd>& vertices, std::span<const MeshTriangle> triangles,
                 int threads)
    : given_(triangles), vertices_(vertices.data()), stride_(vertices.outerStride()) {
  const std::size_t count = triangles.size();
  triangles_.resize(count);
  number_.resize(count);
  nodes_.resize(static_cast<std::size_t>(2 * leaves_of(size()) - 1));
  std::vector<SplitItem> items(count);
  double square = 0;
#pragma omp parallel for num_threads(threads) default(none) shared(triangles, items) reduction(max : square)
  for (std::ptrdiff_t i = 0; i < size(); ++i) {
    Limits limits;
    for (const std::int32_t corner : triangles[static_cast<std::size_t>(i)]) {
      const double* p = vertices_ + corner * stride_;
      const Vector3 v{p[0], p[1], p[2]};
      square = std::max(square, dot(v, v));
      limits.add(v);
    }
    SplitItem& item = items[static_cast<std::size_t>(i)];
    for (int k = 0; k < 3; ++k) {
      item.center[k] = static_cast<float>(0.5 * (limits.low[k] + limits.high[k]));
      item.half[k] = static_cast<float>(0.5 * (limits.high[k] - limits.low[k]));
    }
    item.number = static_cast<std::int32_t>(i);
  }
  extent_ = std::sqrt(square) * (1 + 1e-15);
  const int levels = threads > 1 ? std::bit_width(static_cast<unsigned>(threads)) + 2 : 0;
#pragma omp parallel num_threads(threads) default(none) shared(items, levels) if (levels > 0)
#pragma omp single
  build(items, {0, size(), 0}, levels);
  given_ = {};
  vertices_ = nullptr;
  wide_.build(nodes_, triangles_);
}

BoxTree::Limits BoxTree::build(std::vector<SplitItem>& items, const Span& span, int parallel_levels) {
  if (span.size() <= kLeaf) return fill_leaf(items, span);
  const auto first = items.begin() + span.begin, last = items.begin() + span.end;
  const std::span<const SplitItem> here{first, last};
  const std::ptrdiff_t unit = span.size() > WideTree::kBlock ? WideTree::kBlock : kLeaf;
  const BoxSplit split = span.size() > WideTree::kBlock && span.size() <= tuned::kSearchedTriangles
                             ? best_split(here, unit)
                             : middle_split(here, unit);
  const std::ptrdiff_t middle = span.begin + split.first;
  std::nth_element(first, items.begin() + middle, last, [&](const SplitItem& a, const SplitItem& b) {
    return a.center[split.axis] < b.center[split.axis];
  });
  const auto second = static_cast<std::int32_t>(span.node + 2 * leaves_of(split.first));
  const Span one{span.begin, middle, span.node + 1}, other{middle, span.end, second};
  Limits limits, of_other;
  if (parallel_levels > 0 && span.size() > kLeast) {
#pragma omp task default(none) shared(items, one, parallel_levels, limits)
    limits = build(items, one, parallel_levels - 1);
    of_other = build(items, other, parallel_levels - 1);
#pragma omp taskwait
  } else {
    limits = build(items, one, 0);
    of_other = build(items, other, 0);
  }
  limits.add(of_other);
  bound(span, limits);
  BoxNode& box = nodes_[static_cast<std::size_t>(span.node)];
  box.next = second;
  box.count = 0;
  return limits;
}

// The better one of a box along the axes of the space and, about few triangles, one that lies along them.
void BoxTree::bound(const Span& span, const Limits& limits) {
  BoxNode& box = nodes_[static_cast<std::size_t>(span.node)];
  box = BoxNode::around(limits.low, limits.high);
  if (span.size() > tuned::kOrientedTriangles) return;
  const Triangles triangles{triangles_.data() + span.begin, static_cast<std::size_t>(span.size())};
  BoxNode oriented{};
  if (!lay_along(triangles, vector_of(box.center), oriented)) return;
  fit(triangles, vector_of(box.center), oriented);
  if (measure_of(oriented) < measure_of(box)) box = oriented;
}

BoxTree::Limits BoxTree::fill_leaf(const std::vector<SplitItem>& items, const Span& span) {
  Limits limits;
  for (std::ptrdiff_t i = span.begin; i < span.end; ++i) {
    const std::int32_t number = items[static_cast<std::size_t>(i)].number;
    number_[static_cast<std::size_t>(i)] = number;
    for (std::size_t c = 0; c < 3; ++c) {
      const double* p = vertices_ + given_[static_cast<std::size_t>(number)][c] * stride_;
      const Vector3 v{p[0], p[1], p[2]};
      triangles_[static_cast<std::size_t>(i)].corner[c] = v;
      limits.add(v);
    }
  }
  bound(span, limits);
  BoxNode& box = nodes_[static_cast<std::size_t>(span.node)];
  box.next = static_cast<std::int32_t>(span.begin);
  box.count = static_cast<std::int32_t>(span.size());
  return limits;
}

TriangleRange BoxTree::triangles_of(std::int32_t node_number) const noexcept {
  std::int32_t first = node_number, last = node_number;
  while (!node(first).is_leaf()) ++first;
  while (!node(last).is_leaf()) last = node(last).next;
  return {node(first).next, node(last).next + node(last).count};
}

std::ptrdiff_t BoxTree::memory() const noexcept {
  return static_cast<std::ptrdiff_t>(nodes_.capacity() * sizeof(BoxNode) +
                                     triangles_.capacity() * sizeof(TriangleCorners) +
                                     number_.capacity() * sizeof(std::int32_t) + sizeof(*this)) +
         wide_.memory();
}

}  // namespace raygauge
