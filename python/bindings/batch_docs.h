// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

// The docstrings of batches. Their examples are run by tests/python/test_docstrings.py.

namespace raygauge::python {

inline constexpr const char* kDistanceBatchDoc = R"(The answers of a batch: arrays with one row a problem.

distance, lower, upper: shape (K,), as in Distance. status: texts, shape (K,); status_code: their numbers, int8.
normal: shape (K, n), nan where a problem has none. contact_point: shape (K, n), or None unless witness=True.
pivots: basis changes, shape (K,); 0 where rg.gauge answers, as of 1024 points and more against one set of many points.

A problem is r[k], a Distance; for result in r goes through all of them. r[1:3], a mask or an array of indices pick some.

>>> r = rg.distances([rg.Ball([2, 0]), rg.Ball([0, 4]), rg.Ball([0, 0])], rg.Ball([0, 0]))
>>> r[1].status, [round(result.distance, 6) for result in r], len(r[r.distance > 0])
(<Status.optimal: 'optimal'>, [1.0, 3.0, 0.0], 2)
)";

inline constexpr const char* kToDataframeDoc =
    R"(A pandas.DataFrame with a row for each problem; normals and points are columns normal_0, normal_1, ...

>>> rg.distances([rg.Ball([2, 0]), rg.Ball([0, 4])], rg.Ball([0, 0])).to_dataframe()["status"].tolist()
['optimal', 'optimal']
)";

inline constexpr const char* kDistancesDoc =
    R"(The distances of K problems in one call, on threads, without the interpreter's lock.

A, Q: an array of shape (K, N, n), a problem a row; a list of K sets or arrays of points; or, one of them, a set or an
array of shape (N, n) that all problems share. Arrays are not to be written to meanwhile.
poses_A, poses_Q: homogeneous matrices of shape (K, n+1, n+1), rigid motions of the sets, one for each problem.
along_path: problems follow each other as frames of a motion do: each starts from what the one before it left, but
for every 16th. Faster where steps are small; answers are certified as without.
tolerance, method, witness, time_limit (of each problem): as in distance. threads: 0 for one on each CPU.

Returns Distances. Raises as distance does, naming the problem, counted from 0; Ctrl-C raises KeyboardInterrupt after
the problems that are being solved. Answers do not depend on the number of threads.

>>> import numpy as np
>>> points = np.array([[[2.0, 0.0]], [[0.0, 3.0]], [[0.0, 0.0]]])  # three problems with one point each
>>> r = rg.distances(points, rg.Box([-1, -1], [1, 1]))
>>> r.distance
array([2., 3., 0.])
>>> r.status
array(['optimal', 'optimal', 'contains_origin'], dtype='<U15')
>>> poses = np.tile(np.eye(4), (3, 1, 1))
>>> poses[:, 0, 3] = [2, 3, 4]  # one unit ball in three places
>>> rg.distances(rg.Ball([0, 0, 0]), rg.Ball([0, 0, 0]), method="newton", poses_A=poses).distance.round(6)
array([1., 2., 3.])
)";

inline constexpr const char* kObjectDistanceBatchDoc =
    R"(The answers of object_distances: arrays with one row a problem.

distance, lower, upper: shape (K,), with signed=True negative where objects overlap: minus the depth and its bounds.
status, status_code: as in Distances, of the depth where that is given. normal: shape (K, n), the way for A1 to get
farther away, or out. point_1, point_2: shape (K, n), the closest points or those in contact, nan where there are none;
None unless closest_points=True. pose_gradient_1, pose_gradient_2: as PoseGradient.body_1 and body_2, shape (K, 6), or (K, 3) in
R^2; is_unique: shape (K,), whether its kind is 'unique'; None unless gradient=True.
)";

inline constexpr const char* kObjectDistancesDoc =
    R"(The distances of K pairs of objects in the metric of Q in one call, on threads.

A1, A2: as A and Q in distances: an array of shape (K, N, n), a list, or one for all. poses_1, poses_2: as poses_A there.
Q: one set or array of points. closest_points, gradient, signed, tolerance, method, time_limit: as in object_distance.
Returns ObjectDistances. Raises as distances does.

>>> import numpy as np
>>> poses = np.tile(np.eye(4), (3, 1, 1))
>>> poses[:, 0, 3] = [0.5, 1.5, 3]  # one unit ball in three places, against another
>>> unit = rg.Ball([0, 0, 0])
>>> rg.object_distances(unit, unit, unit, poses_2=poses, signed=True).distance.round(6)
array([-1.5, -0.5,  1. ])
)";

inline constexpr const char* kSeparationBatchDoc =
    R"(The answers of separations: arrays with one row a problem.

outcome: texts, shape (K,), as in SeparationResult; outcome_code: their numbers, int8. normal: shape (K, n), nan where
objects are not separated.
)";

inline constexpr const char* kSeparationsDoc =
    R"(Whether the objects of K pairs are separated, in one call, on threads; ends each at the first proof.

A1, A2, poses_1, poses_2, threads: as in object_distances; tolerance, method, time_limit: as in separation, whose outcomes
these are. Boxes, balls and capsules of R^3 are tested several at a time.
Returns Separations. Raises as distances does.

>>> import numpy as np
>>> poses = np.tile(np.eye(4), (3, 1, 1))
>>> poses[:, 0, 3] = [0.5, 1.5, 3]  # one unit ball in three places, against another
>>> rg.separations(rg.Ball([0, 0, 0]), rg.Ball([0, 0, 0]), poses_2=poses).outcome.tolist()
['intersecting', 'intersecting', 'separated']
)";

}  // namespace raygauge::python
