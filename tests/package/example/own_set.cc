// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// A set of one's own: any convex body whose support mapping can be written down. Here the gauge is the
// Euclidean unit ball, so that the distance is the Euclidean distance of A from the origin.
#include <raygauge/raygauge.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace {

/// {x : |x| <= radius}:  h(u) = radius·|u|,  s(u) = radius·u/|u|.
class Ball final : public raygauge::ConvexSet {
 public:
  Ball(int dimension, double radius) : ConvexSet(dimension), radius_(radius) {}

 private:
  double do_support(const double* u, double* point) const override {
    const auto direction = Eigen::Map<const raygauge::Vector>(u, dimension());
    const double length = direction.norm();
    auto s = Eigen::Map<raygauge::Vector>(point, dimension());
    s.setZero();
    if (length > 0) s = direction * (radius_ / length);
    return radius_ * length;
  }
  void do_center(double* point) const override { Eigen::Map<raygauge::Vector>(point, dimension()).setZero(); }

  double radius_;
};

/// The corners of [1, 2]^n, whose nearest point to the origin is (1, …, 1), at distance sqrt(n).
raygauge::PointSet box(int n) {
  Eigen::MatrixXd corners(n, 1 << n);
  for (int i = 0; i < corners.cols(); ++i) {
    for (int k = 0; k < n; ++k) corners(k, i) = 1 + ((i >> k) & 1);
  }
  return raygauge::PointSet(corners);
}

}  // namespace

int main() {
  raygauge::DistanceSolver solver;
  std::vector<raygauge::DistanceResult> results;
  for (int n = 2; n <= 6; ++n) {
    results.push_back(solver.solve(box(n), Ball(n, 1), raygauge::Effects::witness));
    const raygauge::DistanceResult& r = results.back();
    const double error = std::abs(r.distance - std::sqrt(n));
    std::printf("n = %d: distance %.9f, sqrt(n) %.9f, %s\n", n, r.distance, std::sqrt(n),
                std::string(raygauge::to_string(r.status)).c_str());
    if (r.status != raygauge::DistanceStatus::optimal || error > solver.options().tolerance * std::sqrt(n))
      return 1;
    if (r.contact_point.size() != n || r.normal.size() != n) return 1;
  }
}
