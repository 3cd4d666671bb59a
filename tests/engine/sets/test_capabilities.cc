// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Which combinator passes on which capability of its operands: each entry of the table in docs/sets.md, for
// every set that has the capability.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <sstream>

#include "engine/numerics/vector_kernels.h"
#include "engine/queries/growth_body.h"
#include "engine/sets/capability_queries.h"
#include "engine/sets/object_pair.h"
#include "engine/sets/posed_view.h"
#include "raygauge/queries/solver.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/p_norm_ball.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/polytopes.h"
#include "raygauge/sets/prepared_set.h"
#include "raygauge/sets/truncated_cone.h"
#include "tests/engine/sets/set_cases.h"

namespace raygauge::test_capabilities {
namespace {

constexpr int n = 3;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
using Set = std::shared_ptr<const ConvexSet>;

// What a combinator is applied for: {M x + t : x in S}.
struct Operation {
  std::string name;
  Eigen::Matrix3d M;
  Eigen::Vector3d t;
  bool is_neutral;  // of one set and nothing else, or {0}
  std::function<Set(const Set&)> apply;
};

struct Row {
  std::string name;                    // as in the table
  std::array<std::string, 6> entries;  // inner ball, pieces, flat faces, gauge, touching the origin, symmetry
  std::vector<Operation> operations;
  bool about_origin = false;  // whether its centre is always the origin, so that it serves as Q alone
};

constexpr std::array kColumns = {"inner ball",         "pieces",  "flat faces", "gauge",
                                 "touches the origin", "symmetry"};

bool exchanges_axes(const Eigen::Matrix3d& M) { return (M.array() != 0).count() == 3; }

// A rotation or reflection times a number.
bool is_similarity(const Eigen::Matrix3d& M) {
  const Eigen::Matrix3d square = M.transpose() * M;
  return square.isApprox(square(0, 0) * Eigen::Matrix3d::Identity(), 1e-12);
}

// What an entry of the table says of an operation.
bool promises(const std::string& entry, const Operation& operation) {
  const bool fixed = operation.t.isZero(0);
  const bool alike = operation.M.cwiseAbs().rowwise().sum().isConstant(operation.M.cwiseAbs().row(0).sum());
  if (entry == "yes") return true;
  if (entry == "t = 0") return fixed;
  if (entry == "axes") return exchanges_axes(operation.M);
  if (entry == "t = 0, axes alike") return fixed && exchanges_axes(operation.M) && alike;
  if (entry == "{0}") return operation.is_neutral;
  ADD_FAILURE() << "no such entry: " << entry;
  return false;
}

Set origin() { return std::make_shared<PointSet>(Eigen::MatrixXd::Zero(n, 1)); }

// A view together with what it looks at.
template <class View>
struct Held {
  Set S;
  Pose pose{n};
  Eigen::Vector3d a = Eigen::Vector3d::Zero(), b = Eigen::Vector3d::Zero();
  Set other;
  std::unique_ptr<const View> view;
};

Set posed(const Set& S, const Eigen::Matrix3d& R, const Eigen::Vector3d& t) {
  auto held = std::make_shared<Held<PosedView>>();
  held->S = S;
  held->pose = Pose(R, t);
  held->view = std::make_unique<const PosedView>(*S, held->pose);
  return {held, held->view.get()};
}

Set pair_of_objects(const Set& A2, const Set& A1) {
  auto held = std::make_shared<Held<ObjectPair>>();
  held->S = A2;
  held->other = A1;
  held->view = std::make_unique<const ObjectPair>(*A2, *A1, false);
  return {held, held->view.get()};
}

// S - 0 - ({p} - p).
Set growth_body_of_point(const Set& S) {
  auto held = std::make_shared<Held<GrowthBody>>();
  held->S = S;
  held->a = Eigen::Vector3d(0.1, -2, 0.3);
  held->other = std::make_shared<PointSet>(Eigen::MatrixXd(held->a));
  held->view = std::make_unique<const GrowthBody>(*held->other, TwofoldPoint{held->a.data(), nullptr}, *S,
                                                  TwofoldPoint{held->b.data(), nullptr}, false);
  return {held, held->view.get()};
}

Set negative(const Set& S) {
  return std::make_shared<AffineImage>(S, -Eigen::MatrixXd::Identity(n, n), Vector::Zero(n));
}

const Eigen::Matrix3d kIdentity = Eigen::Matrix3d::Identity();
const Eigen::Vector3d kNowhere = Eigen::Vector3d::Zero();

// Maps that need a combinator of the form M S + t; `scale` where it allows more than rotations.
std::vector<Operation> maps(
    const std::function<Set(const Set&, const Eigen::Matrix3d&, const Eigen::Vector3d&)>& make, bool scales) {
  Random random(17);
  const Eigen::Matrix3d turn = random_rotation(n, random);
  const Eigen::Matrix3d exchange{{0, -1, 0}, {0, 0, 1}, {-1, 0, 0}};
  const Eigen::Vector3d somewhere(0.25, -3, 0.1);
  std::vector<Operation> operations;
  const auto add = [&](const std::string& name, const Eigen::Matrix3d& M, const Eigen::Vector3d& t) {
    operations.push_back({name, M, t, true, [=](const Set& S) { return make(S, M, t); }});
  };
  add("identity", kIdentity, kNowhere);
  add("rotation", turn, kNowhere);
  add("exchange of axes", exchange, kNowhere);
  add("translation", kIdentity, somewhere);
  add("motion", turn, somewhere);
  if (scales) {
    add("scaling", 0.3 * kIdentity, kNowhere);
    add("rotation and scaling", 7 * turn, kNowhere);
    add("scaling of each axis", Eigen::Vector3d(0.5, 3, -0.7).asDiagonal() * exchange, kNowhere);
  }
  return operations;
}

std::vector<Operation> sums(const std::function<Set(const Set&, const Set&)>& subtract, bool sum) {
  const auto other = [sum](const Set& S) { return sum ? S : negative(S); };
  return {{"a set and {0}", kIdentity, kNowhere, true, [=](const Set& S) { return subtract(S, origin()); }},
          {"{0} and a set", kIdentity, kNowhere, true,
           [=](const Set& S) { return subtract(origin(), other(S)); }},
          {"a set and itself", 2 * kIdentity, kNowhere, false,
           [=](const Set& S) { return subtract(S, other(S)); }}};
}

std::vector<Row> rows() {
  const std::array<std::string, 6> of_maps = {"yes", "yes", "yes", "t = 0", "t = 0, axes alike", "axes"};
  const std::array<std::string, 6> of_sums = {"yes", "yes", "yes", "yes", "{0}", "yes"};
  const auto image = [](const Set& S, const Eigen::Matrix3d& M, const Eigen::Vector3d& t) -> Set {
    return std::make_shared<AffineImage>(S, M, t);
  };
  const auto sum = [](const Set& A, const Set& B) -> Set { return std::make_shared<MinkowskiSum>(A, B); };
  const auto difference = [](const Set& A, const Set& B) -> Set {
    return std::make_shared<MinkowskiDifference>(A, B);
  };
  const auto hull = [](std::vector<Set> sets) -> Set { return std::make_shared<UnionHull>(std::move(sets)); };
  return {{"`AffineImage`", of_maps, maps(image, true)},
          {"a set in a pose", of_maps, maps(posed, false)},
          {"`MinkowskiSum`", of_sums, sums(sum, true)},
          {"`MinkowskiDifference`", of_sums, sums(difference, false)},
          {"a pair of objects", of_sums, sums(pair_of_objects, false)},
          {"a growth body", of_sums, {{"of a point", kIdentity, kNowhere, true, growth_body_of_point}}, true},
          {"`UnionHull`",
           {"yes", "yes", "yes", "yes", "yes", "yes"},
           {{"of one set", kIdentity, kNowhere, true, [=](const Set& S) { return hull({S}); }},
            {"of a set and itself", kIdentity, kNowhere, false, [=](const Set& S) {
               return hull({S, S});
             }}}}};
}

struct Operand {
  std::string name;
  Set set;
};

// With the origin inside, but for the last two.
std::vector<Operand> operands() {
  Random random(5);
  const Eigen::Matrix3d turn = random_rotation(n, random);
  const Eigen::Matrix3d L = turn * Eigen::Vector3d(1, 10, 0.1).asDiagonal();
  const Vector zero = Vector::Zero(n), w{{1, 2, 0.5}}, p{{-0.4, 0.1, -1}}, q{{0.5, 0.3, 1.2}};
  Eigen::MatrixXd G(6, n);
  G << turn, -turn;
  return {{"ball", std::make_shared<Ball>(zero, 1.5)},
          {"ellipsoid", std::make_shared<Ellipsoid>(zero, L)},
          {"3-norm ball", std::make_shared<PNormBall>(zero, w, 3.0)},
          {"almost a cube", std::make_shared<PNormBall>(zero, w, 1e6)},
          {"capsule", std::make_shared<Capsule>(p, q, 0.4)},
          {"cylinder", std::make_shared<Cylinder>(p, q, 0.8)},
          {"truncated cone", std::make_shared<TruncatedCone>(p, 0.9, q, 0.3)},
          {"inequalities", std::make_shared<HPolytope>(G, Vector{{1, 2, 3, 1, 0.5, 1}})},
          {"zonotope", std::make_shared<Zonotope>(zero, turn)},
          {"points", std::make_shared<PointSet>(sphere_points(n, 40, random))},
          {"ball that touches the origin", std::make_shared<Ball>(Vector{{3, -4, 0}}, 5.0)},
          {"point", std::make_shared<PointSet>(Eigen::MatrixXd{{0.3}, {1}, {-0.7}})}};
}

template <class Real>
struct Pieces {
  Pieces(const ConvexSet& S, const std::vector<Real>& u) : points(8 * n), hessians(8 * n * n) {
    list.dimension = n;
    list.points = points.data();
    list.hessians = hessians.data();
    support_pieces(S, u.data(), list);
  }
  std::size_t best() const {
    return static_cast<std::size_t>(std::max_element(list.value.begin(), list.value.begin() + list.count) -
                                    list.value.begin());
  }
  std::vector<Real> points, hessians;
  BasicSupportPieces<Real> list;
};

template <class Real>
std::vector<Real> numbers(const Eigen::Vector3d& u) {
  return {u.begin(), u.end()};
}

template <class Real>
Eigen::Vector3d rounded(const Real* x) {
  return {static_cast<double>(x[0]), static_cast<double>(x[1]), static_cast<double>(x[2])};
}

void expect_parallel(const Eigen::Vector3d& one, const Eigen::Vector3d& other) {
  EXPECT_LT((one.normalized() - other.normalized()).norm(), 1e-11);
}

// Each tells whether T = M S + t has what S has, and checks it; `has` tells whether S has it at all.
class Capability : public testing::TestWithParam<std::tuple<std::size_t, std::size_t>> {
 protected:
  static const Operation* operation;

