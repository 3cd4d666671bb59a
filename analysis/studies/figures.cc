// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/figures.h"

#include "analysis/studies/accuracy/true_error.h"
#include "analysis/studies/accuracy/work_precision.h"
#include "analysis/studies/crossover/crossover_map.h"
#include "analysis/studies/example1/example1_figures.h"
#include "analysis/studies/performance_profile/performance_profile_figure.h"
#include "analysis/studies/scaling/time_vs_size.h"
#include "analysis/studies/table3/ratio_heatmap.h"
#include "analysis/studies/wrong_answers/wrong_share.h"

namespace raygauge {

const std::vector<Figure>& figures() {
  static const std::vector<Figure> kFigures = {
      {"time_vs_N", "median time of a solve against N, a panel for each n, a curve for each method",
       time_vs_N},
      {"time_vs_dimension", "median time of a solve against n, a panel for each N, a curve for each method",
       time_vs_dimension},
      {"ratio_heatmap", "ratio of time to the best baseline over (n, N), a panel for each method",
       ratio_heatmap},
      {"performance_profile", "share of the instances solved within a multiple of the fastest method's time",
       performance_profile_figure},
      {"crossover", "the fastest method over (n, N), and by how much", crossover_figure},
      {"true_error", "largest true error against conditioning or scale, a panel for each hard family",
       true_error_figure},
      {"fig5", "Figure 5: error, time and N_rs of Example 1 against the tolerance, A a truncated cone",
       figure5},
      {"fig7", "Figure 7: the same with the roles swapped, A an ellipsoid", figure7},
      {"work_precision", "true error and certified gap against time, tolerance by tolerance", work_precision},
      {"wrong_share", "share of wrong answers against time; about two bodies a panel for each place",
       wrong_share_figure},
  };
  return kFigures;
}

const Figure& figure_named(const std::string& name) {
  std::vector<std::string> known;
  for (const Figure& figure : figures()) {
    if (figure.name == name) return figure;
    known.push_back(figure.name);
  }
  throw UnknownNameError("figure", name, known);
}

}  // namespace raygauge
