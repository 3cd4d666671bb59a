// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/meshes/surface.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace raygauge {
namespace {

using Vertices = Eigen::Ref<const Eigen::Matrix3Xd>;

std::uint64_t hash_of(const Vector3& p) {
  constexpr std::uint64_t kMix = 0x9E3779B97F4A7C15ULL;
  std::uint64_t hash = 0;
  for (const double x : {p.x, p.y, p.z}) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(x + 0.0)) * kMix;  // -0 is 0
    hash ^= hash >> 29;
  }
  return hash;
}

/// Joins what is connected.
class Parts {
 public:
  explicit Parts(std::size_t count) : above_(count) { std::iota(above_.begin(), above_.end(), 0); }

  std::int32_t top(std::int32_t i) {
    while (above(i) != i) i = above(i) = above(above(i));
    return i;
  }
  void join(std::int32_t i, std::int32_t k) { above(std::max(top(i), top(k))) = std::min(top(i), top(k)); }

 private:
  std::int32_t& above(std::int32_t i) { return above_[static_cast<std::size_t>(i)]; }
  std::vector<std::int32_t> above_;
};

/// An edge as its vertex of the greater number sees it.
struct HalfEdge {
  std::int32_t lesser, triangle;
  int turn;  // +1 from the lesser vertex to the greater one
};

/// Half edges by their greater vertex.
struct EdgeTable {
  std::vector<std::size_t> begin;
  std::vector<HalfEdge> edges;
};

// use(a, b, t) for the three edges of each triangle t, from place a to place b; no edge joins a place to
// itself.
template <class Use>
void for_each_edge(std::span<const MeshTriangle> triangles, const std::vector<std::int32_t>& place,
                   const Use& use) {
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t a = place[static_cast<std::size_t>(triangles[t][i])],
                         b = place[static_cast<std::size_t>(triangles[t][(i + 1) % 3])];
      if (a != b) use(a, b, static_cast<std::int32_t>(t));
    }
  }
}

EdgeTable edges_of(std::span<const MeshTriangle> triangles, const std::vector<std::int32_t>& place) {
  EdgeTable table;
  table.begin.assign(place.size() + 1, 0);
  for_each_edge(triangles, place, [&](std::int32_t a, std::int32_t b, std::int32_t) {
    ++table.begin[static_cast<std::size_t>(std::max(a, b)) + 1];
  });
  std::partial_sum(table.begin.begin(), table.begin.end(), table.begin.begin());
  table.edges.resize(table.begin.back());
  std::vector<std::size_t> next(table.begin.begin(), table.begin.end() - 1);
  for_each_edge(triangles, place, [&](std::int32_t a, std::int32_t b, std::int32_t t) {
    table.edges[next[static_cast<std::size_t>(std::max(a, b))]++] = {std::min(a, b), t, a < b ? 1 : -1};
  });
  return table;
}

// The edges at one vertex must be used in both directions as often.
void count_open(std::span<HalfEdge> edges, SurfaceFacts& facts) {
  std::sort(edges.begin(), edges.end(), [](const HalfEdge& a, const HalfEdge& b) {
    return a.lesser != b.lesser ? a.lesser < b.lesser : a.triangle < b.triangle;
  });
  for (std::size_t i = 0; i < edges.size();) {
    int turns = 0;
    std::size_t end = i;
    for (; end < edges.size() && edges[end].lesser == edges[i].lesser; ++end) turns += edges[end].turn;
    if (turns != 0) {
      ++facts.open_edges;
      if (facts.open_triangle < 0 || edges[i].triangle < facts.open_triangle)
        facts.open_triangle = edges[i].triangle;
    }
    i = end;
  }
}

}  // namespace

std::vector<std::int32_t> first_at_place(const Vertices& vertices) {
  const std::size_t count = static_cast<std::size_t>(vertices.cols());
  const std::size_t room = std::bit_ceil(2 * count + 1);
  std::vector<std::int32_t> table(room, -1), place(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3 p = column(vertices, static_cast<std::int32_t>(i));
    std::size_t slot = hash_of(p) & (room - 1);
    while (table[slot] >= 0) {
      const Vector3 q = column(vertices, table[slot]);
      if (p.x == q.x && p.y == q.y && p.z == q.z) break;
      slot = (slot + 1) & (room - 1);
    }
    if (table[slot] < 0) table[slot] = static_cast<std::int32_t>(i);
    place[i] = table[slot];
  }
  return place;
}

SurfaceFacts surface_facts(const Vertices& vertices, std::span<const MeshTriangle> triangles) {
  SurfaceFacts facts;
  const std::vector<std::int32_t> place = first_at_place(vertices);
  EdgeTable table = edges_of(triangles, place);
  for (std::size_t i = 0; i < place.size(); ++i)
    count_open({table.edges.data() + table.begin[i], table.begin[i + 1] - table.begin[i]}, facts);
  Parts parts(place.size());
  for_each_edge(triangles, place, [&](std::int32_t a, std::int32_t b, std::int32_t) { parts.join(a, b); });
  std::vector<bool> named(place.size());
  for (const MeshTriangle& triangle : triangles) {
    const auto top = static_cast<std::size_t>(parts.top(place[static_cast<std::size_t>(triangle[0])]));
    if (!named[top]) facts.parts.push_back(triangle[0]);
    named[top] = true;
  }
  return facts;
}

double enclosed_volume(const Vertices& vertices, std::span<const MeshTriangle> triangles) {
  if (triangles.empty()) return 0;
  const Vector3 o = column(vertices, triangles[0][0]);
  double six_times = 0;
  for (const MeshTriangle& t : triangles) {
    const Vector3 a = column(vertices, t[0]) - o, b = column(vertices, t[1]) - o,
                  c = column(vertices, t[2]) - o;
    six_times += dot(a, cross(b, c));
  }
  return six_times / 6;
}

}  // namespace raygauge