  static Eigen::Vector3d back(const Eigen::Vector3d& u) { return operation->M.transpose() * u; }
  static Eigen::Vector3d normal_of(const Eigen::Vector3d& v) {
    return operation->M.transpose().inverse() * v;
  }

  static bool inner_ball(const ConvexSet& S, const ConvexSet& T) {
    const Eigen::Vector3d c = S.center(), image = operation->M * c + operation->t;
    const double radius = S.inner_radius_unchecked(c.data());
    const double of_T = T.inner_radius_unchecked(image.data());
    const double least_stretch = operation->M.jacobiSvd().singularValues().minCoeff();
    if (!(of_T > 0)) return false;
    EXPECT_GE(of_T, (1 - 1e-9) * least_stretch * radius);
    return true;
  }

  template <class Real>
  static bool pieces_in(const ConvexSet& S, const ConvexSet& T) {
    Random random(3);
    for (int i = 0; i < 5; ++i) {
      const Eigen::Vector3d u = sphere_points(n, 1, random);
      const Pieces<Real> of_S(S, numbers<Real>(back(u))), of_T(T, numbers<Real>(u));
      if (of_T.list.count == 0) return false;
      const std::size_t s = of_S.best(), t = of_T.best();
      const Real value = of_S.list.value[s] + Real{u.dot(operation->t)};
      EXPECT_NEAR(static_cast<double>(of_T.list.value[t] - value), 0,
                  1e-13 * (1 + std::fabs(static_cast<double>(value))));
      const Eigen::Vector3d x = rounded(of_S.list.point(static_cast<int>(s)));
      const Eigen::Vector3d y = rounded(of_T.list.point(static_cast<int>(t)));
      EXPECT_LT((operation->M * x + operation->t - y).norm(), 1e-11 * (1 + y.norm()));
    }
    return true;
  }
  static bool pieces(const ConvexSet& S, const ConvexSet& T) {
    const bool in_double = pieces_in<double>(S, T);
    EXPECT_EQ(pieces_in<Quad>(S, T), in_double);
    return in_double;
  }

