// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// A scene in TOML, which may name the robot crew.urdf: what is accepted has bodies and instants.
#include <string>

#include "scene/input/scene_source.h"
#include "tests/fuzz/crew_file.h"
#include "tests/fuzz/harness.h"
#include "tests/fuzz/scratch_file.h"

namespace raygauge::fuzz {

void check_scene_file(std::string_view input) {
  static const ScratchFile file(".scene.toml");
  static const CrewFile crew;
  const std::string text = crew.named_in(input);
  file.write(text);
  expect_success_or_error([&] {
    const cli::SceneSource source = cli::read_scene(file.path(), {}, {});
    require(source.text.size() <= text.size(), "the text of a scene is that of its file");
  });
}

}  // namespace raygauge::fuzz
