# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""usage: test_subproject.py SOURCE FOLDER CXX_COMPILER [--build]. A project that fetches raygauge is configured; what it would
compile is the library alone, and its own program. With --build that is compiled, which takes minutes, and run."""
import pathlib
import re
import subprocess
import sys


def output_of(*command):
    finished = subprocess.run(list(map(str, command)), capture_output=True, text=True)
    if finished.returncode != 0:
        sys.exit(f"{command}: {finished.stdout}{finished.stderr}")
    return finished.stdout


source, folder, compiler = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3]
project = source / "tests/package/subproject"
output_of("cmake", "--fresh", "-G", "Ninja", "-S", project, "-B", folder, f"-DRAYGAUGE_SOURCE={source}", f"-DCMAKE_CXX_COMPILER={compiler}",
          "-DCMAKE_BUILD_TYPE=Release")
commands = output_of("ninja", "-C", folder, "-t", "commands", "quickstart", "all").splitlines()
found = [re.search(r" -c (\S+)$", line) for line in commands]
compiled = {match.group(1) for match in found if match and not match.group(1).startswith(f"{folder}/")}
rooms = {path.removeprefix(f"{source}/").split("/")[0] for path in compiled if path.startswith(f"{source}/")}
wrong = rooms - {"engine", "scene", "tests"}  # tests: the program itself
wrong |= {path for path in compiled if re.search(r"/(bindings|python|scene/(file|page|input|commands))/", path)}
if wrong or not {"engine", "scene"} <= rooms:
    sys.exit(f"a project with raygauge inside would compile {sorted(wrong) or sorted(rooms)}")
if "--build" in sys.argv:
    output_of("cmake", "--build", folder, "--target", "quickstart")
    if "distance 2, certified" not in output_of(folder / "quickstart"):
        sys.exit("the program of the subproject does not answer")
print(f"{len(compiled)} sources of {sorted(rooms)}")