  // The faces across the axis of the two sets that have them.
  template <class Real>
  static bool flat_face(const ConvexSet& T) {
    const Eigen::Vector3d axis(0.9, 0.2, 2.2), normal = normal_of(axis.normalized());
    const Eigen::Vector3d beside = normal + 0.1 * normal.norm() * Eigen::Vector3d::UnitX();
    const Eigen::Vector3d across = normal - 0.1 * normal.norm() * Eigen::Vector3d::UnitX();
    std::vector<Real> found(n), point(n);
    if (!facet_normal(T, numbers<Real>(beside).data(), numbers<Real>(across).data(), found.data()))
      return false;
    expect_parallel(rounded(found.data()), normal);
    const Eigen::Vector3d target = T.support_mapping(normal) + Eigen::Vector3d(0.01, 0.02, -0.01);
    T.flat_faces()->point(found.data(), numbers<Real>(target).data(), point.data());
    const Eigen::Vector3d u = rounded(found.data());
    EXPECT_NEAR(u.dot(rounded(point.data())), T.support_function(u), 1e-12 * (1 + u.norm() * target.norm()));
    return true;
  }
  static bool flat_faces(const ConvexSet& /*S*/, const ConvexSet& T) {
    const bool in_double = T.flat_faces() != nullptr && flat_face<double>(T);
    EXPECT_EQ(T.flat_faces() != nullptr && flat_face<Quad>(T), in_double);
    return in_double;
  }

