// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace raygauge {

/// Workspaces, one a thread: each lends itself to whoever asks, and what is found does not depend on which.
template <class Tool>
class SharedTools {
 public:
  void add(std::unique_ptr<Tool> tool) {
    free_.push_back(tool.get());
    all_.push_back(std::move(tool));
  }

  const std::vector<std::unique_ptr<Tool>>& all() const noexcept { return all_; }

  /// use(tool) with one that nobody has; there must be one for each thread that asks.
  template <class Use>
  void lend(const Use& use) {
    const Loan loan(*this);
    use(*loan.tool);
  }

 private:
  struct Loan {
    explicit Loan(SharedTools& from) : lender(from) {
      const std::lock_guard lock(lender.mutex_);
      tool = lender.free_.back();
      lender.free_.pop_back();
    }
    ~Loan() {
      const std::lock_guard lock(lender.mutex_);
      lender.free_.push_back(tool);
    }
    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;

    SharedTools& lender;
    Tool* tool = nullptr;
  };

  std::mutex mutex_;
  std::vector<std::unique_ptr<Tool>> all_;
  std::vector<Tool*> free_;
};

}  // namespace raygauge
