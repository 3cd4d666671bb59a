// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

#include "bindings/c/handles.h"
#include "raygauge/exceptions.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/convex_set.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/grasp_wrenches.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/p_norm_ball.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/polytopes.h"
#include "raygauge/sets/prepared_set.h"
#include "raygauge/sets/truncated_cone.h"

namespace {

using namespace raygauge;     // NOLINT(google-build-using-namespace)
using namespace raygauge::c;  // NOLINT(google-build-using-namespace)

using VectorMap = Eigen::Map<const Eigen::VectorXd>;
using MatrixMap = Eigen::Map<const Eigen::MatrixXd>;
using RowsMap = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;

int dimension_of(int32_t n) {
  return static_cast<int>(in_range("n", n, 1, std::numeric_limits<int32_t>::max()));
}

/// n numbers of the caller's.
VectorMap vector_of(const double* values, int32_t n, const char* name) {
  const int size = dimension_of(n);
  return {&needed(values, name), size};
}

/// How many vectors of n doubles an array holds: at most what an address space has room for.
std::ptrdiff_t count_of(int32_t n, int64_t count, const char* name) {
  constexpr int64_t kMost = std::numeric_limits<std::ptrdiff_t>::max() / 8;
  return static_cast<std::ptrdiff_t>(in_range(name, count, 0, kMost / dimension_of(n)));
}

MatrixMap columns_of(const double* values, int32_t n, int64_t count, const char* name,
                     const char* count_name) {
  const std::ptrdiff_t columns = count_of(n, count, count_name);
  return {columns == 0 ? values : &needed(values, name), n, columns};
}

const std::shared_ptr<const ConvexSet>& shared(const rg_set* set, const char* name) {
  return needed(set, name).set;
}

/// Writes a new handle for the set that `made` returns, a shared or a unique pointer.
template <class Make>
rg_error make(rg_set** set, const Make& made) {
  return guarded([&] {
    rg_set*& out = needed(set, "set");
    out = new rg_set{made()};
  });
}

/// The caller's support mapping as the engine asks it. What it writes is not believed without a look.
struct CallersMapping {
  rg_support_mapping mapping;
  void* data;
  int n;

  void operator()(const double* u, double* point) const {
    if (const int32_t answer = mapping(data, n, u, point); answer != 0) {
      throw CallbackFailed("the support mapping returned " + std::to_string(answer));
    }
    for (int k = 0; k < n; ++k) {
      if (std::isfinite(point[k])) continue;
      throw NonFiniteError("the support mapping wrote a coordinate that is not finite: coordinate " +
                           std::to_string(k));
    }
  }
};

}  // namespace

rg_error rg_set_points(int32_t n, int64_t count, const double* points, rg_set** set) {
  return make(set,
              [&] { return std::make_shared<PointSet>(columns_of(points, n, count, "points", "count")); });
}

rg_error rg_set_prepared_points(int32_t n, int64_t count, const double* points, rg_set** set) {
  return make(set,
              [&] { return std::make_shared<PreparedSet>(columns_of(points, n, count, "points", "count")); });
}

rg_error rg_set_ball(int32_t n, const double* center, double radius, rg_set** set) {
  return make(set, [&] { return std::make_shared<Ball>(vector_of(center, n, "center"), radius); });
}

rg_error rg_set_box(int32_t n, const double* lower, const double* upper, rg_set** set) {
  return make(
      set, [&] { return std::make_shared<Box>(vector_of(lower, n, "lower"), vector_of(upper, n, "upper")); });
}

rg_error rg_set_ellipsoid(int32_t n, const double* center, int32_t m, const double* factor, rg_set** set) {
  return make(set, [&] {
    return std::make_shared<Ellipsoid>(vector_of(center, n, "center"),
                                       columns_of(factor, n, m, "factor", "m"));
  });
}

rg_error rg_set_p_norm_ball(int32_t n, const double* center, const double* semi_axes, double p,
                            rg_set** set) {
  return make(set, [&] {
    return std::make_shared<PNormBall>(vector_of(center, n, "center"), vector_of(semi_axes, n, "semi_axes"),
                                       p);
  });
}

rg_error rg_set_capsule(int32_t n, const double* p, const double* q, double radius, rg_set** set) {
  return make(set,
              [&] { return std::make_shared<Capsule>(vector_of(p, n, "p"), vector_of(q, n, "q"), radius); });
}

