// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "analysis/data/method_list.h"

namespace raygauge {

enum class Marker : unsigned char { circle, square, triangle, diamond, triangle_down };
enum class Dash : unsigned char { solid, dashed, dotted, dash_dotted };

/// How a method looks in every figure and on every page, whatever other methods are there.
struct MethodLook {
  std::string color;       ///< "#D55E00"; of Okabe and Ito, which colour-blind readers tell apart
  std::string dark_color;  ///< on dark paper
  Marker marker = Marker::circle;
  Dash dash = Dash::solid;
  bool filled = true;  ///< competitors have hollow markers
};

/// The look of a method by the registered name that `methods` has for its label, filled markers for
/// raygauge's own, by role. What the label says does not matter, but for a label that is not in the list: it
/// is taken for a name. The methods of this program have looks that differ in marker or dash, so that nothing
/// is lost in grey. Of several with one name the first by parameters has the look of the name. The others,
/// and methods that this program does not know, have one drawn from the letters of name and parameters, the
/// next one that is not alike() any look of this program or of another method in the list.
MethodLook look_of_method(const std::string& label, const MethodList& methods);

/// Whether readers would take one look for the other: one marker in colours that are near each other.
bool alike(const MethodLook& a, const MethodLook& b);

/// One line on what a method is, by its registered name, for readers of a page; "" for one that this program
/// does not know.
std::string what_method_is(const std::string& name);

}  // namespace raygauge
