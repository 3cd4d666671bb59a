// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/exact_method.h"

#include <optional>

#include "baselines/exact_lp.h"
#include "baselines/gauge_lp.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

constexpr const char* kName = "exact";

class ExactMethod final : public SolveMethod {
 public:
  void load(const Instance& instance) override {
    lp_.emplace(instance, kName);
    solution_.reset();
  }

  void solve(const SolveRequest& request) override {
    if (!lp_) throw Error("method 'exact': solve before load");
    solution_ = solve_exact_lp(lp_->A(), lp_->Q(), request.time_limit);
  }

  DistanceResult result() override {
    if (!solution_) throw Error("method 'exact': result before solve");
    DistanceResult result;
    result.status = solution_->status;
    result.distance = solution_->rounded.nearest;
    result.lower = solution_->rounded.lower;
    result.upper = solution_->rounded.upper;
    result.counters.pivots = solution_->pivots;
    result.normal.resize(static_cast<Eigen::Index>(solution_->u.size()));
    for (Eigen::Index k = 0; k < result.normal.size(); ++k) {
      result.normal[k] = solution_->u[static_cast<std::size_t>(k)].convert_to<double>();
    }
    return result;
  }

 private:
  std::optional<GaugeLp> lp_;
  std::optional<ExactLpResult> solution_;
};

}  // namespace

void register_exact_method(MethodRegistry& registry) {
  registry.add({kName,
                "the linear program of Example 2 in exact rational arithmetic (GMP " +
                    std::string(gmp_library_version()) + ")",
                {},
                [](const Parameters&) { return std::make_unique<ExactMethod>(); },
                true,
                Role::oracle});
}

const char* gmp_library_version() { return gmp_version; }

}  // namespace raygauge
