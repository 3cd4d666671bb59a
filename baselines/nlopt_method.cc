// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/nlopt_method.h"

#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "baselines/cone_program.h"
#include "raygauge/exceptions.h"

namespace raygauge::nlopt_baseline {
namespace {

constexpr const char* kName = "nlopt_slsqp";

struct Settings {
  double constraint_tolerance = 0;
  int max_evaluations = 0;
};

struct Destroy {
  void operator()(nlopt_opt optimizer) const { nlopt_destroy(optimizer); }
};
using Optimizer = std::unique_ptr<nlopt_opt_s, Destroy>;

double objective(unsigned n, const double* y, double* gradient, void* /*unused*/) {
  for (unsigned k = 0; gradient != nullptr && k < n; ++k) gradient[k] = k == 0 ? 1 : 0;
  return y[0];
}

/// What NLopt's constraint callback works with. NLopt's own test of the objective ends SLSQP at points that
/// are far from feasible, so the paper's is made here: |λ - λ of the evaluation before| <= ε |λ|, all
/// constraints within tolerance.
struct Watch {
  std::optional<ConeProgram> program;
  nlopt_opt optimizer = nullptr;
  double tolerance = 0;
  double constraint_tolerance = 0;
  double previous = 0;  ///< λ of the evaluation before
  bool converged = false;
};

void constraints(unsigned m, double* values, unsigned n, const double* y, double* gradients, void* context) {
  auto& watch = *static_cast<Watch*>(context);
  double violation = 0;
  for (unsigned i = 0; i < m; ++i) {
    double* gradient = gradients == nullptr ? nullptr : gradients + std::size_t{i} * n;
    values[i] = watch.program->value(static_cast<int>(i), y, gradient);
    violation = std::max(violation, values[i]);
  }
  const bool settled = std::abs(y[0] - watch.previous) <= watch.tolerance * std::abs(y[0]);
  watch.previous = y[0];
  if (!settled || !(violation <= watch.constraint_tolerance)) return;
  watch.converged = true;
  nlopt_force_stop(watch.optimizer);
}

DistanceStatus status_of(nlopt_result result) {
  switch (result) {
    case NLOPT_SUCCESS:
    case NLOPT_STOPVAL_REACHED:
    case NLOPT_FTOL_REACHED:
    case NLOPT_XTOL_REACHED:
      return DistanceStatus::optimal;
    case NLOPT_MAXEVAL_REACHED:
      return DistanceStatus::iteration_limit;
    case NLOPT_MAXTIME_REACHED:
      return DistanceStatus::time_limit;
    default:  // NLOPT_ROUNDOFF_LIMITED, NLOPT_FAILURE
      return DistanceStatus::precision_limit;
  }
}

[[noreturn]] void throw_error(const char* what) {
  throw Error(std::string("method '") + kName + "': " + what);
}

class NloptMethod final : public SolveMethod {
 public:
  explicit NloptMethod(const Settings& settings) : settings_(settings) {}

  void load(const Instance& instance) override {
    watch_.program.emplace(instance, kName);
    const auto variables = static_cast<unsigned>(watch_.program->variables());
    optimizer_.reset(nlopt_create(NLOPT_LD_SLSQP, variables));
    if (optimizer_ == nullptr) throw_error("NLopt has no memory left");
    const std::vector<double> tolerances(static_cast<std::size_t>(watch_.program->constraints()),
                                         settings_.constraint_tolerance);
    nlopt_set_min_objective(optimizer_.get(), objective, nullptr);
    nlopt_set_lower_bound(optimizer_.get(), 0, 0.0);
    nlopt_add_inequality_mconstraint(optimizer_.get(), static_cast<unsigned>(tolerances.size()), constraints,
                                     &watch_, tolerances.data());
    nlopt_set_maxeval(optimizer_.get(), settings_.max_evaluations);
    watch_.optimizer = optimizer_.get();
    watch_.constraint_tolerance = settings_.constraint_tolerance;
    y_.resize(variables);
  }

  void solve(const SolveRequest& request) override {
    if (!watch_.program) throw_error("solve before load");
    nlopt_set_maxtime(optimizer_.get(), std::isfinite(request.time_limit) ? request.time_limit : 0);
    nlopt_set_force_stop(optimizer_.get(), 0);
    watch_.tolerance = request.tolerance;
    watch_.previous = DistanceResult::kUnset;
    watch_.converged = false;
    y_ = watch_.program->start();
    status_ = status_of(nlopt_optimize(optimizer_.get(), y_.data(), &distance_));
    if (watch_.converged) {
      status_ = DistanceStatus::optimal;
      distance_ = watch_.previous;
    }
  }

  DistanceResult result() override {
    if (!watch_.program) throw_error("result before solve");
    DistanceResult result;
    result.status = status_;
    result.distance = distance_;
    result.counters.pivots = nlopt_get_numevals(optimizer_.get());
    return result;
  }

 private:
  Settings settings_;
  Watch watch_;
  Optimizer optimizer_;
  Vector y_;
  double distance_ = DistanceResult::kUnset;
  DistanceStatus status_ = DistanceStatus::precision_limit;
};

Component<SolveMethod> slsqp() {
  return {kName,
          "the convex program (5) by the sequential quadratic programming (SLSQP) of NLopt " +
              nlopt_library_version(),
          {{"constraint_tolerance", 1e-12, 0.0, 1.0, "absolute, of each constraint", {}},
           {"max_evaluations", std::int64_t{1000}, 1.0, 1e9, "of the constraints", {}}},
          [](const Parameters& parameters) -> std::unique_ptr<SolveMethod> {
            return std::make_unique<NloptMethod>(
                Settings{real_parameter(parameters, "constraint_tolerance"),
                         static_cast<int>(integer_parameter(parameters, "max_evaluations"))});
          },
          false,  // point sets have no constraints |F x + f| <= g·x + γ
          Role::baseline};
}

}  // namespace
}  // namespace raygauge::nlopt_baseline

namespace raygauge {

void register_nlopt_method(MethodRegistry& registry) { registry.add(nlopt_baseline::slsqp()); }

std::string nlopt_library_version() {
  int major = 0, minor = 0, bugfix = 0;
  nlopt_version(&major, &minor, &bugfix);
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(bugfix);
}

}  // namespace raygauge
