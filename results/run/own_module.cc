// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/run/own_module.h"

#include <dlfcn.h>

#include "raygauge/exceptions.h"

namespace raygauge {
namespace fs = std::filesystem;
namespace {

fs::path path_of(const OwnModule& module) {
  std::error_code error;
  const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (const fs::path& path :
       {folder / module.file, folder.parent_path() / "lib" / "raygauge" / module.file}) {
    if (fs::exists(path, error)) return path;
  }
  throw Error(module.without + " (" + (folder / module.file).string() + " is missing)");
}

}  // namespace

void* function_of(const OwnModule& module, const char* name) {
  const fs::path path = path_of(module);
  void* loaded = ::dlopen(path.c_str(), RTLD_NOW | (module.shares_its_names ? RTLD_GLOBAL : RTLD_LOCAL));
  if (loaded == nullptr) throw Error(path.string() + ": cannot be loaded: " + ::dlerror());
  void* function = ::dlsym(loaded, name);
  if (function == nullptr) throw Error(path.string() + ": not a part of raygauge");
  return function;
}

}  // namespace raygauge
