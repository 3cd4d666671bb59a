# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Each notebook runs from top to bottom, its assertions included, draws a picture, and prints what is stored in it.

    test_notebooks.py --store     runs the notebooks and stores their outputs, after a change
"""
import os
import pathlib
import re
import sys
import tempfile
import unittest

import nbformat
from nbclient import NotebookClient

NOTEBOOKS = pathlib.Path(os.environ["RAYGAUGE_SOURCE"], "python", "notebooks")
os.environ["MPLBACKEND"] = "module://matplotlib_inline.backend_inline"


def executed(page):
    """The notebook after a run in a folder of its own, by the interpreter that runs this test."""
    notebook = nbformat.read(page, as_version=4)
    for cell in notebook.cells:
        if cell.cell_type == "code":
            cell.outputs, cell.execution_count = [], None
    with tempfile.TemporaryDirectory() as folder:
        NotebookClient(notebook, timeout=120, kernel_name="python3").execute(cwd=folder)
    return notebook


def shown(cell):
    """The kinds of a cell's outputs, and its texts with every number as #: times and the order of ties vary."""
    kinds, text = [], ""
    for output in cell.get("outputs", []):
        kinds += sorted(output.get("data", {})) or [output.get("name")]
        plain = output.get("data", {}).get("text/plain", "")
        text += output.get("text", "") + ("" if "image/png" in output.get("data", {}) else plain)
    return kinds, re.sub(r"[ #]+", "#", re.sub(r"-?\d[\d.]*(e[+-]?\d+)?|inf|nan", "#", text))


def store(page):
    notebook = executed(page)
    for number, cell in enumerate(c for c in notebook.cells if c.cell_type == "code"):
        cell.execution_count = number + 1
        cell.metadata = {}
        for output in cell.outputs:
            if "execution_count" in output:
                output["execution_count"] = number + 1
    notebook.metadata = {
        "kernelspec": {"display_name": "Python (raygauge)", "language": "python", "name": "raygauge"},
        "language_info": {"name": "python"},
    }
    nbformat.write(notebook, page)


class Notebooks(unittest.TestCase):
    def test_each_runs_from_top_to_bottom_and_shows_what_is_stored(self):
        pages = sorted(NOTEBOOKS.glob("*.ipynb"))
        self.assertGreaterEqual(len(pages), 5)
        for page in pages:
            stored, notebook = nbformat.read(page, as_version=4), executed(page)
            self.assertEqual(stored.metadata.kernelspec.name, "raygauge", msg=page.name)
            outputs = [output for cell in stored.cells for output in cell.get("outputs", [])]
            self.assertTrue(any("image/png" in output.get("data", {}) for output in outputs), msg=page.name)
            self.assertLess(page.stat().st_size, 500_000, msg=page.name)
            for before, now in zip(stored.cells, notebook.cells, strict=True):
                self.assertEqual(shown(before), shown(now), msg=f"{page.name}: {before.source[:60]}")


if __name__ == "__main__":
    if sys.argv[1:] == ["--store"]:
        for path in sorted(NOTEBOOKS.glob("*.ipynb")):
            store(path)
    else:
        unittest.main()
