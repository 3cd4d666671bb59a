# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Checks, by NumPy alone, each line of `raygauge export --refutations`: python3 check_refutations.py FILE.jsonl

A body is the hull of the ellipsoids c + F z, |z| <= 1. With a unit vector u, all points of the first body are at least
-h_2(-u) - h_1(u) from those of the second; the bodies are at most as far apart as a point of each."""
import json
import sys

import numpy as np


def support(body, u):
    return max(np.array(body["centers"]) @ u + np.linalg.norm(u @ np.array(body["factors"]), axis=1))


def point(body, where):
    weights, z = np.abs(where["weights"]), np.array(where["z"])
    pieces = np.array(body["centers"]) + np.array(body["factors"]) @ (z / max(1, np.linalg.norm(z)))
    return weights / weights.sum() @ pieces


def error(case):
    """By how much the answer is off at least."""
    first, second, answer = case["first"], case["second"], float(case["answer"])
    if "normal" in case:
        u = np.array(case["normal"]) / np.linalg.norm(case["normal"])
        return -support(second, -u) - support(first, u) - answer
    return answer - np.linalg.norm(point(second, case["point_2"]) - point(first, case["point_1"]))


if __name__ == "__main__":
    cases = [json.loads(line) for line in open(sys.argv[1], encoding="utf-8")]
    failed = [number for number, case in enumerate(cases, 1) if not error(case) > 5e-10 * case["size"]]
    print(f"{len(cases) - len(failed)} of {len(cases)} answers are refuted")
    for number in failed:
        print(f"line {number}: not refuted")
    sys.exit(1 if failed else 0)
