// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

// The docstrings of gradients by pose and contact patches. Their examples are run by
// tests/python/test_docstrings.py.

namespace raygauge::python {

inline constexpr const char* kPoseGradientDoc =
    R"(The gradient of signed_distance with respect to the twists of both objects; object_distance(…, gradient=True).

body_1, body_2: of A1 and of A2, shape (6,) in R^3: by the translation, then by the rotation, in the axes of the world, about the
point to which the pose takes the origin of the object. In R^2 shape (3,).
kind: 'unique'; 'one_sided' where closest points or normals are not unique, as between parallel faces: along() has the
derivatives, body_1 and body_2 are one of several; 'undecided': the metric is no ball.

>>> r = rg.object_distance(rg.Ball([0, 0]), rg.Box([2, -1], [4, 1]), rg.Ball([0, 0]), 1e-12, gradient=True)
>>> r.pose_gradient.kind, r.pose_gradient.body_1.round(6) + 0.0
('unique', array([-1.,  0.,  0.]))
)";

inline constexpr const char* kAlongDoc =
    R"(The one-sided derivative where A1 and A2 begin to move by these twists; nan for 'undecided'.)";

inline constexpr const char* kContactPatchDoc = R"(Where two objects are in contact, see contact_patch.

points_1, points_2: shape (k, n), on either object, k <= 8: corners of what their faces have in common. gap: shape (k,), of each pair
along normal, below 0 where the objects overlap. normal: shape (n,), of length 1, from A1 to A2; None where nothing is known.
error: proven, each point is at most this far from its object and from its surface.
lower, upper, status: of the signed distance. len() is k: 0 beyond the margin.
)";

inline constexpr const char* kContactPatchQueryDoc =
    R"(The points of contact of two objects of R^2 or R^3, within a margin.

A1, A2: sets, or arrays of points of shape (N, n). pose_1, pose_2, warm, time_limit: as in object_distance.
margin: pairs of points with a gap up to this belong to the patch. tolerance: of the distance or the depth.
Returns a ContactPatch: a vertex gives one point, an edge two, faces a polygon of at most 8 corners, a disc 8 points of its rim.
Raises as object_distance does, and InvalidParameterError for a negative margin and other dimensions.

>>> patch = rg.contact_patch(rg.Box([0, 0, 0], [2, 2, 1]), rg.Box([1, 1, 1.125], [3, 3, 2]), margin=0.25)
>>> len(patch), patch.gap.round(9)
(4, array([0.125, 0.125, 0.125, 0.125]))
)";

}  // namespace raygauge::python
