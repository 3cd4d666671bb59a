// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/registries.h"

#include <filesystem>
#include <memory>

#include "baselines/command_method.h"
#include "baselines/registry.h"
#include "cli/input/file_sets.h"
#include "generators/files.h"
#include "generators/registry.h"

namespace raygauge::cli {

GeneratorRegistry all_generators() {
  GeneratorRegistry registry("generator");
  register_generators(registry);
  return registry;
}

GeneratorRegistry sweep_generators(const std::string& experiment_path) {
  GeneratorRegistry registry = all_generators();
  const std::filesystem::path folder = std::filesystem::path(experiment_path).parent_path();
  registry.add(files_generator(std::make_shared<FileSets>(folder)));
  return registry;
}

MethodRegistry all_methods() {
  MethodRegistry registry("method");
  register_engine_methods(registry);
  register_baselines(registry);
  return registry;
}

MethodRegistry sweep_methods() {
  MethodRegistry registry = all_methods();
  register_command_method(registry);
  return registry;
}

}  // namespace raygauge::cli
