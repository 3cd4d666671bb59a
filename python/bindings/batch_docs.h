// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

// The docstrings of batches. Their examples are run by tests/python/test_docstrings.py.

namespace raygauge::python {

inline constexpr const char* kDistanceBatchDoc = R"(The answers of a batch: arrays with one row a problem.

distance, lower, upper: shape (K,), as in Distance. status: texts, shape (K,); status_code: their numbers, int8.
normal: shape (K, n), nan where a problem has none. contact_point: shape (K, n), or None unless witness=True.
pivots: basis changes, shape (K,).

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

}  // namespace raygauge::python
