# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Bodies that react, from Python."""
import pickle
import unittest

import numpy as np

import raygauge as rg

GRAVITY = [0, 0, -9.81]


def box(*half):
    return rg.Box([-h for h in half], list(half))


class Simulations(unittest.TestCase):
    def dropped(self):
        scene = rg.Scene(np.linspace(0, 0.4, 5))
        pose = np.eye(4)
        pose[2, 3] = 1
        scene.add_body("ball", rg.Ball([0, 0, 0], 0.1), mass=2, pose=pose, velocity=[1, 0, 0])
        scene.add_body("floor", rg.HalfSpace([0, 0, 1], 0))
        return scene

    def test_free_fall_is_exact(self):
        scene = self.dropped()
        scene.add_query(["clearance"], name="gap")
        found = rg.simulate(scene, gravity=GRAVITY, step=0.1)
        ball = found.states.where(body="ball")
        t = ball["time"]
        np.testing.assert_allclose(ball["position"], np.stack([t, 0 * t, 1 - 9.81 / 2 * t**2], axis=1), atol=1e-12)
        np.testing.assert_allclose(ball["velocity"][-1], [1, 0, -9.81 * 0.4], atol=1e-12)
        np.testing.assert_allclose(found.steps["kinetic"] + found.steps["potential"], 2 * 9.81 + 1, atol=1e-12)
        self.assertEqual((found.steps.rows, found.contacts.rows, found.counters["contact_queries"]), (4, 0, 0))
        self.assertAlmostEqual(found.answers["lower"][0], 0.9 - 9.81 / 2 * 0.16, delta=1e-3)  # of the simulated motion

    def test_a_block_sticks_below_the_tangent_and_slides_above(self):
        slope = 0.4
        for mu, slides in ((0.43, False), (0.3, True)):
            scene = rg.Scene([0, 0.5])
            pose = np.eye(4)
            pose[:3, :3] = [[np.cos(slope), 0, np.sin(slope)], [0, 1, 0], [-np.sin(slope), 0, np.cos(slope)]]
            scene.add_body("block", rg.Box([-0.3, -0.2, 0], [0.3, 0.2, 0.2]), density=700, pose=pose)
            scene.add_body("slope", rg.HalfSpace([np.sin(slope), 0, np.cos(slope)], 0), groups=["ground"])
            found = rg.simulate(scene, gravity=GRAVITY, contact={}, pairs=[("block", "ground", {"friction": mu})])
            block = found.states.where(body="block")["position"]
            way = 9.81 * (np.sin(slope) - mu * np.cos(slope)) * 0.5**2 / 2 if slides else 0
            self.assertAlmostEqual(np.linalg.norm(block[1] - block[0]), way, delta=0.01 * way + 1e-9)
            self.assertGreaterEqual(min(found.steps["least_distance"]), -found.tolerance)
            self.assertLess(max(found.steps["residual"]), 1e-8)

    def test_a_ball_bounces_and_a_disc_spins_in_the_plane(self):
        found = rg.simulate(self.dropped(), gravity=GRAVITY, contact={"restitution": 1}, step=0.01)
        self.assertEqual(set(found.contacts["body_a"]) | set(found.contacts["body_b"]), set())
        scene = rg.Scene(np.linspace(0, 1, 3))
        scene.add_body("disc", rg.Ball([0, 0], 1), mass=1, inertia=0.5, spin=2)
        found = rg.simulate(scene, damping={"angular": 1}, step=1e-3)
        np.testing.assert_allclose(found.states["spin"][:, 2], 2 * np.exp(-found.states["time"]), rtol=6e-4)  # of the middle of a step

    def test_what_was_done_until_a_jam_is_kept(self):
        scene = rg.Scene(np.linspace(0, 0.3, 31))
        up = np.zeros((4, 4))
        up[2, 3] = 1
        scene.add_body("ball", rg.Ball([0, 0, 0], 0.1), mass=1, pose=np.eye(4) + 0.1 * up)
        scene.add_body("floor", rg.HalfSpace([0, 0, 1], 0))
        scene.add_body("press", box(1, 1, 0.1), pose=np.eye(4) + 0.32 * up, velocity=[0, 0, -0.5])
        scene.add_query(["clearance"], name="gap")
        with self.assertRaisesRegex(rg.SimulationError, "at 0.040000 s 'ball' is jammed by 'floor', 'press'") as raised:
            rg.simulate(scene, contact={"friction": 0.5}, step=3e-3)
        for error in (raised.exception, pickle.loads(pickle.dumps(raised.exception))):
            self.assertEqual((str(error), error.done.steps.rows), (str(raised.exception), 13))
            np.testing.assert_allclose(error.done.steps["time"][-1], 0.039)
            np.testing.assert_allclose(np.unique(error.done.states["time"]), [0, 0.01, 0.02, 0.03, 0.039], atol=1e-15)
            self.assertAlmostEqual(error.done.answers["lower"][0], 0, delta=1e-4)

    def test_mistakes_are_exceptions_of_ours(self):
        scene = self.dropped()
        for mistake in (
            lambda: scene.run(),
            lambda: scene.add_body("x", box(1, 1, 1), mass=1, acceleration=[0, 0, 1]),
            lambda: scene.add_body("x", box(1, 1, 1), inertia=[1, 1, 1]),
            lambda: rg.simulate(scene, contact={"fricton": 0.5}),
            lambda: rg.simulate(scene, contact={"friction": -1}),
            lambda: rg.simulate(scene, pairs=[("ball", "nobody", {})], contact={}),
            lambda: rg.simulate(scene, step=0),
            lambda: rg.simulate(scene, step=1e-300),  # more steps than can be counted
            lambda: rg.simulate(scene, step="1 ms"),
            lambda: rg.simulate(scene, gravity=[0, 1]),
            lambda: rg.simulate(scene, gravity=[0, 0, -1e200]),
            lambda: rg.simulate(scene, contact={"friction": "0.5"}),
            lambda: rg.simulate(scene, contact=0.5),
            lambda: rg.simulate(scene, pairs=[("ball", "floor", None)], contact={}),
            lambda: rg.simulate(scene, pairs=[("ball", "floor")], contact={}),
        ):
            self.assertRaises(rg.Error, mistake)
        for wrong in ({"mass": -1}, {"mass": 0}, {"density": float("nan")}, {"density": "heavy"}):  # no standing body either
            with self.subTest(wrong), self.assertRaises(rg.InvalidParameterError):
                scene = self.dropped()
                scene.add_body("x", rg.Ball([5, 5, 5], 1), **wrong)
                rg.simulate(scene)
        overlapping = rg.Scene([0, 1])
        overlapping.add_body("a", box(1, 1, 1), mass=1)
        overlapping.add_body("b", box(1, 1, 1))
        with self.assertRaisesRegex(rg.InvalidParameterError, "'a' and 'b' overlap at the start"):
            rg.simulate(overlapping, contact={})


if __name__ == "__main__":
    unittest.main()
