# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""What the tests of many processes share: an experiment, ways to run it, and the answers in a file."""
import os
import subprocess

import h5py

EXPERIMENT = """name = "e"
[sweep]
n = [3, 4, 6, 8]
N = [20, 50, {largest}]
tolerance = [1e-3, 1e-6]
repetitions = 6
[[generator]]
name = "example2"
[[method]]
name = "direct"
[[method]]
name = "zheng_yamane"
[run]
min_seconds = {min_seconds}
"""
# Two solves of an instance differ in these.
CIRCUMSTANCES = {"session", "seconds", "inner_repetitions", "load_seconds", "thread", "concurrency", "started_at",
                 "host", "rank"}


def write_experiment(folder, largest=100, min_seconds=1e-4):
    path = folder / "e.toml"
    path.write_text(EXPERIMENT.format(largest=largest, min_seconds=min_seconds))
    return path


def answers(path):
    """The rows of a results file without the circumstances, doubles bit by bit, in the order of the file."""
    with h5py.File(path) as file:
        names = sorted(name for name in file["records"] if name not in CIRCUMSTANCES)
        columns = [file["records"][name][:] for name in names]
        columns = [c.view("u8") if c.dtype.kind == "f" else c for c in columns]
        return list(zip(*(c.tolist() for c in columns)))


class Tool:
    def __init__(self, program, folder):
        self.program = program
        self.folder = folder
        self.environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")

    def start(self, *words, ranks=0):
        launcher = ["mpirun", "--oversubscribe", "-n", str(ranks)] if ranks else []
        return subprocess.Popen([*launcher, self.program, *map(str, words)], cwd=self.folder, text=True,
                                env=self.environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def run(self, *words, ranks=0, status=0):
        process = self.start(*words, ranks=ranks)
        out, err = process.communicate(timeout=300)
        assert process.returncode == status, f"{words}: {process.returncode}, not {status}\n{out}{err}"
        return out + err
