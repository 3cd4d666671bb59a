// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/console/interrupt.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>

#include "cli/console/exit_status.h"

namespace raygauge::cli {
namespace {

// A signal handler reaches nothing but globals; lock-free atomics are what it may touch in a threaded
// program.
std::atomic<int> received_signal{0};
std::atomic<const char*> received_notice{nullptr};
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<const char*>::is_always_lock_free);

void remember(int signal) {
  const int saved_errno = errno;
  received_signal.store(signal);
  if (const char* notice = received_notice.load(); notice != nullptr) {
    // Nothing could be done about a notice that does not get through.
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, notice, std::strlen(notice));
  }
  errno = saved_errno;
}

}  // namespace

InterruptGuard::InterruptGuard(const char* notice) {
  received_signal.store(0);
  received_notice.store(notice);
  struct sigaction action {};
  action.sa_handler = remember;
  // SA_RESETHAND: the second signal finds the default action, which ends the program.
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigaction(SIGINT, &action, &previous_interrupt_);
  sigaction(SIGTERM, &action, &previous_terminate_);
}

InterruptGuard::~InterruptGuard() {
  sigaction(SIGINT, &previous_interrupt_, nullptr);
  sigaction(SIGTERM, &previous_terminate_, nullptr);
}

int InterruptGuard::signal() noexcept { return received_signal.load(); }

int interrupted_status() noexcept {
  const int signal = InterruptGuard::signal();
  return kInterrupted + (signal == 0 ? 0 : signal - SIGINT);
}

}  // namespace raygauge::cli
