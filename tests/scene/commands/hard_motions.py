# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Simulates every shipped scene of bodies that react at steps of 1e-2, 1e-3 and 1e-4 s: each step is proven, no energy is gained, and
what is known of the motion holds.

    hard_motions.py --raygauge PROGRAM --scenes FOLDER
"""
import csv
import io
import math
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]))
from scene_program import SceneProgram, main  # noqa: E402

STEPS = (1e-2, 1e-3, 1e-4)
G = 9.81


def number(text):
    try:
        return float(text)
    except ValueError:
        return text


class Motion:
    """What one simulation of a file has found."""

    def __init__(self, step, rows, steps, summary):
        self.step, self.rows, self.steps, self.summary = step, rows, steps, summary

    def of(self, body):
        return [row for row in self.rows if row["body"] == body]

    def end(self, body):
        return self.of(body)[-1]

    def drift(self):
        """How far a body is from where it began, at most."""
        first = {}
        return max(math.dist(place, first.setdefault(row["body"], place))
                   for row in self.rows for place in [(row["x"], row["y"], row["z"])])


class HardMotions(SceneProgram):
    def table(self, results, *options):
        text = self.run_raygauge("export", results, "--csv", "-", *options).stdout
        return [{key: number(cell) for key, cell in row.items()} for row in csv.DictReader(io.StringIO(text))]

    def simulated(self, name, *changes):
        """A motion for each of STEPS, all proven; none in a build without Siconos if the scene has friction."""
        scene = self.scenes / "dynamics" / (name + ".toml")
        self.run_raygauge("scene", "explain", scene)
        results = self.work / "motion.h5"
        command = [self.raygauge, "scene", "simulate", str(scene), "-q", "-o", str(results), "--force", "--step", ",".join(map(str, STEPS))]
        done = subprocess.run(command + [word for change in changes for word in ("--set", change)], capture_output=True, text=True)
        if done.returncode != 0:
            self.assertIn("friction", scene.read_text())
            self.assertRegex(done.stderr, "apt-get install libsiconos-numerics-dev")
            return []
        rows, steps = self.table(results), self.table(results, "--steps")
        motions = [Motion(STEPS[k], *([row for row in table if row["simulation"] == k] for table in (rows, steps)), summary)
                   for k, summary in enumerate(self.table(results, "--simulations"))]
        self.assertEqual([motion.summary["step"] for motion in motions], list(STEPS))
        for motion in motions:
            self.assert_proven(motion)
        self.run_raygauge("report", results, "-o", self.work / "page.html")
        return motions

    def assert_proven(self, motion):
        size = max(row["kinetic"] + abs(row["potential"]) for row in motion.steps)
        self.assertEqual(motion.summary["unproven"], 0, motion.step)
        self.assertLessEqual(motion.summary["energy_rise"], 1e-9 * size, motion.step)
        for row in motion.steps:
            self.assertGreaterEqual(row["least_distance"], -motion.summary["delta"], (motion.step, row["time"]))
            self.assertLessEqual(row["residual"], 1e-9, (motion.step, row["time"]))

    def assert_first_order(self, errors):
        for coarse, fine in zip(errors, errors[1:]):
            self.assertAlmostEqual(fine / coarse, 0.1, delta=0.02)

    def assert_stands(self, motions, size):
        for motion in motions:
            self.assertLessEqual(motion.drift(), 1e-9 * size, motion.step)

    def assert_path(self, motions, body, place):
        """`place`(t): the coordinates that are known of it."""
        for motion in motions:
            for row in motion.of(body):
                for axis, known in place(row["time"]).items():
                    self.assertAlmostEqual(row[axis], known, delta=1e-6, msg=(motion.step, row["time"]))

    def test_no_shipped_scene_is_left_out(self):
        for scene in (self.scenes / "dynamics").glob("*.toml"):
            self.assertTrue(hasattr(self, "test_" + scene.stem), scene)

    def test_arch(self):
        self.assert_stands(self.simulated("arch", "time.to=0.005"), 2)

    # The box floats, so momentum and angular momentum are those of all.
    def test_billiards(self):
        for motion in self.simulated("billiards"):
            self.assertGreater(motion.summary["impacts"], 800)
            first = motion.steps[0]
            for row in motion.steps:
                for key in ("px", "py", "pz", "lx", "ly", "lz", "kinetic"):
                    self.assertAlmostEqual(row[key], first[key], delta=1e-9 * first["kinetic"], msg=(motion.step, row["time"]))

    def test_block_on_slope(self):
        motions = self.simulated("block_on_slope", "time.to=0.5")
        self.assert_stands(motions, 1)
        sliding = self.simulated("block_on_slope", "time.to=0.5", "dynamics.contact.friction=0.3")
        way = G * (math.sin(0.4) - 0.3 * math.cos(0.4)) * 0.5**2 / 2
        errors = [abs(motion.drift() - way) for motion in sliding]
        self.assert_first_order(errors)
        for error in errors[1:]:
            self.assertLess(error, 0.01 * way)

    # It falls from a height of 1 in √(2/g), and each rebound has half the speed of the one before.
    def test_bouncing_ball(self):
        def place(time):
            start, speed = -math.sqrt(2 / G), G * math.sqrt(2 / G)
            while time > start + 2 * speed / G and speed > 1e-6:
                start, speed = start + 2 * speed / G, speed / 2
            since = time - start
            return {"z": 0.1 + max(0, speed * since - G * since**2 / 2)}

        self.assert_path(self.simulated("bouncing_ball"), "ball", place)

    def test_contact_at_start(self):
        def place(time):
            since, speed = (time, 1) if time < 2 / G else (time - 2 / G, 0.5)
            return {"x": 0.5 * time, "z": 0.1 + speed * since - G * since**2 / 2}

        self.assert_path(self.simulated("contact_at_start"), "ball", place)

    def test_dropped_box(self):
        for motion in self.simulated("dropped_box"):
            self.assertLess(motion.steps[-1]["kinetic"], 1e-8)

    def test_fast_box(self):
        for motion in self.simulated("fast_box"):
            self.assertGreater(motion.end("box")["z"], 0.05)

    def test_free_fall(self):
        motions = self.simulated("free_fall")
        self.assert_path(motions, "ball", lambda time: {"x": 1 + time, "y": 2, "z": 30 + 4 * time - G / 2 * time**2})

    def test_heavy_on_light(self):
        self.assert_stands(self.simulated("heavy_on_light"), 0.2)

    def test_house_of_cards(self):
        self.assert_stands(self.simulated("house_of_cards", "time.to=0.2"), 0.2)

    def test_needle(self):
        for motion in self.simulated("needle"):
            self.assertAlmostEqual(motion.end("needle")["z"], 5e-5, delta=motion.summary["delta"])
            self.assertLess(motion.steps[-1]["kinetic"], 1e-12)

    def test_peg_in_hole(self):
        for motion in self.simulated("peg_in_hole"):
            self.assertAlmostEqual(motion.end("peg")["z"], 0.2, delta=1e-6)

    # One corner of the rod meets the wall at a lever arm y: v = (1 + e) ω y / (1 + m y² / I), whatever the step.
    def test_rod_by_wall(self):
        motions = self.simulated("rod_by_wall")
        arm, moment = math.sqrt(0.5**2 + 0.02**2 - 0.3**2), (0.5**2 + 0.02**2) / 3
        for motion in motions:
            self.assertEqual(motion.summary["impacts"], 1)
            self.assertAlmostEqual(motion.end("rod")["vx"] / (-1.5 * 1000 * arm / (1 + arm**2 / moment)), 1, 5)

    # Friction slows it down and turns it, until it rolls from 2 v/(7 μ g) on.
    def test_rolling_ball(self):
        motions = self.simulated("rolling_ball")
        rolls = 2 * 2 / (7 * 0.2 * G)
        way = 2 * rolls - 0.2 * G * rolls**2 / 2 + 10 / 7 * (1 - rolls)
        self.assert_first_order([abs(motion.end("ball")["x"] - way) for motion in motions])
        for motion in motions:
            self.assertAlmostEqual(motion.end("ball")["vx"], 10 / 7, delta=1e-9)
            self.assertAlmostEqual(motion.end("ball")["wy"], 100 / 7, delta=1e-8)

    # The first ball has a way of 0.1 to go.
    def test_row_of_balls(self):
        motions = self.simulated("row_of_balls")
        self.assert_path(motions, "ball 5", lambda time: {"x": 0.8 + max(0, 3 * time - 0.1)})

    def test_spinning_body(self):
        for motion in self.simulated("spinning_body", "time.to=2", "time.instants=41"):
            for key in ("lx", "ly", "lz", "kinetic"):
                self.assertAlmostEqual(motion.steps[0][key], motion.steps[-1][key], delta=1e-10)

    # Ω² = m g (r cos α - h/2 sin α) / (A sin α cos α) keeps its height; A is the moment across its axis.
    def test_spinning_coin(self):
        motions = self.simulated("spinning_coin")
        self.assert_first_order([motion.drift() for motion in motions])
        self.assertLess(motions[-1].drift(), 1e-3 * 0.1)

    def test_tower_of_cubes(self):
        self.assert_stands(self.simulated("tower_of_cubes", "time.to=0.05"), 1)


if __name__ == "__main__":
    main()
