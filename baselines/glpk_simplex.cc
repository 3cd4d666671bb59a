// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/glpk_simplex.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "baselines/building_time.h"
#include "baselines/certify.h"
#include "baselines/gauge_lp.h"
#include "baselines/glpk_environment.h"
#include "engine/sweep/limited_load.h"
#include "raygauge/exceptions.h"

namespace raygauge::glpk {
namespace {

struct Settings {
  std::string name;
  int variant = GLP_PRIMAL;
  bool presolve = false;
  bool scale = false;
  bool advanced_basis = false;
};

/// Above this many coefficients GLPK gives up (NNZ_MAX in its sources).
constexpr double kMaxNonzeros = 5e8;

int milliseconds(double seconds) {
  const double rounded = std::ceil(seconds * 1e3);
  constexpr int kLongest = std::numeric_limits<int>::max();
  return rounded >= kLongest ? kLongest : std::max(1, static_cast<int>(rounded));
}

glp_smcp simplex_parameters(const Settings& settings, const SolveRequest& request) {
  glp_smcp parameters;
  glp_init_smcp(&parameters);
  parameters.msg_lev = GLP_MSG_OFF;
  parameters.meth = settings.variant;
  parameters.presolve = settings.presolve ? GLP_ON : GLP_OFF;
  parameters.tol_bnd = parameters.tol_dj = std::clamp(request.tolerance / 10, 1e-12, 1e-3);
  parameters.tm_lim = milliseconds(request.time_limit);
  return parameters;
}

/// The seconds of glp_simplex() that no time limit ends, in those of filling the model: it copies the model
/// first and evaluates its columns last. Measured with 10^6 points of R^3 and 5·10^4 of R^75, the larger one
/// rounded up, and so for what may come before.
double seconds_of_setup(const Settings& settings) {
  constexpr double kCopy = 1.6, kAdvancedBasis = 12, kScale = 120, kPresolve = 80;
  return kCopy + (settings.advanced_basis ? kAdvancedBasis : 0) + (settings.scale ? kScale : 0) +
         (settings.presolve ? kPresolve : 0);
}

void add_rows(glp_prob* model, const GaugeLp& lp) {
  glp_set_obj_dir(model, GLP_MIN);
  glp_add_rows(model, lp.rows());
  for (int row = 0; row < lp.rows(); ++row) {
    glp_set_row_bnds(model, row + 1, GLP_FX, lp.right_hand_side(row), lp.right_hand_side(row));
  }
}

/// False if that takes too long. `index` and `value` have room for the rows; GLPK counts from 1, and element
/// 0 of both is not read. Out of memory GLPK leaves by longjmp: nothing here may need a destructor.
bool fill_model(glp_prob* model, const GaugeLp& lp, const int* index, double* value, BuildingTime& time) {
  add_rows(model, lp);
  const int rows = lp.rows();
  const int columns = static_cast<int>(lp.columns());
  for (int j = 0; j < columns; ++j) {
    if (j % kColumnsBetweenLooks == 0) {
      if (time.is_too_long()) return false;
      glp_add_cols(model, std::min(kColumnsBetweenLooks, columns - j));
    }
    lp.copy_column(j, value + 1);
    glp_set_col_bnds(model, j + 1, GLP_LO, 0, 0);
    glp_set_obj_coef(model, j + 1, lp.cost(j));
    glp_set_mat_col(model, j + 1, rows, index, value);
  }
  return !time.is_too_long();
}

DistanceStatus status_of(int code, int solution) {
  switch (code) {
    case 0:
      if (solution == GLP_OPT) return DistanceStatus::optimal;
      return solution == GLP_NOFEAS ? DistanceStatus::unreachable : DistanceStatus::precision_limit;
    case GLP_ENOPFS:
      return DistanceStatus::unreachable;
    case GLP_ETMLIM:
      return DistanceStatus::time_limit;
    case GLP_EITLIM:
      return DistanceStatus::iteration_limit;
    default:
      return DistanceStatus::precision_limit;
  }
}

class GlpkSimplex final : public SolveMethod, public LimitedLoad {
 public:
  explicit GlpkSimplex(Settings settings)
      : settings_(std::move(settings)), time_(seconds_of_setup(settings_)) {}

  void limit_load(double seconds) override { time_.limit(seconds); }

  void load(const Instance& instance) override {
    GaugeLp lp(instance, settings_.name);
    if (static_cast<double>(lp.columns()) * lp.rows() > kMaxNonzeros) {
      throw InvalidParameterError("method '" + settings_.name +
                                  "' takes at most 5e8 coefficients, (n + 1)(N_A + N_Q)");
    }
    lp_ = std::move(lp);
    build();
  }

