# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Wrong answers about two bodies are refuted, and docs/examples/check_refutations.py notices a refutation that is none.

    refutations.py --raygauge PROGRAM --check check_refutations.py
"""
import argparse
import fcntl
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

# A solver that is wrong in every way: its tolerance is the size of the bodies.
EXPERIMENT = """name = "wrong"
[sweep]
n = 3
N = 12
repetitions = 2
[[generator]]
name = "bodies"
kind_1 = ["box", "cone", "hull"]
kind_2 = ["ball", "capsule", "cylinder", "ellipsoid", "hull"]
place = ["near", "overlap"]
scale = [1e-3, 1, 50]
quantity = QUANTITY
[[method]]
name = "object_distance"
[[method]]
name = "fcl_libccd"
distance_tolerance = 1.0
[[method]]
name = "fcl_indep"
"""


def check(script, path):
    return subprocess.run([sys.executable, script, path], stdout=subprocess.PIPE, text=True, check=False)


def spoilt(case):
    """The same with an answer that its proof does not refute."""
    answer = float(case["answer"])
    far = 10 * case["size"] + answer
    if case["quantity"] == "separated":
        return dict(case, answer=1.0 - answer)
    if case["quantity"] == "depth":
        return dict(case, answer=0.0 if "normal" in case else far)
    return dict(case, answer=far if "normal" in case else 0.0)


class Sweep:
    """The experiment about one quantity, and what of it fails."""

    def __init__(self, arguments, folder, quantity, proofs):
        self.arguments, self.folder, self.proofs, self.failures = arguments, folder, proofs, []
        text = EXPERIMENT.replace("QUANTITY", f'"{quantity}"')
        (folder / "wrong.toml").write_text(text)
        self.raygauge("run", "wrong.toml", "-o", "wrong.h5", "--quiet", "--force")
        self.said = self.raygauge("export", "wrong.h5", "--refutations", "wrong.jsonl").stderr
        self.cases = [json.loads(line) for line in (folder / "wrong.jsonl").read_text().splitlines()]

    def raygauge(self, *words):
        command = [self.arguments.raygauge, *words]
        return subprocess.run(command, cwd=self.folder, check=True, capture_output=True, text=True)

    def fail_unless(self, holds, text):
        self.failures += [] if holds else [text]

    def check_interrupted(self):
        """SIGINT while a reader is slow: the line at hand is the last one."""
        pipe = self.folder / "pipe"
        os.mkfifo(pipe)
        command = [self.arguments.raygauge, "export", "wrong.h5", "--refutations", "pipe"]
        with open(os.open(pipe, os.O_RDONLY | os.O_NONBLOCK), "rb") as reader:
            fcntl.fcntl(reader, 1031, 4096)  # F_SETPIPE_SZ
            os.set_blocking(reader.fileno(), True)
            with subprocess.Popen(command, cwd=self.folder, stderr=subprocess.PIPE, text=True) as program:
                lines = []
                while not lines and program.poll() is None:  # the end of the file, until it is opened there
                    lines += filter(None, [reader.readline()])
                    time.sleep(0.01)
                program.send_signal(signal.SIGINT)
                lines += reader.readlines()
                said = program.stderr.read()
        pipe.unlink()
        held = program.returncode == 130 and said == "interrupted\n" and len(lines) < len(self.cases)
        self.fail_unless(held, f"interrupted: status {program.returncode}, {len(lines)} lines, {said}")

    def check(self):
        wrong = int(self.said.split()[1])
        self.fail_unless(wrong == len(self.cases) > 20, f"{len(self.cases)} lines: {self.said}")
        for case in self.cases:
            self.fail_unless(case["method"].startswith("fcl"), f"of {case['method']}")
        checked = check(self.arguments.check, self.folder / "wrong.jsonl")
        verified = checked.returncode == 0 and checked.stdout == f"{wrong} of {wrong} answers are refuted\n"
        self.fail_unless(verified, checked.stdout)
        for proof in self.proofs:
            self.check_spoilt(proof)
        self.check_interrupted()
        table = self.raygauge("table", "wrong.h5", "--wrong").stdout
        self.fail_unless("Who is wrong" in table and "fcl_libccd" in table, table)
        return wrong

    def check_spoilt(self, proof):
        case = next((case for case in self.cases if proof in case), None)
        if case is None:
            self.failures.append(f"no case with {proof}")
            return
        (self.folder / "spoilt.jsonl").write_text(json.dumps(spoilt(case)) + "\n")
        code = check(self.arguments.check, self.folder / "spoilt.jsonl").returncode
        self.fail_unless(code == 1, f"a spoilt refutation passes: {spoilt(case)}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--raygauge", required=True)
    parser.add_argument("--check", required=True)
    arguments = parser.parse_args()
    failures, wrong = [], 0
    with tempfile.TemporaryDirectory() as name:
        for quantity, proofs in (("distance", ("normal", "point_1")), ("depth", ("normal", "triangles"))):
            sweep = Sweep(arguments, pathlib.Path(name), quantity, proofs)
            wrong += sweep.check()
            failures += [f"{quantity}: {text}" for text in sweep.failures]
    print("\n".join(failures) or f"{wrong} refutations")
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
