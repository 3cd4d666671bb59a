// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/render/method_look.h"

#include <array>
#include <cstdint>

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

constexpr std::array<const char*, 6> kOtherColors = {"#B15928", "#1B7837", "#5E3C99",
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

}  // namespace

MethodLook look_of_method(const std::string& method, const MethodList& methods) {
  const bool filled = !methods.is_competitor(method);
  if (const KnownMethod* known = known_method(method))
    return {known->color, known->dark_color, known->marker, known->dash, filled};
  const std::uint32_t letters = letters_of(method);
  const char* color = kOtherColors.at(letters % kOtherColors.size());
  return {color, color, static_cast<Marker>(letters / 7 % 5), static_cast<Dash>(1 + letters / 37 % 3),
          filled};
}

std::string what_method_is(const std::string& name) {
  const KnownMethod* known = known_method(name);
  return known == nullptr ? "" : known->what;
}

}  // namespace raygauge
