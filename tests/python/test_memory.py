# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""The memory of the process stays where it is over many calls."""
import gc
import unittest

import numpy as np

import raygauge as rg


def resident_bytes():
    with open("/proc/self/statm", encoding="ascii") as numbers:
        return int(numbers.read().split()[1]) * 4096


class Memory(unittest.TestCase):
    def assert_stable(self, call, calls):
        for _ in range(calls // 10):
            call()
        gc.collect()
        before = resident_bytes()
        for _ in range(calls):
            call()
        gc.collect()
        grown = resident_bytes() - before
        self.assertLess(grown, 4e6, msg=f"{grown / calls:.1f} bytes a call")  # a leaked double each would be 8e6

    def test_distances_leave_nothing_behind(self):
        A, Q = np.array([[2.0, 0.5], [3.0, 1.0]]), np.array([[1.0, 0.0], [-1.0, 1.0], [-1.0, -1.0]])
        self.assert_stable(lambda: rg.distance(A, Q).normal, 1_000_000)

    def test_refusals_leave_nothing_behind(self):
        def call():
            try:
                rg.distance([[np.nan, 1.0]], [[1.0, 0.0]])
            except rg.NonFiniteError:
                pass

        self.assert_stable(call, 30_000)

    def test_batches_and_mappings_leave_nothing_behind(self):
        problems = np.random.default_rng(0).normal(size=(8, 5, 3)) + 3

        def call():
            rg.distances(problems, rg.SupportMappingSet(np.zeros(3), np.sign), threads=1)

        self.assert_stable(call, 1000)


if __name__ == "__main__":
    unittest.main()
