# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Lists the sentences of more than 35 words in pages (.md) and in the comments of headers (.h).

    long_sentences.py FILE ...     prints FILE:LINE: WORDS words: the beginning of the sentence

Code and a list of names in code count as one word, symbols of formulas as none. A cell of a table and an item of a list are sentences of their own.
"""
import pathlib
import re
import sys

LONGEST = 35
CODE = re.compile(r"`+[^`]*`+|\$[^$]*\$")
NAMES = re.compile(r"(?:code[,;]?\s+(?:and |or )?)+code")
LINK = re.compile(r"!?\[([^\]]*)\]\([^)]*\)")
END = re.compile(r"[.!?](?=[)\"'*”]*(\s|$))")
ITEM = re.compile(r"^\s*([-*]|\d+\.)\s+")


def paragraphs_of_page(text):
    """(line number, paragraph) of running text; code blocks are left out."""
    first, lines, fenced = 0, [], False
    for number, line in enumerate(text.splitlines() + [""], start=1):
        if line.lstrip().startswith("```"):
            fenced = not fenced
            line = ""
        elif fenced or (line.startswith("    ") and not lines):
            line = ""
        starts = line.startswith(("#", "|", "!")) or ITEM.match(line)
        if (starts or not line.strip()) and lines:
            yield first, " ".join(lines)
            lines = []
        if line.startswith("#"):
            yield number, line
        elif line.startswith("|"):
            yield from ((number, cell) for cell in re.split(r"(?<!\\)\|", line))
        elif line.strip():
            first = number if not lines else first
            lines.append(ITEM.sub("", line).strip())


def paragraphs_of_header(text):
    """(line number, paragraph) of the comments; lines of formulas are one word each."""
    first, lines = 0, []
    for number, line in enumerate(text.splitlines() + [""], start=1):
        comment = re.search(r"(?:^|\s)//[/!]?<?( .*|)$", line)
        alone = comment and line.lstrip().startswith("//")
        words = comment.group(1) if comment else ""
        if words.startswith("     "):
            words = " formula"
        if lines and (not alone or not words.strip() or ITEM.match(words)):
            yield first, " ".join(lines)
            lines = []
        if words.strip() and alone:
            first = number if not lines else first
            lines.append(words.strip())
        elif words.strip():
            yield number, words.strip()


def sentences(paragraph):
    """The sentences of a paragraph, with code and links as one word."""
    plain = NAMES.sub("code", LINK.sub(r"\1", CODE.sub("code", paragraph)))
    begin = 0
    for match in END.finditer(plain):
        yield plain[begin:match.end()]
        begin = match.end()
    yield plain[begin:]


def long_sentences(path):
    text = path.read_text(encoding="utf-8")
    paragraphs = paragraphs_of_page if path.suffix == ".md" else paragraphs_of_header
    for line, paragraph in paragraphs(text):
        for sentence in sentences(paragraph):
            words = [word for word in sentence.split() if re.search(r"[^\W\d_]{2}|^[aA]$", word)]
            if len(words) > LONGEST:
                yield f"{path}:{line}: {len(words)} words: {' '.join(words[:10])} …"


if __name__ == "__main__":
    for name in sys.argv[1:]:
        for line in long_sentences(pathlib.Path(name)):
            print(line)
