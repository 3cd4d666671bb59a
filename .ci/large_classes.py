#!/usr/bin/env python3
# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""Prints the classes with more than 25 member functions, a line each. Constructors, destructors and assignment do not count.

    usage: large_classes.py FILE...
"""
import re
import sys

MOST = 25
CLASS = re.compile(r'\b(?:class|struct)\s+([A-Za-z_]\w*)(?:\s+final)?\s*(?::(?!:)[^;{}]*)?\{')
FUNCTION = re.compile(r'([~A-Za-z_]\w*|operator\S+)\s*\(')
NO_FUNCTION = ('using', 'friend', 'enum', 'class', 'struct', 'static_assert')


def without_texts(source):
    source = re.sub(r'//[^\n]*|/\*.*?\*/', '', source, flags=re.DOTALL)
    return re.sub(r'"(\\.|[^"\\])*"', '""', source)


def body_of(source, begin):
    """What stands in the braces that are open at `begin`, without what is in braces there."""
    depth, body = 1, []
    for letter in source[begin:]:
        depth += (letter == '{') - (letter == '}')
        if depth == 0:
            break
        if depth == 1:
            body.append(';' if letter == '}' else letter)
    return ''.join(body)


def member_functions(name, body):
    for statement in re.split(r';|\b(?:public|private|protected):', body):
        statement = re.sub(r'template\s*<(?:[^<>]|<[^<>]*>)*>', '', statement).strip()
        for _ in range(3):  # arguments of templates
            statement = re.sub(r'<[^<>]*>', '', statement)
        found = FUNCTION.search(statement)
        if not found or statement.startswith(NO_FUNCTION) or '(*' in statement or '=' in statement[:found.start()]:
            continue
        if found[1].strip('~') != name and found[1] != 'operator=':
            yield found[1]


def main():
    for path in sys.argv[1:]:
        with open(path, encoding='utf-8') as file:
            source = without_texts(file.read())
        for found in CLASS.finditer(source):
            count = len(list(member_functions(found[1], body_of(source, found.end()))))
            if count > MOST:
                print(f'{path}: {found[1]} has {count} member functions')


if __name__ == '__main__':
    main()
