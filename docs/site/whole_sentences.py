# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Doxygen's input filter: whole_sentences.py FILE.h prints the header with whole first sentences.

Doxygen takes the first paragraph as the short description. Where a formula of its own lines follows and the sentence goes on,
the formula becomes part of the paragraph.
"""

import pathlib
import re
import sys

# "/// … gives" / "///" / "///     formula" / "///" / "/// rest": the sentence before the formula has no full stop.
FORMULA = re.compile(
    r"(?m)^(?P<before>[ ]*/// (?! {4}).*[^.\s])\n[ ]*///\n(?P<formula>(?:[ ]*/// {5}.*\n)+)(?:[ ]*///\n(?=[ ]*/// \S))?")


def joined(match):
    lines = [line.strip().removeprefix("///").strip() for line in match["formula"].splitlines()]
    indent = match["before"][: len(match["before"]) - len(match["before"].lstrip())]
    # The full stop stands outside: Doxygen ends the short description at it.
    spans = [f"``{line[:-1]}``." if line.endswith(".") else f"``{line}``" for line in lines if line]
    return match["before"] + "\n" + "".join(f"{indent}/// {span}\n" for span in spans)


def whole(text):
    return FORMULA.sub(joined, text)


if __name__ == "__main__":
    sys.stdout.reconfigure(encoding="utf-8")
    sys.stdout.write(whole(pathlib.Path(sys.argv[1]).read_text(encoding="utf-8")))
