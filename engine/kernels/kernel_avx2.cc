// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#define RAYGAUGE_ISA avx2
#define RAYGAUGE_WIDTH 4
#include "engine/kernels/kernel_impl.h"
