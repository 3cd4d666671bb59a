// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Support functions in quadruple precision, held to what no rounding changes: h(u) = u·s(u), h(u) >= u·s(v).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/numerics/vector_kernels.h"
#include "engine/sets/capability_queries.h"
#include "raygauge/sets/truncated_cone.h"
#include "tests/engine/sets/set_cases.h"

namespace raygauge::test_quad_pieces {
namespace {

template <class Real>
struct Evaluated {
  Evaluated(const ConvexSet& S, const std::vector<Real>& u)
      : points(static_cast<std::size_t>(S.dimension()) * SupportPieces::kCapacity),
        hessians(points.size() * static_cast<std::size_t>(S.dimension())) {
    pieces.dimension = S.dimension();
    pieces.points = points.data();
    pieces.hessians = hessians.data();
    support_pieces(S, u.data(), pieces);
  }
  int best() const {
    return static_cast<int>(std::max_element(pieces.value.begin(), pieces.value.begin() + pieces.count) -
                            pieces.value.begin());
  }
  Real value() const { return pieces.value[static_cast<std::size_t>(best())]; }

  std::vector<Real> points, hessians;
  BasicSupportPieces<Real> pieces;
};

std::vector<Quad> in_quad(const Vector& u) { return {u.begin(), u.end()}; }

class QuadPieces : public testing::TestWithParam<SetCase> {
 protected:
  const ConvexSet& set() const { return *GetParam().set; }
  int n() const { return set().dimension(); }
  bool smooth() const {
    return set().structure() == SupportStructure::smooth || set().structure() == SupportStructure::point;
  }
  /// Σ |u_k| m_k
  double magnitude(const Vector& u) const {
    Vector m(n());
    set().magnitude_unchecked(m.data());
    return u.cwiseAbs().dot(m);
  }
  double error(const Vector& u) const { return ConvexSet::rounding_error<Quad>(n()) * magnitude(u); }
};

TEST_P(QuadPieces, AreThoseOfDoublePrecisionWithMoreDigits) {
  if (!smooth()) return;
  Random random(71);
  for (int i = 0; i < 20; ++i) {
    const Vector u = gaussian_points(n(), 1, random);
    const Evaluated<double> coarse(set(), {u.begin(), u.end()});
    const Evaluated<Quad> fine(set(), in_quad(u));
    ASSERT_EQ(fine.pieces.count, coarse.pieces.count);
    EXPECT_NEAR(static_cast<double>(fine.value()), coarse.value(),
                ConvexSet::rounding_error(n()) * magnitude(u));
    for (int j = 0; j < n() * n(); ++j) {
      const double H = coarse.hessians[static_cast<std::size_t>(j)];
      EXPECT_NEAR(static_cast<double>(fine.hessians[static_cast<std::size_t>(j)]), H,
                  1e-7 * (1 + std::fabs(H)));
    }
  }
}

TEST_P(QuadPieces, HoldTheSupportInequalityToThirtyDigits) {
  if (!smooth()) return;
  Random random(72);
  for (int i = 0; i < 20; ++i) {
    const Vector u = sphere_points(n(), 1, random);
    const Evaluated<Quad> at_u(set(), in_quad(u));
    const Quad h = at_u.value();
    for (int j = 0; j < at_u.pieces.count; ++j) {
      const Quad of_point = dot(u.data(), at_u.pieces.point(j), n());
      const Quad value = at_u.pieces.value[static_cast<std::size_t>(j)];
      EXPECT_LE(static_cast<double>(elementary::fabs(value - of_point)), 2 * error(u)) << "piece " << j;
    }
    for (const double away : {1e-14, 1e-8, 1.0}) {
      const Vector v = u + away * sphere_points(n(), 1, random);
      const Evaluated<Quad> at_v(set(), in_quad(v));
      const Quad below = dot(u.data(), at_v.pieces.point(at_v.best()), n());
      EXPECT_LE(static_cast<double>(below - h), error(u) + error(v)) << "away " << away;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sets, QuadPieces, testing::ValuesIn(set_cases()),
                         [](const auto& test) { return test.param.name; });

// A disc and its normal, whose coordinates no double holds.
template <class Body>
void expect_flat_face(const Body& body, const Vector& from, const Vector& to, const Vector& center,
                      double radius) {
  const Vector axis = (to - from) / (to - from).norm();
  const Vector beside = axis + 0.1 * Vector::Unit(3, 0), across = axis - 0.1 * Vector::Unit(3, 0);
  Quad normal[3], point[3];
  ASSERT_TRUE(facet_normal(body, in_quad(beside).data(), in_quad(across).data(), normal));
  const std::vector<Quad> target = in_quad(center + Vector{{0.1, -0.2, 0.3}});
  body.flat_faces()->point(normal, target.data(), point);
  // In the plane of the disc, and no further from its centre than the radius.
  Quad along = 0, square = 0;
  for (int k = 0; k < 3; ++k) {
    along += normal[k] * (point[k] - Quad{center[k]});
    square += (point[k] - Quad{center[k]}) * (point[k] - Quad{center[k]});
    EXPECT_NEAR(static_cast<double>(normal[k]), axis[k], 1e-15);
  }
  EXPECT_LT(static_cast<double>(elementary::fabs(along)), 1e-31);
  EXPECT_LE(static_cast<double>(elementary::sqrt(square)), radius * (1 + 1e-15));
}

TEST(QuadFacets, AreFlatToThirtyDigits) {
  const Vector p{{0.1, 0.2, -0.7}}, q{{1.3, -0.4, 0.9}};
  expect_flat_face(Cylinder(p, q, 0.5), p, q, q, 0.5);
  expect_flat_face(TruncatedCone(p, 0.5, q, 0.25), p, q, q, 0.25);
}

}  // namespace
}  // namespace raygauge::test_quad_pieces
