// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// A set of one's own: any convex body whose support mapping can be written down. Here the gauge is the
// Euclidean unit ball, so that the distance is the Euclidean distance of A from the origin.
#include <raygauge/raygauge.h>

#include <cmath>
#include <cstdio>
#include <string>

namespace {

/// {x : |x| <= radius}:  h(u) = radius·|u|,  s(u) = radius·u/|u|.
class Ball final : public raygauge::ConvexSet {
 public:
  Ball(int dimension, double radius) : ConvexSet(dimension), radius_(radius) {}

 private:
  double do_support(const double* u, double* point) const override {
    const auto direction = Eigen::Map<const Eigen::VectorXd>(u, dimension());
    const double length = direction.norm();
    auto s = Eigen::Map<Eigen::VectorXd>(point, dimension());
    s.setZero();
    if (length > 0) s = direction * (radius_ / length);
    return radius_ * length;
  }
  void do_center(double* point) const override { Eigen::Map<Eigen::VectorXd>(point, dimension()).setZero(); }

  double radius_;
};

/// The corners of [1, 2] × [2, 3] × … × [n, n+1], whose nearest point to the origin is (1, 2, …, n).
raygauge::PointSet box(int n) {
  Eigen::MatrixXd corners(n, 1 << n);
  for (int i = 0; i < corners.cols(); ++i) {
    for (int k = 0; k < n; ++k) corners(k, i) = 1 + k + ((i >> k) & 1);
  }
  return raygauge::PointSet(corners);
}

/// |(1, 2, …, n)|.
double exact_distance(int n) { return std::sqrt(n * (n + 1) * (2 * n + 1) / 6.0); }

}  // namespace

int main() {
  raygauge::DistanceSolver solver;
  for (int n = 2; n <= 6; ++n) {
    // A copy: the solver's own result lives until its next solve only.
    const raygauge::DistanceResult r = solver.solve(box(n), Ball(n, 1), raygauge::Effects::witness);
    const double exact = exact_distance(n);
    std::printf("n = %d: distance %.9f, exactly %.9f, %s\n", n, r.distance, exact,
                std::string(raygauge::to_string(r.status)).c_str());
    const bool close = std::abs(r.distance - exact) <= solver.options().tolerance * exact;
    if (r.status != raygauge::DistanceStatus::optimal || !close) return 1;
    if (r.normal.size() != n || r.contact_point.size() != n) return 1;
  }
}
