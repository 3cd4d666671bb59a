// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/component.h"

#include <cmath>
#include <memory>
#include <utility>

#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

void check_at_least(const std::string& owner, const char* what, int value, int minimum) {
  if (value >= minimum) return;
  throw InvalidParameterError(owner + ": " + what + " must be at least " + std::to_string(minimum) +
                              ", got " + std::to_string(value));
}

class FunctionGenerator final : public Generator {
 public:
  FunctionGenerator(const std::string& name, GenerateFunction function, int minimum_n, Parameters parameters)
      : owner_("generator '" + name + "'"),
        function_(function),
        minimum_n_(minimum_n),
        parameters_(std::move(parameters)) {}

  Instance generate(const InstanceKey& key) const override {
    check_at_least(owner_, "n", key.n, minimum_n_);
    check_at_least(owner_, "N", key.N, 1);
    check_at_least(owner_, "repetition", key.repetition, 0);
    return function_(key, parameters_);
  }

 private:
  std::string owner_;
  GenerateFunction function_;
  int minimum_n_;
  Parameters parameters_;
};

}  // namespace

Component<Generator> generator_component(std::string name, std::string description,
                                         std::vector<ParameterInfo> parameters, GenerateFunction generate,
                                         int minimum_n) {
  auto make = [name, generate, minimum_n](const Parameters& given) {
    return std::make_unique<FunctionGenerator>(name, generate, minimum_n, given);
  };
  return {std::move(name), std::move(description), std::move(parameters), std::move(make)};
}

Component<Generator> with_known_distance(Component<Generator> generator, double rounding) {
  generator.promises = {true, rounding};
  return generator;
}

double reciprocal(double value) { return 1 / value; }
double power_of_two(double value) { return std::exp2(value); }

}  // namespace raygauge
