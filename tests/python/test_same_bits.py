# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Python and C++ give the same bits over all families of point sets."""
import os
import subprocess
import unittest

import numpy as np

import raygauge as rg


def instances(lines):
    """(name, A, Q, (distance, lower, upper), status) of each instance that the C++ program wrote."""
    rows = iter(lines)
    for row in rows:
        name, n, size_a, size_q, distance, lower, upper, status = row.split()
        points = [[float.fromhex(number) for number in next(rows).split()] for _ in range(int(size_a) + int(size_q))]
        array = np.array(points).reshape(-1, int(n))
        answer = tuple(float.fromhex(number) for number in (distance, lower, upper))
        yield name, array[: int(size_a)], array[int(size_a):], answer, status


class SameBits(unittest.TestCase):
    def test_on_every_family_of_point_sets(self):
        text = subprocess.run([os.environ["RAYGAUGE_HARD_ANSWERS"]], check=True, capture_output=True, text=True).stdout
        families = set()
        for name, A, Q, answer, status in instances(text.splitlines()):
            result = rg.distance(A, Q, 1e-9)
            self.assertEqual((result.distance, result.lower, result.upper), answer, msg=name)
            self.assertEqual(result.status, status, msg=name)
            families.add(name)
        self.assertGreaterEqual(len(families), 20, msg=sorted(families))


if __name__ == "__main__":
    unittest.main()
