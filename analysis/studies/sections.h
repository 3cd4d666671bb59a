// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "analysis/studies/report.h"

namespace raygauge::report {

// The sections of the page, one file each. Each is nothing where the records lack its data.

/// What was run and where, and three lines of verdict. Always there.
std::optional<Section> summary_section(const Input& input);
/// Heat map of the ratio to the best baseline over (n, N), and Table III: needs a baseline.
std::optional<Section> ratios_section(const Input& input);
/// Time against N and against n with fitted exponents: needs two sizes.
std::optional<Section> scaling_section(const Input& input);
/// Median time against the mean true (else proven) error over the tolerances: needs two tolerances.
std::optional<Section> work_precision_section(const Input& input);
/// Dolan and Moré's profiles: needs two methods.
std::optional<Section> profiles_section(const Input& input);
/// Mean K and N_rs against ε, as Figures 5 and 7 of the paper: needs two tolerances and counted iterations.
std::optional<Section> iterations_section(const Input& input);
/// Which method wins where: needs two methods.
std::optional<Section> crossover_section(const Input& input);
/// How far each method can be trusted: needs known true distances.
std::optional<Section> stability_section(const Input& input);
/// Who is wrong about two bodies, how often, at what price: needs records of the generator `bodies`.
std::optional<Section> wrong_answers_section(const Input& input);
/// What each digit costs and where a method stops getting better: needs known true distances and two
/// tolerances.
std::optional<Section> accuracy_section(const Input& input);
/// Tables I and II of the paper beside what was measured: needs records of Example 1.
std::optional<Section> example1_section(const Input& input);
/// What each machine did and how the methods compare on it: needs records of two machines.
std::optional<Section> machines_section(const Input& input);
/// Machines, builds, versions and calibration of every session, and the experiments' texts. Always there.
std::optional<Section> provenance_section(const Input& input);
/// The records themselves, to download as CSV. Always there.
std::optional<Section> records_section(const Input& input);

}  // namespace raygauge::report
