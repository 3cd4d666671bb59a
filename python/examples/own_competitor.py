# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""HiGHS, by scipy, as a competitor on instances of one's own: own_competitor.py out/own.h5"""

import sys

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linprog

import raygauge as rg

Points = NDArray[np.float64]


@rg.method
class highs:
    """The linear program of Example 2 by scipy's HiGHS."""

    def load(self, A: Points, Q: Points) -> None:
        """min sum(beta), sum(alpha_i a_i) - sum(beta_j q_j) = 0, sum(alpha) = 1, alpha and beta >= 0."""
        self.sizes = len(A), len(Q)
        self.cost = np.repeat([0.0, 1.0], self.sizes)
        self.columns = np.vstack([np.hstack([A.T, -Q.T]), 1 - self.cost])
        self.right_side = np.append(np.zeros(A.shape[1]), 1.0)

    def solve(self, time_limit: float) -> rg.Answer:
        options = {"time_limit": time_limit}
        lp = linprog(self.cost, A_eq=self.columns, b_eq=self.right_side, method="highs", options=options)
        if lp.status != 0:
            return rg.Answer(np.inf if lp.status == 2 else np.nan)
        used = lp.x > 1e-12
        return rg.Answer(
            lp.fun,
            u=lp.eqlin.marginals[:-1],
            points_A=np.flatnonzero(used[: self.sizes[0]]),
            points_Q=np.flatnonzero(used[self.sizes[0] :]),
            pivots=lp.nit,
        )


@rg.generator
def rings(rng: np.random.Generator, n: int, N: int, gap: float = 2.0) -> tuple[Points, Points]:
    """Points on two spheres, `gap` apart."""
    A, Q = rng.normal(size=(2, N, n))
    A /= np.linalg.norm(A, axis=1, keepdims=True)
    Q /= np.linalg.norm(Q, axis=1, keepdims=True)
    return A + np.eye(n)[0] * (2 + gap), Q


results = rg.run(
    {
        "sweep": {"n": [3, 6], "N": [100], "repetitions": 5},
        "generator": [{"name": "rings"}],
        "method": [{"name": "column_generation"}, {"name": "highs"}],
    },
    sys.argv[1],
    force=True,
)
frame = results.to_dataframe()
print(frame.groupby(["n", "method"], observed=True)[["seconds", "lower", "upper"]].median())
