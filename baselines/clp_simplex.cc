// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/clp_simplex.h"

#include <ClpConfig.h>

#include <ClpSimplex.hpp>
#include <ClpSolve.hpp>
#include <CoinPackedMatrix.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "baselines/building_time.h"
#include "baselines/certify.h"
#include "baselines/gauge_lp.h"
#include "engine/sweep/limited_load.h"
#include "raygauge/exceptions.h"

namespace raygauge::clp {
namespace {

enum class Variant { primal, dual };

struct Settings {
  std::string name;
  Variant variant = Variant::primal;
  bool presolve = false;
  int scaling = 3;
};

/// In the order of ClpSimplex::scaling's modes 0, 1, 2, 3.
const std::vector<std::string> kScalings = {"off", "equilibrium", "geometric", "auto"};

/// Elements of a Clp model are counted by int.
constexpr double kMaxElements = std::numeric_limits<int>::max();

/// The seconds that Clp takes to copy and scale the model, and for its first iteration, in those of the
/// matrix: no time limit ends them. Measured with 10^6 points of R^3 and 5·10^4 of R^75, the larger one
/// rounded up.
double seconds_of_setup(const Settings& settings) {
  constexpr double kCopyAndScale = 6, kPresolve = 12;
  return kCopyAndScale + (settings.presolve ? kPresolve : 0);
}

/// The LP's columns as a dense column-major matrix, explicit zeros left out; those so far where it takes too
/// long.
CoinPackedMatrix matrix_of(const GaugeLp& lp, BuildingTime& time) {
  CoinPackedMatrix matrix(true, 0, 0);
  matrix.setDimensions(lp.rows(), 0);
  matrix.reserve(static_cast<int>(lp.columns()), static_cast<CoinBigIndex>(lp.columns() * lp.rows()));
  std::vector<double> column(static_cast<std::size_t>(lp.rows())), value(column.size());
  std::vector<int> index(column.size());
  for (std::ptrdiff_t j = 0; j < lp.columns(); ++j) {
    if (j % kColumnsBetweenLooks == 0 && time.is_too_long()) break;
    lp.copy_column(j, column.data());
    std::size_t count = 0;
    for (std::size_t row = 0; row < column.size(); ++row) {
      if (column[row] == 0) continue;
      index[count] = static_cast<int>(row);
      value[count++] = column[row];
    }
    matrix.appendCol(static_cast<int>(count), index.data(), value.data());
  }
  return matrix;
}

/// False if that takes too long.
bool fill_model(ClpSimplex& model, const GaugeLp& lp, BuildingTime& time) {
  const CoinPackedMatrix matrix = matrix_of(lp, time);
  if (time.is_too_long()) return false;
  const auto columns = static_cast<std::size_t>(lp.columns());
  const std::vector<double> lower(columns, 0.0), upper(columns, std::numeric_limits<double>::infinity());
  std::vector<double> cost(columns), right_hand_side(static_cast<std::size_t>(lp.rows()));
  for (std::size_t j = 0; j < columns; ++j) cost[j] = lp.cost(static_cast<std::ptrdiff_t>(j));
  for (int row = 0; row < lp.rows(); ++row) {
    right_hand_side[static_cast<std::size_t>(row)] = lp.right_hand_side(row);
  }
  model.loadProblem(matrix, lower.data(), upper.data(), cost.data(), right_hand_side.data(),
                    right_hand_side.data());
  return true;
}

/// Clp's secondary status: optimal outright, or after the presolver left an empty problem; any other one says
/// that the unscaled problem has infeasibilities left.
bool optimal_without_reserve(int secondary) { return secondary == 0 || secondary == 6; }

DistanceStatus status_of(const ClpSimplex& model) {
  switch (model.status()) {
    case 0:
      return optimal_without_reserve(model.secondaryStatus()) ? DistanceStatus::optimal
                                                              : DistanceStatus::precision_limit;
    case 1:
      return DistanceStatus::unreachable;
    case 3:
      return model.secondaryStatus() == 9 ? DistanceStatus::time_limit : DistanceStatus::iteration_limit;
    default:
      return DistanceStatus::precision_limit;
  }
}

class ClpSimplexMethod final : public SolveMethod, public LimitedLoad {
 public:
  explicit ClpSimplexMethod(Settings settings)
      : settings_(std::move(settings)), time_(seconds_of_setup(settings_)) {}

