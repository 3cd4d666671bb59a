# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""usage: test_subproject.py SOURCE FOLDER CXX_COMPILER [--build]. A project that fetches raygauge is configured; what it would
compile is the library alone, and its own program; so does the README's command for the library alone. With --build the project is
compiled, which takes minutes, and run."""
import pathlib
import re
import subprocess
import sys


def output_of(*command):
    finished = subprocess.run(list(map(str, command)), capture_output=True, text=True)
    if finished.returncode != 0:
        sys.exit(f"{command}: {finished.stdout}{finished.stderr}")
    return finished.stdout


def check_library_alone(*options, targets):
    """Configures; what the targets would compile is engine and scenes, and programs of this folder (tests)."""
    output_of("cmake", "--fresh", "-G", "Ninja", "-B", folder, f"-DCMAKE_CXX_COMPILER={compiler}", "-DCMAKE_BUILD_TYPE=Release", *options)
    commands = output_of("ninja", "-C", folder, "-t", "commands", *targets).splitlines()
    found = [re.search(r" -c (\S+)$", line) for line in commands]
    compiled = {match.group(1) for match in found if match and not match.group(1).startswith(f"{folder}/")}
    rooms = {path.removeprefix(f"{source}/").split("/")[0] for path in compiled if path.startswith(f"{source}/")}
    wrong = rooms - {"engine", "scene", "tests"}
    wrong |= {path for path in compiled if re.search(r"/(bindings|python|scene/(file|page|input|commands))/", path)}
    if wrong or not {"engine", "scene"} <= rooms:
        sys.exit(f"{options}: would compile {sorted(wrong) or sorted(rooms)}")
    print(f"{len(compiled)} sources of {sorted(rooms)}")


source, folder, compiler = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3]
line = re.search(r"cmake -S \. -B \S+ (-DRAYGAUGE_BUILD_PROGRAM=OFF.*)", (source / "README.md").read_text(encoding="utf-8")).group(1)
check_library_alone("-S", source, *line.split(), targets=["all"])
check_library_alone("-S", source / "tests/package/subproject", f"-DRAYGAUGE_SOURCE={source}", targets=["quickstart", "all"])
if "--build" in sys.argv:
    output_of("cmake", "--build", folder, "--target", "quickstart")
    if "distance 2, certified" not in output_of(folder / "quickstart"):
        sys.exit("the program of the subproject does not answer")
