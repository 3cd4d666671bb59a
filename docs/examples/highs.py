# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""usage: highs.py highs-ds|highs-ipm. The linear program of Example 2 by HiGHS, through SciPy, for the method `command`
(docs/baselines.md). HiGHS is told the tolerance as GLPK and Clp are; presolve is on, its default."""
import sys

import numpy as np
from scipy.optimize import linprog

METHOD = sys.argv[1] if len(sys.argv) == 2 else ""
if METHOD not in ("highs-ds", "highs-ipm"):
    sys.exit("usage: highs.py highs-ds|highs-ipm")
OPTIMAL, LIMIT, INFEASIBLE = 0, 1, 2  # SciPy's numbers


def read(count):
    return np.array([[float(word) for word in sys.stdin.readline().split()] for _ in range(count)])


def model(A, Q):
    """min c·x subject to M x = b, x >= 0, x = (α, β): Σα_i a_i = Σβ_j q_j, Σα_i = 1, the least Σβ_j."""
    M = np.vstack([np.hstack([A.T, -Q.T]), np.repeat([1.0, 0.0], [len(A), len(Q)])])
    c = np.repeat([0.0, 1.0], [len(A), len(Q)])
    return {"c": c, "A_eq": M, "b_eq": np.append(np.zeros(A.shape[1]), 1.0), "bounds": (0, None), "method": METHOD}


def answer(points, tolerance, limit):
    feasible = min(max(tolerance / 10, 1e-10), 1e-3)  # HiGHS takes nothing smaller than 1e-10
    options = {"primal_feasibility_tolerance": feasible, "dual_feasibility_tolerance": feasible}
    if METHOD == "highs-ipm":
        options["ipm_optimality_tolerance"] = max(feasible, 1e-12)
    if np.isfinite(limit):
        options["time_limit"] = limit
    solved = linprog(**points["model"], options=options)
    if solved.status == INFEASIBLE:
        return "inf"
    if solved.status != OPTIMAL:
        return ("time_limit" if solved.status == LIMIT else "precision_limit") + " inf"
    count = points["count"]
    used = np.flatnonzero(solved.x > 0)
    words = [repr(float(solved.fun)), "u", *(repr(float(y)) for y in solved.eqlin.marginals[:-1])]
    for name, indices in (("a", used[used < count]), ("q", used[used >= count] - count)):
        words += [name, *map(str, indices)] if len(indices) else []
    return " ".join(words)


points = {}
for words in (line.split() for line in iter(sys.stdin.readline, "")):
    if words[0] == "points":
        sizes = [int(word) for word in words[1:3]]
        points = {"model": model(read(sizes[0]), read(sizes[1])), "count": sizes[0]}
        print("ready", flush=True)
    else:
        print(answer(points, float(words[1]), float(words[2])), flush=True)
