# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""`pip wheel --no-build-isolation --no-deps .`: the module is compiled by CMake, and stripped.

RAYGAUGE_BUILD_FOLDER names a configured build folder to be used; without it one is made for this interpreter, of engine and
scenes alone. RAYGAUGE_ENGINE_ONLY=1 leaves out what such a folder has for sweeps, which links the program's libraries.
CMAKE_ARGS are further options for CMake.
"""

import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent


def version():
    project = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"project\(raygauge VERSION (\S+)", project).group(1)


def take_qhull_along(module):
    """Copies Qhull's shared libraries to _libs beside the module, which looks for them there: few systems have them."""
    needed = subprocess.run(["ldd", str(module)], capture_output=True, text=True, check=True).stdout
    for name, path in re.findall(r"(libqhull\S+) => (/\S+)", needed):
        (module.parent / "_libs").mkdir(exist_ok=True)
        shutil.copy(os.path.realpath(path), module.parent / "_libs" / name)


class BuildByCMake(build_ext):
    def build_extension(self, extension):
        folder = os.environ.get("RAYGAUGE_BUILD_FOLDER")
        engine_only = not folder or os.environ.get("RAYGAUGE_ENGINE_ONLY") == "1"
        if not folder:
            folder = pathlib.Path(self.build_temp).resolve()
            options = ["-DCMAKE_BUILD_TYPE=Release", f"-DPython_EXECUTABLE={sys.executable}", "-DRAYGAUGE_BUILD_PYTHON=ON"]
            options += [f"-DRAYGAUGE_{part}=OFF" for part in ("BUILD_PROGRAM", "BUILD_C", "BUILD_TESTS", "BUILD_BENCH", "INSTALL")]
            options += shlex.split(os.environ.get("CMAKE_ARGS", ""))
            subprocess.run(["cmake", "-S", str(ROOT), "-B", str(folder), *options], check=True)
        subprocess.run(["cmake", "--build", str(folder), "--parallel", str(os.cpu_count() or 1), "--target", "raygauge_python"], check=True)
        target = pathlib.Path(self.get_ext_fullpath(extension.name)).parent
        shutil.rmtree(target / "_libs", ignore_errors=True)  # of an earlier build, with other modules
        for old in target.glob("_*.so"):
            old.unlink()
        target.mkdir(parents=True, exist_ok=True)
        # _sweeps is there where ./run.sh python found the program built.
        for built in (pathlib.Path(folder) / "python" / "raygauge").glob("_raygauge*.so" if engine_only else "_*.so"):
            shutil.copy(built, target)
            if shutil.which("strip"):
                subprocess.run(["strip", "--strip-unneeded", str(target / built.name)], check=True)
            if engine_only:
                take_qhull_along(target / built.name)


setup(version=version(), ext_modules=[Extension("raygauge._raygauge", [])], cmdclass={"build_ext": BuildByCMake})
