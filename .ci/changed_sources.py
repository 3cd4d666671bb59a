#!/usr/bin/env python3
# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Prints the compiled sources that differ from a commit, and for each header that does the sources that include it.

A header that no source includes directly is read through the headers that include it. Sources of a folder that the compile
commands do not name (tests, bench) are left out.

    usage: changed_sources.py COMMIT COMPILE_COMMANDS
"""
import json
import os
import re
import subprocess
import sys

INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)


def git(*arguments):
    return subprocess.run(['git', *arguments], check=True, capture_output=True, text=True).stdout.splitlines()


def included(path):
    """The project's files that a file includes; a public header is named as its users name it."""
    with open(path, encoding='utf-8') as file:
        names = INCLUDE.findall(file.read())
    return {f'include/{name}' if name.startswith('raygauge/') else name for name in names}


def includers(header, includes):
    """The sources nearest to a header in the graph of includes."""
    seen, level = {header}, [header]
    while level:
        level = [path for path, names in includes.items() if path not in seen and not names.isdisjoint(level)]
        seen.update(level)
        sources = [path for path in level if path.endswith('.cc')]
        if sources:
            return sources
    return []


def main():
    commit, commands = sys.argv[1:]
    with open(commands, encoding='utf-8') as file:
        compiled = {os.path.relpath(entry['file']) for entry in json.load(file)}
    compiled &= set(git('ls-files', '*.cc'))
    includes = {path: included(path) for path in git('ls-files', '*.cc', '*.h') if os.path.exists(path)}
    includes = {path: names for path, names in includes.items() if path in compiled or path.endswith('.h')}
    changed = set(git('diff', '--name-only', '--diff-filter=d', commit, '--', '*.cc', '*.h'))
    chosen = changed & compiled
    for header in sorted(changed & set(includes) - compiled):
        sources = includers(header, includes)
        if not chosen.intersection(sources):  # one reader of a header is enough to read it
            chosen.update(sorted(sources)[:1])
    print('\n'.join(sorted(chosen)))


if __name__ == '__main__':
    main()