rg_error rg_set_cylinder(int32_t n, const double* p, const double* q, double radius, rg_set** set) {
  return make(set,
              [&] { return std::make_shared<Cylinder>(vector_of(p, n, "p"), vector_of(q, n, "q"), radius); });
}

rg_error rg_set_cone(int32_t n, const double* base, double base_radius, const double* top, double top_radius,
                     rg_set** set) {
  return make(set, [&] {
    return std::make_shared<TruncatedCone>(vector_of(base, n, "base"), base_radius, vector_of(top, n, "top"),
                                           top_radius);
  });
}

rg_error rg_set_simplex(int32_t n, const double* corner, const double* legs, rg_set** set) {
  return make(set, [&] {
    return std::make_shared<Simplex>(vector_of(corner, n, "corner"), vector_of(legs, n, "legs"));
  });
}

rg_error rg_set_zonotope(int32_t n, const double* center, int32_t count, const double* generators,
                         rg_set** set) {
  return make(set, [&] {
    return std::make_shared<Zonotope>(vector_of(center, n, "center"),
                                      columns_of(generators, n, count, "generators", "count"));
  });
}

rg_error rg_set_h_polytope(int32_t n, int64_t count, const double* normals, const double* offsets,
                           rg_set** set) {
  return make(set, [&] {
    const std::ptrdiff_t rows = count_of(n, count, "count");
    if (rows > 0) needed(normals, "normals"), needed(offsets, "offsets");
    return std::make_shared<HPolytope>(RowsMap(normals, rows, n), VectorMap(offsets, rows));
  });
}

rg_error rg_set_contact_wrenches(const double* point, const double* normal, double friction, int32_t facets,
                                 rg_set** set) {
  return make(set, [&] {
    return std::make_shared<ContactWrenches>(vector_of(point, 3, "point"), vector_of(normal, 3, "normal"),
                                             friction, facets);
  });
}

rg_error rg_set_support_mapping(int32_t n, const double* center, rg_support_mapping mapping, void* data,
                                rg_set** set) {
  return make(set, [&] {
    needed(mapping, "mapping");
    return std::make_shared<SupportMappingSet>(vector_of(center, n, "center"),
                                               CallersMapping{mapping, data, n});
  });
}

rg_error rg_set_affine_image(const rg_set* S, const double* M, const double* t, rg_set** set) {
  return make(set, [&] {
    const int n = shared(S, "S")->dimension();
    return std::make_shared<AffineImage>(shared(S, "S"), columns_of(M, n, n, "M", "n"), vector_of(t, n, "t"));
  });
}

rg_error rg_set_sum(const rg_set* A, const rg_set* B, rg_set** set) {
  return make(set, [&] { return std::make_shared<MinkowskiSum>(shared(A, "A"), shared(B, "B")); });
}

rg_error rg_set_difference(const rg_set* A2, const rg_set* A1, rg_set** set) {
  return make(set, [&] { return std::make_shared<MinkowskiDifference>(shared(A2, "A2"), shared(A1, "A1")); });
}

rg_error rg_set_union_hull(int64_t count, const rg_set* const* sets, rg_set** set) {
  return make(set, [&] {
    std::vector<std::shared_ptr<const ConvexSet>> members;
    in_range("count", count, 0, std::numeric_limits<int32_t>::max());
    for (int64_t i = 0; i < count; ++i)
      members.push_back(shared((&needed(sets, "sets"))[i], "an entry of sets"));
    return std::make_shared<UnionHull>(std::move(members));
  });
}

void rg_set_free(rg_set* set) { delete set; }

int32_t rg_set_dimension(const rg_set* set) { return set == nullptr ? 0 : set->set->dimension(); }

rg_error rg_set_center(const rg_set* set, double* center) {
  return guarded([&] {
    const ConvexSet& S = *shared(set, "set");
    Vector::Map(&needed(center, "center"), S.dimension()) = S.center();
  });
}

rg_error rg_set_support(const rg_set* set, const double* u, double* value, double* point) {
  return guarded([&] {
    const ConvexSet& S = *shared(set, "set");
    const VectorMap direction = vector_of(u, S.dimension(), "u");
    const double h = S.support_function(direction);
    if (point != nullptr) Vector::Map(point, S.dimension()) = S.support_mapping(direction);
    if (value != nullptr) *value = h;
  });
}
