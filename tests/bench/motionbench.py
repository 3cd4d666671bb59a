# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""raygauge_motionbench on problems of a planar arm: the same plans on any number of threads, and after kills.

Usage: motionbench.py PROGRAM RAYGAUGE"""
import csv
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

import h5py
import numpy as np

ROD = '<collision><origin rpy="0 1.5707963267948966 0" xyz="0.5 0 0"/><geometry><cylinder length="1" radius="0.02"/></geometry></collision>'
LIMIT = '<limit lower="-2.9" upper="2.9" effort="1" velocity="1"/>'
URDF = (
    f'<robot name="arm"><link name="ground"/><link name="inner">{ROD}</link><link name="outer">{ROD}</link>'
    f'<joint name="j" type="revolute"><parent link="ground"/><child link="inner"/><axis xyz="0 0 1"/>{LIMIT}</joint>'
    f'<joint name="k" type="revolute"><origin xyz="1 0 0"/><parent link="inner"/><child link="outer"/><axis xyz="0 0 1"/>{LIMIT}</joint>'
    "</robot>"
)
SRDF = '<robot name="arm"><group name="arm"><joint name="j"/><joint name="k"/></group></robot>'
SCENE = """name: posts
world:
  collision_objects:
    - id: post
      primitives:
        - type: cylinder
          dimensions: [1, 0.005]
      primitive_poses:
        - position: [1.7, {y}, 0]
          orientation: [0, 0, 0, 1]
    - id: stone
      primitives:
        - type: box
          dimensions: [0.2, 0.2, 0.2]
      primitive_poses:
        - position: [0, {stone}, 0]
          orientation: [0, 0, 0, 1]
"""
REQUEST = """group_name: arm
start_state:
  joint_state:
    name: [j, k]
    position: [-0.9, 0.1]
goal_constraints:
  - joint_constraints:
      - joint_name: j
        position: 0.9
      - joint_name: k
        position: 0.1
"""
TIMES = ("search_seconds", "plan_seconds", "proof_seconds")


class Motionbench(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.work = pathlib.Path(scratch.name)
        self.robot = self.work / "arm"
        for environment in ("a", "b"):
            folder = self.robot / "problems" / environment
            folder.mkdir(parents=True)
            for number, y, stone in (("0001", 0, 1.3), ("0002", 0.2, -1.3), ("0003", 0, 9)):
                (folder / f"scene{number}.yaml").write_text(SCENE.format(y=y, stone=stone))
                (folder / f"request{number}.yaml").write_text(REQUEST)
        # One problem begins in contact.
        (self.robot / "problems" / "b" / "scene0002.yaml").write_text(SCENE.format(y=-0.78, stone=9).replace("1.7", "0.62"))
        (self.robot / "arm.urdf").write_text(URDF)
        (self.robot / "arm.srdf").write_text(SRDF)
        (self.robot / "meshes").mkdir()

    def command(self, *options):
        return [PROGRAM, str(self.robot), "--problems", "3", *map(str, options)]

    def run_it(self, *options):
        done = subprocess.run(self.command(*options), capture_output=True, text=True, cwd=self.work)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def plans(self, name):
        """All but times of a CSV file."""
        with open(self.work / name, newline="") as file:
            return [{key: value for key, value in row.items() if key not in TIMES} for row in csv.DictReader(file)]

    def records(self, name):
        """All but times, threads and sessions of the records, sorted."""
        with h5py.File(self.work / name) as file:
            columns = {key: file["records"][key][:] for key in file["records"]}
        for key in ("seconds", "started_at", "session", "thread", "concurrency", "host"):
            columns.pop(key)
        rows = zip(*(map(repr, np.nan_to_num(column, nan=-1) if column.dtype.kind == "f" else column) for column in columns.values()),
                   strict=True)
        return sorted(rows)

    def test_threads_change_nothing(self):
        told = [self.run_it("--threads", k, "--csv", f"{k}.csv", "-o", f"{k}.h5") for k in (1, 2, 5)]
        self.assertEqual(len(self.plans("1.csv")), 5 * 5)
        for k, text in zip((1, 2, 5), told, strict=True):
            self.assertEqual(self.plans(f"{k}.csv"), self.plans("1.csv"))
            self.assertEqual(self.records(f"{k}.h5"), self.records("1.h5"))
            self.assertIn("left out: b 0002: start in contact", text)
            self.assertIn("left out, for start or goal is not free: 1", text)
        self.run_it("--processor-time", "--proven-only", "--csv", "own.csv")
        self.assertEqual(self.plans("own.csv"), [row for row in self.plans("1.csv") if row["validator"] == "proven"])
        first = [row for row in self.plans("1.csv") if row["validator"] == "proven"]
        self.assertEqual({row["proof"] for row in first}, {"free"})

    def test_records_have_proofs_and_depths_and_commands_read_them(self):
        self.run_it("-o", "plans.h5")
        with h5py.File(self.work / "plans.h5") as file:
            records = {key: file["records"][key][:] for key in ("method", "role", "seconds", "upper", "agrees", "repetition", "generator")}
        by = {}
        for k in range(len(records["method"])):
            row = {key: column[k].decode() if isinstance(column[k], bytes) else column[k] for key, column in records.items()}
            by[row["method"], row["generator"], row["repetition"]] = row
        self.assertEqual(len(by), 2 * 5 * 5)
        collisions = 0
        for (method, *problem), row in by.items():
            if method.startswith("proof of "):
                self.assertEqual(row["role"], "oracle")
                self.assertGreater(row["seconds"], 0)
                continue
            proof = by["proof of " + method, *problem]
            self.assertEqual(np.isnan(proof["upper"]), bool(row["agrees"]))
            collisions += not row["agrees"]
        self.assertGreater(collisions, 0)
        self.assertTrue(all(row["agrees"] for (method, *_), row in by.items() if method == "proven"))
        for words in (["table", "plans.h5", "--rows", "method", "--cols", "generator", "--value", "median seconds"], ["plot", "plans.h5", "--figure", "wrong_share", "-o", "plans.svg"], ["info", "plans.h5"]):
            done = subprocess.run([RAYGAUGE, *words], capture_output=True, text=True, cwd=self.work)
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("samples 0.125", (self.work / "plans.svg").read_text())

    def test_a_run_that_is_killed_is_continued_without_a_difference(self):
        self.run_it("-o", "whole.h5")
        killed = stored = 0
        parts = self.work / "cut.h5.parts"

        def size():
            return sum(part.stat().st_size for part in parts.glob("*.csv")) if parts.exists() else 0

        while killed < 4:
            process = subprocess.Popen(self.command("-o", "cut.h5", "--threads", "2"), cwd=self.work, stdout=subprocess.DEVNULL)
            while process.poll() is None and size() <= stored:
                time.sleep(0.001)
            process.kill()
            if process.wait() == 0:
                break
            killed, stored = killed + 1, size()
        self.assertGreater(killed, 1)
        self.run_it("-o", "cut.h5")
        self.assertEqual(self.records("cut.h5"), self.records("whole.h5"))
        self.run_it("-o", "cut.h5")  # nothing is left to do
        self.assertEqual(self.records("cut.h5"), self.records("whole.h5"))


if __name__ == "__main__":
    PROGRAM, RAYGAUGE = (str(pathlib.Path(name).resolve()) for name in sys.argv[1:3])
    unittest.main(argv=sys.argv[:1])
