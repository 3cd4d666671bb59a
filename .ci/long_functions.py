#!/usr/bin/env python3
# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Prints the functions of C++ sources whose bodies have more than 40 lines: file, line, length, first line.

It relies on clang-format's layout. A function starts at column 0 (a member inside its class at column 2), its body
opens at the end of that line or of one of the indented lines after it, and closes with a brace in the column of the start.

    usage: long_functions.py FILE...
"""
import re
import sys

LIMIT = 40
# What opens a brace at the start's column without being a function.
OTHER = re.compile(r'(namespace|extern|class|struct|union|enum|template .*\b(class|struct|union)\b|public|private'
                   r'|protected|#|//|\})')
TYPE = re.compile(r'(template .*)?\b(class|struct|union)\b[^()]*\{$')
DATA = re.compile(r'(=|\breturn\b)[^()]*\{$')  # an initialiser


def functions(lines, indent, first, last):
    """Yields (line, length) of the functions that start in the column `indent` of lines[first:last]."""
    start = opened = None
    for i in range(first, last):
        text = lines[i]
        column = len(text) - len(text.lstrip())
        if not text or column < indent:
            continue
        if column == indent and text[indent] == '}':
            if opened is not None and not text.startswith('};', indent):
                yield start, i - opened - 1
            start = opened = None
        elif opened is None:
            if column == indent:
                start = None if OTHER.match(text, indent) or text.endswith(';') else i
            if start is not None and text.endswith('{'):
                opened = i
            elif text.endswith((';', '}')):
                start = None


def members(lines):
    """Yields the functions inside the classes that start at column 0."""
    opened = None
    for i, text in enumerate(lines):
        if TYPE.match(text):
            opened = i
        elif opened is not None and text.startswith('}'):
            yield from functions(lines, 2, opened + 1, i)
            opened = None


def main():
    for name in sys.argv[1:]:
        with open(name, encoding='utf-8') as file:
            lines = file.read().splitlines()
        found = list(functions(lines, 0, 0, len(lines))) + list(members(lines))
        for start, length in sorted(found):
            if length > LIMIT:
                print(f'{name}:{start + 1}: {length} lines: {lines[start].strip()}')


if __name__ == '__main__':
    main()
