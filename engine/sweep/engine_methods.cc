// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "engine/numerics/decompositions.h"
#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/queries/solver.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sweep/method.h"

namespace raygauge {
namespace {

/// What a method of the engine keeps between load() and result(). There is no model to build: load chooses
/// the sets.
class EngineMethod : public SolveMethod {
 public:
  DistanceResult result() override {
    if (result_ == nullptr) throw Error("result() of a method that has solved nothing since load()");
    return *result_;
  }

 protected:
  explicit EngineMethod(const DistanceOptions& options) : options_(options) {}

  /// Whether the options differ from now on.
  bool take(const SolveRequest& request) {
    if (request.tolerance == options_.tolerance && request.time_limit == options_.time_limit) return false;
    options_.tolerance = request.tolerance;
    options_.time_limit = request.time_limit;
    return true;
  }

  DistanceOptions options_;
  const DistanceResult* result_ = nullptr;  ///< of the last solve since load()
};

/// DistanceSolver behind the interface of a sweep.
class DistanceMethodOfEngine final : public EngineMethod {
 public:
  explicit DistanceMethodOfEngine(const DistanceOptions& options) : EngineMethod(options), solver_(options) {}

  void load(const Instance& instance) override {
    A_ = instance.A;
    Q_ = instance.Q;
    result_ = nullptr;
  }

  void solve(const SolveRequest& request) override {
    if (take(request)) solver_.set_options(options_);
    result_ = &solver_.solve(*A_, *Q_);
  }

 private:
  DistanceSolver solver_;
  std::shared_ptr<const ConvexSet> A_, Q_;
};

/// An operand of a difference as an object that may be moved: a rigid image is its set in a pose.
struct MovedObject {
  std::shared_ptr<const ConvexSet> set;
  std::optional<Pose> pose;

  explicit MovedObject(std::shared_ptr<const ConvexSet> S) : set(std::move(S)) {
    const auto* image = dynamic_cast<const AffineImage*>(set.get());
    if (image == nullptr || !is_rotation(image->M())) return;
    pose.emplace(image->M(), image->t());
    set = image->S();
  }

  Posed posed() const { return pose ? Posed(*set, *pose) : Posed(*set); }

 private:
  static bool is_rotation(const DenseMatrix& M) {
    constexpr double kRigid = 1e-12;
    return M.rows() > 0 && (M.transpose() * M).isIdentity(kRigid) && lu_determinant(M) > 0;
  }
};

/// ObjectDistanceSolver and GrowthDistanceSolver behind the same interface: A is the difference of the two
/// objects, or one beside the origin.
class ObjectMethod final : public EngineMethod {
 public:
  ObjectMethod() : EngineMethod(DistanceOptions()), distance_(std::in_place), growth_(std::in_place) {}

  bool answers(Quantity /*any*/) const override { return true; }

  void load(const Instance& instance) override {
    const auto* difference = dynamic_cast<const MinkowskiDifference*>(instance.A.get());
    const auto origin = [&] {
      return std::make_shared<PointSet>(Eigen::MatrixXd::Zero(instance.A->dimension(), 1));
    };
    first_.emplace(difference == nullptr ? std::shared_ptr<const ConvexSet>(origin()) : difference->A1());
    second_.emplace(difference == nullptr ? instance.A : difference->A2());
    Q_ = instance.Q;
    quantity_ = instance.quantity;
    result_ = nullptr;
  }

  void solve(const SolveRequest& request) override {
    if (take(request)) {
      distance_.emplace(options_);
      growth_.emplace(growth_options());
    }
    const Posed A1 = first_->posed(), A2 = second_->posed();
    switch (quantity_) {
      case Quantity::distance:
        result_ = &distance_->solve(A1, A2, *Q_).distance;
        return;
      case Quantity::growth:
        result_ = &growth_->solve_about_centers(A1, A2);
        return;
      case Quantity::depth:
        take_depth(distance_->solve(A1, A2, *Q_, ObjectEffects::depth));
        break;
      case Quantity::separated:
        take_separation(growth_->separation(A1, A2));
        break;
    }
    result_ = &answer_;
  }

 private:
  DistanceOptions growth_options() const {
    DistanceOptions options = options_;
    options.method = DistanceMethod::newton;  // see GrowthDistanceSolver
    return options;
  }

  void take_depth(const ObjectDistance& found) {
    const bool computed = found.depth.evaluations > 0;
    answer_.distance = computed ? found.depth.depth : 0;
    answer_.lower = computed ? found.depth.lower : 0;
    answer_.upper = computed ? found.depth.upper : 0;
    answer_.status = computed ? found.depth.status : DistanceStatus::optimal;
    answer_.counters = found.distance.counters;
  }

