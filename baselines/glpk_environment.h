// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glpk.h>

#include <memory>
#include <thread>

namespace raygauge {

/// A GLPK problem, owned by the thread that made it.
///
/// GLPK keeps one memory environment a thread, and a problem may only be used and deleted in its own. So the
/// thread owns the problem, and a GlpkProblem is a handle: destroyed in the owning thread it deletes the
/// problem at once, destroyed elsewhere it leaves that to the owning thread's exit. The environment of a
/// thread is freed with its last problem. Its terminal output is silenced.
class GlpkProblem {
 public:
  /// An empty problem of the calling thread.
  GlpkProblem();
  ~GlpkProblem();
  GlpkProblem(GlpkProblem&& other) noexcept;
  GlpkProblem& operator=(GlpkProblem&& other) noexcept;

  /// The problem. Throws Error outside the thread that made it.
  glp_prob* get() const;

  /// glp_simplex(get(), &parameters). `aborted` is set, and the problem is unusable afterwards, where GLPK
  /// hit an internal error, at which it would end the whole process.
  int simplex(const glp_smcp& parameters, bool& aborted);

 private:
  struct Slot;
  struct Environment;
  static Environment& environment();
  void release() noexcept;

  std::shared_ptr<Slot> slot_;
};

}  // namespace raygauge
