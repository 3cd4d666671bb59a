// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "analysis/data/filter.h"
#include "analysis/data/method_list.h"
#include "analysis/render/table.h"
#include "raygauge/sweep/instance.h"
#include "raygauge/sweep/record.h"

namespace raygauge {

/// An answer about two bodies is wrong where it is off by more than this part of their size (of 1, of growth
/// distances and of "separated?") ...
inline constexpr double kWrongBeyond = 1e-6;
/// ... or where it has the wrong sign (that bodies apart meet, or the reverse) and is off by more than this
/// part.
inline constexpr double kWrongSignBeyond = 1e-9;

/// What is known of the distance of the two bodies, or of what else was asked: it lies in [lower, upper].
struct KnownDistance {
  double lower = 0;
  double upper = 0;  ///< +∞ where nothing is known
};

/// What the records know of each instance of two bodies: the planted distance with its rounding, or else what
/// methods of raygauge have proven, all of them together. For one thread at a time.
class KnownDistances {
 public:
  explicit KnownDistances(const std::vector<Record>& records);
  KnownDistance operator()(const Record& record) const;

 private:
  using InstanceName = std::tuple<SharedText, int, int, std::uint64_t, int>;
  static InstanceName name_of(const Record& record);
  std::map<InstanceName, KnownDistance> known_;
  mutable const std::pair<const InstanceName, KnownDistance>* last_ = nullptr;  ///< that was asked for
};

/// Whether a record is of two bodies: its generator is `bodies`, which says their size.
bool is_of_bodies(const Record& record);

/// What was asked of the bodies: the parameter `quantity`.
Quantity quantity_of(const Record& record);

/// The size of the bodies, the parameter `scale` ...
double size_of_bodies(const Record& record);
/// ... and what errors of the record are measured by: that, or 1 of what has no unit.
double unit_of_errors(const Record& record);

enum class Verdict : std::uint8_t {
  right,
  inexact,     ///< off by more than kWrongBeyond, on the right side of 0 (of 1, of growth distances)
  wrong_sign,  ///< off by more than kWrongSignBeyond, on the other side of that
  gave_up,     ///< no answer: the solver threw an exception or said that it failed (`precision_limit`)
  limit,       ///< no answer within the limit of time or iterations
};

/// Of an answer beside what is known. By how much it is off: the distance from the claim to [lower, upper].
Verdict verdict_on(const Record& record, const KnownDistance& known);

/// By how much the claim of a record is off, in unit_of_errors(), of growth distances above 1 in what is
/// known of them; NaN without a claim.
double error_in_sizes(const Record& record, const KnownDistance& known);

/// How often one method is wrong.
struct WrongAnswers {
  std::string method;
  std::size_t asked = 0;
  std::size_t inexact = 0, wrong_sign = 0, gave_up = 0, limits = 0;  ///< of each Verdict
  double worst = 0;           ///< largest error_in_sizes() of an answer
  double median_seconds = 0;  ///< of a solve, no answer counting as infinitely slow

  std::size_t wrong() const noexcept { return inexact + wrong_sign; }
  double wrong_share() const { return static_cast<double>(wrong()) / static_cast<double>(asked); }
};

/// How often each method is wrong about one quantity in one place at one tolerance; the place "" is all of
/// them together.
struct WrongInPlace {
  double tolerance = 0;
  Quantity quantity = Quantity::distance;
  std::string place;
  std::vector<WrongAnswers> methods;
  /// By kind of body, as far as a place is named: the pairs of which one body at least is of that kind.
  std::vector<std::pair<std::string, std::vector<WrongAnswers>>> kinds;
};

struct WrongStudy {
  MethodList methods;
  std::vector<WrongInPlace>
      places;  ///< by tolerance and quantity; in order of first appearance, all places last
};

/// Of the records of two bodies that pass the filter; what is known may come from others. Throws
/// EmptySetError if there is none.
WrongStudy wrong_answers(const std::vector<Record>& records, const Filter& filter = {});

/// For reading, for each tolerance and quantity: a table by place and method, one by place and kind.
std::vector<Table> wrong_answers_tables(const WrongStudy& study);

/// For CSV: a row for each tolerance, quantity, place, kind and method; "all" for all of them.
Table wrong_answers_long_table(const WrongStudy& study);

}  // namespace raygauge
