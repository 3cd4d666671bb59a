# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""The Python code of docs/python.md, run from top to bottom."""
import os
import pathlib
import re
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["RAYGAUGE_SOURCE"])


class Tutorial(unittest.TestCase):
    def test_every_block_runs(self):
        page = (SOURCE / "docs" / "python.md").read_text(encoding="utf-8")
        blocks = re.findall(r"(?ms)^```python\n(.*?)^```$", page)
        self.assertGreaterEqual(len(blocks), 8)
        names = {}
        before = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            self.addCleanup(os.chdir, before)
            os.symlink(SOURCE / "experiments", "experiments")
            for block in blocks:
                exec(compile(block, "docs/python.md", "exec"), names)
            self.assertGreater(os.path.getsize("time.svg"), 1000)
            os.chdir(before)


if __name__ == "__main__":
    unittest.main()
