// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/render/method_look.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

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
    {"paper", "#8C8C8C", "#A8A8A8", Marker::circle, Dash::solid, "what the paper published"},
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

std::array<int, 3> channels_of(const std::string& color) {
  std::array<int, 3> channels{};
  for (std::size_t k = 0; k < 3; ++k) channels.at(k) = std::stoi(color.substr(1 + 2 * k, 2), nullptr, 16);
  return channels;
}

MethodLook look_of(const KnownMethod& known, bool filled) {
  return {known.color, known.dark_color, known.marker, known.dash, filled};
}

/// The number of looks that are drawn from: colours, markers and dashes.
constexpr std::uint32_t kMarkers = 5;
constexpr std::uint32_t kDashes = 3;
constexpr std::uint32_t kDrawn = kOtherColors.size() * kMarkers * kDashes;

/// A look from the letters of `text`, the first after it that is free.
MethodLook drawn_look(const std::string& text, bool filled, const std::vector<MethodLook>& taken) {
  const std::uint32_t letters = letters_of(text);
  MethodLook look;
  for (std::uint32_t turn = 0; turn < kDrawn; ++turn) {
    const std::uint32_t place = (letters + turn) % kDrawn;
    look.color = look.dark_color = kOtherColors.at(place % kOtherColors.size());
    look.marker = static_cast<Marker>(place / kOtherColors.size() % kMarkers);
    look.dash = static_cast<Dash>(1 + place / (kOtherColors.size() * kMarkers));
    look.filled = filled;
    if (std::none_of(taken.begin(), taken.end(), [&](const MethodLook& other) { return alike(look, other); }))
      return look;
  }
  return look;
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

bool alike(const MethodLook& a, const MethodLook& b) {
  constexpr int kNear = 110;  // of 441: closer colours are one colour in a small marker
  if (a.marker != b.marker) return false;
  const std::array<int, 3> p = channels_of(a.color), q = channels_of(b.color);
  int squares = 0;
  for (std::size_t k = 0; k < 3; ++k) squares += (p.at(k) - q.at(k)) * (p.at(k) - q.at(k));
  return squares < kNear * kNear;
}

MethodLook look_of_method(const std::string& label, const MethodList& methods) {
  const MethodFacts* listed = methods.find(label);
  const MethodFacts method = listed != nullptr ? *listed : MethodFacts{label, label, "", Role::engine};
  const KnownMethod* known = known_method(method.name);
  if (known != nullptr && is_first_of_its_name(method, methods))
    return look_of(*known, !method.is_competitor());

  std::vector<MethodFacts> drawn = {method};
  for (const std::string& other : methods) {
    const MethodFacts& facts = *methods.find(other);
    const bool has_name_look = known_method(facts.name) != nullptr && is_first_of_its_name(facts, methods);
    if (!has_name_look && facts.label != method.label) drawn.push_back(facts);
  }
  std::sort(drawn.begin(), drawn.end(), [](const MethodFacts& a, const MethodFacts& b) {
    return std::tie(a.name, a.parameters, a.label) < std::tie(b.name, b.parameters, b.label);
  });
  std::vector<MethodLook> taken;
  for (const KnownMethod& each : kKnown) taken.push_back(look_of(each, true));
  for (const MethodFacts& each : drawn) {
    const std::string twin = is_there_twice(each, methods) ? ' ' + each.label : std::string();
    taken.push_back(drawn_look(each.name + ' ' + each.parameters + twin, !each.is_competitor(), taken));
    if (each.label == method.label) break;
  }
  return taken.back();
}

std::string what_method_is(const std::string& name) {
  const KnownMethod* known = known_method(name);
  return known == nullptr ? "" : known->what;
}

}  // namespace raygauge
