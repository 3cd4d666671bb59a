# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""A distance, its proof, a batch of poses."""

import numpy as np

import raygauge as rg

A = np.array([[2.0, 0.0], [4.0, -1.0], [4.0, 1.0]])  # a triangle: a point a row
Q = np.array([[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]])

result = rg.distance(A, Q)
print(result.distance, "is proven to lie in", [result.lower, result.upper])

poses = np.tile(np.eye(3), (4, 1, 1))
poses[:, 0, 2] = [0.0, 1.0, 2.0, 3.0]  # the triangle moves away
print(rg.distances(A, Q, poses_A=poses).distance)