  static bool gauge(const ConvexSet& S, const ConvexSet& T) {
    const Eigen::Vector3d y(0.3, -1, 0.8), x = operation->M * y;
    Eigen::Vector3d normal_S, normal_T;
    const double of_S = gauge_bound(S, y.data(), normal_S.data());
    const double of_T = gauge_bound(T, x.data(), normal_T.data());
    EXPECT_EQ(of_S < kInfinity && T.gauge() != nullptr, of_T < kInfinity);
    if (of_T < kInfinity) {
      EXPECT_NEAR(of_T, of_S, 1e-12 * of_S);
      expect_parallel(normal_T, normal_of(normal_S));
    }
    Quad quad_S[n], quad_T[n];
    const bool normal = gauge_normal(S, numbers<Quad>(y).data(), quad_S);
    EXPECT_EQ(gauge_normal(T, numbers<Quad>(x).data(), quad_T), normal && T.gauge() != nullptr);
    if (normal && T.gauge() != nullptr) expect_parallel(rounded(quad_T), normal_of(rounded(quad_S)));
    return T.gauge() != nullptr;
  }

  static bool touching(const ConvexSet& S, const ConvexSet& T) {
    Eigen::Vector3d u, of_T;
    EXPECT_TRUE(touches_origin(S, u.data()));
    if (!touches_origin(T, of_T.data())) return false;
    expect_parallel(of_T, normal_of(u));
    return true;
  }

  static bool symmetry(const ConvexSet& S, const ConvexSet& T) {
    Eigen::Vector3d e, of_T;
    EXPECT_TRUE(is_unconditional(S, e.data()));
    if (!is_unconditional(T, of_T.data())) return false;
    EXPECT_LT((operation->M.cwiseAbs() * e - of_T).norm(), 1e-12 * (e.norm() + 1));
    return true;
  }

