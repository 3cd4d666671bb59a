# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Paths planned from Python: of a robot among obstacles, of a scene file, proven again, and mistakes."""

import math
import os
import pathlib
import signal
import threading
import time
import unittest

import numpy as np
import raygauge as rg

SCENES = pathlib.Path(os.environ["RAYGAUGE_SOURCE"]) / "experiments/scenes"
START = {"turn": -1.2, "lift": 1.2, "elbow": 0.6, "bend": 0.4, "grip": 0.02}
GOAL = {**START, "turn": 1.2}


class Plans(unittest.TestCase):
    def setUp(self):
        self.robot = rg.load_robot(SCENES / "arm.urdf")
        self.around = rg.Scene()
        self.around.add_body("post", rg.Cylinder([0.62, 0, -0.2], [0.62, 0, 0.6], 0.05))

    def values(self, by_name):
        return [by_name.get(joint, 0.0) for joint in self.robot.joints]

    def test_a_path_around_a_post_is_proven_and_the_straight_line_is_in_contact(self):
        straight = rg.prove_path(self.robot, [self.values(START), self.values(GOAL)], self.around, margin=0.01)
        self.assertEqual(straight.outcome, "contact")
        found = rg.plan(self.robot, START, self.values(GOAL), self.around, margin=0.01)
        self.assertTrue(found)
        self.assertEqual(found.path.shape, (len(found.times), len(self.robot.joints)))
        np.testing.assert_array_equal(found.path[0], self.values(START))
        np.testing.assert_array_equal(found.path[-1], self.values(GOAL))
        np.testing.assert_array_equal(found.times, np.arange(len(found.times)))
        self.assertAlmostEqual(found.length, np.linalg.norm(np.diff(found.path, axis=0), axis=1).sum(), places=9)
        self.assertGreater(found.length, 2.4)
        self.assertGreater(found.edges, 0)
        self.assertEqual(found.undecided, 0)
        self.assertTrue(rg.prove_path(self.robot, found.path, self.around, margin=0.01))

    def test_the_same_seed_gives_the_same_path_also_on_two_threads(self):
        def planned(seed):
            return rg.plan(self.robot, START, GOAL, self.around, seed=seed).path

        once = [planned(1), planned(2)]
        self.assertNotEqual(once[0].tolist(), once[1].tolist())
        again = [None, None]

        def plan_into(k):
            again[k] = planned(k + 1)

        threads = [threading.Thread(target=plan_into, args=(k,)) for k in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for first, second in zip(once, again, strict=True):
            np.testing.assert_array_equal(first, second)

    def test_a_scene_file_with_a_plan_gives_the_trajectory_of_its_robot(self):
        scene = rg.load_scene(SCENES / "arm_plan.toml")
        found = rg.plan(scene, seed=3)
        self.assertEqual((found.times[0], found.times[-1]), (0, 4))
        np.testing.assert_array_equal(found.path[[0, -1]], [self.values(START), self.values(GOAL)])
        self.assertTrue(rg.prove_path(self.robot, found.path, self.around, times=found.times, margin=0.01))
        with self.assertRaisesRegex(rg.InvalidParameterError, "has start, goal"):
            rg.plan(scene, START, GOAL)
        with self.assertRaisesRegex(rg.Error, "no .plan."):
            rg.plan(rg.load_scene(SCENES / "falling_box.toml"))

    def caged(self, **options):
        """Walls to both sides and a ceiling: the arm cannot turn round."""
        cage = rg.Scene()
        for name, y in (("left", 0.35), ("right", -0.35)):
            cage.add_body(name, rg.Box([-2, y - 0.01, -2], [2, y + 0.01, 2]))
        cage.add_body("ceiling", rg.Box([-2, -2, 0.5], [2, 2, 0.52]))
        bent = {"lift": 1.2, "elbow": 0.6}
        return rg.plan(self.robot, bent, {**bent, "turn": math.pi - 0.2}, cage, **options)

    def test_no_path_is_an_answer(self):
        found = self.caged(time_limit=0.2)
        self.assertFalse(found)
        self.assertEqual(found.path.shape, (0, len(self.robot.joints)))
        self.assertEqual(found.times.shape, (0,))

    def test_ctrl_c_ends_the_search(self):
        def interrupt():
            time.sleep(0.3)
            os.kill(os.getpid(), signal.SIGINT)

        thread = threading.Thread(target=interrupt)
        thread.start()
        with self.assertRaises(KeyboardInterrupt):
            self.caged(time_limit=1000)
        thread.join()

    def test_mistakes_are_refused(self):
        with self.assertRaisesRegex(rg.InvalidParameterError, "the goal of the plan is in contact"):
            rg.plan(self.robot, START, {**GOAL, "turn": 0}, self.around)
        with self.assertRaisesRegex(rg.InvalidParameterError, "beyond the limits"):
            rg.plan(self.robot, START, {**GOAL, "turn": 3.1}, self.around)
        with self.assertRaises(rg.UnknownNameError):
            rg.plan(self.robot, START, {"turns": 1})
        with self.assertRaises(rg.UnknownNameError):
            rg.plan(self.robot, START, GOAL, planner="rrt_conect")
        for wrong in ({"time_limit": 0}, {"seed": 0}, {"time_limit": math.inf}, {"margin": -1}):
            with self.assertRaises(rg.InvalidParameterError):
                rg.plan(self.robot, START, GOAL, **wrong)
        with self.assertRaisesRegex(rg.InvalidParameterError, "start and a goal"):
            rg.plan(self.robot, START)
        with self.assertRaises(rg.DimensionMismatchError):
            rg.plan(self.robot, [0, 0], GOAL)
        with self.assertRaises(TypeError):
            rg.plan(self.robot, START, GOAL, speed=1)
        self.around.add_body("ball", rg.Ball([3, 0, 0], 0.1), velocity=[0, 1, 0])
        with self.assertRaisesRegex(rg.InvalidParameterError, "'ball' moves"):
            rg.plan(self.robot, START, GOAL, self.around)


if __name__ == "__main__":
    unittest.main()
