// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/render/method_look.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>

namespace raygauge {
namespace {

struct KnownMethod {
  const char* name;
  const char* color;
  const char* dark_color;
  Marker marker;
  Dash dash;
  const char* what;
};

constexpr std::array<KnownMethod, 10> kKnown = {{
    {"column_generation", "#D55E00", "#D55E00", Marker::circle, Dash::solid,
     "raygauge: column generation; the linear program over the points met so far, certified"},
    {"zheng_yamane", "#0072B2", "#3D9BD9", Marker::square, Dash::solid,
     "raygauge: the ray-shooting algorithm of Zheng and Yamane"},
    {"newton", "#009E73", "#009E73", Marker::triangle, Dash::solid,
     "raygauge: sequential quadratic programming on smooth sets, certified"},
    {"glpk_primal", "#000000", "#FFFFFF", Marker::circle, Dash::dashed,
     "GLPK's primal simplex on the linear program (the paper's comparison)"},
    {"glpk_dual", "#8C8C8C", "#A8A8A8", Marker::square, Dash::dotted,
     "GLPK's dual simplex on the linear program"},
    {"clp_primal", "#56B4E9", "#56B4E9", Marker::triangle, Dash::dashed,
     "Clp's primal simplex on the linear program"},
    {"clp_dual", "#E69F00", "#E69F00", Marker::diamond, Dash::dotted,
     "Clp's dual simplex on the linear program"},
    {"exact", "#CC79A7", "#CC79A7", Marker::triangle_down, Dash::dash_dotted,
     "the linear program in rational arithmetic: the truth that answers are checked against"},
    {"nlopt_slsqp", "#6A3D9A", "#B79AD9", Marker::diamond, Dash::dashed,
     "NLopt's sequential quadratic programming on the convex program"},
    {"nlopt_mma", "#7A5C00", "#C9A83A", Marker::triangle_down, Dash::dotted,
     "NLopt's moving asymptotes on the convex program"},
}};

constexpr std::array<const char*, 6> kOtherColors = {"#B15928", "#1B7837", "#B2182B",
                                                     "#C51B7D", "#35978F", "#4D4D4D"};

const KnownMethod* known_method(const std::string& name) {
  for (const KnownMethod& each : kKnown)
    if (name == each.name) return &each;
  return nullptr;
}

/// FNV-1a: the same on every machine.
std::uint32_t letters_of(const std::string& text) {
  std::uint32_t hash = 2166136261U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  return hash;
}

/// A look from the letters of `text`, beside those of the known methods.
MethodLook drawn_look(const std::string& text, bool filled) {
  const std::uint32_t letters = letters_of(text);
  const char* color = kOtherColors.at(letters % kOtherColors.size());
  return {color, color, static_cast<Marker>(letters / 7 % 5), static_cast<Dash>(1 + letters / 37 % 3),
          filled};
}

/// The methods of one registered name in an order that does not depend on that of the records.
bool stands_before(const MethodFacts& a, const MethodFacts& b) {
  return std::tie(a.parameters, a.label) < std::tie(b.parameters, b.label);
}

/// Of several methods of one registered name the first one has the look of the name.
bool is_first_of_its_name(const MethodFacts& method, const MethodList& methods) {
  return std::none_of(methods.begin(), methods.end(), [&](const std::string& label) {
    const MethodFacts& other = *methods.find(label);
    return other.name == method.name && stands_before(other, method);
  });
}

bool is_there_twice(const MethodFacts& method, const MethodList& methods) {
  return std::any_of(methods.begin(), methods.end(), [&](const std::string& label) {
    const MethodFacts& other = *methods.find(label);
    return other.name == method.name && other.parameters == method.parameters && stands_before(other, method);
  });
}

}  // namespace

MethodLook look_of_method(const std::string& label, const MethodList& methods) {
  const MethodFacts* listed = methods.find(label);
  const MethodFacts method = listed != nullptr ? *listed : MethodFacts{label, label, "", Role::engine};
  const bool filled = !method.is_competitor();
  const KnownMethod* known = known_method(method.name);
  if (known != nullptr && is_first_of_its_name(method, methods))
    return {known->color, known->dark_color, known->marker, known->dash, filled};
  const std::string twin = is_there_twice(method, methods) ? ' ' + label : std::string();
  return drawn_look(method.name + ' ' + method.parameters + twin, filled);
}

std::string what_method_is(const std::string& name) {
  const KnownMethod* known = known_method(name);
  return known == nullptr ? "" : known->what;
}

}  // namespace raygauge
