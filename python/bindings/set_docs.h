// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

// The docstrings of the sets. Their examples are run by tests/python/test_docstrings.py.

namespace raygauge::python {

inline constexpr const char* kConvexSetDoc =
    R"(A nonempty compact convex set of R^n, known through its support function.

Sets never change and may be used by several threads and in several calls at once. They are made by the classes
below; an array of points of shape (N, n) stands for the convex hull of its rows wherever a set is expected.
)";

inline constexpr const char* kPointSetDoc = R"(conv{p_1, ..., p_N}, the convex hull of N points.

points: array of shape (N, n), one point a row; an array in C order of doubles is read once, without another copy.

Raises EmptySetError, NonFiniteError (naming point and coordinate, counted from 0), InvalidParameterError.

>>> triangle = rg.PointSet([[2, 0], [4, -1], [4, 1]])
>>> len(triangle), triangle.dimension
(3, 2)
>>> triangle.support_function([1, 0])
4.0
)";

inline constexpr const char* kPreparedSetDoc = R"(conv{p_1, ..., p_N}, prepared once for many queries.

points: array of shape (N, n) or a PointSet. In R^3 a table lists, for each small cell of directions, the few
points that can be highest there; where has_hulls(), points inside the hull are dropped. In other dimensions a
tree of clusters leaves out most of tens of thousands of points; where it would not pay, this is a PointSet.

Raises as PointSet does.

>>> import numpy as np
>>> cloud = rg.PreparedSet(np.random.default_rng(0).normal(size=(500, 3)))
>>> len(cloud) < 500, cloud.vertex_count > 10
(True, True)
>>> warm, pose = rg.WarmStart(), np.eye(4)
>>> pose[0, 3] = 9.0
>>> rg.object_distance(cloud, cloud, rg.Ball([0, 0, 0]), pose_2=pose, warm=warm).status
<Status.optimal: 'optimal'>
)";

inline constexpr const char* kContactWrenchesDoc =
    R"(The wrenches (f, p x f) in R^6 of a contact with Coulomb friction, its normal force at most 1.

point, normal: shape (3,); the normal points into the object that is held. friction: mu, not negative. facets: 0 for the
exact cone, or m >= 3 for a pyramid inside it. UnionHull of several contacts bounds the sum of their normal forces by 1.

>>> rg.ContactWrenches([0, 0, 1], [0, 0, -1], 0.5).support_function([1, 0, 0, 0, 0, 0])
0.5
)";

inline constexpr const char* kHPolytopeDoc =
    R"({x : G x <= g}, a bounded polytope with interior, by its inequalities.

G: shape (m, n). g: shape (m,). Raises InvalidParameterError where it is not bounded or has no interior, EmptySetError, DimensionMismatchError,
NonFiniteError.

>>> rg.HPolytope([[1, 0], [0, 1], [-1, -1]], [1, 1, 1]).support_function([1, 1])
2.0
)";

inline constexpr const char* kHalfSpaceDoc =
    R"({x : n.x <= b}, a half-space, as of a floor; in the plane a half-plane.

normal: shape (n,), the outer normal n, of any length. offset: b. It is not bounded: object_distance, object_distances,
separation and scenes take it, together with a bounded set; all else raises InvalidParameterError.

Raises InvalidParameterError, NonFiniteError.

>>> floor = rg.HalfSpace([0, 0, 1], 0)
>>> r = rg.object_distance(rg.Ball([0, 0, 0.75]), floor, rg.Ball([0, 0, 0]), signed=True)
>>> round(r.signed_distance, 12)
-0.25
)";

inline constexpr const char* kMeshDoc =
    R"(The union of triangles of R^3 or, if solid, also what they bound. It need not be convex.

vertices: shape (N, 3). triangles: shape (M, 3), numbers of vertices from 0 on. solid: the surface must be closed, its triangles
counterclockwise as seen from outside. object_distance, object_distances and separation take it, in the Euclidean metric;
all else raises InvalidParameterError, a depth or a growth distance too: convex parts have these.

size: M. volume: of a solid. Raises EmptySetError, InvalidParameterError, NonFiniteError.

>>> corner = rg.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]], solid=True)
>>> r = rg.object_distance(corner, rg.Ball([2, 0, 0], 0.5), rg.Ball([0, 0, 0]))
>>> round(r.distance, 6)
0.5
)";

inline constexpr const char* kMeshFromFileDoc =
    R"(The mesh of a file: .obj, .off, .stl, .ply, .dae, .glb or .pcd, also .gz (docs/meshes.md).

Raises Error, with the file's name; ProgramError where the package was built without the program.

>>> rg.Mesh.from_file("cube.obj").size
4
)";

inline constexpr const char* kMeshCloudDoc =
    R"(Balls of one radius about points, shape (N, 3), as one object: what a Mesh has, a cloud has.

>>> cloud = rg.Mesh.cloud([[0, 0, 0], [0, 0, 3]], radius=0.5)
>>> cloud.size, cloud.radius
(2, 0.5)
>>> rg.object_distance(cloud, rg.Ball([0, 4, 0], 1)).distance
2.5
)";