  void limit_load(double seconds) override { time_.limit(seconds); }

  void load(const Instance& instance) override {
    GaugeLp lp(instance, settings_.name);
    if (static_cast<double>(lp.columns()) * lp.rows() > kMaxElements) {
      throw InvalidParameterError("method '" + settings_.name +
                                  "' takes at most 2^31 - 1 coefficients, (n + 1)(N_A + N_Q)");
    }
    lp_ = std::move(lp);
    model_.emplace();
    model_->setLogLevel(0);
    model_->scaling(settings_.scaling);
    time_.begin();
    is_built_ = fill_model(*model_, *lp_, time_);
    load_seconds_ = time_.seconds_since_begin();
  }

  void solve(const SolveRequest& request) override {
    if (!lp_) throw Error("method '" + settings_.name + "': solve before load");
    if (!is_built_) return;
    const double tolerance = std::clamp(request.tolerance / 10, 1e-12, 1e-3);
    model_->setPrimalTolerance(tolerance);
    model_->setDualTolerance(tolerance);
    model_->setMaximumWallSeconds(std::clamp(request.time_limit - load_seconds_, 1e-3, 1e9));
    model_->setNumberIterations(0);
    model_->allSlackBasis(true);
    if (settings_.presolve) {
      ClpSolve options;
      options.setSolveType(settings_.variant == Variant::primal ? ClpSolve::usePrimal : ClpSolve::useDual);
      options.setPresolveType(ClpSolve::presolveOn);
      model_->initialSolve(options);
    } else if (settings_.variant == Variant::primal) {
      model_->primal();
    } else {
      model_->dual();
    }
  }

  DistanceResult result() override {
    if (!lp_) throw Error("method '" + settings_.name + "': result before solve");
    LpAnswer answer;
    answer.status = DistanceStatus::time_limit;
    if (!is_built_) return certified_result(*lp_, answer);
    answer.status = status_of(*model_);
    answer.objective = model_->objectiveValue();
    answer.pivots = model_->numberIterations();
    for (int j = 0; j < lp_->columns(); ++j) {
      if (model_->getColumnStatus(j) == ::ClpSimplex::basic) answer.basis.push_back(j);
    }
    answer.u = Vector::Map(model_->dualRowSolution(), lp_->rows() - 1);
    return certified_result(*lp_, answer);
  }

 private:
  Settings settings_;
  std::optional<GaugeLp> lp_;
  std::optional<ClpSimplex> model_;
  BuildingTime time_;
  double load_seconds_ = 0;
  bool is_built_ = false;  ///< there was time for it
};

int scaling_mode(const std::string& name) {
  return static_cast<int>(std::find(kScalings.begin(), kScalings.end(), name) - kScalings.begin());
}

Component<SolveMethod> component(const std::string& name, const std::string& variant_name, Variant variant) {
  return {name,
          "the linear program of Example 2 by the " + variant_name + " simplex of Clp " + clp_version(),
          {{"presolve", false, {}, {}, "run Clp's presolver", {}},
           {"scaling", std::string("auto"), {}, {}, "how Clp scales the model", kScalings}},
          [name, variant](const Parameters& parameters) -> std::unique_ptr<SolveMethod> {
            return std::make_unique<ClpSimplexMethod>(
                Settings{name, variant, boolean_parameter(parameters, "presolve"),
                         scaling_mode(string_parameter(parameters, "scaling"))});
          },
          true,
          Role::baseline};
}

}  // namespace
}  // namespace raygauge::clp

namespace raygauge {

void register_clp_methods(MethodRegistry& registry) {
  registry.add(clp::component("clp_primal", "primal", clp::Variant::primal));
  registry.add(clp::component("clp_dual", "dual", clp::Variant::dual));
}

const char* clp_version() { return CLP_VERSION; }

}  // namespace raygauge