  static bool has(std::size_t column, const ConvexSet& S) {
    Eigen::Vector3d u;
    switch (column) {
      case 0:
        return S.inner_radius_unchecked(Eigen::Vector3d(S.center()).data()) > 0;
      case 1:
        return S.smooth() != nullptr;
      case 2:
        return S.flat_faces() != nullptr;
      case 3:
        return S.gauge() != nullptr;
      case 4:
        return touches_origin(S, u.data());
      default:
        return S.symmetry() != nullptr;
    }
  }
};

const Operation* Capability::operation = nullptr;

TEST_P(Capability, IsPassedOnWhereTheTableSaysSo) {
  const auto [row_index, column] = GetParam();
  const Row row = rows()[row_index];
  constexpr std::array kChecks = {&inner_ball, &pieces, &flat_faces, &gauge, &touching, &symmetry};
  int tried = 0;
  for (const Operand& operand : operands()) {
    if (!has(column, *operand.set)) continue;
    for (const Operation& of_row : row.operations) {
      SCOPED_TRACE(operand.name + ", " + of_row.name);
      operation = &of_row;
      const Set T = of_row.apply(operand.set);
      EXPECT_EQ(kChecks[column](*operand.set, *T), promises(row.entries[column], of_row));
      ++tried;
    }
  }
  EXPECT_GT(tried, 0);
}

std::string parameter_name(const testing::TestParamInfo<std::tuple<std::size_t, std::size_t>>& info) {
  std::string name = rows()[std::get<0>(info.param)].name + "_" + kColumns[std::get<1>(info.param)];
  name.erase(std::remove(name.begin(), name.end(), '`'), name.end());
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Table, Capability,
                         testing::Combine(testing::Range(std::size_t{0}, rows().size()),
                                          testing::Range(std::size_t{0}, kColumns.size())),
                         parameter_name);

TEST(Capabilities, AreThoseOfTheTableInTheDocumentation) {
  std::ifstream file(RAYGAUGE_DOCS "/sets.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  ASSERT_FALSE(page.empty());
  for (const Row& row : rows()) {
    std::string line = "\n| " + row.name + " |";
    for (const std::string& entry : row.entries) line += " " + entry + " |";
    EXPECT_NE(page.find(line + "\n"), std::string::npos) << "not in docs/sets.md:" << line;
  }
}

// {A + 0, Q}, {A, Q + 0}, {M A, M Q} have the distance of {A, Q}, and as good bounds.
void expect_as_good(const Set& A, const Set& Q, const DistanceResult& known, const DistanceOptions& options) {
  DistanceSolver solver(options);
  const DistanceResult& result = solver.solve(*A, *Q);
  EXPECT_LE(result.lower, known.upper * (1 + 1e-12));
  EXPECT_GE(result.upper, known.lower * (1 - 1e-12));
  EXPECT_EQ(result.status, known.status);
  EXPECT_LE(result.upper - result.lower,
            std::max(options.tolerance * result.upper, 1.01 * (known.upper - known.lower)));
}

class Solves : public testing::TestWithParam<std::size_t> {};

TEST_P(Solves, AreAsGoodForACombinationThatChangesNothing) {
  const Row row = rows()[GetParam()];
  const Vector away{{4, -3, 5}};
  for (const Operand& of_A : operands()) {
    const Set A = std::make_shared<AffineImage>(of_A.set, Eigen::MatrixXd::Identity(n, n), away);
    for (const Operand& of_Q : operands()) {
      if (of_Q.name == "point" || of_Q.name == "ball that touches the origin") continue;
      for (const DistanceMethod method : {DistanceMethod::newton, DistanceMethod::column_generation}) {
        DistanceOptions options;
        options.method = method;
        options.tolerance = 1e-10;
        const DistanceResult known = DistanceSolver(options).solve(*A, *of_Q.set);
        for (const Operation& operation : row.operations) {
          if (!operation.t.isZero(0) || !operation.is_neutral || !is_similarity(operation.M)) continue;
          SCOPED_TRACE(of_A.name + " and " + of_Q.name + ", " + std::string(to_string(method)) + ", " +
                       operation.name);
          if (operation.M.isIdentity(0)) expect_as_good(A, operation.apply(of_Q.set), known, options);
          if (row.about_origin) continue;
          expect_as_good(operation.apply(A), operation.apply(of_Q.set), known, options);
          if (operation.M.isIdentity(0)) expect_as_good(operation.apply(A), of_Q.set, known, options);
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Table, Solves, testing::Range(std::size_t{0}, rows().size()));

}  // namespace
}  // namespace raygauge::test_capabilities
