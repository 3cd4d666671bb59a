# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Names that mean something in another language, through every output: of a results file made by hand and of experiment
and scene files. No command may run, and what is read back is the name, or its printable form.

    hostile_names.py --raygauge PROGRAM
"""
import argparse
import csv
import html.parser
import io
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

import h5py
import numpy

NAMES = {
    "every control character": bytes(range(1, 32)) + b"\x7f",
    "line feeds": b"q\n!touch pwned\n#",
    "commands of a shell": b"`touch pwned`$(touch pwned); touch pwned",
    "quotes": b"\"' . system(\"touch pwned\") . '\\\"\\",
    "a script": b"</script><!--<script>alert(1)</script>-->",
    "marks": b"a|b*c_d<i>&amp;&lt;%d%s[2pt]@x{y}^z~#$$![x](y)",
    "marks at the front": b"[9cm]*|",
    "marks of the templates": b"{{script}}{{data}}/*DATA*//*SCRIPT*/<!--TITLE-->",
    "bytes that are not UTF-8": b"a\xff\xfe\xc3b\xed\xa0\x80",
    "characters that are not seen": "a\u202eb\u0085c\u2028d\ufffe".encode(),
    "a formula": b"=1+1,\"x\"",
}
UNSEEN = re.compile("[\u0080-\u009f\u2028-\u202e\u2066-\u2069\ufffe\uffff]")
SCENE = """
[time]
to = 1
instants = 3
[[body]]
name = "a"
shape = { shape = "ball", center = [0, 0, 0], radius = 1 }
motion = { velocity = [1, 0, 0] }
[[body]]
name = "b"
shape = { shape = "ball", center = [4, 0, 0], radius = 1 }
[[query]]
name = "q"
effects = ["distance", "time_of_impact", "clearance"]
"""
EXPERIMENT = """
name = "e"
[sweep]
n = [3, 4]
N = [20, 50]
tolerance = 1e-6
repetitions = 2
[[generator]]
name = "example2"
[[method]]
name = "column_generation"
[[method]]
name = "glpk_dual"
[run]
min_seconds = 0
"""


def decoded(name):
    """As JSON has it: what is not UTF-8 is replaced."""
    return name.decode(errors="replace")


def printable(name):
    text = UNSEEN.sub("\ufffd", decoded(name))
    return "".join(chr(0x2400 + ord(c)) if ord(c) < 32 else "\u2421" if c == "\x7f" else c for c in text)


def squeezed(text):
    """Without the replacements, of which programs make one or several for a broken character."""
    return text.replace("\ufffd", "")


def rename(path, table, column, new_name):
    """Puts other texts in the place of a column's, as a stranger's program may."""
    with h5py.File(path, "r+") as file:
        group = file[table]
        texts = [new_name(text) for text in group[column][:]]
        attributes = dict(group[column].attrs)
        del group[column]
        kind = h5py.string_dtype("utf-8", max(map(len, texts)))
        group.create_dataset(column, data=numpy.array(texts, dtype=kind))
        group[column].attrs.update(attributes)


class Page(html.parser.HTMLParser):
    """The scripts of a page."""

    def __init__(self, text):
        super().__init__()
        self.scripts = []
        self.inside = False
        self.data = None
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        if tag == "script":
            self.scripts.append("")
            self.inside = True
            if dict(attrs).get("id") == "data":
                self.data = len(self.scripts) - 1

    def handle_endtag(self, tag):
        self.inside = self.inside and tag != "script"

    def handle_data(self, data):
        if self.inside:
            self.scripts[-1] += data


class HostileNames(unittest.TestCase):
    raygauge = None
    pictures = 0

    @classmethod
    def setUpClass(cls):
        cls.base = pathlib.Path(tempfile.mkdtemp(prefix="raygauge-names-"))
        cls.addClassCleanup(shutil.rmtree, cls.base, ignore_errors=True)
        (cls.base / "scene.toml").write_text(SCENE)
        (cls.base / "e.toml").write_text(EXPERIMENT)
        for words in (["scene", "run", "scene.toml", "-o", "scene.h5"], ["run", "e.toml", "-o", "e.h5"]):
            subprocess.run([cls.raygauge, *words, "-q"], cwd=cls.base, check=True)

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(dir=self.base))

    def run_raygauge(self, *words, statuses=(0,)):
        done = subprocess.run([self.raygauge, *words], cwd=self.folder, capture_output=True, check=False)
        self.assertIn(done.returncode, statuses, (words, done.stderr))
        self.assertFalse(list(self.folder.rglob("*pwned*")), f"a command has run: {words}")
        self.assertNotRegex(done.stderr.decode(), "[\x00-\x09\x0b-\x1f\x7f]")
        return done.stdout

    def text(self, *words, statuses=(0,)):
        """What is printed, which no name may break: UTF-8 without control characters."""
        out = self.run_raygauge(*words, statuses=statuses).decode()
        self.assertNotRegex(out, "[\x00-\x09\x0b-\x1f\x7f]")
        return out

    def picture(self, results, *words):
        kinds = ("svg",) if self.pictures else ("png", "pdf", "svg")
        self.pictures += 1
        for kind in kinds:
            self.run_raygauge("plot", results, *words, "-o", f"x.{kind}")
        return "".join(xml.etree.ElementTree.parse(self.folder / "x.svg").getroot().itertext())

    def page(self, results):
        self.run_raygauge("report", results, "-o", "x.html")
        page = Page((self.folder / "x.html").read_text())
        return json.loads(page.scripts[page.data]), len(page.scripts)

    def hostile_scene(self, name):
        shutil.copy(self.base / "scene.h5", self.folder / "s.h5")
        rename(self.folder / "s.h5", "bodies", "name", lambda old: old + name)
        rename(self.folder / "s.h5", "queries", "name", lambda old: old + name)
        return "s.h5"

    def test_of_bodies_and_queries(self):
        for what, name in NAMES.items():
            with self.subTest(what):
                results = self.hostile_scene(name)
                shown = printable(name)
                for words in (["table"], ["info"]):
                    self.assertIn(squeezed(shown).split('"')[0], squeezed(self.text(*words, results)))
                self.assertIn(squeezed(shown), squeezed(self.picture(results)))
                data, scripts = self.page(results)
                self.assertEqual(squeezed(data["bodies"][0]), squeezed("a" + decoded(name)))
                self.assertEqual(scripts, 3)
                info = json.loads(self.run_raygauge("info", results, "--json"))
                self.assertEqual(squeezed(info["queries"][0]["name"]), squeezed("q" + decoded(name)))
                self.run_raygauge("export", results, "--csv", "-")

    def hostile_results(self, name):
        shutil.copy(self.base / "e.h5", self.folder / "r.h5")
        for column in ("method", "method_name", "method_parameters", "generator", "generator_parameters", "host"):
            rename(self.folder / "r.h5", "records", column, lambda old: name + old)
        rename(self.folder / "r.h5", "provenance/machines", "cpu_model", lambda old: name + old)
        return "r.h5"

    def test_of_methods_and_generators(self):
        for what, name in NAMES.items():
            with self.subTest(what):
                results = self.hostile_results(name)
                shown = squeezed(printable(name))
                pivot = ["table", results, "--rows", "method", "--cols", "generator"]
                self.assertIn(shown, squeezed(self.text(*pivot)))
                self.text("table", results, "--accuracy")
                self.text("table", results, "--stability")
                self.assertIn(shown, squeezed(self.text("info", results)))
                info = json.loads(self.run_raygauge("info", results, "--json"))
                self.assertIn(squeezed(decoded(name) + "column_generation"), map(squeezed, info["methods"]))
                self.assertIn(shown, squeezed(self.picture(results, "--figure", "time_vs_N")))
                self.text("plot", results, "-o", ".")
                data, scripts = self.page(results)
                self.assertIn(squeezed(decoded(name) + "glpk_dual"), [squeezed(m["name"]) for m in data["methods"]])
                self.assertEqual(scripts, 3)
                shutil.copy(self.folder / results, self.folder / "again.h5")
                self.text("compare", results, "again.h5", "--all", statuses=(0, 1))
                json.loads(self.run_raygauge("compare", results, "again.h5", "--json", statuses=(0, 1)))

    def test_in_csv_are_read_back_byte_by_byte(self):
        for what, name in NAMES.items():
            with self.subTest(what):
                results = self.hostile_results(name)
                for words in (["export", results, "--csv", "-"], ["export", results, "--tidy", "--csv", "-"]):
                    rows = list(csv.DictReader(io.StringIO(self.run_raygauge(*words).decode(errors="surrogateescape"),
                                                           newline="")))
                    self.assertEqual({row["method"] for row in rows},
                                     {(name + method).decode(errors="surrogateescape")
                                      for method in (b"column_generation", b"glpk_dual")})

    def test_in_markdown_have_no_meaning(self):
        for what, name in NAMES.items():
            with self.subTest(what):
                table = self.text("table", self.hostile_results(name), "--rows", "method,generator", "--cols", "n",
                                  "--format", "markdown")
                bars = {len(re.findall(r"(?<!\\)(?:\\\\)*\|", line)) for line in table.splitlines() if line.startswith("|")}
                self.assertEqual(len(bars), 1, table)
                self.assertNotRegex(table.replace("<br>", ""), r"(?<!\\)(?:\\\\)*[<`]")

    def test_in_latex_are_set_as_they_are(self):
        tables = ""
        for name in NAMES.values():
            if name != NAMES["bytes that are not UTF-8"]:  # pdflatex has no glyph for U+FFFD in a note of ours
                tables += self.text("table", self.hostile_results(name), "--rows", "method,generator", "--cols", "n",
                                    "--format", "latex") + "\\clearpage\n"
        if shutil.which("pdflatex") is None:
            return
        document = "\\documentclass{article}\n\\begin{document}\n" + tables + "\\end{document}\n"
        (self.folder / "tables.tex").write_text(document)
        done = subprocess.run(["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "tables.tex"], cwd=self.folder,
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout[-2000:])
        self.assertFalse(list(self.folder.rglob("*pwned*")))

    def test_of_scene_and_experiment_files(self):
        for what, name in NAMES.items():
            try:
                text = json.dumps(name.decode(), ensure_ascii=False)
            except UnicodeDecodeError:
                continue  # TOML is UTF-8
            text = text.replace("\x7f", "\\u007f")
            with self.subTest(what):
                (self.folder / "s.toml").write_text(f"name = {text}" + SCENE.replace('"q"', text).replace('"a"', text))
                self.text("scene", "explain", "s.toml")
                json.loads(self.run_raygauge("scene", "explain", "s.toml", "--json"))
                self.text("scene", "run", "s.toml", "-o", "s.h5", "--force")
                self.assertIn(printable(name), self.picture("s.h5"))
                (self.folder / "e.toml").write_text(
                    EXPERIMENT.replace('"e"', '"e"\ndescription = ' + text).replace('name = "column_generation"',
                                                                                  f'name = "column_generation"\nlabel = {text}'))
                self.text("run", "e.toml", "--dry-run", statuses=(0, 2))
                self.text("run", "e.toml", "-o", "e.h5", "--force", statuses=(0, 2))

    def test_in_batch_scripts_are_one_word_or_refused(self):
        (self.folder / "e.toml").write_text(EXPERIMENT)
        for part in ("a b", "it's", "a#b", "100%j", "$(touch pwned)", "`touch pwned`", "; touch pwned"):
            script = self.text("submit", "e.toml", "--slurm", "--array", "2", "-o", f"{part}.h5", "--account", part,
                               "--print", "--", f"--comment={part}")
            (self.folder / "job.sh").write_text(script)
            subprocess.run(["bash", "-n", "job.sh"], cwd=self.folder, check=True)
            options = [line[len("#SBATCH "):] for line in script.splitlines() if line.startswith("#SBATCH ")]
            quoted = f'"--comment={part}"'
            self.assertIn(quoted if set(part) & set(" '#") else quoted.strip('"'), options)
        for part in ("a\nb", "a\"b", "a\\b", "a\tb"):
            done = self.run_raygauge("submit", "e.toml", "--slurm", "--array", "2", "--account", part, "--print",
                                     statuses=(2,))
            self.assertEqual(done, b"")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--raygauge", required=True)
    arguments, rest = parser.parse_known_args()
    HostileNames.raygauge = arguments.raygauge
    unittest.main(argv=[sys.argv[0], *rest])
