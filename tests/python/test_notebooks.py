# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Each notebook runs from top to bottom, its assertions included, and draws a picture."""
import os
import pathlib
import sys
import tempfile
import unittest

import nbformat
from nbclient import NotebookClient

NOTEBOOKS = pathlib.Path(os.environ["RAYGAUGE_SOURCE"], "python", "notebooks")


class Notebooks(unittest.TestCase):
    def test_each_runs_from_top_to_bottom(self):
        os.environ["MPLBACKEND"] = "module://matplotlib_inline.backend_inline"
        pages = sorted(NOTEBOOKS.glob("*.ipynb"))
        self.assertGreaterEqual(len(pages), 5)
        for page in pages:
            notebook = nbformat.read(page, as_version=4)
            for cell in notebook.cells:  # they are kept without outputs
                self.assertEqual(cell.get("outputs", []), [], msg=page.name)
            with tempfile.TemporaryDirectory() as folder:
                NotebookClient(notebook, timeout=120, kernel_name="python3").execute(cwd=folder)
            outputs = [output for cell in notebook.cells for output in cell.get("outputs", [])]
            self.assertTrue(any("image/png" in output.get("data", {}) for output in outputs), msg=page.name)


if __name__ == "__main__":
    sys.exit(unittest.main())
