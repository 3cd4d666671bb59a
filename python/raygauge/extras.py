# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""What the package can use and does not need: NumPy alone is enough for distances and scenes."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator


@contextlib.contextmanager
def extra(name: str) -> Iterator[None]:
    """Around imports that need an extra of the package: one that is missing is named, with what installs it."""
    try:
        yield
    except ModuleNotFoundError as error:
        missing = error.name or "a module"
        raise ModuleNotFoundError(
            f"{missing} is not installed: pip install 'raygauge[{name}]', or apt-get install python3-{missing}", name=error.name
        ) from None
