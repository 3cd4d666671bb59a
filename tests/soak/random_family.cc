// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "tests/soak/random_family.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "raygauge/sets/point_set.h"

namespace raygauge::soak {
namespace {

struct Range {
  double first = 0;
  double last = 0;
};

// The dimensions, and how many of a thousand instances come from each band.
struct DimensionBand {
  int first;
  int last;
  double share;
};
constexpr std::array<DimensionBand, 8> kBands = {{{2, 2, 0.28},
                                                  {3, 3, 0.34},
                                                  {4, 4, 0.14},
                                                  {5, 6, 0.13},
                                                  {7, 9, 0.07},
                                                  {10, 14, 0.03},
                                                  {15, 25, 0.009},
                                                  {26, 50, 0.001}}};

int draw_dimension(RandomStream& stream) {
  double share = stream.uniform();
  for (const DimensionBand& band : kBands) {
    if (share < band.share) return static_cast<int>(stream.integer(band.first, band.last));
    share -= band.share;
  }
  return 2;
}

int draw_size(RandomStream& stream, int n) {
  const double kind = stream.uniform();
  if (kind < 0.6) return static_cast<int>(stream.integer(1, 2 * n + 4));
  if (kind < 0.95) return static_cast<int>(stream.integer(n + 1, 10 * n));
  return static_cast<int>(stream.integer(20, n <= 5 ? 400 : 120));
}

// Logarithmically uniform over ranges that span orders of magnitude, else uniform; the ends come up by
// themselves once in a while.
double draw_within(RandomStream& stream, const Range& range) {
  const double ends = stream.uniform();
  if (ends < 0.1) return ends < 0.05 ? range.first : range.last;
  if (!(range.first > 0) || range.last < 100 * range.first) {
    return range.first + stream.uniform() * (range.last - range.first);
  }
  const double log_ratio = std::log(range.last) - std::log(range.first);
  return std::clamp(range.first * std::exp(stream.uniform() * log_ratio), range.first, range.last);
}

Range near_default(const ParameterInfo& parameter, double value) {
  const double reach = 10 * std::fabs(value) + 1;
  const double low = parameter.minimum > 0 ? std::fabs(value) / 1e4 : value - reach;
  const double high = parameter.minimum > 0 ? std::fabs(value) * 1e4 : value + reach;
  return {std::max(low, parameter.minimum), std::min(high, parameter.maximum)};
}

double draw_number(RandomStream& stream, const ParameterInfo& parameter, double default_value) {
  if (stream.uniform() < 0.2) return default_value;
  const bool bounded = std::isfinite(parameter.minimum) && std::isfinite(parameter.maximum);
  const bool anywhere = bounded && stream.uniform() < 0.5;
  return draw_within(stream, anywhere ? Range{parameter.minimum, parameter.maximum}
                                      : near_default(parameter, default_value));
}

ParameterValue draw_value(RandomStream& stream, const ParameterInfo& parameter) {
  const ParameterValue& given = parameter.default_value;
  if (std::holds_alternative<bool>(given)) return stream.uniform() < 0.5;
  if (std::holds_alternative<std::int64_t>(given)) {
    return std::llround(draw_number(stream, parameter, static_cast<double>(std::get<std::int64_t>(given))));
  }
  if (std::holds_alternative<double>(given)) return draw_number(stream, parameter, std::get<double>(given));
  if (parameter.choices.empty()) return given;
  const auto last = static_cast<std::int64_t>(parameter.choices.size()) - 1;
  return parameter.choices[static_cast<std::size_t>(stream.integer(0, last))];
}

}  // namespace

std::vector<std::string> point_set_generators(const GeneratorRegistry& registry) {
  std::vector<std::string> names;
  for (const std::string& name : registry.names()) {
    const Instance instance = registry.make(name, {})->generate({1, 3, 20, 0});
    if (dynamic_cast<const PointSet*>(instance.A.get()) != nullptr &&
        dynamic_cast<const PointSet*>(instance.Q.get()) != nullptr) {
      names.push_back(name);
    }
  }
  return names;
}

RandomFamily draw_family(const GeneratorRegistry& registry, const std::vector<std::string>& names,
                         RandomStream& stream) {
  RandomFamily family;
  const auto last = static_cast<std::int64_t>(names.size()) - 1;
  family.generator = names[static_cast<std::size_t>(stream.integer(0, last))];
  for (const ParameterInfo& parameter : registry.find(family.generator).parameters) {
    family.parameters[parameter.name] = draw_value(stream, parameter);
  }
  family.key.seed = stream.bits();
  family.key.n = draw_dimension(stream);
  family.key.N = draw_size(stream, family.key.n);
  return family;
}

}  // namespace raygauge::soak
