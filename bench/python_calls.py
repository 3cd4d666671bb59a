# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""What Python adds to a call and to a batch: n = 3, N = 200, arrays, one thread, CPU time, rounds alternating with C++.

    PYTHONPATH=build/release/python python3 bench/python_calls.py build/release/bench/raygauge_python_calls [PROBLEMS]
"""

import subprocess
import sys
import tempfile
import time

import numpy as np

import raygauge as rg

N, n, CALLS, ROUNDS = 200, 3, 2000, 15
PROBLEMS = int(sys.argv[2]) if len(sys.argv) > 2 else 100_000


def seconds_of(work):
    start = time.process_time()
    work()
    return time.process_time() - start


def main():
    points = np.random.default_rng(1).normal(size=(PROBLEMS, 2, N, n))
    points[:, 0, :, 0] += 5
    A, Q = np.ascontiguousarray(points[:, 0]), np.ascontiguousarray(points[:, 1])

    def calls():
        first, second = A[0], Q[0]
        for _ in range(CALLS):
            rg.distance(first, second)

    works = {"call": calls, "batch": lambda: rg.distances(A, Q, threads=1)}
    with tempfile.NamedTemporaryFile() as file:
        points.tofile(file.name)
        command = [sys.argv[1], file.name, str(N), str(n), str(PROBLEMS)]
        with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as other:

            def in_cpp(work):
                other.stdin.write(work + "\n")
                other.stdin.flush()
                return float(other.stdout.readline().split()[0])

            for work, rounds in (("call", ROUNDS), ("batch", 5)):
                works[work](), in_cpp(work)
                pairs = np.array([(seconds_of(works[work]), in_cpp(work)) for _ in range(rounds)])
                count = CALLS if work == "call" else PROBLEMS
                python, cpp = np.median(pairs, axis=0) / count * 1e6
                more = np.median(pairs[:, 0] - pairs[:, 1]) / count * 1e6
                ratio = np.median(pairs[:, 0] / pairs[:, 1])
                print(f"{work:5}  Python {python:6.2f} us  C++ {cpp:6.2f} us  {more:+.2f} us  ratio {ratio:.3f}")
            other.stdin.close()


if __name__ == "__main__":
    main()
