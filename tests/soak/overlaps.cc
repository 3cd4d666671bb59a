// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "tests/soak/overlaps.h"

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "engine/numerics/number_text.h"
#include "generators/random.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/point_set.h"

namespace raygauge::soak {
namespace {

using Whole = Eigen::Matrix<std::int64_t, 3, 1>;  // in quarters; the third is 0 in R^2

enum class Truth : std::uint8_t { apart, touching, overlapping };

DistanceOptions options() {
  DistanceOptions options;
  options.method = DistanceMethod::newton;
  return options;
}

// A polytope in a pose: its vertices in the world in quarters, and the set that is solved.
struct Body {
  std::vector<Whole> vertices;
  std::shared_ptr<const ConvexSet> set;
  Pose pose{3};
};

Whole cross(const Whole& a, const Whole& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// A rotation by right angles: signs and an order of the axes.
Eigen::Matrix<std::int64_t, 3, 3> draw_turn(RandomStream& stream, int n) {
  Eigen::Matrix<std::int64_t, 3, 3> R = Eigen::Matrix<std::int64_t, 3, 3>::Identity();
  for (std::int64_t turns = stream.integer(0, 5); turns > 0; --turns) {
    const auto i = stream.integer(0, n - 1), j = (i + 1) % n;
    const Eigen::Matrix<std::int64_t, 3, 1> column = R.col(i);
    R.col(i) = R.col(j);
    R.col(j) = -column;
  }
  return R;
}

// In the frame of the body: a box, a cross-polytope, a simplex, or any points.
std::vector<Whole> draw_vertices(RandomStream& stream, int n, std::int64_t step, std::int64_t size) {
  const auto draw = [&](std::int64_t low, std::int64_t high) { return step * stream.integer(low, high); };
  const Whole center(draw(-size, size), draw(-size, size), n == 3 ? draw(-size, size) : 0);
  const Whole half(draw(1, size), draw(1, size), n == 3 ? draw(1, size) : 0);
  std::vector<Whole> points;
  const std::int64_t kind = stream.integer(0, 3);
  if (kind == 0) {
    for (int i = 0; i < 1 << n; ++i) {
      points.push_back(center + Whole((i & 1) != 0 ? half[0] : -half[0], (i & 2) != 0 ? half[1] : -half[1],
                                      (i & 4) != 0 ? half[2] : -half[2]));
    }
  } else if (kind == 1) {
    for (int k = 0; k < n; ++k) {
      points.push_back(center + half[k] * Whole::Unit(k));
      points.push_back(center - half[k] * Whole::Unit(k));
    }
  } else {
    const std::int64_t count = kind == 2 ? n + 1 : stream.integer(1, 8);
    for (std::int64_t i = 0; i < count; ++i)
      points.emplace_back(draw(-size, size), draw(-size, size), n == 3 ? draw(-size, size) : 0);
  }
  return points;
}

bool is_box(const std::vector<Whole>& points, int n) {
  if (points.size() != std::size_t{1} << n || (points.front().array() > points.back().array()).any())
    return false;
  for (int i = 0; i < 1 << n; ++i) {
    for (int k = 0; k < n; ++k) {
      const Whole& corner = (i >> k & 1) != 0 ? points.back() : points.front();
      if (points[static_cast<std::size_t>(i)][k] != corner[k]) return false;
    }
  }
  return true;
}

// Multiples of a quarter times `scale`, in a pose or where they are.
Body make_body(RandomStream& stream, const std::vector<Whole>& points, int n, double scale, bool posed) {
  Body body;
  const double unit = scale / 4;
  Eigen::MatrixXd columns(n, static_cast<Eigen::Index>(points.size()));
  for (Eigen::Index i = 0; i < columns.cols(); ++i)
    columns.col(i) = points[static_cast<std::size_t>(i)].head(n).cast<double>() * unit;
  if (is_box(points, n) && stream.uniform() < 0.5) {
    body.set = std::make_shared<Box>(columns.col(0), columns.col(columns.cols() - 1));
  } else {
    body.set = std::make_shared<PointSet>(columns);
  }
  Eigen::Matrix<std::int64_t, 3, 3> R = Eigen::Matrix<std::int64_t, 3, 3>::Identity();
  Whole t = Whole::Zero();
  if (posed) {
    R = draw_turn(stream, n);
    for (int k = 0; k < n; ++k) t[k] = stream.integer(-4, 4);
  }
  body.pose = Pose(R.topLeftCorner(n, n).cast<double>(), t.head(n).cast<double>() * unit);
  for (const Whole& point : points) body.vertices.push_back(R * point + t);
  return body;
}

// Whether the origin is one of the points, between two of them, or in a triangle of three, which are all in a
// plane through the origin: then it is in their hull if it is in any.
bool holds_origin(const std::vector<Whole>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].isZero()) return true;
    for (std::size_t j = 0; j < i; ++j) {
      const Whole across = cross(points[i], points[j]);
      if (across.isZero()) {
        if (points[i].dot(points[j]) < 0) return true;
        continue;
      }
      for (std::size_t k = 0; k < j; ++k) {
        if (across.dot(cross(points[j], points[k])) > 0 && across.dot(cross(points[k], points[i])) > 0)
          return true;
      }
    }
  }
  return false;
}

