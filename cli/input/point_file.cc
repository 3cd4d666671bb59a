// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/point_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "cli/input/input_file.h"
#include "cli/input/number_word.h"
#include "raygauge/exceptions.h"
#include "results/text/words.h"

namespace raygauge::cli {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool is_separator(char c) { return c == ',' || c == ';'; }
bool ends_token(char c) { return is_blank(c) || is_separator(c) || c == '#'; }

bool begins_with_number(const char* begin, const char* end) {
  double ignored = 0;
  const auto [stop, error] = std::from_chars(begin, end, ignored);
  return error != std::errc::invalid_argument && (stop == end || ends_token(*stop));
}

/// Reads blocks of a text as they come; a line that a block cuts is kept for the next one.
class PointParser {
 public:
  PointParser(const std::string& name, const PointFormat& format)
      : name_(name), skip_header_(format.skip_header), header_option_(format.header_option) {}

  void feed(std::string_view block) {
    if (block.empty()) return;
    if (std::memchr(block.data(), '\0', block.size()) != nullptr)
      throw InvalidParameterError(name_ + ": not a text file in UTF-8 or ASCII (it holds zero bytes)");
    const std::size_t last = block.rfind('\n');
    if (last == std::string_view::npos) {
      rest_ += block;
      return;
    }
    if (!rest_.empty()) {
      const std::size_t first = block.find('\n') + 1;
      rest_ += block.substr(0, first);
      parse_lines(rest_);
      rest_.clear();
      parse_lines(block.substr(first, last + 1 - first));
    } else {
      parse_lines(block.substr(0, last + 1));
    }
    rest_ = block.substr(last + 1);
  }

  Eigen::MatrixXd finish() {
    parse_lines(rest_);
    if (values_.empty())
      throw EmptySetError(name_ + ": no points (the file is empty, or holds comments only)");
    return Eigen::MatrixXd::Map(values_.data(), n_, static_cast<std::ptrdiff_t>(values_.size()) / n_);
  }

 private:
  /// What stands between the coordinates of a line.
  struct Separators {
    bool comma = false;
    bool semicolon = false;
    bool blank = false;  ///< alone
  };

  /// Lines end at LF, CR LF or CR; the last one may lack its end.
  void parse_lines(std::string_view text) {
    const char* at = text.data();
    const char* const end = at + text.size();
    while (at != end) {
      const auto left = static_cast<std::size_t>(end - at);
      const auto* newline = static_cast<const char*>(std::memchr(at, '\n', left));
      const char* stop = newline == nullptr ? end : newline;
      const auto* carriage =
          static_cast<const char*>(std::memchr(at, '\r', static_cast<std::size_t>(stop - at)));
      if (carriage != nullptr) stop = carriage;
      ++line_number_;
      parse_line(at, stop);
      const bool two = stop != end && *stop == '\r' && stop + 1 != end && stop[1] == '\n';
      at = std::min(stop + (two ? 2 : 1), end);
    }
  }

  void parse_line(const char* begin, const char* end) {
    if (line_number_ == 1 &&
        std::string_view(begin, static_cast<std::size_t>(end - begin)).starts_with(kByteOrderMark))
      begin += kByteOrderMark.size();
    const std::size_t size_before = values_.size();
    const auto skip_blanks = [end](const char* from) {
      while (from != end && is_blank(*from)) ++from;
      return from;
    };
    const auto at_end = [end](const char* from) { return from == end || *from == '#'; };
    const char* at = skip_blanks(begin);
    if (at_end(at)) return;
    if (std::exchange(skip_header_, false) && !begins_with_number(at, end)) return;
    Separators separators;
    while (true) {
      at = parse_number(at, end, begin);
      const char* next = skip_blanks(at);
      if (at_end(next)) break;
      if (!is_separator(*next)) {
        separators.blank = true;
      } else {
        (*next == ',' ? separators.comma : separators.semicolon) = true;
        next = skip_blanks(next + 1);
        if (at_end(next))
          throw InvalidParameterError(place(next - begin + 1) +
                                      "a coordinate is missing after the last separator");
      }
      at = next;
    }
    check_separators(separators);
    check_length(static_cast<std::ptrdiff_t>(values_.size() - size_before));
  }

  /// A comma beside another separator may be a decimal one: 2,5;0,5 would be four coordinates.
  void check_separators(const Separators& separators) const {
    if (!separators.comma || !(separators.semicolon || separators.blank)) return;
    throw InvalidParameterError(name_ + ": line " + std::to_string(line_number_) + " has commas beside " +
                                (separators.semicolon ? "semicolons" : "blanks") +
                                ": are they decimal commas? Write 2.5, not 2,5, or separate by commas alone");
  }

  void check_length(std::ptrdiff_t length) {
    if (n_ == 0) {
      n_ = length;
      first_line_ = line_number_;
    } else if (length != n_) {
      throw InvalidParameterError(name_ + ": line " + std::to_string(line_number_) + " has " +
                                  counted(length, "coordinate") + ", line " + std::to_string(first_line_) +
                                  " has " + std::to_string(n_));
    }
  }

  /// Stores the number at `at`, in the line [begin, end), and returns where it ends.
  const char* parse_number(const char* at, const char* end, const char* begin) {
    // from_chars takes no plus sign.
    const char* const digits = *at == '+' && end - at > 1 && at[1] != '-' ? at + 1 : at;
    double value = 0;
    const auto [stop, error] = std::from_chars(digits, end, value);
    if (error != std::errc() || !(stop == end || ends_token(*stop)) || !std::isfinite(value))
      return parse_oddity(at, std::find_if(at, end, ends_token), at - begin + 1);
    values_.push_back(value);
    return stop;
  }

  /// A token that is no plain number: an underflow, or a complaint.
  const char* parse_oddity(const char* begin, const char* end, std::ptrdiff_t column) {
    if (begin == end)
      throw InvalidParameterError(place(column) + "a coordinate is missing before this separator");
    const std::string_view token(begin, static_cast<std::size_t>(end - begin));
    const std::optional<double> value = number_of(token);
    if (!value)
      throw InvalidParameterError(place(column) + quoted(token) + " is not a number" + header_hint());
    if (!std::isfinite(*value))
      throw NonFiniteError(place(column) + quoted(token) + non_finite_reason(token));
    values_.push_back(*value);
    return end;
  }

  std::string header_hint() const {
    if (!values_.empty()) return "";
    return " (a heading must start with '#'" +
           (header_option_.empty() ? ")" : "; " + header_option_ + " skips one)");
  }

  std::string place(std::ptrdiff_t column) const {
    return name_ + ":" + std::to_string(line_number_) + ":" + std::to_string(column) + ": ";
  }

  const std::string& name_;
  bool skip_header_;
  const std::string header_option_;
  std::string rest_;
  std::vector<double> values_;
  std::ptrdiff_t n_ = 0;
  std::ptrdiff_t line_number_ = 0;
  std::ptrdiff_t first_line_ = 0;
};

}  // namespace

Eigen::MatrixXd parse_points(std::string_view text, const std::string& name, const PointFormat& format) {
  PointParser parser(name, format);
  parser.feed(text);
  return parser.finish();
}

Eigen::MatrixXd read_point_file(const std::string& path, const PointFormat& format) {
  constexpr std::size_t kBlock = 1 << 20;
  InputFile file(path);
  const std::string name = input_name(path);
  PointParser parser(name, format);
  std::string block(kBlock, '\0');
  while (const std::size_t size = file.read(block.data(), kBlock)) parser.feed({block.data(), size});
  return parser.finish();
}

}  // namespace raygauge::cli
