// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "raygauge/exceptions.h"

namespace raygauge {

/// gnuplot is not there, or refused a script. The message is one line: what is missing, or gnuplot's first
/// complaint.
class GnuplotError : public Error {
 public:
  using Error::Error;
};

/// Of a PNG.
inline constexpr double kPrintPixelsAnInch = 300;

enum class ImageFormat : std::uint8_t { svg, png, pdf, eps, tikz };

/// The extensions of file names: .svg, .png, .pdf, .eps, and .tikz or .tex for TikZ.
const std::vector<std::string>& image_extensions();

/// By the extension of a file name. Throws InvalidParameterError for any other.
ImageFormat image_format_of(const std::string& path);

/// The picture that a gnuplot script draws, as the bytes of a file. `script` is all but the terminal;
/// width and height are in inches, and sizes of fonts in points hold for the printed picture (PNG: 300
/// pixels an inch). The same script gives the same SVG. Throws GnuplotError.
std::string draw_with_gnuplot(const std::string& script, ImageFormat format, double width, double height);

}  // namespace raygauge
