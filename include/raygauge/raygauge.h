// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

// The whole public interface of the library: sets, what is asked of them, and scenes. Sweeps:
// raygauge/sweep.h. C programs get the C interface.
#if !defined(__cplusplus)
#include "raygauge/raygauge_c.h"
#elif __cplusplus < 201709L && (!defined(_MSVC_LANG) || _MSVC_LANG < 202002L)
#error "raygauge needs C++20: compile with -std=c++20"
#else
#include "raygauge/exceptions.h"
#include "raygauge/meshes/mesh.h"
#include "raygauge/methods/options.h"
#include "raygauge/methods/result.h"
#include "raygauge/queries/gradient.h"
#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/membership.h"
#include "raygauge/queries/mesh_distance.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/queries/pair_batch.h"
#include "raygauge/queries/solver.h"
#include "raygauge/scene/continuous.h"
#include "raygauge/scene/edge_checker.h"
#include "raygauge/scene/motion.h"
#include "raygauge/scene/scene_run.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/convex_set.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/grasp_wrenches.h"
#include "raygauge/sets/half_space.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/p_norm_ball.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/polytopes.h"
#include "raygauge/sets/pose.h"
#include "raygauge/sets/prepared_set.h"
#include "raygauge/sets/truncated_cone.h"
#endif
