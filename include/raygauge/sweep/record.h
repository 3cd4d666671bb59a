// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstdint>
#include <limits>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "raygauge/methods/result.h"
#include "raygauge/sweep/registry.h"

namespace raygauge {

/// What a SharedText is compared with.
template <class T>
concept PlainText = std::same_as<T, std::string> || std::same_as<T, std::string_view> ||
    std::convertible_to<const T&, const char*>;

/// A text of which a program sees few different ones, such as a name: each is kept once, to the end of the
/// program, and copies take the room of a pointer. Thread safe.
class SharedText {
 public:
  SharedText() : SharedText(std::string_view()) {}
  SharedText(std::string_view text) : text_(&kept(text)) {}        // NOLINT(google-explicit-constructor)
  SharedText(const std::string& text) : text_(&kept(text)) {}      // NOLINT(google-explicit-constructor)
  SharedText(const char* text) : text_(&kept(text)) {}             // NOLINT(google-explicit-constructor)
  operator const std::string&() const noexcept { return *text_; }  // NOLINT(google-explicit-constructor)
  operator std::string_view() const noexcept { return *text_; }    // NOLINT(google-explicit-constructor)
  const std::string& str() const noexcept { return *text_; }
  bool empty() const noexcept { return text_->empty(); }

  friend bool operator==(SharedText a, SharedText b) noexcept { return a.text_ == b.text_; }
  template <PlainText T>
  friend bool operator==(SharedText a, const T& b) {
    return *a.text_ == std::string_view(b);
  }
  friend bool operator<(SharedText a, SharedText b) noexcept {
    return a.text_ != b.text_ && *a.text_ < *b.text_;
  }
  friend std::ostream& operator<<(std::ostream& out, SharedText text) { return out << *text.text_; }
  friend std::string operator+(const std::string& a, SharedText b) { return a + *b.text_; }
  friend std::string operator+(SharedText a, const std::string& b) { return *a.text_ + b; }

 private:
  static const std::string& kept(std::string_view text);

  const std::string* text_;
};

/// One row of a results file: one method on one instance at one tolerance. The file's columns bear these
/// names.
struct Record {
  std::uint64_t cell = 0;           ///< index of the cell in the experiment's grid
  SharedText generator;             ///< registered name
  SharedText generator_parameters;  ///< "separation=1.5": every parameter, defaults included
  SharedText method;                ///< the label of the experiment ([[method]] label, or else its name)
  SharedText method_parameters;
  SharedText method_name;    ///< registered name
  Role role = Role::engine;  ///< whose the method is
  int n = 0;
  int N = 0;
  double tolerance = 0;
  std::uint64_t seed = 0;
  int repetition = 0;

  double seconds = 0;         ///< one solve: total time of the inner repetitions / their number
  int inner_repetitions = 1;  ///< solves timed together, because one alone is too short for the clock
  double load_seconds = 0;    ///< building the model (for engine methods: choosing the sets, next to nothing)

  double distance = 0;
  double lower = 0;  ///< NaN where nothing could be certified
  double upper = 0;
  double exact_distance = 0;           ///< the generator's truth; NaN where unknown
  double exact_distance_rounding = 0;  ///< its relative error; 0: exact for the doubles of the instance
  SharedText hardness_label;           ///< what `hardness` is, as in "1/δ"; empty where there is none
  double hardness = std::numeric_limits<double>::quiet_NaN();  ///< see Hardness
  DistanceStatus status = DistanceStatus::optimal;

  /// Whether this method's interval [lower, upper] meets those of all other methods on the instance, and the
  /// distance lies within the tolerance of them. Averages leave out the times of records that disagree.
  bool agrees = true;

  DistanceCounters counters;  ///< outer_iterations is K, ray_iterations is N_rs

  SharedText host;        ///< machine that ran it; set where it is stored
  int rank = 0;           ///< MPI rank that ran it, 0 without MPI; set where it is stored
  int thread = 0;         ///< OpenMP thread that ran it
  int concurrency = 1;    ///< threads that were solving during this run
  double started_at = 0;  ///< seconds since the session began
  int session = 0;        ///< which session of a resumed run made the record, from 0; set where it is stored
};

/// All records of one cell: the unit of scheduling, storing and resuming.
struct CellResult {
  std::uint64_t cell = 0;
  std::vector<Record> records;
};

/// Where finished cells go. Called from several threads; implementations lock.
class RecordSink {
 public:
  virtual ~RecordSink() = default;

  /// Takes a finished cell; when it returns, the cell survives a kill. Throws Error when it cannot be stored.
  virtual void store(const CellResult& cell) = 0;
};

}  // namespace raygauge
