// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

// The public interface of the library raygauge::sweep: experiments, run over many instances by many methods.
#if __cplusplus < 201709L && (!defined(_MSVC_LANG) || _MSVC_LANG < 202002L)
#error "raygauge needs C++20: compile with -std=c++20"
#else
#include "raygauge/sweep/experiment.h"
#include "raygauge/sweep/instance.h"
#include "raygauge/sweep/method.h"
#include "raygauge/sweep/record.h"
#include "raygauge/sweep/registry.h"
#include "raygauge/sweep/sweep.h"
#endif
