# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Runs every raygauge command that a page of the documentation shows, in the order of the page, in one folder.

    run_documented_commands.py PAGE.md ...       what the page shows (docs/contributing.md has the rules)
    run_documented_commands.py --help-texts ...  the examples at the end of `raygauge COMMAND --help`

Each command must end with status 0, or with one that its comment names: `raygauge … # exit status 0 or 1`. What the page
shows of its output must be what it prints; `…` stands for anything within a line, a line of it for any lines.
"""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

RAYGAUGE = re.compile(r"(^|[|;&(]\s*)raygauge\s")
EXPECTED_STATUS = re.compile(r"#.*exit status (\d+)(?:,? or (\d+))?")
READS_RESULTS = re.compile(r"\braygauge (table|plot|export|info|report|compare)\b|END_OF_PYTHON")
RESULTS_FILE = re.compile(r"[\w./-]+\.h5(?![\w.:/])")


def code_blocks(page):
    """(kind, lines) of each code block: kind is the word after the fence, or "indented"."""
    kind, lines, fenced = None, [], False
    for line in page.splitlines() + [""]:
        fence = re.match(r"\s*```(\w*)", line)
        if fenced:
            if fence:
                yield kind, lines
                kind, lines, fenced = None, [], False
            else:
                lines.append(line)
        elif fence:
            if kind:
                yield kind, lines
            kind, lines, fenced = fence.group(1) or "text", [], True
        elif line.startswith("    "):
            kind = "indented"
            lines.append(line[4:])
        elif kind:
            yield kind, lines
            kind, lines = None, []


def joined(lines):
    """Lines that end in a backslash, with the next one."""
    return re.sub(r"\\\n\s*", "", "\n".join(lines)).splitlines()


class Command:
    """What to run in a shell, and what the page says that it prints (None where it says nothing)."""

    def __init__(self, text, output=None):
        self.text = text
        self.output = output


def session_of(lines):
    """The commands of a console block with the lines below each."""
    commands = []
    for line in joined(lines):
        if line.startswith("$ "):
            commands.append(Command(line[2:], []))
        elif commands:
            commands[-1].output.append(line)
    return commands


def commands_of(page):
    """What to run, in the order of the page."""
    last = None
    for kind, lines in code_blocks(page):
        shown, last = last, None
        if kind == "sh" and any(RAYGAUGE.search(line) for line in lines):
            last = Command("\n".join(lines))
            yield last
        elif kind == "python" and "import raygauge" not in page:  # tests/python runs those
            last = Command(f"{sys.executable} - <<'END_OF_PYTHON'\n" + "\n".join(lines) + "\nEND_OF_PYTHON")
            yield last
        elif kind == "text" and shown is not None:
            shown.output = lines
        elif kind == "console":
            session = session_of(lines)
            yield from (session if any(RAYGAUGE.search(each.text) for each in session) else [])
        elif kind == "indented":
            yield from (Command(line) for line in joined(lines) if line.startswith("raygauge "))


def is_shown(shown, printed):
    """Whether the lines `shown` stand for the text `printed`."""
    pattern = ""
    for line in shown:
        if line.strip() == "…":
            pattern += r"(?:.*\n)*"
        else:
            pattern += ".*".join(re.escape(part) for part in line.rstrip().split("…")) + r"[ ]*\n"
    return re.fullmatch(pattern, printed if printed.endswith("\n") or not printed else printed + "\n") is not None


def examples_of(help_text):
    """The lines below "Examples:" in a help text."""
    _, _, after = help_text.partition("Examples:\n")
    for line in after.split("\n\n")[0].splitlines():
        if RAYGAUGE.search(line):
            yield line.strip()


def shortened(experiment):
    """The experiment with two values of n and of N and one repetition: the same commands, done in a second."""

    def first_two(match):
        numbers = re.findall(r"\d+", match.group(2))[:2]
        return f"{match.group(1)} = [{', '.join(numbers)}]"

    text = re.sub(r"^(n|N)\s*=\s*(.*)$", first_two, experiment, flags=re.MULTILINE)
    return re.sub(r"^repetitions\s*=.*$", "repetitions = 1", text, flags=re.MULTILINE)


class Folder:
    """Where commands run: with the files that pages speak of, and raygauge first on PATH."""

    def __init__(self, path, source, raygauge):
        self.path = path
        self.environment = dict(os.environ, PATH=f"{raygauge.parent}{os.pathsep}{os.environ['PATH']}", NO_COLOR="1")
        shutil.copytree(source / "tests/cli/documented", path, dirs_exist_ok=True)
        shutil.copytree(source / "docs/examples", path, dirs_exist_ok=True)
        shutil.copytree(source / "experiments/scenes", path / "experiments/scenes")
        (path / "out").mkdir()
        for experiment in (source / "experiments").glob("*.toml"):
            (path / "experiments" / experiment.name).write_text(shortened(experiment.read_text()))
        self.write_datasets()

    def write_datasets(self):
        import h5py  # pylint: disable=import-outside-toplevel
        import numpy  # pylint: disable=import-outside-toplevel

        with h5py.File(self.path / "points.h5", "w") as file:
            file["A"] = numpy.loadtxt(self.path / "A.csv", delimiter=",")
            file["Q"] = numpy.loadtxt(self.path / "Q.csv")

    def shell(self, command):
        return subprocess.run(
            ["bash", "-euo", "pipefail", "-c", command],
            cwd=self.path,
            env=self.environment,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            check=False,
        )

    def provide_results(self, command):
        """Makes each results file that the command reads and that is not there, NAME.h5 from the shortened
        experiment NAME, or else from Example 2."""
        if not READS_RESULTS.search(command):
            return
        for name in RESULTS_FILE.findall(command):
            if not (self.path / name).exists():
                (self.path / name).parent.mkdir(parents=True, exist_ok=True)
                experiment = f"experiments/{pathlib.Path(name).stem}.toml"
                if not (self.path / experiment).exists():
                    experiment = "experiments/example2.toml"
                made = self.shell(f"raygauge run {experiment} --quiet -o {name}")
                if made.returncode != 0:
                    sys.exit(f"cannot make {name}:\n{made.stdout}")

    def failure(self, command):
        """What went wrong with the command; "" if nothing did."""
        self.provide_results(command.text)
        expected = EXPECTED_STATUS.search(command.text)
        statuses = [int(each) for each in expected.groups() if each] if expected else [0]
        outcome = self.shell(command.text)
        if outcome.returncode not in statuses:
            return f"exit status {outcome.returncode}, expected {statuses}:\n$ {command.text}\n{outcome.stdout}\n"
        if command.output is not None and not is_shown(command.output, outcome.stdout):
            shown = "\n".join(command.output)
            return f"another output than the page shows:\n$ {command.text}\n{outcome.stdout}\nshown:\n{shown}\n"
        return ""


def help_texts(raygauge):
    def run_help(*words):
        return subprocess.run([raygauge, *words, "--help"], stdout=subprocess.PIPE, text=True, check=True).stdout

    listed = run_help().partition("Subcommands:\n")[2].split("\n\n")[0]
    for command in re.findall(r"^  (\w+)", listed, flags=re.MULTILINE):
        yield run_help(command)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("page", nargs="?", type=pathlib.Path)
    parser.add_argument("--help-texts", action="store_true")
    parser.add_argument("--raygauge", type=pathlib.Path, required=True)
    parser.add_argument("--source", type=pathlib.Path, required=True)
    arguments = parser.parse_args()
    if arguments.help_texts:
        commands = [Command(line) for text in help_texts(arguments.raygauge) for line in examples_of(text)]
    else:
        commands = list(commands_of(arguments.page.read_text()))
    with tempfile.TemporaryDirectory(prefix="raygauge-docs-") as path:
        folder = Folder(pathlib.Path(path), arguments.source, arguments.raygauge.resolve())
        failures = [failure for failure in map(folder.failure, commands) if failure]
    print(*failures, f"{len(commands)} commands, {len(failures)} failed", sep="\n")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
