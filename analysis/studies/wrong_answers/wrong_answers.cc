// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/wrong_answers/wrong_answers.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "analysis/constants.h"
#include "analysis/data/parameter_columns.h"
#include "analysis/data/truth.h"
#include "analysis/statistics/statistics.h"
#include "engine/sweep/agreement.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

/// Gathers the records of one method.
class Tally {
 public:
  void add(const Record& record, const KnownDistance& known) {
    const Verdict verdict = verdict_on(record, known);
    ++answers_.asked;
    answers_.inexact += verdict == Verdict::inexact;
    answers_.wrong_sign += verdict == Verdict::wrong_sign;
    answers_.gave_up += verdict == Verdict::gave_up;
    answers_.limits += verdict == Verdict::limit;
    const double error = error_in_sizes(record, known);
    if (error > answers_.worst) answers_.worst = error;
    seconds_.push_back(time_or_infinity(record));
  }

  WrongAnswers of(const std::string& method) const {
    WrongAnswers answers = answers_;
    answers.method = method;
    answers.median_seconds = median(seconds_);
    return answers;
  }

 private:
  WrongAnswers answers_;
  std::vector<double> seconds_;
};

using Tallies = std::map<SharedText, Tally>;  ///< by method

/// What a part of the study is made of.
struct Part {
  Tallies all;
  std::map<std::string, Tallies> kinds;
};

std::vector<WrongAnswers> in_order(const Tallies& tallies, const MethodList& methods) {
  std::vector<WrongAnswers> rows;
  for (const std::string& method : methods) {
    const auto tally = tallies.find(method);
    if (tally != tallies.end()) rows.push_back(tally->second.of(method));
  }
  return rows;
}

using Question = std::pair<double, Quantity>;  ///< with its tolerance

WrongInPlace finished(const Question& asked, const std::string& place, const Part& part,
                      const MethodList& methods) {
  WrongInPlace result{asked.first, asked.second, place, in_order(part.all, methods), {}};
  for (const auto& [kind, tallies] : part.kinds) result.kinds.emplace_back(kind, in_order(tallies, methods));
  return result;
}

/// What the parameters of the generator say.
struct Bodies {
  Quantity quantity = Quantity::distance;
  double size = 1;
  std::string place;
  std::set<std::string> kinds;  ///< those that are named: of "any" none
};

Bodies read_bodies(const Record& record) {
  const auto text = [&record](const char* name) {
    return parameter_text(record, std::string("generator.") + name);
  };
  Bodies bodies;
  if (const std::string quantity = text("quantity"); !quantity.empty())
    bodies.quantity = quantity_from_string(quantity);
  if (const std::string scale = text("scale"); !scale.empty()) bodies.size = std::stod(scale);
  bodies.place = text("place");
  bodies.kinds = {text("kind_1"), text("kind_2")};
  bodies.kinds.erase("any");
  return bodies;
}

/// The same of millions of records, of which those of a cell follow each other.
const Bodies& bodies_of(const Record& record) {
  thread_local SharedText parameters;
  thread_local Bodies bodies;
  if (!(record.generator_parameters == parameters)) {
    bodies = read_bodies(record);
    parameters = record.generator_parameters;
  }
  return bodies;
}

}  // namespace

KnownDistances::InstanceName KnownDistances::name_of(const Record& record) {
  return {record.generator_parameters, record.n, record.N, record.seed, record.repetition};
}

KnownDistances::KnownDistances(const std::vector<Record>& records) {
  auto last = known_.end();  // the records of an instance follow each other
  for (const Record& record : records) {
    if (!is_of_bodies(record)) continue;
    const InstanceName name = name_of(record);
    if (last == known_.end() || last->first != name)
      last = known_.try_emplace(known_.end(), name, KnownDistance{0, kInfinity});
    KnownDistance& known = last->second;
    if (const double planted = record.exact_distance; !std::isnan(planted)) {
      const double rounding = record.exact_distance_rounding;
      known = {planted * (1 - rounding), planted * (1 + rounding)};
    } else if (record.role != Role::baseline) {
      if (record.lower > known.lower) known.lower = record.lower;  // a NaN proves nothing
      if (record.upper < known.upper) known.upper = record.upper;
    }
  }
}

KnownDistance KnownDistances::operator()(const Record& record) const {
  const InstanceName name = name_of(record);
  if (!last_ || last_->first != name) last_ = &*known_.find(name);
  return last_->second;
}

bool is_of_bodies(const Record& record) { return record.generator == "bodies"; }

double size_of_bodies(const Record& record) { return bodies_of(record).size; }

Quantity quantity_of(const Record& record) { return bodies_of(record).quantity; }

double unit_of_errors(const Record& record) {
  const Quantity asked = quantity_of(record);
  return asked == Quantity::distance || asked == Quantity::depth ? size_of_bodies(record) : 1;
}

double error_in_sizes(const Record& record, const KnownDistance& known) {
  const double claim = claimed_distance(record);
  const bool is_ratio = quantity_of(record) == Quantity::growth && known.lower > 1;
  const double unit = is_ratio ? known.lower : unit_of_errors(record);
  return std::max({known.lower - claim, claim - known.upper, std::isnan(claim) ? kNaN : 0.0}) / unit;
}

Verdict verdict_on(const Record& record, const KnownDistance& known) {
  const std::optional<double> claim = claim_of(record);
  if (!claim) return record.status == DistanceStatus::precision_limit ? Verdict::gave_up : Verdict::limit;
  if (std::isnan(*claim)) return Verdict::gave_up;
  const double error = error_in_sizes(record, known);
  const double touching = quantity_of(record) == Quantity::growth ? 1 : 0;
  const bool other_side = *claim > touching ? known.upper <= touching : known.lower > touching;
  if (other_side && error > kWrongSignBeyond) return Verdict::wrong_sign;
  return error > kWrongBeyond ? Verdict::inexact : Verdict::right;
}

WrongStudy wrong_answers(const std::vector<Record>& records, const Filter& filter) {
  const KnownDistances known(records);
  WrongStudy study;
  std::map<Question, std::pair<std::vector<std::string>, std::map<std::string, Part>>> by_question;
  for (const Record& record : records) {  // millions: not copied
    if (!is_of_bodies(record) || !filter(record)) continue;
    if (study.methods.find(record.method) == nullptr) study.methods.add(facts_of(record));
    const Bodies& bodies = bodies_of(record);
    auto& [order, parts] = by_question[{record.tolerance, bodies.quantity}];
    if (!parts.contains(bodies.place)) order.push_back(bodies.place);
    const KnownDistance distance = known(record);
    for (Part* part : {&parts[bodies.place], &parts[""]}) {
      part->all[record.method].add(record, distance);
      for (const std::string& kind : bodies.kinds) part->kinds[kind][record.method].add(record, distance);
    }
  }
  if (by_question.empty()) throw EmptySetError("no record of the generator bodies passes the filter");
  for (const auto& [asked, places] : by_question) {
    for (const std::string& place : places.first)
      study.places.push_back(finished(asked, place, places.second.at(place), study.methods));
    study.places.push_back(finished(asked, "", places.second.at(""), study.methods));
  }
  return study;
}

}  // namespace raygauge
