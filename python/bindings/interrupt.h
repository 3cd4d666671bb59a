// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <functional>

namespace raygauge::python {

/// Runs `work` on a thread of its own, without the interpreter's lock, while the caller's thread keeps
/// looking for Python's signals, every 20 ms. After Ctrl-C `stop` is set, `work` is waited for, and
/// KeyboardInterrupt raised. What `work` throws is thrown here. To be called with the lock held.
void run_interruptibly(std::atomic<bool>& stop, const std::function<void()>& work);

}  // namespace raygauge::python
