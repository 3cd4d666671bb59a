// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "scene/file/scene_file.h"

namespace raygauge::scene_page {

/// One HTML page that shows what a scene's results hold, and needs no network: the bodies as they move, the
/// events, a timeline for each query, and how the answers came about.
std::string make_page(const SceneFile& file);

/// Compiled in by cmake/EmbedTexts.cmake.
std::string page_template();
std::string page_style();
std::string page_script();
std::string three_library();

}  // namespace raygauge::scene_page
