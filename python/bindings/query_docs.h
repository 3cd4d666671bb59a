// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

// The docstrings of queries. Their examples are run by tests/python/test_docstrings.py.

namespace raygauge::python {

inline constexpr const char* kDistanceDoc =
    R"(The generalized distance d_Q(A) = min{t >= 0 : A and t Q have a common point}.

A, Q: sets, or arrays of points of shape (N, n), of the same n; Q is to have the origin in its interior.
tolerance: the solve ends when upper - lower <= tolerance * upper; in (0, 1).
method: automatic (newton where Q is smooth, column_generation otherwise), column_generation, newton (smooth sets, many digits) or zheng_yamane (the paper's algorithm).
pose_A, pose_Q: homogeneous matrices of shape (n+1, n+1), rigid motions of the sets, which are not copied.
warm: a WarmStart that the pair keeps from query to query.
witness: also compute a contact point. time_limit: seconds. max_iterations: basis changes, 0 for the engine's own limit.
threads: of one solve; they help with a million coordinates and more.

Returns a Distance; limits and unreachable are statuses of it.
Raises DimensionMismatchError, NonFiniteError, EmptySetError, InvalidParameterError, UnknownNameError.

>>> import numpy as np
>>> A = np.array([[2.0, 0.0], [4.0, -1.0], [4.0, 1.0]])  # a triangle ...
>>> Q = np.array([[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]])  # ... and a square: a point a row
>>> rg.distance(A, Q).distance
2.0
>>> rg.distance(A, rg.Ball([0, 0]), 1e-12, method="newton", witness=True).contact_point
array([2., 0.])
)";

inline constexpr const char* kObjectDistanceDoc =
    R"(The distance from object A1 to object A2 in the metric of Q.

min{gauge_Q(a2 - a1) : a1 in A1, a2 in A2}; Euclidean with Q = Ball(zeros(n)).
A1, A2, Q: sets, or arrays of points of shape (N, n). pose_1, pose_2, warm: as in distance. closest_points, gradient: what to compute besides.
signed: compute the depth of objects that meet.
Returns an ObjectDistance; 0 with status contains_origin where the objects meet. Raises as distance does.

>>> r = rg.object_distance(rg.Ball([0, 0]), rg.Ball([5, 0]), rg.Ball([0, 0]), method="newton", closest_points=True)
>>> round(r.distance, 9)
3.0
>>> r.closest_point_1.round(6), r.closest_point_2.round(6)
(array([1., 0.]), array([4., 0.]))
>>> round(rg.object_distance(rg.Ball([0, 0]), rg.Ball([1.5, 0]), rg.Ball([0, 0]), signed=True).signed_distance, 9)
-0.5
)";

inline constexpr const char* kGrowthDistanceDoc =
    R"(The growth distance: A scaled about its centre and Q about the origin touch.

min{s >= 0 : c_A + s (A - c_A) and s Q have a common point}; above 1 for separated sets, below 1 for overlapping ones.
pose_A, pose_Q, warm: as in distance.
Returns a Distance. Raises as distance does.

>>> round(rg.growth_distance(rg.Ball([3, 0]), rg.Ball([0, 0])).distance, 6)
1.5
)";

inline constexpr const char* kSeparationQueryDoc =
    R"(Whether two objects are separated; ends at the first proof of either answer.

pose_1, pose_2, warm: as in distance.
Returns a SeparationResult. Raises as distance does.

>>> rg.separation(rg.Ball([0, 0]), rg.Ball([3, 0])).outcome
<Separation.separated: 'separated'>
)";

inline constexpr const char* kOriginInInteriorDoc =
    R"(Whether the origin lies in the interior of the hull of points, as a gauge needs.

Q: an array of shape (N, n) or a PointSet. Returns True or False, both proven, or None if the time limit came first.

>>> rg.origin_in_interior([[1, 0], [-1, 1], [-1, -1]])
True
)";

inline constexpr const char* kGaugeDoc =
    R"(The gauge of a set at a point, min{t >= 0 : x in t S}, as proven bounds (lower, upper).

S: a set or an array (N, n); x: an array (n,); inf where no multiple of S has x. tolerance: relative gap.
For many points, x: an array (M, n): two arrays (M,). threads: as of distances().

>>> lower, upper = rg.gauge(rg.Ball([0, 0], 2), [3, 4])
>>> round(lower, 6), round(upper, 6)
(2.5, 2.5)
)";

inline constexpr const char* kContainsDoc =
    R"(Whether a point lies in a set: True or False, both proven, or None for a point too near to the boundary.

S: a set or an array (N, n); x: an array (n,). tolerance: how near, relative to the way from the set's center.
For many points, x: an array (M, n): a masked array (M,), with a mask where nothing is proven; most points of a
hull take a tenth of the time of single calls. threads: as of distances().

>>> rg.contains(rg.Box([0, 0], [2, 1]), [1.5, 0.5]), rg.contains([[0, 0], [2, 0], [0, 2]], [1.5, 1.5])
(True, False)
)";

inline constexpr const char* kGradientMovingADoc =
    R"(The gradient of d_Q(A + t) with respect to t at 0, shape (n,).

result: of distance(), with a finite distance above 0; at a kink, one of the subgradients.

>>> rg.gradient_moving_A(rg.distance(rg.Ball([3, 0]), rg.Ball([0, 0]), 1e-12, "newton")).round(6)
array([1., 0.])
)";

inline constexpr const char* kGradientMovingQDoc =
    R"(The gradient of the distance of A in the gauge of Q + t at t = 0, shape (n,).

>>> rg.gradient_moving_Q(rg.distance(rg.Ball([3, 0]), rg.Ball([0, 0]), 1e-12, "newton")).round(6)
array([-2., -0.])
)";

}  // namespace raygauge::python
