// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace raygauge {

/// A text of gnuplot's enhanced mode as LaTeX sets it: 10^{-6} as mathematics, \_ as _, and what is special
/// to LaTeX escaped. What stands between dollars is mathematics already.
std::string tex_of_enhanced(const std::string& text);

/// What gnuplot's terminal tikz drew, whose texts are the script's, with the texts as LaTeX sets them.
std::string with_tex_texts(const std::string& picture);

}  // namespace raygauge
