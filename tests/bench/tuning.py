# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""raygauge_tuning: a row with every value and the own one in brackets, on instances that are asked for; mistakes are one line."""
import subprocess
import sys

program = sys.argv[1]


def run(*arguments):
    return subprocess.run([program, "--rounds", "1", *arguments], capture_output=True, text=True, timeout=300)


own = run("--only", "kShortList")
assert own.returncode == 0, own.stderr
(row,) = [line for line in own.stdout.splitlines() if line.startswith("kShortList ")]
assert "[2]" in row and all(f"  {value}: " in row for value in (1, 4, 8, 16)), row

asked = run("--only", "kReachOfViolators", "--values", "0,0.5", "--cells", "3:20,5:40", "--variant", "near")
assert asked.returncode == 0, asked.stderr
(row,) = [line for line in asked.stdout.splitlines() if line.startswith("kReachOfViolators ")]
assert "near 3:20 5:40" in row and "  0: " in row and "[0.2]" in row and "  0.5: " in row, row

for mistake, cause in ((("--only", "kNothing"), "kNothing: no tuning.h of the engine has it"),
                       (("--only", "kShortList", "--cells", "3"), "--cells 3: n:N expected"),
                       (("--only", "kShortList", "--cells", "3:x"), "--cells 3:x: n:N expected"),
                       (("--only", "kShortList", "--cells", "3:9", "--variant", "odd"), "odd")):
    refused = run(*mistake)
    assert refused.returncode != 0 and cause in refused.stderr, (mistake, refused.stderr)
