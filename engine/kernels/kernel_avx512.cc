// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#define RAYGAUGE_ISA avx512
#define RAYGAUGE_WIDTH 8
#include "engine/kernels/kernel_impl.h"
