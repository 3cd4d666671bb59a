// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

// The whole public interface of the library: sets, the distance between them, and sweeps over many of them.
#include "engine/distance/options.h"
#include "engine/distance/result.h"
#include "engine/distance/solver.h"
#include "engine/exceptions.h"
#include "engine/sets/convex_set.h"
#include "engine/sets/point_set.h"
#include "engine/sweep/experiment.h"
#include "engine/sweep/instance.h"
#include "engine/sweep/method.h"
#include "engine/sweep/record.h"
#include "engine/sweep/registry.h"
#include "engine/sweep/sweep.h"
