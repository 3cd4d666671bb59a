// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bench/pair_bodies.h"
#include "bench/pair_library.h"

namespace raygauge::bench {

/// A pair inside a library that was loaded, for one query. Destroyed before the library is.
class LibraryPair {
 public:
  /// Empty (`has()` is false) where the library has no such bodies or no such query.
  LibraryPair(const raygauge_pair_library& library, const PosedPair& pair, raygauge_pair_query query,
              double tolerance);

  bool has() const { return pair_ != nullptr; }
  void place(const Pose& first, const Pose& second);

  /// A solve from a cold start, which is remembered.
  bool solve_and_remember(raygauge_pair_answer& answer);
  bool solve(raygauge_pair_answer& answer) {
    return library_.solve(pair_.get(), nullptr, nullptr, &answer) == 1;
  }
  /// From what was remembered, which stays as it is; what this solve leaves is dropped.
  bool solve_warm(raygauge_pair_answer& answer) {
    return library_.solve(pair_.get(), memory_.data(), next_.data(), &answer) == 1;
  }

 private:
  const raygauge_pair_library& library_;
  Pose frame_[2] = {Pose(3), Pose(3)};  ///< of the library's bodies in the sets' own frames
  std::unique_ptr<void, void (*)(void*)> pair_;
  std::vector<std::byte> memory_, next_;
};

/// The library behind an adapter, a shared object: see pair_library.h.
class LoadedLibrary {
 public:
  /// Throws std::runtime_error, with the path and the cause, for what is no adapter of this version.
  explicit LoadedLibrary(const std::string& path);

  const raygauge_pair_library& functions() const { return *functions_; }

 private:
  std::unique_ptr<void, int (*)(void*)> object_;
  const raygauge_pair_library* functions_ = nullptr;
};

}  // namespace raygauge::bench
