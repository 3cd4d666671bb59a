# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""The Debian packages: made by cpack, or those of a folder; installed by dpkg into a root of their own, run there, removed without
a trace.

    test_debs.py BUILD_FOLDER COMPILER [FOLDER]     (as root; the libraries that they depend on are this system's)
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

BUILD, COMPILER = pathlib.Path(sys.argv.pop(1)).resolve(), sys.argv.pop(1)
MADE = pathlib.Path(sys.argv.pop(1)).resolve() if len(sys.argv) > 1 else None


def run(*command, **options):
    finished = subprocess.run([str(word) for word in command], capture_output=True, text=True, **options)
    if finished.returncode != 0:
        raise AssertionError(f"{command}: {finished.stdout}{finished.stderr}")
    return finished.stdout


def field(package, name):
    return run("dpkg-deb", "--field", package, name).strip()


class Packages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        folder = pathlib.Path(cls.scratch.name)
        if MADE is None:
            run("cpack", "-G", "DEB", "--config", BUILD / "CPackConfig.cmake", "-B", folder / "debs", cwd=BUILD)
        cls.packages = {field(path, "Package"): path for path in (MADE or folder / "debs").glob("*.deb")}
        cls.root = folder / "root"
        (cls.root / "var/lib/dpkg/info").mkdir(parents=True)
        (cls.root / "var/lib/dpkg/updates").mkdir()
        (cls.root / "var/lib/dpkg/status").touch()
        # The root holds nothing but these packages: what they depend on, and ldconfig, is looked for on this system.
        run("dpkg", f"--root={cls.root}", "--force-depends", "--force-script-chrootless", "--install", *cls.packages.values())

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def environment(self):
        return {**os.environ, "LD_LIBRARY_PATH": str(self.root / "usr/lib"),
                "PYTHONPATH": str(self.root / "usr/lib/python3/dist-packages"),
                "PATH": f"{self.root / 'usr/bin'}:{os.environ['PATH']}"}

    def test_1_each_part_is_a_package_that_says_what_it_needs(self):
        self.assertLessEqual({"libraygauge0.2", "libraygauge-dev", "raygauge"}, set(self.packages))
        self.assertRegex(field(self.packages["libraygauge-results"], "Depends"), "libhdf5")
        self.assertNotRegex(field(self.packages["libraygauge0.2"], "Depends"), "hdf5|siconos")
        self.assertRegex(field(self.packages["raygauge"], "Depends"), r"libhdf5.*libstdc\+\+6")
        self.assertIn("libgomp1", field(self.packages["libraygauge0.2"], "Depends"))
        self.assertNotRegex(field(self.packages["raygauge"], "Depends"), "mpi|siconos|mumps")
        for module, library in (("mpi", "libopenmpi"), ("siconos", "libsiconos-numerics"), ("bullet", "libbullet"), ("ode", "libode"),
                                ("mujoco", "libmujoco")):
            if f"raygauge-{module}" in self.packages:
                self.assertRegex(field(self.packages[f"raygauge-{module}"], "Depends"), rf"raygauge \(= .*{library}")
        self.assertEqual("raygauge-siconos" in self.packages, "libraygauge-friction" in self.packages)
        if "libraygauge-friction" in self.packages:
            self.assertRegex(field(self.packages["libraygauge-friction"], "Depends"), "libsiconos-numerics")
        for path in self.packages.values():
            self.assertIn("copyright", run("dpkg-deb", "--contents", path))

    def test_2_the_program_finds_its_libraries_and_answers(self):
        program = self.root / "usr/bin/raygauge"
        self.assertNotIn("not found", run("ldd", program))
        points = pathlib.Path(self.scratch.name, "points.csv")
        points.write_text("2,0\n4,-1\n4,1\n", encoding="utf-8")
        gauge = pathlib.Path(self.scratch.name, "gauge.csv")
        gauge.write_text("1,0\n-1,0\n0,1\n0,-1\n", encoding="utf-8")
        answer = run("raygauge", "distance", points, gauge, "--json", env=self.environment())
        self.assertRegex(answer, r'"status": *"optimal"')

    def test_3_every_command_has_a_man_page_and_is_completed(self):
        folder = self.root / "usr/share/man/man1"
        commands = re.findall(r"(?m)^  ([a-z]+) ", run(self.root / "usr/bin/raygauge", "--help").split("Subcommands:")[1])
        self.assertGreaterEqual(len(commands), 8)
        completion = self.root / "usr/share/bash-completion/completions/raygauge"
        for command in commands:
            self.assertIn(f"raygauge-{command} \\-", (folder / f"raygauge-{command}.1").read_text(encoding="utf-8"))
            words = f"source {completion}; COMP_WORDS=(raygauge {command[:-1]}); COMP_CWORD=1; _raygauge; "
            self.assertIn(command, run("bash", "-c", words + 'echo "${COMPREPLY[@]}"').split())
        words = f"source {completion}; COMP_WORDS=(raygauge run --resu); COMP_CWORD=2; _raygauge; "
        self.assertEqual(run("bash", "-c", words + 'echo "${COMPREPLY[@]}"').strip(), "--resume")
        self.check_zsh_and_fish(commands)

    def check_zsh_and_fish(self, commands):
        zsh = self.root / "usr/share/zsh/vendor-completions/_raygauge"
        # What the completion system would be handed: the entries of _describe and of compadd.
        stubs = f"compdef() {{ }}; _describe() {{ print -l -- $commands }}; compadd() {{ print -l -- $options }}; source {zsh}; "
        offered = run("zsh", "-fc", stubs + "words=(raygauge r) CURRENT=2 PREFIX=r; _raygauge").splitlines()
        self.assertEqual([line.split(":")[0] for line in offered], commands)
        offered = run("zsh", "-fc", stubs + "words=(raygauge run --re) CURRENT=3 PREFIX=--re; _raygauge").splitlines()
        self.assertIn("--resume", offered)
        fish = self.root / "usr/share/fish/vendor_completions.d/raygauge.fish"
        offered = run("fish", "--no-config", "-c", f"source {fish}; complete -C 'raygauge '").splitlines()
        self.assertLessEqual(set(commands), {line.split("\t")[0] for line in offered})
        offered = run("fish", "--no-config", "-c", f"source {fish}; complete -C 'raygauge run --resu'")
        self.assertTrue(offered.startswith("--resume\tContinue a run"), msg=offered)

    def check_names(self, library, own, least):
        path = self.root / "usr/lib" / library
        self.assertNotIn("not found", run("ldd", path))
        self.assertIn(library, run("objdump", "-p", path))
        names = [line.split(maxsplit=2)[2] for line in run("nm", "--dynamic", "--defined-only", "--demangle", path).splitlines()]
        self.assertGreater(len(names), least)
        self.assertEqual([name for name in names if not re.match(own, name)], [])

    def test_4_the_shared_libraries_show_their_own_names_alone(self):
        of_type = "(?:vtable|typeinfo|typeinfo name|guard variable) for "
        self.check_names("libraygauge.so.0.2", rf"(?:{of_type}|non-virtual thunk to )?raygauge::", 100)
        self.check_names("libraygauge_results.so.0.2", rf"raygauge::ResultsWriter::|{of_type}raygauge::", 5)
        if "libraygauge-friction" in self.packages:
            self.check_names("libraygauge_friction.so.0.2", rf"raygauge::siconos_friction\(\)|{of_type}raygauge::", 0)

    def test_5_a_program_is_compiled_and_linked_against_the_packages(self):
        source = pathlib.Path(__file__).parent / "example" / "quickstart.cc"
        program = pathlib.Path(self.scratch.name, "quickstart")
        include = self.root / "usr/include"
        run(COMPILER, "-std=c++20", f"-I{include}",
            f"-I{include}/raygauge", "-I/usr/include/eigen3", source, "-o", program, f"-L{self.root / 'usr/lib'}", "-lraygauge", "-lqhullcpp", "-lqhull_r")
        self.assertIn("libraygauge.so.0.2", run("ldd", program, env=self.environment()))
        self.assertIn("distance 2,", run(program, env=self.environment()))

    def test_6_the_python_package_answers(self):
        if "python3-raygauge" not in self.packages:  # a build without Python makes none
            self.assertFalse((BUILD / "python/raygauge").exists())
            return
        text = run("/usr/bin/python3", "-c", "import raygauge as rg; print(rg.__file__, rg.distance([[2, 0]], rg.Ball([0, 0])))",
                   env=self.environment())
        self.assertIn(str(self.root), text)
        self.assertIn("optimal", text)

    def test_7_the_python_package_names_the_libraries_of_its_modules(self):
        if "python3-raygauge" not in self.packages:
            return
        depends = field(self.packages["python3-raygauge"], "Depends")
        modules = sorted((self.root / "usr/lib/python3/dist-packages/raygauge").glob("_*.so"))
        for module in modules:
            self.assertNotIn("not found", run("ldd", module))
            needed = re.findall(r"NEEDED +(\S+)", run("objdump", "-p", module))
            for library in needed:
                # One of the packages that have the library: libc6-i386 has a libm.so.6, too.
                owners = {line.split(":")[0] for line in run("dpkg", "--search", f"*/{library}").splitlines()}
                named = [owner for owner in owners if re.search(rf"(^|[ ,|]){re.escape(owner)}(?![-\w.])", depends)]
                self.assertTrue(named, msg=f"{module.name}: {library} of {owners}, not in {depends}")
        if (BUILD / "python/raygauge/_sweeps.so").exists() or len(modules) > 1:
            for library in ("libtinyxml2", "libhdf5", "libglpk"):
                self.assertIn(library, depends)

    def test_8_a_sweep_with_a_method_in_python_runs_from_the_package(self):
        if not list((self.root / "usr/lib/python3/dist-packages/raygauge").glob("_sweeps*.so")):
            return
        code = ("import raygauge as rg\n"
                "@rg.method\n"
                "def mine(A, Q, tolerance): return rg.distance(A, Q, tolerance).distance\n"
                "r = rg.run({'sweep': {'n': [2], 'N': [9], 'repetitions': 2}, 'generator': [{'name': 'example2'}],\n"
                "            'method': [{'name': 'column_generation'}, {'name': 'mine'}]}, 'mine.h5')\n"
                "print(rg.__file__, r.sizes['record'], bool(r.agrees.all()))")
        text = run("/usr/bin/python3", "-c", code, env=self.environment(), cwd=self.scratch.name)
        self.assertIn(str(self.root), text)
        self.assertIn("4 True", text)

    def test_9_all_is_removed_without_a_trace(self):
        run("dpkg", f"--root={self.root}", "--force-depends", "--force-script-chrootless", "--purge", *self.packages)
        left = [path for path in self.root.rglob("*") if path.is_file() and "var/lib/dpkg" not in str(path)
                and "var/log" not in str(path)]
        self.assertEqual(left, [])


if __name__ == "__main__":
    unittest.main()
