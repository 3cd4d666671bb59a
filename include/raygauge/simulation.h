// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

// The public interface of the library raygauge::simulation: bodies that fall, hit, slide and rest. Friction
// needs a solver: that of raygauge::friction, or one of your own.
#if __cplusplus < 201709L && (!defined(_MSVC_LANG) || _MSVC_LANG < 202002L)
#error "raygauge needs C++20: compile with -std=c++20"
#else
#include "raygauge/scene/dynamics.h"
#include "raygauge/scene/friction.h"
#include "raygauge/scene/simulation.h"
#endif
