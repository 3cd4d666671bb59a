// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/hdf5/trial.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <csignal>

#include "results/disk/atomic_file.h"
#include "results/exceptions.h"

namespace raygauge::hdf5 {
namespace {

/// The copy dies of a signal as a process does by itself, says nothing and leaves no core.
void become_trial(double seconds) {
  for (const int number : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGXCPU}) std::signal(number, SIG_DFL);
  const auto limit = static_cast<rlim_t>(std::ceil(seconds));
  const struct rlimit cpu = {limit, limit + 1};
  ::setrlimit(RLIMIT_CPU, &cpu);
  const struct rlimit core = {0, 0};
  ::setrlimit(RLIMIT_CORE, &core);
  const int nowhere = ::open("/dev/null", O_WRONLY);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
}

}  // namespace

bool survives(const std::function<void()>& work, double seconds) {
  const pid_t child = ::fork();
  if (child < 0) throw ResultsError("no process to try a file in: " + system_reason(errno));
  if (child == 0) {
    become_trial(seconds);
    try {
      work();
    } catch (...) {
      // An error is an end as well; the process itself will report it.
    }
    ::syscall(SYS_exit_group, 0);  // nothing is flushed: the buffers are copies
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw ResultsError("a process cannot be waited for: " + system_reason(errno));
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace raygauge::hdf5
