// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/scene/continuous.h"
#include "raygauge/scene/scene_run.h"

namespace raygauge {

/// A row about a query and a pair of bodies; at instant k, if that is not negative.
SceneRecord begin_row(const Scene& scene, int query, BodyPair pair, std::int64_t k = -1);

/// What an answer says of whether two bodies are apart.
SceneStatus status_of(const PairAnswer& answer);

/// Puts a part of an answer into a row.
void take_distance(const PairAnswer& answer, SceneRecord& row);
void take_points(const PairAnswer& answer, SceneRecord& row);
void take_growth(const PairAnswer& growth, SceneRecord& row);
void take_depth(const PairAnswer& answer, SceneRecord& row);

/// The distance, and of depth, points and gradient what the query asks for.
void take_asked(const PairAnswer& answer, SceneEffects effects, SceneRecord& row);

}  // namespace raygauge
