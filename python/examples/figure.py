# Copyright (c) 2026 The raygauge authors
# SPDX-License-Identifier: MIT
"""From a results file to a figure: figure.py out/example2.h5 time.svg"""

import sys

import raygauge as rg

results = rg.open(sys.argv[1])
axes = rg.plot.time(results, by="N")
axes.figure.savefig(sys.argv[2])
