// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/render/figures/description.h"

#include <zlib.h>

#include <cmath>
#include <cstdint>

#include "results/text/language.h"

namespace raygauge {
namespace {

/// Replaces what stands between the first <tag> and </tag>.
void replace_element(std::string& svg, const std::string& tag, const std::string& text) {
  const std::size_t begin = svg.find("<" + tag + ">");
  const std::size_t end = svg.find("</" + tag + ">", begin);
  if (begin == std::string::npos || end == std::string::npos) return;
  const std::size_t inside = begin + tag.size() + 2;
  svg.replace(inside, end - inside, language::markup(text));
}

std::string big_endian(std::uint32_t number) {
  std::string bytes;
  for (const unsigned shift : {24U, 16U, 8U, 0U}) bytes += static_cast<char>(number >> shift & 0xFFU);
  return bytes;
}

/// The chunk pHYs (PNG specification, 11.3.4.3) for so many pixels an inch.
std::string physical_size_chunk(double pixels_an_inch) {
  constexpr double kInch = 0.0254;  // metres
  const auto per_metre = static_cast<std::uint32_t>(std::lround(pixels_an_inch / kInch));
  const std::string data = "pHYs" + big_endian(per_metre) + big_endian(per_metre) + std::string(1, 1);
  const auto check = static_cast<std::uint32_t>(
      crc32(0, reinterpret_cast<const Bytef*>(data.data()), static_cast<uInt>(data.size())));
  return big_endian(static_cast<std::uint32_t>(data.size() - 4)) + data + big_endian(check);
}

}  // namespace

std::string described(std::string picture, ImageFormat format, const std::string& title,
                      const std::string& description) {
  if (format == ImageFormat::svg) {
    replace_element(picture, "title", title);
    replace_element(picture, "desc", description);
    const std::size_t root = picture.find("<svg");
    if (root != std::string::npos) picture.insert(root + 4, " role=\"img\"");
  }
  if (format == ImageFormat::png) {
    constexpr std::size_t kAfterHeader = 8 + 25;  // the signature and the chunk IHDR
    if (picture.size() > kAfterHeader) picture.insert(kAfterHeader, physical_size_chunk(kPrintPixelsAnInch));
  }
  return picture;
}

}  // namespace raygauge