  void solve(const SolveRequest& request) override {
    if (!lp_) throw Error("method '" + settings_.name + "': solve before load");
    if (aborted_) build();
    if (aborted_) return;
    const double left =
        std::isfinite(request.time_limit) ? time_.left_of(request.time_limit) : request.time_limit;
    code_ = GLP_ETMLIM;
    begun_ = left > 0;
    if (!begun_) return;
    const glp_smcp parameters = simplex_parameters(settings_, {request.tolerance, left});
    const bool advanced_basis = settings_.advanced_basis;
    int code = GLP_EFAIL;
    aborted_ = !problem_->survives([&parameters, advanced_basis, &code](glp_prob* model) {
      glp_set_it_cnt(model, 0);
      if (advanced_basis) {
        glp_adv_basis(model, 0);
      } else {
        glp_std_basis(model);
      }
      code = glp_simplex(model, &parameters);
    });
    code_ = code;
  }

  DistanceResult result() override {
    if (!lp_) throw Error("method '" + settings_.name + "': result before solve");
    return certified_result(*lp_, answer());
  }

 private:
  void build() {
    time_.begin();
    problem_.emplace();
    std::vector<int> index(static_cast<std::size_t>(lp_->rows()) + 1);
    std::iota(index.begin(), index.end(), 0);
    std::vector<double> value(index.size());
    bool filled = false;
    aborted_ = !problem_->survives([this, &index, &value, &filled](glp_prob* model) {
      filled = fill_model(model, *lp_, index.data(), value.data(), time_);
    });
    if (aborted_ || !filled || !settings_.scale) return;
    aborted_ = !problem_->survives([](glp_prob* model) { glp_scale_prob(model, GLP_SF_AUTO); });
  }

  LpAnswer answer() const {
    LpAnswer answer;
    if (aborted_) return answer;
    glp_prob* model = problem_->get();
    answer.status = begun_ ? status_of(code_, glp_get_status(model)) : DistanceStatus::time_limit;
    if (!begun_) return answer;
    answer.pivots = glp_get_it_cnt(model);
    if (glp_get_prim_stat(model) == GLP_UNDEF) return answer;
    answer.objective = glp_get_obj_val(model);
    for (int j = 0; j < lp_->columns(); ++j) {
      if (glp_get_col_stat(model, j + 1) == GLP_BS) answer.basis.push_back(j);
    }
    answer.u.resize(lp_->rows() - 1);
    for (int row = 0; row + 1 < lp_->rows(); ++row) answer.u[row] = glp_get_row_dual(model, row + 1);
    return answer;
  }

  Settings settings_;
  std::optional<GaugeLp> lp_;
  std::optional<GlpkProblem> problem_;
  BuildingTime time_;
  int code_ = GLP_EFAIL;
  bool begun_ = false;  ///< the last solve had time to copy the model
  bool aborted_ =
      false;  ///< GLPK gave up on an internal error, or for want of memory; the model has to be built again
};

Component<SolveMethod> component(const std::string& name, const std::string& variant_name, int variant) {
  return {name,
          "the linear program of Example 2 by the " + variant_name + " simplex of GLPK " + glp_version(),
          {{"presolve", false, {}, {}, "run GLPK's presolver", {}},
           {"scale", false, {}, {}, "scale the model when it is loaded (GLP_SF_AUTO)", {}},
           {"basis", std::string("standard"), {}, {}, "first basis", {"standard", "advanced"}}},
          [name, variant](const Parameters& parameters) -> std::unique_ptr<SolveMethod> {
            return std::make_unique<GlpkSimplex>(Settings{
                name, variant, boolean_parameter(parameters, "presolve"),
                boolean_parameter(parameters, "scale"), string_parameter(parameters, "basis") == "advanced"});
          },
          true,
          Role::baseline,
          {},
          variant == GLP_DUAL ? std::vector<std::string>{"glpk"} : std::vector<std::string>{}};
}

}  // namespace
}  // namespace raygauge::glpk

namespace raygauge {

void register_glpk_methods(MethodRegistry& registry) {
  registry.add(glpk::component("glpk_primal", "primal", GLP_PRIMAL));
  registry.add(glpk::component("glpk_dual", "dual", GLP_DUAL));
}

const char* glpk_version() { return glp_version(); }

}  // namespace raygauge
