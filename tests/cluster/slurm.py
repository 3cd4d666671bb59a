# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Job arrays and their merges under a real Slurm: requeued, warned before the time limit, stopped at it, killed.

All arrays run at the same time, each in a folder of its own. --thorough adds what takes Slurm more than a minute.
"""
import argparse
import json
import os
import shutil
import signal
import subprocess
import tempfile
import unittest
from pathlib import Path

from slurm_cluster import NotStarted, SlurmCluster
from support import Killer, Tool, answers, children, write_experiment

PROGRAM = None
THOROUGH = False
KILLS = 3


class RankJob(Killer):
    """Runs by ranks, also as jobs of Slurm, that are killed."""

    def __init__(self, slurm, tool, name):
        super().__init__(tool, name)
        self.slurm = slurm

    def attempt_as_task(self):
        """Kills the task of a job: the shell that Slurm has started, under which mpirun runs."""
        folder = self.tool.folder
        script = folder / "ranks.sbatch"
        script.write_text("#!/bin/bash\necho $$ > task.pid\n"
                          f"mpirun --oversubscribe -n {self.ranks()} {PROGRAM} {' '.join(self.words())}\nexit\n")
        (folder / "task.pid").unlink(missing_ok=True)
        job = self.slurm.run("sbatch", "--parsable", "--no-requeue", str(script), cwd=folder).strip()
        self.slurm.wait_for(lambda: (folder / "task.pid").exists() and (folder / "task.pid").read_text(), "the task")
        task = (folder / "task.pid").read_text().strip()
        self.wait()
        launchers = children(task)
        ranks = [rank for launcher in launchers for rank in children(launcher)]
        self.kill("Slurm task", task)
        self.slurm.wait_for(lambda: not self.slurm.run("squeue", "-h", "-j", job, check=False).strip(), "the job", 60)
        self.wait_for_death([*launchers, *ranks])
        self.attempts += 1


class Array:
    """A submitted array of two tasks."""

    def __init__(self, slurm, base, name, min_seconds, words):
        self.slurm = slurm
        self.folder = base / name
        self.folder.mkdir()
        self.tool = Tool(PROGRAM, self.folder)
        self.tool.environment = dict(slurm.environment)
        write_experiment(self.folder, min_seconds=min_seconds)
        self.submit(*words)

    def submit(self, *words):
        text = self.tool.run("submit", "e.toml", "--slurm", "--array", 2, "-o", "s.h5", *words)
        self.array, self.merge = (line.split()[1].rstrip(",") for line in text.splitlines()[:2])

    def complete(self):
        """What `info` says: only what is missing, and the merge after it."""
        command = json.loads(self.tool.run("info", "s.h5", "--json"))["complete"]
        text = self.slurm.run("bash", "-ec", command, cwd=self.folder)
        self.merge = text.split()[-1]

    def show(self, job):
        return self.slurm.run("scontrol", "show", "job", job)

    def wait_for_cells(self):
        self.slurm.wait_for(lambda: list(self.folder.glob("s.shard-1-of-2.h5.parts/cells-*")), "the first task")

    def kill_the_first_task(self):
        words = f"{PROGRAM} run .* {self.folder / 's.h5'} --shard 1/2"
        (process,) = subprocess.run(["pgrep", "-f", words], text=True, capture_output=True).stdout.split()
        os.kill(int(process), signal.SIGKILL)

    def wait_for_end(self, seconds=150):
        self.slurm.wait_for(lambda: not self.slurm.run("squeue", "-h", "-j", self.merge, check=False).strip(),
                            "the merge", seconds)

    def sessions(self):
        return self.tool.run("info", "s.shard-1-of-2.h5").count("\nsession")

    def logs(self):
        return "".join(log.read_text() for log in self.folder.glob("*.log"))


class Slurm(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        base = Path(tempfile.mkdtemp(prefix="raygauge-slurm-"))
        cls.addClassCleanup(shutil.rmtree, base, ignore_errors=True)
        (base / "slurm").mkdir()
        slurm = SlurmCluster(base / "slurm")
        try:
            slurm.__enter__()
        except NotStarted as reason:  # a container without the rights for it, say
            raise unittest.SkipTest(f"no Slurm can be started on this machine: {reason}") from reason
        cls.addClassCleanup(slurm.__exit__)
        cls.slurm = slurm
        cls.base = base
        cls.whole_folder = base / "one"
        cls.whole_folder.mkdir()
        write_experiment(cls.whole_folder)
        Tool(PROGRAM, cls.whole_folder).run("run", "e.toml", "-o", "one.h5", "-q")
        # 288 records of so many seconds at least, for two tasks. Slurm looks at time limits every 30 s.
        cls.warned = Array(slurm, base, "warned", 0.25, ("--time", "0:01:00", "--", "--signal=B:USR1@58"))
        if THOROUGH:
            cls.stopped = Array(slurm, base, "stopped", 0.6, ("--time", "0:01:00", "--", "--signal=B:CONT@1"))
        cls.requeued = Array(slurm, base, "requeued", 0.02, ())
        cls.killed = Array(slurm, base, "killed", 0.02, ())
        cls.plain = Array(slurm, base, "plain", 1e-4, ())
        cls.requeued.wait_for_cells()
        slurm.run("scontrol", "requeue", f"{cls.requeued.array}_1")
        cls.killed.wait_for_cells()
        cls.killed.kill_the_first_task()

    def expect_the_file_of_one_process(self, array):
        self.assertTrue((array.folder / "s.h5").exists(), array.logs())
        self.assertEqual(answers(array.folder / "s.h5"), answers(self.whole_folder / "one.h5"))

    def test_1_a_requeued_task_goes_on(self):
        self.assertIn(f"Dependency=afterany:{self.requeued.array}", self.requeued.show(self.requeued.merge))
        self.requeued.wait_for_end()
        self.assertGreaterEqual(self.requeued.sessions(), 2)
        self.expect_the_file_of_one_process(self.requeued)

    def test_2_an_array_and_the_merge_after_it(self):
        self.plain.wait_for_end()
        self.expect_the_file_of_one_process(self.plain)

    def test_3_after_a_kill_the_merge_refuses_and_a_second_array_goes_on(self):
        self.killed.wait_for_end()
        self.assertFalse((self.killed.folder / "s.h5").exists())
        self.assertIn("--partial merges them all the same", self.killed.logs())
        self.killed.complete()
        self.killed.wait_for_end()
        self.assertGreaterEqual(self.killed.sessions(), 2)
        self.expect_the_file_of_one_process(self.killed)

    def test_4_a_task_warned_before_its_time_limit_is_queued_again_and_goes_on(self):
        self.warned.wait_for_end()
        self.assertIn("interrupted", self.warned.logs())
        self.assertGreaterEqual(self.warned.sessions(), 2)
        self.expect_the_file_of_one_process(self.warned)

    def test_6_kills_of_ranks_of_mpirun_and_of_tasks_lose_and_repeat_nothing(self):
        folder = self.base / "kills"
        folder.mkdir()
        write_experiment(folder, min_seconds=5e-3 * KILLS)
        tool = Tool(PROGRAM, folder)
        self.slurm.environment.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
        jobs = RankJob(self.slurm, tool, "k.h5")
        attempts = [lambda: jobs.attempt("rank"), lambda: jobs.attempt("mpirun"), jobs.attempt_as_task]
        jobs.kill_often(KILLS, lambda killed: attempts[killed % 3]())
        self.assertEqual(set(jobs.killed), {"rank", "mpirun", "Slurm task"})
        for file in jobs.files():
            self.assertEqual(answers(file), answers(self.whole_folder / "one.h5"))

    def test_5_a_task_stopped_at_its_time_limit_keeps_its_cells(self):
        self.stopped.wait_for_end(300)
        self.assertIn("DUE TO TIME LIMIT", self.stopped.logs())
        self.assertFalse((self.stopped.folder / "s.h5").exists())
        self.stopped.submit("--time", "0:02:00")
        self.stopped.wait_for_end(300)
        self.assertGreaterEqual(self.stopped.sessions(), 2)
        self.expect_the_file_of_one_process(self.stopped)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--raygauge", required=True)
    parser.add_argument("--thorough", action="store_true")
    parser.add_argument("--kills", type=int, default=KILLS)
    arguments, rest = parser.parse_known_args()
    PROGRAM = str(Path(arguments.raygauge).resolve())
    THOROUGH = arguments.thorough
    KILLS = arguments.kills
    if not THOROUGH:
        del Slurm.test_5_a_task_stopped_at_its_time_limit_keeps_its_cells
    unittest.main(argv=["slurm", *rest], verbosity=2)
