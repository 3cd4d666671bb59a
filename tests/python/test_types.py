# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""mypy --strict passes over the package and over an example of its use."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["RAYGAUGE_SOURCE"])
# No Debian package has type information of these.
UNTYPED = ("h5py", "pandas", "matplotlib", "scipy")


def checked(folder, targets):
    settings = pathlib.Path(folder, "mypy.ini")
    sections = [f"[mypy-{name}.*]\nignore_missing_imports = True\n" for name in UNTYPED]
    settings.write_text("[mypy]\nstrict = True\nwarn_return_any = False\n" + "".join(sections), encoding="utf-8")
    command = [sys.executable, "-m", "mypy", "--config-file", str(settings), "--cache-dir", str(folder), *targets]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True,
                          env={**os.environ, "MYPYPATH": str(SOURCE / "python")})


class Types(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self.scratch.cleanup)

    def test_package_and_examples_are_strictly_typed_and_a_mistake_is_found(self):
        examples = sorted(str(path) for path in (SOURCE / "python" / "examples").glob("*.py"))
        self.assertTrue(examples)
        for targets in (["-p", "raygauge"], *([example] for example in examples)):
            result = checked(self.scratch.name, targets)
            self.assertEqual(result.returncode, 0, msg=result.stdout + result.stderr)
        wrong = pathlib.Path(self.scratch.name, "wrong.py")
        wrong.write_text('import raygauge as rg\nrg.distance([[1.0]], rg.Ball([0.0]), method="simplex")\n',
                         encoding="utf-8")
        result = checked(self.scratch.name, [str(wrong)])
        self.assertEqual(result.returncode, 1, msg=result.stdout)
        self.assertIn("arg-type", result.stdout)


if __name__ == "__main__":
    unittest.main()
