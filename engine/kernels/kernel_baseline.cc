// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#define RAYGAUGE_ISA baseline
#define RAYGAUGE_WIDTH 2
#include "engine/kernels/kernel_impl.h"
