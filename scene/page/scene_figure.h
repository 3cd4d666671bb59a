// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/render/figures/figure.h"
#include "scene/file/scene_file.h"

namespace raygauge {

/// The picture of a scene's answers: a panel for each query that asks for distances (or growth) at instants,
/// in it a curve over time for each of the pairs that come nearest, with its certified band, and a line at
/// each proven contact and at each query's least clearance. A scene of one instant has one panel with a mark
/// for each query. Throws FigureNeedsError where no query has such answers.
Drawing draw_scene(const SceneFile& file, FigureSize size);

}  // namespace raygauge
