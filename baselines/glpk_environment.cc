// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/glpk_environment.h"

#include <algorithm>
#include <atomic>
#include <csetjmp>
#include <utility>
#include <vector>

#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

int swallow_output(void* /*info*/, const char* /*text*/) { return 1; }

void leave_failed_call(void* frame) { std::longjmp(*static_cast<std::jmp_buf*>(frame), 1); }

}  // namespace

struct GlpkProblem::Slot {
  glp_prob* problem = nullptr;
  std::thread::id owner = std::this_thread::get_id();
  std::atomic<bool> abandoned = false;
};

/// The problems of one thread.
struct GlpkProblem::Environment {
  std::vector<std::shared_ptr<Slot>> slots;

  void delete_abandoned() {
    std::erase_if(slots, [](const std::shared_ptr<Slot>& slot) {
      if (!slot->abandoned) return false;
      if (slot->problem != nullptr) glp_delete_prob(std::exchange(slot->problem, nullptr));
      return true;
    });
    if (slots.empty()) glp_free_env();
  }

  ~Environment() {
    for (const auto& slot : slots) slot->abandoned = true;
    delete_abandoned();
  }
};

GlpkProblem::Environment& GlpkProblem::environment() {
  thread_local Environment instance;
  return instance;
}

GlpkProblem::GlpkProblem() : slot_(std::make_shared<Slot>()) {
  Environment& here = environment();
  here.slots.push_back(slot_);
  glp_term_hook(swallow_output, nullptr);
  glp_term_out(GLP_OFF);
  glp_prob*& problem = slot_->problem;
  if (!run_guarded(
          nullptr, [](glp_prob*, void* made) { *static_cast<glp_prob**>(made) = glp_create_prob(); },
          &problem))
    throw Error("GLPK is out of memory");
}

GlpkProblem::~GlpkProblem() { release(); }

GlpkProblem::GlpkProblem(GlpkProblem&& other) noexcept : slot_(std::move(other.slot_)) {}

GlpkProblem& GlpkProblem::operator=(GlpkProblem&& other) noexcept {
  if (this != &other) {
    release();
    slot_ = std::move(other.slot_);
  }
  return *this;
}

void GlpkProblem::release() noexcept {
  if (!slot_) return;
  const bool at_home = slot_->owner == std::this_thread::get_id();
  slot_->abandoned = true;
  slot_.reset();
  if (at_home) environment().delete_abandoned();
}

glp_prob* GlpkProblem::get() const {
  if (slot_->owner != std::this_thread::get_id()) {
    throw Error("a GLPK problem can only be used in the thread that loaded it");
  }
  return slot_->problem;
}

// Between the jump and its landing there are frames of GLPK and of `call` only, so that the jump is well
// defined.
bool GlpkProblem::run_guarded(glp_prob* problem, void (*call)(glp_prob*, void*), void* context) {
  std::jmp_buf frame;
  glp_error_hook(leave_failed_call, &frame);
  if (setjmp(frame) == 0) {
    call(problem, context);
    glp_error_hook(nullptr, nullptr);
    return true;
  }
  glp_error_hook(nullptr, nullptr);
  return false;
}

}  // namespace raygauge
