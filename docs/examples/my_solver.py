# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""A solver for the plane: the best of the directions across the edges of A and Q."""
import sys


def read(count):
    return [[float(word) for word in sys.stdin.readline().split()] for _ in range(count)]


def solve(A, Q):
    best = (0.0, [0.0, 0.0])
    for x, y in ((p, r) for points in (A, Q) for p in points for r in points):
        u = [x[1] - y[1], y[0] - x[0]]
        h = max(-u[0] * q[0] - u[1] * q[1] for q in Q)
        if h > 0:
            u = [u[0] / h, u[1] / h]
            best = max(best, (-max(u[0] * a[0] + u[1] * a[1] for a in A), u))
    return best


for words in (line.split() for line in iter(sys.stdin.readline, "")):
    if words[0] == "points":
        A, Q = read(int(words[1])), read(int(words[2]))
        print("ready", flush=True)
    else:
        distance, u = solve(A, Q)
        print(distance, "u", *u, flush=True)
