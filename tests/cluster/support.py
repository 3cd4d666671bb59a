# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""What the tests of many processes share: an experiment, ways to run it, and the answers in a file."""
import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

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
name = "column_generation"
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


def is_alive(process):
    try:
        return Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
    except OSError:
        return False


def children(process):
    return subprocess.run(["pgrep", "-P", str(process)], text=True, capture_output=True).stdout.split()


def instances_of_file(path):
    if not path.exists():
        return set()
    with h5py.File(path) as file:
        records = file["records"]
        return set(zip(records["cell"][:].tolist(), records["repetition"][:].tolist()))


def instances_of_journal(path):
    rows = [line.split(",") for line in path.read_text().splitlines() if line[:1] != "#"]
    if not rows:
        return set()
    cell, repetition = rows[0].index("cell"), rows[0].index("repetition")
    return {(int(row[cell]), int(row[repetition])) for row in rows[1:] if len(row) == len(rows[0])}


def stored_instances(folder, name, attempts=20):
    """How many instances the journals and the file of a run hold. A run that ends while this reads moves its journals'
    rows into the file and removes them: then it is read again."""
    for attempt in range(1, attempts + 1):
        try:
            journals = sorted(Path(folder).glob(f"{name}.parts/cells-*.csv"))
            return len(set().union(*map(instances_of_journal, journals), instances_of_file(Path(folder) / name)))
        except FileNotFoundError:
            assert attempt < attempts, f"{name}: journals vanish without end"
            time.sleep(0.05)


class Killer:
    """Kills runs of ranks, each resumed with another number of ranks, and tells what it has done."""

    def __init__(self, tool, name, seed=1):
        self.tool = tool
        self.name = name
        self.chance = random.Random(seed)
        self.killed = {}
        self.attempts = 0
        self.finished = []

    def kill_often(self, kills, attempt):
        """Until so many processes have been killed: attempt(i), i kills having been made. A run that has finished before it
        was killed makes way for a new one."""
        while sum(self.killed.values()) < kills:
            assert self.attempts < 4 * kills, f"{self.killed} in {self.attempts} attempts"
            folder = self.tool.folder
            if (folder / self.name).exists() and not (folder / f"{self.name}.parts").exists():
                self.finished.append(self.name)
                self.name = f"after-{len(self.finished)}-{self.finished[0]}"
            attempt(sum(self.killed.values()))

    def files(self):
        """The last run finished by another number of ranks, and those that had finished before they were killed."""
        self.tool.run(*self.words(), ranks=self.ranks())
        return [self.tool.folder / name for name in [*self.finished, self.name]]

    def ranks(self):
        return 2 + self.attempts % 3

    def words(self):
        return "run", "e.toml", "-o", self.name, "--resume", "-q"

    def wait(self):
        """For a new cell in every other attempt; else for a while, in which a run may only have begun."""
        before = stored_instances(self.tool.folder, self.name)
        end = time.monotonic() + 20
        while self.attempts % 2 == 0 and time.monotonic() < end:
            if stored_instances(self.tool.folder, self.name) > before:
                return
            time.sleep(0.02)
        time.sleep(self.chance.uniform(0.3, 1.2))

    def kill(self, kind, process):
        if not is_alive(process):
            return
        os.kill(int(process), signal.SIGKILL)
        self.killed[kind] = self.killed.get(kind, 0) + 1
        stored = stored_instances(self.tool.folder, self.name)
        print(f"kill {sum(self.killed.values())}: {kind} of a run by {self.ranks()} ranks, {stored} instances stored",
              file=sys.stderr)

    def wait_for_death(self, processes):
        end = time.monotonic() + 60
        while any(is_alive(process) for process in processes):
            assert time.monotonic() < end, "ranks outlive the job"
            time.sleep(0.05)

    def attempt(self, kind):
        """Starts a run under mpirun and kills a rank or mpirun."""
        job = self.tool.start(*self.words(), ranks=self.ranks())
        self.wait()
        ranks = children(job.pid)
        if kind == "rank" and ranks:
            self.kill(kind, self.chance.choice(ranks))
        else:
            self.kill("mpirun", job.pid)
        self.wait_for_death(ranks)  # they notice that mpirun has gone
        try:
            job.communicate(timeout=10)
        except subprocess.TimeoutExpired:  # Open MPI 4.1's mpirun may wait for itself once its ranks are dead
            job.kill()
            job.communicate(timeout=60)
        self.attempts += 1


class Tool:
    def __init__(self, program, folder):
        self.program = program
        self.folder = folder
        # What Open MPI's modules keep cannot be told from a leak once they are unloaded.
        sanitizer = os.environ.get("ASAN_OPTIONS", "") + ":detect_leaks=0"
        self.environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                                ASAN_OPTIONS=sanitizer)

    def start(self, *words, ranks=0):
        launcher = ["mpirun", "--oversubscribe", "-n", str(ranks)] if ranks else []
        return subprocess.Popen([*launcher, self.program, *map(str, words)], cwd=self.folder, text=True,
                                env=self.environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def run(self, *words, ranks=0, status=0):
        process = self.start(*words, ranks=ranks)
        out, err = process.communicate(timeout=300)
        assert process.returncode == status, f"{words}: {process.returncode}, not {status}\n{out}{err}"
        return out + err
