# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""usage: wheel.py SOURCE SCRATCH [BUILD_FOLDER | WHEEL]. Takes that wheel, or makes one, of a configured build folder or of a fresh
source distribution, and tries it where a user would: in a virtual environment that has NumPy alone."""
import email
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time
import unittest
import zipfile

SOURCE, SCRATCH = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
GIVEN = sys.argv[3] if len(sys.argv) > 3 else None
del sys.argv[1:]
# Of the system: every Linux with a Python of GCC 12's age has these.
SYSTEM = re.compile(r"lib(c|m|gcc_s|stdc\+\+|gomp|quadmath|dl|pthread)\.so|ld-linux")
FIRST_DISTANCE = """
import sys, raygauge as rg
print(rg.__file__, rg.__version__)
r = rg.distance([[2, 0], [4, -1], [4, 1]], rg.Ball([0, 0]))
assert r.lower <= 2 <= r.upper
"""


def run(*command, **options):
    finished = subprocess.run([str(word) for word in command], capture_output=True, text=True, **options)
    if finished.returncode != 0:
        raise AssertionError(f"{command}: {finished.stdout}{finished.stderr}")
    return finished.stdout


def seconds_of_children():
    """CPU time: what else the machine does is not the wheel's."""
    times = os.times()
    return times.children_user + times.children_system


def make_wheel(folder):
    """The wheel; without a build folder by way of a source distribution, which is unpacked elsewhere."""
    if GIVEN and GIVEN.endswith(".whl"):
        return pathlib.Path(GIVEN)
    environment = {**os.environ, "SOURCE_DATE_EPOCH": "1700000000"}
    source = SOURCE
    if GIVEN:
        environment.update(RAYGAUGE_BUILD_FOLDER=GIVEN, RAYGAUGE_ENGINE_ONLY="1")
        # The metadata and the build of setuptools are written beside the sources.
        source = folder / "source"
        shutil.copytree(SOURCE / "python", source / "python", ignore=shutil.ignore_patterns("*.egg-info", "__pycache__"))
        for name in ("CMakeLists.txt", "LICENSE", "README.md", "setup.py", "pyproject.toml"):
            shutil.copy(SOURCE / name, source)
    else:
        run(sys.executable, "-m", "build", "--sdist", "--no-isolation", "--outdir", folder, SOURCE)
        source = next(folder.glob("raygauge-*.tar.gz"))
    start = time.monotonic()
    run(sys.executable, "-m", "pip", "wheel", "--no-index", "--no-build-isolation", "--no-deps", "--wheel-dir", folder, source,
        env=environment, cwd=folder)
    print(f"the wheel took {time.monotonic() - start:.0f} s")
    return next(folder.glob("*.whl"))


def bare_environment(folder):
    """A virtual environment without the system's packages; NumPy, which no index here has, is linked into it."""
    run("/usr/bin/python3", "-m", "venv", folder)
    packages = next(folder.glob("lib/python*/site-packages"))
    for name in pathlib.Path("/usr/lib/python3/dist-packages").glob("numpy*"):
        (packages / name.name).symlink_to(name)
    return folder / "bin/python"


class Wheel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(SCRATCH, ignore_errors=True)
        SCRATCH.mkdir(parents=True)
        cls.wheel = make_wheel(SCRATCH)
        cls.version = re.search(r"project\(raygauge VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text(encoding="utf-8")).group(1)
        cls.python = bare_environment(SCRATCH / "environment")
        start = seconds_of_children()
        run(cls.python, "-m", "pip", "install", "--no-index", "--no-deps", cls.wheel)
        run(cls.python, "-c", FIRST_DISTANCE, cwd=SCRATCH)
        cls.seconds = seconds_of_children() - start

    def test_its_name_size_and_contents_are_as_promised(self):
        self.assertRegex(self.wheel.name, rf"raygauge-{re.escape(self.version)}-cp3\d+-cp3\d+-linux_\w+\.whl")
        self.assertLess(self.wheel.stat().st_size, 10e6)
        with zipfile.ZipFile(self.wheel) as archive:
            names = archive.namelist()
            metadata = email.message_from_string(archive.read(f"raygauge-{self.version}.dist-info/METADATA").decode())
        for name in ("__init__.py", "_raygauge.pyi", "py.typed", "extras.py"):
            self.assertIn(f"raygauge/{name}", names)
        self.assertFalse([name for name in names if "_sweeps" in name and name.endswith(".so")])  # it links GPL and HDF5
        self.assertEqual({pathlib.Path(name).name for name in names if ".dist-info/LICENSE" in name}, {"LICENSE", "LICENSES.txt"})
        self.assertEqual((metadata["Name"], metadata["Version"]), ("raygauge", self.version))
        self.assertEqual(set(metadata.get_all("Provides-Extra")), {"results", "plot"})
        self.assertIn("# raygauge", metadata.get_payload())

    def test_its_libraries_are_the_systems_or_inside(self):
        package = next((SCRATCH / "environment").glob("lib/python*/site-packages/raygauge"))
        inside = {path.name for path in package.glob("_libs/*")}
        for library in [*package.glob("_raygauge*.so"), *package.glob("_libs/*")]:
            dynamic = run("readelf", "-d", library)
            for needed in re.findall(r"\(NEEDED\).*\[(.*)\]", dynamic):
                self.assertTrue(SYSTEM.match(needed) or needed in inside, msg=f"{library.name} needs {needed}")
            self.assertNotIn(".debug_info", run("readelf", "-S", library))
            self.assertNotIn(".symtab", run("readelf", "-S", library))  # stripped
        loaded = run("ldd", next(package.glob("_raygauge*.so")))
        for name in inside:
            self.assertIn(f"{name} => {package.resolve()}", loaded)

    def test_it_is_installed_and_answers_within_10_seconds(self):
        self.assertLess(self.seconds, 10)
        self.assertIn(str(SCRATCH / "environment"), run(self.python, "-c", FIRST_DISTANCE, cwd=SCRATCH))
        self.assertIn("No broken requirements", run(self.python, "-m", "pip", "check"))

    def test_the_suites_that_need_numpy_alone_pass_there(self):
        for name in ("queries", "arrays", "copies"):
            run(self.python, SOURCE / "tests/python" / f"test_{name}.py", env={**os.environ, "PYTHONPATH": ""}, cwd=SCRATCH)

    def test_what_is_missing_is_said_with_what_installs_it(self):
        def message(code):
            finished = subprocess.run([self.python, "-c", f"import raygauge as rg\n{code}"], capture_output=True, text=True, cwd=SCRATCH)
            return finished.stderr.splitlines()[-1]

        self.assertIn("pip install 'raygauge[results]'", message("rg.open('results.h5')"))
        self.assertIn("pip install 'raygauge[plot]'", message("rg.plot._current(None)"))
        self.assertIn("ProgramError: reading files needs", message("rg.load_set('cube.obj')"))
        self.assertIn("ProgramError: the program raygauge is not on PATH", message("import os; os.environ['PATH'] = ''; rg.run({}, 'x.h5')"))


if __name__ == "__main__":
    unittest.main()
