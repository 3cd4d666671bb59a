# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Prints docs/dependencies.md, made of cmake/debian-packages.txt:

    docs/site/dependencies.py > docs/dependencies.md

.ci/check-house fails where the page is not what this prints.
"""
import pathlib

LIST = pathlib.Path(__file__).resolve().parent.parent.parent / "cmake" / "debian-packages.txt"

HEAD = """# Dependencies and licences

All dependencies are packages of Debian 12. `run.sh` installs what a command needs; on another system, install their counterparts
first. This page is made of [cmake/debian-packages.txt](../cmake/debian-packages.txt) by `docs/site/dependencies.py`.

What is optional has a CMake option, `RAYGAUGE_BUILD_PYTHON` or `RAYGAUGE_WITH_…`: `AUTO` (the default: on if its package is found
at configuration), `ON` (an error without the package) or `OFF`. CMake prints one line for each.
"""

GROUPS = {
    "build": "Program, library and tests: `./run.sh`",
    "check": "Checks before a change lands: `./run.sh install check`",
    "python": "Python package: `./run.sh python`",
    "notebooks": "Notebooks: `./run.sh notebooks`",
    "docs": "Documentation site: `./run.sh docs`",
    "octave": "Octave package: `./run.sh install octave`",
    "packages": "Debian packages: `./run.sh install packages`",
    "cluster": "Tests of Slurm jobs: `./run.sh install cluster`",
    "arm64": "Tests for 64-bit ARM: `./run.sh install arm64`",
}

LICENCES = """
## Licences
raygauge is under the MIT licence. Using any of these libraries on your own machine has no consequence. A binary that you
distribute is subject to the licences of what it links. The library alone uses Eigen and optionally Qhull; the rest is
the program's.

| linked | licence | consequence for a binary that you distribute |
| --- | --- | --- |
| Eigen | MPL-2 | headers only; the licence concerns changes to Eigen itself |
| Qhull | BSD-like | distribute its `COPYING.txt`; `-DRAYGAUGE_WITH_QHULL=OFF` builds without |
| GLPK | GPL-3 | the whole binary falls under GPL-3; `-DRAYGAUGE_WITH_GLPK=OFF` builds without |
| Clp, CoinUtils | EPL-1 | keep the notices and offer Clp's source; the FSF holds EPL and GPL to be incompatible: distribute GLPK or Clp, not both (`-DRAYGAUGE_WITH_CLP=OFF`) |
| NLopt | MIT, in Debian's build with parts under LGPL-2.1 | link it dynamically (the default) or let users relink; `-DRAYGAUGE_WITH_NLOPT=OFF` builds without |
| GMP | LGPL-3 or GPL-2 | link it dynamically (the default) or let users relink |
| LIBSVM | BSD-3 | keep its notice; `-DRAYGAUGE_WITH_LIBSVM=OFF` builds without |
| FCL, libccd, OctoMap | BSD-3 | keep their notices |
| Bullet | zlib | none; `-DRAYGAUGE_WITH_BULLET=OFF` builds without |
| ODE, MuJoCo | BSD-3, Apache-2.0 | keep their notices |
| CGAL | GPL-3 | the whole binary falls under GPL-3; `-DRAYGAUGE_WITH_CGAL=OFF` builds without |
| OMPL | BSD-3 | keep its notice; `-DRAYGAUGE_WITH_OMPL=OFF` builds without |
| tinyxml2, HDF5, Random123, CLI11, toml++, fmt, nlohmann-json, zlib | BSD, MIT or zlib | keep their notices |
| Boost | BSL-1.0 | none |
"""


def packages():
    """(group, package, why) of each line of the list."""
    for line in LIST.read_text(encoding="utf-8").splitlines():
        if line and not line.startswith("#"):
            yield line.split(maxsplit=2)


def page():
    parts = [HEAD]
    listed = list(packages())
    assert {group for group, _, _ in listed} == set(GROUPS), "GROUPS is not the groups of the list"
    for name, title in GROUPS.items():
        lines = "".join(f"- `{package}`: {why}\n" for group, package, why in listed if group == name)
        parts.append(f"\n## {title}\n\n{lines}")
    return "".join(parts) + LICENCES


if __name__ == "__main__":
    print(page(), end="")
