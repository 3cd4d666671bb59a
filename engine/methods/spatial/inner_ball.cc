// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/inner_ball.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/methods/spatial/nearest_on_simplex.h"
#include "engine/methods/spatial/portal.h"
#include "engine/numerics/fused.h"

namespace raygauge {
namespace {

constexpr int kMostExchanges = 200;  // rims and ellipsoids that overlap by little need small portals
constexpr int kFacets[4][3] = {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}};  // facet f lacks corner f
// Of the corners of the first simplex in c, the last one's being the rest; should the ray pass an edge, the
// next ones are taken.
constexpr double kWeights[2][3] = {{0.2831853071, 0.2671828182, 0.2360679775},
                                   {0.2071067811, 0.3143189247, 0.1914213562}};
constexpr Vector3 kGeneric{0.6180339887, 0.5357109341, -0.5754170229};

class InnerBall {
 public:
  InnerBall(const SpatialPair& pair, PrecisePair& numbers, const PreciseVector3& center, double enough);

  double run();

 private:
  PreciseVector3 support(const PreciseVector3& u);
  PreciseVector3 farther_support(const PreciseVector3& u);
  bool find_simplex();
  bool choose_portal(const double* weight);
  double depth() const;
  Portal<DoubleDouble> about_c() const { return {portal_[0] - c_, portal_[1] - c_, portal_[2] - c_}; }
  double refine();

  PrecisePair& precise_;
  PreciseVector3 center_;  // the origin of what follows
  double enough_;
  PreciseVector3 prism_[3];
  std::size_t prisms_;
  PreciseVector3 simplex_[4];
  PreciseVector3 c_;
  PreciseVector3 portal_[3];
};

InnerBall::InnerBall(const SpatialPair& pair, PrecisePair& numbers, const PreciseVector3& center,
                     double enough)
    : precise_(numbers), center_(center), enough_(enough), prisms_(pair.prisms().size()) {
  for (std::size_t i = 0; i < prisms_; ++i) {
    double world[3] = {0, 0, 0};
    pair.frame().to_world(pair.prisms()[i], world);
    if (pair.dimension() == 2) world[2] = pair.prisms()[i].z;
    prism_[i] = precise({world[0], world[1], world[2]});
  }
}

// Of length 1 in about.
PreciseVector3 unit(const PreciseVector3& u) {
  const double size = std::sqrt(dot(u, u).high);
  return size > 0 ? u * DoubleDouble{1 / size} : PreciseVector3{};
}

// s(u) of the bodies, balls and prism included, for a u of length 1 in about.
PreciseVector3 InnerBall::support(const PreciseVector3& u) {
  DoubleDouble height;
  PreciseVector3 s = precise_.support(u, height).s + precise_.ball_points(u) - center_;
  for (std::size_t i = 0; i < prisms_; ++i) s = dot(u, prism_[i]).high < 0 ? s - prism_[i] : s + prism_[i];
  return s;
}

// Of s(u) and s(-u) the one that is farther from the plane across u through the first corner.
PreciseVector3 InnerBall::farther_support(const PreciseVector3& u) {
  const PreciseVector3 up = support(u), down = support(-u);
  const double above = dot(u, up - simplex_[0]).high, below = -dot(u, down - simplex_[0]).high;
  return above >= below ? up : down;
}

// Four support points with as much between them as D has. False where that is nothing but rounding.
bool InnerBall::find_simplex() {
  const PreciseVector3 generic = precise(kGeneric);
  simplex_[0] = support(generic);
  simplex_[1] = support(-generic);
  const PreciseVector3 e = simplex_[1] - simplex_[0];
  if (!(dot(e, e).high > 0)) return false;
  simplex_[2] = farther_support(precise(any_orthogonal(rounded(unit(e)))));
  const PreciseVector3 n = unit(cross(e, simplex_[2] - simplex_[0]));
  if (!(dot(n, n).high > 0)) return false;
  simplex_[3] = farther_support(n);
  return std::fabs(dot(n, simplex_[3] - simplex_[0]).high) > 8 * precise_.error();
}

// Of the origin in the tetrahedron of c and the portal, for certain.
double InnerBall::depth() const {
  const PreciseVector3* corners[4] = {&c_, &portal_[0], &portal_[1], &portal_[2]};
  return nearest_face(corners, 4).depth - 4 * precise_.error();
}

// The facet of the simplex through which the ray from c to the origin leaves it, its corners so ordered that
// their normal points outward.
bool InnerBall::choose_portal(const double* weight) {
  double rest = 1;
  c_ = {};
  for (int i = 0; i < 3; ++i) {
    c_ = c_ + simplex_[i] * DoubleDouble{weight[i]};
    rest -= weight[i];
  }
  c_ = c_ + simplex_[3] * DoubleDouble{rest};
  for (const auto& facet : kFacets) {
    for (int i = 0; i < 3; ++i) portal_[i] = simplex_[facet[i]];
    if (about_c().determinant().high < 0) std::swap(portal_[0], portal_[1]);
    if (about_c().holds(-c_)) return true;
  }
  return false;
}

// The portal moves outward until it has passed the origin, or is on the boundary of D.
RAYGAUGE_FUSED double InnerBall::refine() {
  const PreciseVector3 p = -c_;
  double deepest = 0;
  for (int i = 0; i < kMostExchanges; ++i) {
    PreciseVector3 n = unit(triangle_normal(portal_[0], portal_[1], portal_[2]));
    if (dot(n, p).high < 0) n = -n;
    if (dot(n, portal_[0]).high > 0) deepest = std::max(deepest, depth());
    if (deepest > enough_) break;
    const PreciseVector3 w = support(n);
    const double gain = dot(n, w - portal_[0]).high;
    if (dot(n, w).high < 0 || !(gain > precise_.error())) break;
    portal_[about_c().leaving(p, w - c_)] = w;
  }
  return deepest;
}

double InnerBall::run() {
  if (!find_simplex()) return 0;
  double deepest = 0;
  for (const double* weight : kWeights) {
    if (choose_portal(weight)) deepest = std::max(deepest, refine());
    if (deepest > enough_) break;
  }
  return deepest;
}

}  // namespace

double inner_ball(const SpatialPair& pair, PrecisePair& precise, const PreciseVector3& center,
                  double enough) {
  return InnerBall(pair, precise, center, enough).run();
}

}  // namespace raygauge
