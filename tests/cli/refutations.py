# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Wrong answers about two bodies are refuted, and docs/examples/check_refutations.py notices a refutation that is none.

    refutations.py --raygauge PROGRAM --check check_refutations.py
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

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
    return dict(case, answer=far if "normal" in case else 0.0)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--raygauge", required=True)
    parser.add_argument("--check", required=True)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "wrong.toml").write_text(EXPERIMENT)

        def raygauge(*words):
            return subprocess.run([arguments.raygauge, *words], cwd=folder, check=True, capture_output=True, text=True)

        raygauge("run", "wrong.toml", "-o", "wrong.h5", "--quiet")
        said = raygauge("export", "wrong.h5", "--refutations", "wrong.jsonl").stderr
        lines = (folder / "wrong.jsonl").read_text().splitlines()
        cases = [json.loads(line) for line in lines]
        wrong = int(said.split()[1])
        failures = [] if wrong == len(cases) > 20 else [f"{len(cases)} lines: {said}"]
        for kind in ("normal", "point_1"):
            failures += [] if any(kind in case for case in cases) else [f"no case with {kind}"]
        failures += [f"of {case['method']}" for case in cases if not case["method"].startswith("fcl")]
        checked = check(arguments.check, folder / "wrong.jsonl")
        if checked.returncode != 0 or checked.stdout != f"{wrong} of {wrong} answers are refuted\n":
            failures.append(checked.stdout)
        for case in (next(case for case in cases if kind in case) for kind in ("normal", "point_1")):
            (folder / "spoilt.jsonl").write_text(json.dumps(spoilt(case)) + "\n")
            if check(arguments.check, folder / "spoilt.jsonl").returncode != 1:
                failures.append(f"a spoilt refutation passes: {spoilt(case)}")
        table = raygauge("table", "wrong.h5", "--wrong").stdout
        if "Who is wrong" not in table or "fcl_libccd" not in table:
            failures.append(table)
    print("\n".join(failures) or f"{wrong} refutations")
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
