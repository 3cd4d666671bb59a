# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Shards and MPI ranks give the file of one process, whatever is killed on the way (--kills 20: more often)."""
import argparse
import json
import os
import shutil
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

from support import Killer, Tool, answers, write_experiment

PROGRAM = None
KILLS = 4
SCENES = Path(__file__).resolve().parents[2] / "experiments/scenes"


class ManyProcesses(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="raygauge-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        self.tool = Tool(PROGRAM, self.folder)
        self.experiment = write_experiment(self.folder)

    def run_whole(self, name="one.h5"):
        self.tool.run("run", "e.toml", "-o", name, "-q")
        return answers(self.folder / name)

    def shards(self, count, name="s.h5"):
        for i in range(1, count + 1):
            self.tool.run("run", "e.toml", "-o", name, "--shard", f"{i}/{count}", "-q")
        return [f"s.shard-{i}-of-{count}.h5" for i in range(1, count + 1)]

    def test_seven_shards_merge_to_the_run_of_one_process(self):
        parts = self.shards(7)
        self.tool.run("merge", *parts, "-o", "s.h5")
        self.assertEqual(answers(self.folder / "s.h5"), self.run_whole())

    def test_a_dear_cell_is_split_between_shards(self):
        write_experiment(self.folder, largest=2000)
        parts = self.shards(5)
        cells = [{row[0] for row in answers(self.folder / part)} for part in parts]
        self.assertTrue(any(a & b for a in cells for b in cells if a is not b))
        self.tool.run("merge", *parts, "-o", "s.h5")
        self.assertEqual(answers(self.folder / "s.h5"), self.run_whole())

    def test_more_ranks_than_cores_give_the_file_of_one_process(self):
        whole = self.run_whole()
        for ranks in (2, 4):
            self.tool.run("run", "e.toml", "-o", f"mpi{ranks}.h5", ranks=ranks)
            self.assertEqual(answers(self.folder / f"mpi{ranks}.h5"), whole)

    def test_a_run_goes_on_with_other_shards_ranks_and_threads(self):
        self.tool.run("run", "e.toml", "-o", "s.h5", "--shard", "2/5", "-q")
        self.tool.run("run", "e.toml", "-o", "s.h5", "--shard", "1/3", "--resume", "-q")
        self.tool.run("run", "e.toml", "-o", "s.h5", "--resume", ranks=3)
        self.assertEqual(answers(self.folder / "s.h5"), self.run_whole())

    def test_kills_of_ranks_and_of_mpirun_lose_and_repeat_nothing(self):
        write_experiment(self.folder, min_seconds=2e-3 * KILLS)
        killer = Killer(self.tool, "k.h5")
        killer.kill_often(KILLS, lambda killed: killer.attempt("mpirun" if killed % 4 == 3 else "rank"))
        whole = self.run_whole()
        for file in killer.files():
            self.assertEqual(answers(file), whole)

    def test_a_merge_of_too_few_parts_is_refused_and_writes_nothing(self):
        parts = self.shards(3)
        text = self.tool.run("merge", *parts[:2], "-o", "s.h5", status=2)
        self.assertIn("--partial", text)
        self.assertFalse((self.folder / "s.h5").exists())
        self.tool.run("merge", *parts[:2], "-o", "s.h5", "--partial")
        self.tool.run("run", "e.toml", "-o", "s.h5", "--resume", "-q")
        self.assertEqual(answers(self.folder / "s.h5"), self.run_whole())

    def test_info_tells_how_far_shards_are_and_the_command_that_completes_them(self):
        self.tool.run("run", "e.toml", "-o", "s.h5", "--shard", "2/4", "-q")
        text = self.tool.run("info", "s.h5")
        self.assertRegex(text, r"shards +4: 3 missing, 1 done")
        self.assertRegex(text, r"\n +3/4 +missing, 0 of \d+ instances")
        report = json.loads(self.tool.run("info", "s.h5", "--json"))
        self.assertEqual([shard["state"] for shard in report["shards"]], ["missing", "done", "missing", "missing"])
        self.assertEqual(sum(shard["instances"] for shard in report["shards"]), 24 * 6)
        command = report["complete"].replace("EXPERIMENT.toml", "e.toml")
        subprocess.run(["bash", "-ec", command], cwd=self.folder, check=True, capture_output=True)
        self.assertEqual(answers(self.folder / "s.h5"), self.run_whole())
        (machine,) = json.loads(self.tool.run("info", "s.h5", "--json"))["machines"]
        self.assertEqual(machine["sessions"], 4)
        self.assertEqual(machine["records"], 24 * 6 * 2)

    def run_scene(self, name, *words, ranks=0):
        self.tool.run("scene", "run", SCENES / "arm.toml", "-o", name, "-q", "--threads", 1, *words, ranks=ranks)
        return self.folder / name

    def test_a_scene_by_shards_and_by_ranks_gives_the_file_of_one_process(self):
        whole = answers(self.run_scene("one.h5"))
        for i in (1, 2, 3):
            self.run_scene("s.h5", "--shard", f"{i}/3")
        parts = [f"s.shard-{i}-of-3.h5" for i in (1, 2, 3)]
        text = self.tool.run("merge", *parts[:2], "-o", "s.h5", status=2)
        self.assertIn("--partial", text)
        self.tool.run("merge", *parts[:2], "-o", "some.h5", "--partial")
        self.tool.run("merge", *parts, "-o", "s.h5")
        self.assertEqual(answers(self.folder / "s.h5"), whole)
        self.assertEqual(answers(self.run_scene("mpi.h5", ranks=3)), whole)
        self.assertFalse((self.folder / "mpi.h5.parts").exists())
        self.assertEqual(answers(self.run_scene("some.h5", "--resume", ranks=2)), whole)

    def test_a_repeated_cell_of_a_scene_is_taken_once_and_contradictions_are_refused(self):
        import h5py
        whole = answers(self.run_scene("one.h5"))
        self.run_scene("two.h5")
        self.tool.run("merge", "one.h5", "two.h5", "-o", "s.h5")
        self.assertEqual(answers(self.folder / "s.h5"), whole)
        with h5py.File(self.folder / "two.h5", "r+") as file:
            file["records/solves"][5] += 1
        text = self.tool.run("merge", "one.h5", "two.h5", "-o", "t.h5", status=2)
        self.assertIn("one.h5 and two.h5 contradict each other in solves", text)
        self.assertFalse((self.folder / "t.h5").exists())

    def test_shards_without_cells_have_files_that_merge(self):
        words = ["--set", "sweep.n=3", "--set", "sweep.N=20", "--set", "sweep.tolerance=1e-3", "--set", "sweep.repetitions=1"]
        for i in (1, 2, 3):
            self.tool.run("run", "e.toml", "-o", "s.h5", "--shard", f"{i}/3", *words, "-q")
        parts = [f"s.shard-{i}-of-3.h5" for i in (1, 2, 3)]
        self.tool.run("merge", *parts, "-o", "s.h5")
        self.assertEqual(sum(len(answers(self.folder / part)) for part in parts), 2)
        self.assertEqual(len(answers(self.folder / "s.h5")), 2)
        text = self.tool.run("run", "e.toml", "-o", "s.h5", "--shard", "3/3", *words, "--resume")
        self.assertIn("no cells", text)

    def test_parts_of_another_experiment_are_refused(self):
        self.shards(2)
        self.tool.run("run", "e.toml", "-o", "other.h5", "--set", "sweep.seed=2", "-q")
        text = self.tool.run("merge", "s.shard-1-of-2.h5", "other.h5", "-o", "s.h5", status=2)
        self.assertIn("seed", text)

    def test_repeated_cells_are_taken_once_and_contradictions_are_refused(self):
        import h5py
        whole = self.run_whole()
        self.run_whole("two.h5")
        text = self.tool.run("merge", "one.h5", "two.h5", "-o", "s.h5")
        self.assertIn("in it once", text)
        self.assertEqual(answers(self.folder / "s.h5"), whole)
        with h5py.File(self.folder / "two.h5", "r+") as file:
            file["records/distance"][5] *= 1.001
        text = self.tool.run("merge", "one.h5", "two.h5", "-o", "t.h5", status=2)
        self.assertIn("contradict", text)
        self.assertFalse((self.folder / "t.h5").exists())

    def test_parts_of_another_commit_are_refused_unless_asked_for(self):
        import h5py
        import numpy
        parts = self.shards(2)
        with h5py.File(self.folder / parts[1], "r+") as file:
            commits = file["provenance/sessions/git_commit"]
            commits[...] = numpy.array(["0" * 7] * len(commits), dtype=commits.dtype)
        text = self.tool.run("merge", *parts, "-o", "s.h5", status=2)
        self.assertIn("another build", text)
        self.tool.run("merge", *parts, "-o", "s.h5", "--mixed-builds")
        self.assertEqual(answers(self.folder / "s.h5"), self.run_whole())

    def test_two_runs_of_the_same_cells_at_once_are_refused(self):
        write_experiment(self.folder, min_seconds=2e-2)
        first = self.tool.start("run", "e.toml", "-o", "s.h5", "--shard", "1/2")
        while not list(self.folder.glob("s.shard-1-of-2.h5.parts/cells-*")):
            time.sleep(0.02)
        for words in (["--shard", "1/2", "--resume"], ["--resume"], ["--shard", "1/3", "--resume"]):
            text = self.tool.run("run", "e.toml", "-o", "s.h5", *words, status=2)
            self.assertIn("another process is writing", text)
        self.assertIn("another process", self.tool.run("merge", "s.shard-1-of-2.h5", "-o", "s.h5", status=2))
        first.communicate(timeout=300)
        self.assertEqual(first.returncode, 0)

    def test_a_lost_lock_ends_the_run_and_keeps_its_cells(self):
        write_experiment(self.folder, min_seconds=2e-2)
        run = self.tool.start("run", "e.toml", "-o", "s.h5")
        while not list(self.folder.glob("s.h5.parts/cells-*")):
            time.sleep(0.02)
        (self.folder / "s.h5.parts" / "lock").unlink()
        _, err = run.communicate(timeout=300)
        self.assertEqual(run.returncode, 2)
        self.assertIn("lock of this run was lost", err)
        self.tool.run("run", "e.toml", "-o", "s.h5", "--resume", "-q")
        write_experiment(self.folder, min_seconds=2e-2)
        self.assertEqual(answers(self.folder / "s.h5"), self.run_whole())

    def test_submit_without_slurm_is_one_line(self):
        environment = dict(os.environ, PATH="/nowhere")
        done = subprocess.run([PROGRAM, "submit", "e.toml", "--slurm", "--array", "3"], cwd=self.folder, text=True,
                              capture_output=True, env=environment)
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stderr.count("\n"), 1)
        self.assertIn("sbatch", done.stderr)

    def test_submit_prints_both_scripts(self):
        text = self.tool.run("submit", "e.toml", "--slurm", "--array", 3, "--time", "1:00:00", "-o", "x y.h5", "--print",
                             "--", "--mem=1G")
        for piece in ("--array=1-3", "#SBATCH --time=1:00:00", "#SBATCH --mem=1G", "x y.shard-3-of-3.h5'", " merge -o "):
            self.assertIn(piece, text)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--raygauge", required=True)
    parser.add_argument("--kills", type=int, default=KILLS)
    arguments, rest = parser.parse_known_args()
    PROGRAM = str(Path(arguments.raygauge).resolve())
    KILLS = arguments.kills
    unittest.main(argv=["many_processes", *rest], verbosity=2)