inline constexpr const char* kZonotopeDoc =
    R"({center + t_1 g_1 + ... + t_m g_m : -1 <= t_i <= 1}, a sum of segments.

center: shape (n,). generators: shape (m, n), one g_i a row.

>>> rg.Zonotope([0, 0], [[1, 0], [0, 1], [1, 1]]).support_function([1, 1])
4.0
)";

inline constexpr const char* kBallDoc =
    R"({x : |x - center| <= radius}, the Euclidean ball; radius 0 is a point.

center: shape (n,). Raises InvalidParameterError, NonFiniteError.

>>> rg.distance(rg.Ball([3, 0, 0], 1), rg.Ball([0, 0, 0])).distance
2.0
)";

inline constexpr const char* kEllipsoidDoc = R"({center + L z : |z| <= 1}, an ellipsoid of any orientation.

center: shape (n,). factor: L, shape (n, m); semi-axes a along the columns of a rotation R are L = R * a.

>>> rg.Ellipsoid([0, 0], [[3, 0], [0, 1]]).support_function([1, 0])
3.0
)";

inline constexpr const char* kPNormBallDoc =
    R"({center + semi_axes * z : |z|_p <= 1}, the ball of a weighted p-norm.

center: shape (n,). semi_axes: a number or shape (n,), not negative. p: from 1 to infinity.

>>> round(rg.distance([[3, 4]], rg.PNormBall([0, 0], p=1)).distance, 9)  # |(3, 4)| in the norm of p = 1
7.0
)";

inline constexpr const char* kCapsuleDoc = R"({x : the distance of x to the segment from p to q is <= radius}.

p, q: shape (n,). Raises InvalidParameterError, DimensionMismatchError, NonFiniteError.

>>> rg.Capsule([0, 0, 0], [0, 0, 2], 0.5).support_function([0, 0, 1])
2.5
)";

inline constexpr const char* kCylinderDoc =
    R"(The cylinder around the segment from p to q, which differ; p, q: shape (n,).

>>> rg.Cylinder([0, 0, 0], [0, 0, 2], 0.5).support_function([0, 0, 1])
2.0
)";

inline constexpr const char* kTruncatedConeDoc = R"(The hull of two discs across the axis from base to top.

base, top: shape (n,), and differ; top_radius 0 is a cone.

>>> rg.TruncatedCone([0, 0, 0], 1, [0, 0, 2]).support_function([1, 0, 0])
1.0
)";

inline constexpr const char* kBoxDoc =
    R"({x : lower <= x <= upper}, a box along the axes; lower, upper: shape (n,).

>>> rg.Box([-1, -2], [1, 2]).support_function([1, 1])
3.0
)";

inline constexpr const char* kSimplexDoc = R"(The simplex with a right-angled corner and legs along the axes.

corner: shape (n,). legs: a number or shape (n,), of either sign.

>>> rg.Simplex([0, 0, 0]).support_function([1, 2, 3])
3.0
)";

inline constexpr const char* kAffineImageDoc = R"({matrix @ x + translation : x in set}.

matrix: shape (n, n), invertible. translation: shape (n,).

>>> rg.AffineImage(rg.Ball([0, 0]), [[2, 0], [0, 1]], [5, 0]).support_function([1, 0])
7.0
)";

inline constexpr const char* kMinkowskiSumDoc =
    R"(A + B = {a + b : a in A, b in B}; A, B: sets or arrays of points.

>>> rg.MinkowskiSum(rg.Box([-1, -1], [1, 1]), rg.Ball([0, 0], 0.5)).support_function([1, 0])
1.5
)";

inline constexpr const char* kMinkowskiDifferenceDoc = R"(A2 - A1 = {a2 - a1 : a2 in A2, a1 in A1}.

Its distance is that from object A1 to object A2, see object_distance.

>>> rg.MinkowskiDifference(rg.Ball([5, 0]), rg.Ball([0, 0])).center
array([5., 0.])
)";

inline constexpr const char* kUnionHullDoc =
    R"(The convex hull of a union; sets: an iterable of sets or arrays of points.

>>> rg.UnionHull([rg.Ball([0, 0]), [[3, 0]]]).support_function([1, 0])
3.0
)";

inline constexpr const char* kSupportMappingSetDoc = R"(A set of one's own, from its support mapping.

center: shape (n,), a point of the set, in its interior if it has one. mapping: a callable that takes u, shape (n,),
and returns a point of the set that is farthest along u; always the same one for the same u, also for u = 0. It is
called with the interpreter's lock held. What it raises passes through the call that asked.

>>> import numpy as np
>>> diamond = rg.SupportMappingSet([0, 0], lambda u: np.sign(u) * (np.abs(u) == np.abs(u).max()) / max(1, (np.abs(u)
...     == np.abs(u).max()).sum()))
>>> rg.distance([[3, 1]], diamond).distance
4.0
)";

}  // namespace raygauge::python
