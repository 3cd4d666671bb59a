# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""A job array and its merge under a real Slurm: requeued, stopped at its time limit, killed."""
import argparse
import shutil
import tempfile
import unittest
from pathlib import Path

from slurm_cluster import SlurmCluster
from support import Tool, answers, write_experiment

PROGRAM = None


class Slurm(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.base = Path(tempfile.mkdtemp(prefix="raygauge-slurm-"))
        cls.addClassCleanup(shutil.rmtree, cls.base, ignore_errors=True)
        (cls.base / "slurm").mkdir()
        cls.slurm = SlurmCluster(cls.base / "slurm")
        cls.slurm.__enter__()
        cls.addClassCleanup(cls.slurm.__exit__)

    def setUp(self):
        self.folder = self.base / self.id().split(".")[-1]
        self.folder.mkdir()
        self.tool = Tool(PROGRAM, self.folder)
        self.tool.environment = dict(self.slurm.environment)

    def submit(self, *words):
        text = self.tool.run("submit", "e.toml", "--slurm", "-o", "s.h5", *words)
        return text.split()[1].rstrip(","), text.split("merge")[1].split()[0].rstrip(",")

    def states(self, job):
        return self.slurm.run("squeue", "-h", "-r", "-j", job, "-o", "%T", check=False).split()

    def wait_for_end(self, seconds=240):
        self.slurm.wait_for(lambda: self.slurm.run("squeue", "-h").strip() == "", "the jobs", seconds)

    def expect_the_file_of_one_process(self):
        logs = "".join(log.read_text() for log in self.folder.glob("*.log"))
        self.assertTrue((self.folder / "s.h5").exists(), logs)
        self.tool.run("run", "e.toml", "-o", "one.h5", "-q")
        self.assertEqual(answers(self.folder / "s.h5"), answers(self.folder / "one.h5"))

    def test_an_array_and_the_merge_after_it(self):
        write_experiment(self.folder)
        array, merge = self.submit("--array", 4)
        self.assertIn(f"Dependency=afterany:{array}", self.slurm.run("scontrol", "show", "job", merge))
        self.wait_for_end()
        self.expect_the_file_of_one_process()

    def test_a_requeued_task_and_a_killed_one_go_on(self):
        write_experiment(self.folder, min_seconds=5e-3)
        array, _ = self.submit("--array", 2)
        cells = lambda: list(self.folder.glob("s.shard-1-of-2.h5.parts/cells-*"))
        self.slurm.wait_for(cells, "the first task")
        self.slurm.run("scontrol", "requeue", f"{array}_1")
        self.wait_for_end()
        parts = self.folder / "s.shard-1-of-2.h5"
        sessions = self.tool.run("info", parts).count("\nsession")
        self.assertGreaterEqual(sessions, 2)
        self.expect_the_file_of_one_process()

    def test_a_task_at_its_time_limit_is_queued_again_and_goes_on(self):
        write_experiment(self.folder, min_seconds=0.2)  # 96 s of work for each of two tasks, in a minute's limit
        self.submit("--array", 2, "--time", "0:01:00", "--", "--signal=B:USR1@20")
        self.wait_for_end(560)
        logs = "".join(log.read_text() for log in self.folder.glob("*.log"))
        self.assertIn("interrupted", logs)
        write_experiment(self.folder, min_seconds=0.2)
        info = self.tool.run("info", "s.shard-1-of-2.h5")
        self.assertGreaterEqual(info.count("\nsession"), 2)
        self.assertTrue((self.folder / "s.h5").exists(), logs)
        rows = answers(self.folder / "s.h5")
        self.assertEqual(len(rows), len(set(rows)))
        self.assertEqual(len(rows), 24 * 6 * 2)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--raygauge", required=True)
    arguments, rest = parser.parse_known_args()
    PROGRAM = str(Path(arguments.raygauge).resolve())
    unittest.main(argv=["slurm", *rest], verbosity=2)
