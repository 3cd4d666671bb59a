# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Ctrl-C ends a batch within 0.2 s."""
import os
import signal
import threading
import time
import unittest

import numpy as np

import raygauge as rg


class Interrupt(unittest.TestCase):
    def test_a_batch_ends_within_a_fifth_of_a_second(self):
        generator = np.random.default_rng(1)
        A = generator.normal(size=(200, 10)) + 4
        poses = np.tile(np.eye(11), (50000, 1, 1))
        Q = generator.normal(size=(200, 10))
        sent = []

        def interrupt():
            time.sleep(0.3)
            sent.append(time.monotonic())
            os.kill(os.getpid(), signal.SIGINT)

        thread = threading.Thread(target=interrupt)
        thread.start()
        with self.assertRaises(KeyboardInterrupt):
            rg.distances(A, Q, poses_A=poses, threads=1)
            thread.join()
        waited = time.monotonic() - sent[0]
        thread.join()
        print(f"KeyboardInterrupt came {waited * 1e3:.0f} ms after the signal")
        self.assertLess(waited, 0.2)


if __name__ == "__main__":
    unittest.main()
