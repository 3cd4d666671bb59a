// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "tests/soak/random_set.h"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/p_norm_ball.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/polytopes.h"
#include "raygauge/sets/truncated_cone.h"

namespace raygauge::soak {
namespace {

using Set = std::shared_ptr<const ConvexSet>;

// Draws the numbers of one set.
class Draw {
 public:
  Draw(RandomStream& stream, Vector center, double size)
      : stream_(stream), center_(std::move(center)), size_(size) {}

  const Vector& center() const { return center_; }
  Eigen::Index n() const { return center_.size(); }

  /// In [low, high] · size.
  double number(double low, double high) {
    const double share =
        stream_.uniform() < 0.5 ? static_cast<double>(stream_.integer(0, 4)) / 4 : stream_.uniform();
    return size_ * (low + (high - low) * share);
  }
  double positive() { return number(0.25, 1); }
  double length() { return stream_.uniform() < 0.1 ? 0.0 : positive(); }
  Vector along() { return draw_direction(stream_, static_cast<int>(n())) * positive(); }
  Vector lengths() {
    return Vector::NullaryExpr(n(), [&](Eigen::Index) { return positive(); });
  }
  Eigen::MatrixXd matrix() {
    Eigen::MatrixXd M = Eigen::MatrixXd::Identity(n(), n());
    const double spread = stream_.uniform() < 0.2 ? 6 : 1;
    for (Eigen::Index k = 0; k < n(); ++k) M(k, k) = std::pow(10.0, -spread * stream_.uniform());
    if (spread > 1 || stream_.uniform() < 0.3) return M;
    for (Eigen::Index k = 1; k < n(); ++k) M(k - 1, k) = number(-1, 1) / size_;
    return M;
  }
  Eigen::MatrixXd cloud() {
    const Eigen::Index N = stream_.integer(1, 2 * n() + 6);
    return Eigen::MatrixXd::NullaryExpr(n(), N, [&](Eigen::Index, Eigen::Index) { return number(-1, 1); })
               .colwise() +
           center_;
  }
  double exponent() {
    constexpr std::array<double, 6> kExponents = {1.0, 1.1, 1.5, 2.0, 4.0, 100.0};
    return stream_.uniform() < 0.5 ? kExponents[static_cast<std::size_t>(stream_.integer(0, 5))]
                                   : 1 + 9 * stream_.uniform();
  }

 private:
  RandomStream& stream_;
  Vector center_;
  double size_;
};

RandomSet draw_simple(RandomStream& stream, Draw& draw) {
  const Vector half = draw.along();
  const Vector p = draw.center() - half, q = draw.center() + half;
  switch (stream.integer(0, 8)) {
    case 0:
      return {std::make_shared<Ball>(draw.center(), draw.length()), "ball"};
    case 1:
      return {std::make_shared<Ellipsoid>(draw.center(), draw.positive() * draw.matrix()), "ellipsoid"};
    case 2:
      return {std::make_shared<Capsule>(p, q, draw.length()), "capsule"};
    case 3:
      return {std::make_shared<Cylinder>(p, q, draw.length()), "cylinder"};
    case 4:
      return {std::make_shared<TruncatedCone>(p, draw.length(), q, draw.length()), "cone"};
    case 5:
      return {std::make_shared<PNormBall>(draw.center(), draw.lengths(), draw.exponent()), "p-ball"};
    case 6: {
      const Vector reach = draw.lengths();
      return {std::make_shared<Box>(draw.center() - reach, draw.center() + reach), "box"};
    }
    case 7: {
      const Vector legs = draw.lengths();
      return {std::make_shared<Simplex>(draw.center() - 0.25 * legs, legs), "simplex"};
    }
    default:
      return {std::make_shared<PointSet>(draw.cloud()), "points"};
  }
}

}  // namespace

Vector draw_direction(RandomStream& stream, int n) {
  const double kind = stream.uniform();
  if (kind < 0.3) return Vector::Unit(n, stream.integer(0, n - 1)) * (stream.uniform() < 0.5 ? -1.0 : 1.0);
  if (kind < 0.5) return Vector::Constant(n, (stream.uniform() < 0.5 ? -1.0 : 1.0) / std::sqrt(n));
  return Vector(Vector::NullaryExpr(n, [&](Eigen::Index) { return stream.normal(); })).normalized();
}

RandomSet draw_set(RandomStream& stream, const Vector& center, double size, int depth) {
  Draw draw(stream, center, size);
  if (depth == 0 || stream.uniform() < 0.6) return draw_simple(stream, draw);
  const RandomSet first = draw_set(stream, center, 0.5 * size, depth - 1);
  const Vector zero = Vector::Zero(center.size());
  switch (stream.integer(0, 3)) {
    case 0: {
      const RandomSet second = draw_set(stream, zero, 0.5 * size, depth - 1);
      return {std::make_shared<MinkowskiSum>(first.set, second.set),
              "sum(" + first.label + ", " + second.label + ")"};
    }
    case 1: {
      const RandomSet second = draw_set(stream, zero, 0.5 * size, depth - 1);
      return {std::make_shared<MinkowskiDifference>(first.set, second.set),
              "difference(" + first.label + ", " + second.label + ")"};
    }
    case 2: {
      const RandomSet second = draw_set(stream, center + draw.along(), 0.5 * size, depth - 1);
      return {std::make_shared<UnionHull>(std::vector<Set>{first.set, second.set}),
              "hull(" + first.label + ", " + second.label + ")"};
    }
    default: {
      const RandomSet inner = draw_set(stream, zero, size, depth - 1);
      return {std::make_shared<AffineImage>(inner.set, draw.matrix(), center), "image(" + inner.label + ")"};
    }
  }
}

}  // namespace raygauge::soak
