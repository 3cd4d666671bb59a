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
  /// An empty problem of the calling thread. Throws Error where there is no memory for it.
  GlpkProblem();
  ~GlpkProblem();
  GlpkProblem(GlpkProblem&& other) noexcept;
  GlpkProblem& operator=(GlpkProblem&& other) noexcept;

  /// The problem. Throws Error outside the thread that made it.
  glp_prob* get() const;

  /// Runs `call` on the problem and returns whether it came back: where GLPK hits an internal error, or finds
  /// no memory, it would end the process; here the call is abandoned instead, and the problem is unusable
  /// afterwards. The call is left by longjmp, so it must hold nothing that needs a destructor. Throws as
  /// get() does.
  template <class Call>
  bool survives(Call&& call) {
    return run_guarded(
        get(), [](glp_prob* problem, void* context) { (*static_cast<Call*>(context))(problem); }, &call);
  }

 private:
  struct Slot;
  struct Environment;
  static Environment& environment();
  static bool run_guarded(glp_prob* problem, void (*call)(glp_prob*, void*), void* context);
  void release() noexcept;

  std::shared_ptr<Slot> slot_;
};

}  // namespace raygauge
