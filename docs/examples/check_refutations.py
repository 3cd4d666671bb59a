# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Checks, by NumPy alone, each line of `raygauge export --refutations`: python3 check_refutations.py FILE.jsonl

A body is the hull of the ellipsoids c + F z, |z| <= 1. With a unit vector u, all points of the first body are at least
-h_2(-u) - h_1(u) from those of the second; the bodies are at most as far apart as a point of each. They are at most
h_2(-u) + h_1(u) deep, and at least as deep as the planes of a closed surface in their difference are far from the origin,
if all its triangles are seen from there in the same sense. Growth: both scaled about their centres."""
import json
import sys

import numpy as np


def support(body, u):
    return max(np.array(body["centers"]) @ u + np.linalg.norm(u @ np.array(body["factors"]), axis=1))


def point(body, where):
    weights, z = np.abs(where["weights"]), np.array(where["z"])
    pieces = np.array(body["centers"]) + np.array(body["factors"]) @ (z / max(1, np.linalg.norm(z)))
    return weights / weights.sum() @ pieces


def by_normal(case, answer):
    u = np.array(case["normal"]) / np.linalg.norm(case["normal"])
    reach = support(case["second"], -u) + support(case["first"], u)
    if case["quantity"] == "growth":
        between = u @ np.subtract(case["center_2"], case["center_1"])
        return between / (reach + between) - answer
    return answer - reach if case["quantity"] == "depth" else -reach - answer


def by_points(case, answer):
    first, second = point(case["first"], case["point_1"]), point(case["second"], case["point_2"])
    if case["quantity"] == "growth":
        first, second = ((1 - case["growth"]) * np.array(c) + case["growth"] * p
                         for c, p in ((case["center_1"], first), (case["center_2"], second)))
        return answer - case["growth"] if np.linalg.norm(second - first) < 1e-9 * case["size"] else -1
    claimed = 1e-9 * case["size"] if case["quantity"] == "separated" else answer
    return claimed - np.linalg.norm(second - first)


def by_surface(case, answer):
    pairs = zip(case["corners_1"], case["corners_2"])
    corners = np.array([point(case["second"], p2) - point(case["first"], p1) for p1, p2 in pairs])
    edges = [(t[k], t[k - 1]) for t in case["triangles"] for k in range(3)]
    closed = len(set(edges)) == len(edges) and {(b, a) for a, b in edges} == set(edges)
    a, b, c = corners[np.array(case["triangles"])].transpose(1, 0, 2)
    normals = np.cross(b - a, c - a)
    offsets = np.einsum("ij,ij->i", normals, a) / np.linalg.norm(normals, axis=1)
    return min(offsets) - answer if closed and min(offsets) > 0 else -1


def error(case):
    """By how much the answer is off at least."""
    proof = by_normal if "normal" in case else by_surface if "triangles" in case else by_points
    return proof(case, float(case["answer"]))


if __name__ == "__main__":
    number, failed = 0, []
    with open(sys.argv[1], encoding="utf-8") as lines:
        for number, case in enumerate(map(json.loads, lines), 1):
            if not error(case) > 5e-10 * (1 if case["quantity"] == "growth" else case["size"]):
                failed.append(number)
    print(f"{number - len(failed)} of {number} answers are refuted")
    for number in failed:
        print(f"line {number}: not refuted")
    sys.exit(1 if failed else 0)
