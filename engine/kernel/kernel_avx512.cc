// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#define RAYGAUGE_ISA avx512
#define RAYGAUGE_WIDTH 8
#include "engine/kernel/kernel_impl.h"