// What is on the plane through the origin across n, if all points are on one side of it; empty otherwise.
bool supports(const std::vector<Whole>& points, const Whole& n, std::vector<Whole>& on_plane) {
  on_plane.clear();
  bool above = false, below = false;
  for (const Whole& point : points) {
    const std::int64_t height = n.dot(point);
    above = above || height > 0;
    below = below || height < 0;
    if (above && below) return false;
    if (height == 0) on_plane.push_back(point);
  }
  return true;
}

// A plane through the origin that supports the points can be turned until it holds two of them (in R^2, and
// where they are flat, one and a normal), or be moved from the origin.
Truth truth_of(const Body& A, const Body& B, int n) {
  std::vector<Whole> points, on_plane;
  for (const Whole& a : A.vertices) {
    for (const Whole& b : B.vertices) points.push_back(b - a);
  }
  std::vector<Whole> directions = points;
  if (n == 2) directions.assign(1, Whole(0, 0, 1));
  for (int k = 0; k < n; ++k) directions.push_back(Whole::Unit(k));
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (const Whole& direction : directions) {
      const Whole normal = cross(points[i], direction);
      if (normal.isZero() || (n == 2 && normal[2] != 0) || !supports(points, normal, on_plane)) continue;
      return holds_origin(on_plane) ? Truth::touching : Truth::apart;
    }
  }
  const bool is_point = std::all_of(points.begin(), points.end(), [](const Whole& p) { return p.isZero(); });
  return is_point ? Truth::touching : Truth::overlapping;
}

std::string text_of(const Body& body) {
  std::string text;
  for (const Whole& v : body.vertices)
    text += " (" + std::to_string(v[0]) + " " + std::to_string(v[1]) + " " + std::to_string(v[2]) + ")";
  return text;
}

std::string violation(Truth truth, bool is_exact, const DistanceResult& d, const DistanceResult& g,
                      Separation s) {
  const auto bounds = [](const DistanceResult& r) {
    return " [" + shortest_text(r.lower) + ", " + shortest_text(r.upper) + "], " +
           std::string(to_string(r.status));
  };
  const bool met = d.status == DistanceStatus::contains_origin;
  if (truth == Truth::overlapping) {
    if (!met) return "they overlap, but the distance is" + bounds(d);
    if (s != Separation::intersecting) return "they overlap, but the separation is another";
    if (!(g.upper <= 1)) return "they overlap, but the growth distance is" + bounds(g);
  }
  if (truth == Truth::apart && (met || s == Separation::intersecting || g.upper < 1))
    return "they are apart, but the distance is" + bounds(d) + ", the growth distance" + bounds(g);
  if (truth == Truth::touching && is_exact && (d.lower > 0 || s == Separation::separated || g.lower > 1))
    return "they touch, but the distance is" + bounds(d) + ", the growth distance" + bounds(g);
  return "";
}

}  // namespace

Overlaps::Overlaps(std::uint64_t seed) : seed_(seed), distance_(options()), growth_(options()) {}

std::optional<std::string> Overlaps::check(std::int64_t number) {
  RandomStream stream({seed_, 1, static_cast<int>(number >> 31), static_cast<int>(number & 0x7fffffff)},
                      "overlaps", RandomPurpose::shape);
  const int n = stream.uniform() < 0.7 ? 3 : 2;
  constexpr std::array<double, 4> kScales = {1, 1, 1e9, 1e-9};
  const double scale = kScales[static_cast<std::size_t>(stream.integer(0, 3))];
  constexpr std::array<std::int64_t, 3> kSteps = {1, 2, 4};
  const auto step = [&] { return kSteps[static_cast<std::size_t>(stream.integer(0, 2))]; };
  const bool posed = stream.uniform() < 0.5;
  const std::vector<Whole> one = draw_vertices(stream, n, step(), stream.integer(1, 6));
  std::vector<Whole> other = draw_vertices(stream, n, step(), stream.integer(1, 6));
  if (stream.uniform() < 0.1) other = one;
  const Body A = make_body(stream, one, n, scale, posed), B = make_body(stream, other, n, scale, posed);
  const Truth truth = truth_of(A, B, n);
  const Ball metric(Vector::Zero(n), 1);
  const Posed first(*A.set, A.pose), second(*B.set, B.pose);
  const DistanceResult d = distance_.solve(first, second, metric, ObjectEffects::none, nullptr).distance;
  const DistanceResult g = growth_.solve_about_centers(first, second);
  const Separation s = growth_.separation(first, second).outcome;
  ++tally_.pairs;
  tally_.overlapping += truth == Truth::overlapping ? 1 : 0;
  tally_.touching += truth == Truth::touching ? 1 : 0;
  tally_.undecided += truth == Truth::touching && d.status != DistanceStatus::contains_origin ? 1 : 0;
  const std::string what = violation(truth, scale >= 1, d, g, s);
  if (what.empty()) return std::nullopt;
  return "pair " + std::to_string(number) + " in R^" + std::to_string(n) + ", scale " + shortest_text(scale) +
         ": " + what + "; in quarters:" + text_of(A) + " and" + text_of(B);
}

std::string to_string(const OverlapTally& tally) {
  return std::to_string(tally.pairs) + " pairs, " + std::to_string(tally.overlapping) + " overlap, " +
         std::to_string(tally.touching) + " touch, " + std::to_string(tally.undecided) +
         " of these with an open distance\n";
}

}  // namespace raygauge::soak
