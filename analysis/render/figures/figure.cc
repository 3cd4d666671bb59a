// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/render/figures/figure.h"

#include <utility>

#include "analysis/render/figures/description.h"

namespace raygauge {

FigureSize figure_size_from_string(const std::string& name) {
  if (name == "single") return FigureSize::single;
  if (name == "double") return FigureSize::double_wide;
  throw UnknownNameError("figure size", name, {"single", "double"});
}

double width_of(FigureSize size) {
  constexpr double kSingle = 3.5;
  constexpr double kDouble = 7.16;
  return size == FigureSize::single ? kSingle : kDouble;
}

std::vector<std::string> draw(const Figure& figure, const std::vector<Record>& records,
                              const FigureOptions& options, ImageFormat format) {
  Drawing first = figure.make(records, options);
  std::vector<Drawing> pages = std::move(first.next_pages);
  pages.insert(pages.begin(), std::move(first));
  std::vector<std::string> pictures;
  for (std::size_t p = 0; p < pages.size(); ++p) {
    std::string title = figure.name;
    if (pages.size() > 1) title += ", page " + std::to_string(p + 1) + " of " + std::to_string(pages.size());
    pictures.push_back(described(draw_with_gnuplot(pages[p].script, format, pages[p].width, pages[p].height),
                                 format, title, figure.description));
  }
  return pictures;
}

}  // namespace raygauge
