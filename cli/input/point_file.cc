// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/point_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <system_error>
#include <vector>

#include "cli/input/input_file.h"
#include "cli/output/counted.h"
#include "engine/exceptions.h"

namespace raygauge::cli {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool is_separator(char c) { return c == ',' || c == ';'; }
bool ends_token(char c) { return is_blank(c) || is_separator(c) || c == '#'; }

/// The token as a message can show it: printable, on one line, not endless.
std::string quoted(std::string_view token) {
  constexpr std::size_t kLongest = 40;
  std::string text(token.substr(0, kLongest));
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; }, '?');
  return "'" + text + (token.size() > kLongest ? "…'" : "'");
}

class PointParser {
 public:
  PointParser(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  Eigen::MatrixXd parse() {
    if (text_.substr(0, kByteOrderMark.size()) == kByteOrderMark) text_.remove_prefix(kByteOrderMark.size());
    if (text_.find('\0') != std::string_view::npos) {
      throw InvalidParameterError(name_ + ": not a text file in UTF-8 or ASCII (it holds zero bytes)");
    }
    while (!text_.empty()) parse_line(next_line());
    if (values_.empty())
      throw EmptySetError(name_ + ": no points (the file is empty, or holds comments only)");
    return Eigen::MatrixXd::Map(values_.data(), n_, static_cast<std::ptrdiff_t>(values_.size()) / n_);
  }

 private:
  /// Cuts the next line off the text: it ends at LF, CR LF or CR.
  std::string_view next_line() {
    const std::size_t end = std::min(text_.find_first_of("\r\n"), text_.size());
    const std::string_view line = text_.substr(0, end);
    const std::size_t skip = text_.substr(end, 2) == "\r\n" ? 2 : 1;
    text_.remove_prefix(std::min(end + skip, text_.size()));
    ++line_number_;
    return line;
  }

  void parse_line(std::string_view line) {
    const std::size_t size_before = values_.size();
    const char* const begin = line.data();
    const char* const end = begin + line.size();
    const auto skip_blanks = [end](const char* at) { return std::find_if_not(at, end, is_blank); };
    const char* at = skip_blanks(begin);
    while (at != end && *at != '#') {
      const char* const token_end = std::find_if(at, end, ends_token);
      const auto column = at - begin + 1;
      if (token_end == at)
        throw InvalidParameterError(place(column) + "a coordinate is missing before this separator");
      values_.push_back(parse_number(at, token_end, column));
      at = skip_blanks(token_end);
      if (at == end || !is_separator(*at)) continue;
      at = skip_blanks(at + 1);
      if (at == end || *at == '#') {
        throw InvalidParameterError(place(at - begin + 1) +
                                    "a coordinate is missing after the last separator");
      }
    }
    if (values_.size() > size_before) check_length(static_cast<std::ptrdiff_t>(values_.size() - size_before));
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

  double parse_number(const char* begin, const char* end, std::ptrdiff_t column) const {
    const std::string_view token(begin, static_cast<std::size_t>(end - begin));
    // from_chars takes no plus sign.
    const char* const digits = *begin == '+' && end - begin > 1 && begin[1] != '-' ? begin + 1 : begin;
    double value = 0;
    const auto [stop, error] = std::from_chars(digits, end, value);
    if (error == std::errc::invalid_argument || stop != end) {
      throw InvalidParameterError(place(column) + quoted(token) + " is not a number" + header_hint());
    }
    // Out of range is overflow or underflow; strtod tells which.
    if (error == std::errc::result_out_of_range)
      value = std::strtod(std::string(digits, end).c_str(), nullptr);
    if (!std::isfinite(value)) throw NonFiniteError(place(column) + quoted(token) + non_finite_reason(token));
    return value;
  }

  static std::string non_finite_reason(std::string_view token) {
    const bool is_overflow = token.find_first_of("0123456789") != std::string_view::npos;
    return is_overflow ? " is too large for double precision" : " is not a finite number";
  }

  std::string header_hint() const { return values_.empty() ? " (a heading must start with '#')" : ""; }

  std::string place(std::ptrdiff_t column) const {
    return name_ + ":" + std::to_string(line_number_) + ":" + std::to_string(column) + ": ";
  }

  std::string_view text_;
  const std::string& name_;
  std::vector<double> values_;
  std::ptrdiff_t n_ = 0;
  std::ptrdiff_t line_number_ = 0;
  std::ptrdiff_t first_line_ = 0;
};

}  // namespace

Eigen::MatrixXd parse_points(std::string_view text, const std::string& name) {
  return PointParser(text, name).parse();
}

Eigen::MatrixXd read_point_file(const std::string& path) {
  return parse_points(read_input(path), input_name(path));
}

}  // namespace raygauge::cli
