# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Every case of experiments/reported has a proven distance, the closed form where there is one, and a line in README.md.

    reported_cases.py --raygauge PROGRAM --cases experiments/reported
"""
import argparse
import csv
import json
import pathlib
import re
import subprocess
import sys

TOUCH = 1e-12  # what touches is proven to be no further apart


def failures_of(case, answer, page):
    lower, upper = answer["lower"], answer["upper"]
    if not upper - lower <= max(TOUCH, 1e-6 * upper):
        yield f"the distance is only known to lie in [{lower}, {upper}]"
    if case["closed_form"]:
        expected = max(0.0, float(case["closed_form"]))  # minus the depth of bodies that meet
        if not lower - 1e-9 * expected <= expected <= upper + 1e-9 * expected:
            yield f"{expected} is not in [{lower}, {upper}]"
    if not re.fullmatch(r"https://github\.com/[\w.-]+/[\w.-]+/issues/\d+", case["report"]):
        yield "no report"
    if f"| [{case['pair']}]({case['report']}) |" not in page:
        yield "not in README.md"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--raygauge", required=True)
    parser.add_argument("--cases", type=pathlib.Path, required=True)
    arguments = parser.parse_args()
    with open(arguments.cases / "pairs.csv", encoding="utf-8", newline="") as file:
        cases = list(csv.DictReader(file))
    page = (arguments.cases / "README.md").read_text(encoding="utf-8")
    failures = []
    for case in cases:
        command = [arguments.raygauge, "distance", case["A"], case["Q"], "--json"]
        outcome = subprocess.run(command, cwd=arguments.cases, stdout=subprocess.PIPE, text=True, check=False)
        failures += [f"{case['pair']}: {what}" for what in failures_of(case, json.loads(outcome.stdout), page)]
    print("\n".join(failures) or f"{len(cases)} cases")
    sys.exit(1 if failures or len(cases) < 30 else 0)


if __name__ == "__main__":
    main()
