// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/render/figures/problem_pages.h"

#include <algorithm>
#include <exception>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "analysis/data/parameter_columns.h"
#include "analysis/render/figures/style.h"
#include "engine/numerics/number_text.h"
#include "results/text/words.h"

namespace raygauge {
namespace {

/// The name of a problem, by what is not the same in all records.
class ProblemNames {
 public:
  explicit ProblemNames(const std::vector<Record>& records) : parameters_(records) {
    for (const Record& record : records) {
      generators_.insert(record.generator);
      tolerances_.insert(record.tolerance);
    }
  }

  std::string of(const Record& record) const {
    std::vector<std::string> words;
    if (generators_.size() > 1) words.push_back(record.generator);
    const std::string parameters = parameters_.of_generator(record);
    if (!parameters.empty()) words.push_back(parameters);
    if (tolerances_.size() > 1) words.push_back("ε = " + rounded_text(record.tolerance, 6));
    return joined(words, ", ");
  }

 private:
  VaryingParameters parameters_;
  std::set<std::string> generators_;
  std::set<double> tolerances_;
};

/// In order of first appearance.
std::vector<Problem> problems_of(const std::vector<Record>& records) {
  const ProblemNames names(records);
  std::map<std::tuple<std::string, std::string, double>, std::size_t> places;
  std::vector<Problem> problems;
  for (const Record& record : records) {
    const auto [place, is_new] = places.try_emplace(
        {record.generator, record.generator_parameters, record.tolerance}, problems.size());
    if (is_new) problems.push_back({names.of(record), {}});
    problems[place->second].records.push_back(record);
  }
  return problems;
}

std::string first_names(const std::vector<Problem>& problems) {
  constexpr std::size_t kShown = 3;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < kShown; ++i) names.push_back(problems[i].name);
  return joined(names, "; ");
}

}  // namespace

Drawing page_for_each_problem(const std::string& figure, const std::vector<Record>& records,
                              const Filter& filter, const std::function<Drawing(const Problem&)>& draw_one) {
  const std::vector<Problem> problems =
      problems_of(figure_style::comparable_records(figure, records, filter));
  if (problems.size() > kMostProblems) {
    throw FigureNeedsError("figure " + figure +
                           " draws a page for each generator, its parameters and tolerance, " +
                           "and there are " + std::to_string(problems.size()) + " (" + first_names(problems) +
                           "; …); choose with --where");
  }
  std::vector<Drawing> pages;
  std::exception_ptr missing;
  for (const Problem& problem : problems) {
    try {
      pages.push_back(draw_one(problem));
    } catch (const FigureNeedsError&) {
      missing = std::current_exception();
    }
  }
  if (pages.empty()) std::rethrow_exception(missing);
  Drawing first = std::move(pages.front());
  first.next_pages.assign(std::make_move_iterator(pages.begin() + 1), std::make_move_iterator(pages.end()));
  return first;
}

}  // namespace raygauge
