# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""`pip install --no-build-isolation .`: the module is compiled by CMake.

RAYGAUGE_BUILD_FOLDER names a configured build folder to be used; otherwise one is made for this interpreter.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent


def version():
    project = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"project\(raygauge VERSION (\S+)", project).group(1)


class BuildByCMake(build_ext):
    def build_extension(self, extension):
        folder = os.environ.get("RAYGAUGE_BUILD_FOLDER")
        if not folder:
            folder = pathlib.Path(self.build_temp).resolve()
            options = ["-DCMAKE_BUILD_TYPE=Release", f"-DPython_EXECUTABLE={sys.executable}", "-DRAYGAUGE_BUILD_PYTHON=ON"]
            options += [f"-DRAYGAUGE_{part}=OFF" for part in ("BUILD_PROGRAM", "BUILD_TESTS", "BUILD_BENCH", "INSTALL")]
            subprocess.run(["cmake", "-S", str(ROOT), "-B", str(folder), *options], check=True)
        subprocess.run(["cmake", "--build", str(folder), "--parallel", str(os.cpu_count() or 1), "--target", "raygauge_python"], check=True)
        target = pathlib.Path(self.get_ext_fullpath(extension.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        # _sweeps is there where ./run.sh python found the program built.
        for built in (pathlib.Path(folder) / "python" / "raygauge").glob("_*.so"):
            shutil.copy(built, target.parent / built.name)


setup(version=version(), ext_modules=[Extension("raygauge._raygauge", [])], cmdclass={"build_ext": BuildByCMake})
