# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Ctrl-C ends a batch, and a single call, within 0.2 s."""
import os
import signal
import threading
import time
import unittest

import numpy as np

import raygauge as rg


class Interrupt(unittest.TestCase):
    def seconds_until_interrupted(self, call):
        """From the signal, which comes 0.3 s after `call` has begun, to the exception: of this process's own time, as other
        processes may hold the processor meanwhile."""
        sent = []

        def interrupt():
            time.sleep(0.3)
            sent.append(time.process_time())
            os.kill(os.getpid(), signal.SIGINT)

        thread = threading.Thread(target=interrupt)
        thread.start()
        with self.assertRaises(KeyboardInterrupt):
            call()
            thread.join()
        waited = time.process_time() - sent[0]
        thread.join()
        print(f"KeyboardInterrupt came {waited * 1e3:.0f} ms after the signal")
        return waited

    def test_a_batch_ends_within_a_fifth_of_a_second(self):
        generator = np.random.default_rng(1)
        A = generator.normal(size=(200, 10)) + 4
        poses = np.tile(np.eye(11), (50000, 1, 1))
        Q = generator.normal(size=(200, 10))
        waited = self.seconds_until_interrupted(lambda: rg.distances(A, Q, poses_A=poses, threads=1))
        self.assertLess(waited, 0.2)

    def test_a_single_long_call_ends_within_a_fifth_of_a_second(self):
        generator = np.random.default_rng(1)
        A, Q = generator.normal(size=(2, 4000, 400))
        waited = self.seconds_until_interrupted(lambda: rg.distance(A + 0.2, Q, 1e-9))
        self.assertLess(waited, 0.2)

    def test_a_handler_that_does_not_raise_leaves_the_answer(self):
        generator = np.random.default_rng(1)
        A, Q = generator.normal(size=(2, 2000, 200))
        alone = rg.distance(A + 0.2, Q).distance
        heard = []
        before = signal.signal(signal.SIGALRM, lambda *_: heard.append(True))
        self.addCleanup(signal.signal, signal.SIGALRM, before)
        signal.setitimer(signal.ITIMER_REAL, 0.01, 0.01)
        self.addCleanup(signal.setitimer, signal.ITIMER_REAL, 0)
        for _ in range(20):  # a fast machine may end a call before the first signal
            self.assertEqual(rg.distance(A + 0.2, Q).distance, alone)
        self.assertTrue(heard)


if __name__ == "__main__":
    unittest.main()