  void take_separation(const SeparationResult& found) {
    const bool apart = found.outcome == Separation::separated;
    const bool meet = found.outcome == Separation::intersecting;
    answer_.lower = apart ? 1 : 0;
    answer_.upper = meet ? 0 : 1;
    answer_.distance = answer_.lower == answer_.upper ? answer_.lower : DistanceResult::kUnset;
    answer_.status = apart  ? DistanceStatus::optimal
                     : meet ? DistanceStatus::contains_origin
                            : DistanceStatus::precision_limit;
    answer_.counters = found.counters;
  }

  std::optional<ObjectDistanceSolver> distance_;
  std::optional<GrowthDistanceSolver> growth_;
  std::optional<MovedObject> first_, second_;
  std::shared_ptr<const ConvexSet> Q_;
  Quantity quantity_ = Quantity::distance;
  DistanceResult answer_;  ///< of a quantity whose solver has another result
};

const std::map<std::string, InstructionSet> kInstructionSets = {{"automatic", InstructionSet::automatic},
                                                                {"baseline", InstructionSet::baseline},
                                                                {"avx2", InstructionSet::avx2},
                                                                {"avx512", InstructionSet::avx512}};
const std::map<std::string, StopRule> kStopRules = {{"certified_gap", StopRule::certified_gap},
                                                    {"published_sigma", StopRule::published_sigma}};

template <class T>
std::vector<std::string> names_of(const std::map<std::string, T>& choices) {
  std::vector<std::string> names;
  names.reserve(choices.size());
  for (const auto& entry : choices) names.push_back(entry.first);
  return names;
}

std::vector<ParameterInfo> common_parameters() {
  return {{"instruction_set",
           std::string("automatic"),
           {},
           {},
           "instruction set of the vector kernels",
           names_of(kInstructionSets)},
          {"max_iterations",
           std::int64_t{0},
           0.0,
           9e15,
           "largest number of basis changes; 0: chosen from n",
           {}}};
}

DistanceOptions options_from(DistanceMethod method, const Parameters& parameters) {
  DistanceOptions options;
  options.method = method;
  options.instruction_set = kInstructionSets.at(string_parameter(parameters, "instruction_set"));
  options.max_iterations = integer_parameter(parameters, "max_iterations");
  return options;
}

}  // namespace

void register_engine_methods(MethodRegistry& registry) {
  std::vector<ParameterInfo> of_column_generation = common_parameters();
  of_column_generation.push_back({"threads",
                                  std::int64_t{1},
                                  1.0,
                                  static_cast<double>(kMostThreads),
                                  "threads of one solve, for its passes over very large point sets",
                                  {}});
  registry.add({"column_generation",
                "the linear program of Example 2 by column generation over support mappings",
                std::move(of_column_generation), [](const Parameters& parameters) {
                  DistanceOptions options = options_from(DistanceMethod::column_generation, parameters);
                  options.threads = static_cast<int>(integer_parameter(parameters, "threads"));
                  return std::make_unique<DistanceMethodOfEngine>(options);
                }});
  registry.add(
      {"newton", "Newton steps on the dual with the Hessians of the support functions, for smooth sets",
       common_parameters(), [](const Parameters& parameters) {
         return std::make_unique<DistanceMethodOfEngine>(options_from(DistanceMethod::newton, parameters));
       }});
  registry.add({"object_distance",
                "two objects, A = A2 - A1, as scenes ask for them: fixed-size code first; all quantities",
                {},
                [](const Parameters& /*none*/) { return std::make_unique<ObjectMethod>(); }});
  std::vector<ParameterInfo> published = common_parameters();
  published.push_back(
      {"stop_rule",
       std::string("certified_gap"),
       {},
       {},
       "certified_gap: upper - lower <= tolerance * upper; published_sigma: |σ_k - 1| < tolerance",
       names_of(kStopRules)});
  registry.add({"zheng_yamane", "Algorithm 1 as published, warm-started as in Fig. 3c", std::move(published),
                [](const Parameters& parameters) {
                  DistanceOptions options = options_from(DistanceMethod::zheng_yamane, parameters);
                  options.stop_rule = kStopRules.at(string_parameter(parameters, "stop_rule"));
                  return std::make_unique<DistanceMethodOfEngine>(options);
                }});
}

}  // namespace raygauge
