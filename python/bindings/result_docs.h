// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

// The docstrings of results. Their examples are run by tests/python/test_docstrings.py.

namespace raygauge::python {

inline constexpr const char* kStatusDoc = R"(The outcome of a solve; a text as well: status == "optimal".

optimal: upper - lower <= tolerance * upper. contains_origin: the origin is in A, the distance 0. unreachable: no
multiple of Q meets A, the distance is infinite. precision_limit, iteration_limit, time_limit: the bounds hold but are
farther apart than the tolerance.
)";

inline constexpr const char* kSeparationDoc = R"(The answer of a separation test; a text as well.

separated: a plane between the objects is proven. intersecting: a common point is. undecided: neither.
)";

inline constexpr const char* kDistanceResultDoc = R"(The answer to a distance query.

distance: d_Q(A), a pure number, within [lower, upper]; 0 for contains_origin, inf for unreachable.
lower, upper: proven bounds. gap: upper - lower. status: a Status.
normal: shape (n,), of the plane that separates A from distance * Q, scaled to h_Q(-normal) = 1; None where there is none.
contact_point: shape (n,), a point of A and of distance * Q; None unless witness=True.
sigma: the last sigma_k of the method zheng_yamane; nan otherwise. seconds: wall time, where a time limit was set.
origin_weights: for contains_origin of point sets, (index, weight) of the points of A that prove it.
counters: what the solve did.

>>> r = rg.distance([[2, 0], [4, -1], [4, 1]], rg.Ball([0, 0]), 1e-9, "newton")
>>> r.lower <= 2 <= r.upper, r.status
(True, <Status.optimal: 'optimal'>)
>>> round(r.normal[0], 6)
-1.0
)";

inline constexpr const char* kDepthDoc =
    R"(How deep two objects that meet are in each other, see object_distance.

depth: the least translation of A1, measured by Q, after which the interiors are disjoint; at most upper, and at least lower
where that is above 0: proven for all directions at once. status: optimal where upper - lower <= tolerance * upper.
normal: shape (n,), the way out for A1, scaled to h_Q(normal) = 1. point_1, point_2: shape (n,), in contact, in A1 and in A2.

>>> depth = rg.object_distance(rg.Box([0, 0], [2, 2]), rg.Ball([1, 1.5]), rg.Ball([0, 0]), signed=True).depth
>>> round(depth.depth, 9), round(float(depth.normal[1]), 9)
(1.5, -1.0)
)";

inline constexpr const char* kObjectDistanceResultDoc = R"(The distance of two objects, see object_distance.

closest_point_1, closest_point_2: shape (n,), in A1 and in A2, where asked for and where there are any; else None.
gradient_1, gradient_2: shape (n,), of signed_distance when A1 or A2 is moved. pose_gradient: a PoseGradient in R^2 and R^3, or None.
depth: a Depth, with signed=True and where the objects are not proven to be apart; else None.
signed_distance: the distance, or minus the depth. float() of the answer is that, too.
)";

inline constexpr const char* kSeparationResultDoc = R"(The answer of separation().

outcome: a Separation. normal: u with max u·x over A2 below min u·x over A1, for separated; else None.
lower, upper: bounds on the growth distance about both centres, as far as they were needed.
)";

}  // namespace raygauge::python
