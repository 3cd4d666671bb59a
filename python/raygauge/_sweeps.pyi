# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
from .components import Component

def run(
    *,
    source: str,
    output: str,
    threads: int | None,
    resume: bool,
    force: bool,
    progress: bool,
    methods: list[Component],
    generators: list[Component],
    versions: list[tuple[str, str]],
    failures: list[BaseException],
) -> None: ...
