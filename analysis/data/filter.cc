// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/data/filter.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>

#include "analysis/data/columns.h"
#include "analysis/data/filter_tokens.h"
#include "analysis/data/parameter_columns.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

using Predicate = std::function<bool(const Record&)>;
/// Extended precision holds a double and every 64-bit integer.
using Number = std::function<long double(const Record&)>;

struct ToExtended {
  long double operator()(const std::string&) const { return std::numeric_limits<long double>::quiet_NaN(); }
  template <class T>
  long double operator()(T value) const {
    return static_cast<long double>(value);
  }
};

Number number_column(const AnalysisColumn& column) {
  return [get = column.get](const Record& record) { return std::visit(ToExtended{}, get(record)); };
}

template <class T>
std::optional<T> parse_as(const std::string& text) {
  T value = 0;
  const char* begin = text.data() + (text.size() > 1 && text[0] == '+' ? 1 : 0);
  const auto [end, failure] = std::from_chars(begin, text.data() + text.size(), value);
  if (failure != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// An integer exactly; anything else as the double it is in a record: 1e-6 must equal a stored 1e-6.
std::optional<long double> parse_number(const std::string& text) {
  if (const auto integer = parse_as<std::uint64_t>(text)) return static_cast<long double>(*integer);
  if (const auto real = parse_as<double>(text)) return static_cast<long double>(*real);
  return std::nullopt;
}

template <class Value>
bool compare(const std::string& symbol, const Value& a, const Value& b) {
  if (symbol == "==") return a == b;
  if (symbol == "!=") return a != b;
  if (symbol == "<") return a < b;
  if (symbol == "<=") return a <= b;
  if (symbol == ">") return a > b;
  return a >= b;
}

bool is_comparison(const Token& token) {
  return token.kind == TokenKind::symbol &&
         (token.text == "==" || token.text == "!=" || token.text[0] == '<' || token.text[0] == '>');
}

/// Throws UnknownNameError for a name in front of a comparison that is neither a column nor a parameter of
/// any of the records.
void check_names(const std::string& expression, const std::vector<Record>& records) {
  const std::vector<Token> tokens = filter_tokens(expression);
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    if (tokens[i].kind == TokenKind::word && is_comparison(tokens[i + 1]) &&
        find_analysis_column(tokens[i].text) == nullptr)
      column_among(records, tokens[i].text, filter_place(expression, tokens[i].position));
  }
}

class Parser {
 public:
  explicit Parser(const std::string& expression)
      : expression_(expression), tokens_(filter_tokens(expression)) {}

  Predicate parse() {
    Predicate result = any();
    if (peek().kind != TokenKind::end) fail(peek(), "expected && or ||, found '" + peek().text + "'");
    return result;
  }

 private:
  /// One nested condition takes one frame of the stack to parse and one to ask.
  static constexpr int kDeepest = 200;

  const Token& peek() const { return tokens_[next_]; }

  const Token& take() { return tokens_[next_ + 1 < tokens_.size() ? next_++ : next_]; }

  bool accept(const std::string& symbol) {
    if (peek().kind != TokenKind::symbol || peek().text != symbol) return false;
    take();
    return true;
  }

  [[noreturn]] void fail(const Token& at, const std::string& what) const {
    throw InvalidParameterError(filter_complaint(expression_, at.position, what));
  }

  Predicate any() {
    std::vector<Predicate> terms = {all()};
    while (accept("||")) terms.push_back(all());
    if (terms.size() == 1) return terms.front();
    return [terms = std::move(terms)](const Record& record) {
      return std::any_of(terms.begin(), terms.end(), [&](const Predicate& term) { return term(record); });
    };
  }

  Predicate all() {
    std::vector<Predicate> terms = {one()};
    while (accept("&&")) terms.push_back(one());
    if (terms.size() == 1) return terms.front();
    return [terms = std::move(terms)](const Record& record) {
      return std::all_of(terms.begin(), terms.end(), [&](const Predicate& term) { return term(record); });
    };
  }

  Predicate one() {
    if (depth_ == kDeepest) {
      fail(peek(), "more than " + std::to_string(kDeepest) + " negations and parentheses within each other");
    }
    ++depth_;
    Predicate result = inner_one();
    --depth_;
    return result;
  }

  Predicate inner_one() {
    if (accept("!")) return [inner = one()](const Record& record) { return !inner(record); };
    if (peek().kind == TokenKind::symbol && peek().text == "(") {
      const Token opening = take();
      Predicate inner = any();
      if (!accept(")")) fail(opening, "the parenthesis that opens here is never closed");
      return inner;
    }
    return comparison();
  }

  const AnalysisColumn& known_column(const Token& name) const {
    const AnalysisColumn* column = find_analysis_column(name.text);
    return column != nullptr ? *column : analysis_column(name.text, filter_place(expression_, name.position));
  }

  /// Whether records have such a parameter is for filtered() to say.
  Predicate parameter_comparison(const Token& name) {
    const std::string symbol = take().text;
    const Token value = take_value(symbol);
    const auto number = value.kind == TokenKind::word ? parse_number(value.text) : std::nullopt;
    return [name = name.text, symbol, text = value.text, number](const Record& record) {
      const std::string own = parameter_text(record, name);
      if (own.empty()) return symbol == "!=";
      const auto own_number = parse_number(own);
      if (number && own_number) return compare(symbol, *own_number, *number);
      return compare(symbol, own, text);
    };
  }

  Token take_value(const std::string& symbol) {
    Token value = take();
    if (value.kind == TokenKind::symbol || value.kind == TokenKind::end)
      fail(value, "expected a value after " + symbol);
    return value;
  }

  Predicate comparison() {
    const Token name = take();
    if (name.kind != TokenKind::word)
      fail(name, "expected a column, found " + (name.text.empty() ? "the end" : "'" + name.text + "'"));
    if (at_comparison() && find_analysis_column(name.text) == nullptr) return parameter_comparison(name);
    const AnalysisColumn& column = known_column(name);
    if (!at_comparison()) return truth(column, name);
    const std::string symbol = take().text;
    const Token value = take_value(symbol);
    if (column.type == ValueType::text) return text_comparison(column, symbol, value.text);
    return number_comparison(column, symbol, value);
  }

  bool at_comparison() const { return is_comparison(peek()); }

  Predicate truth(const AnalysisColumn& column, const Token& name) const {
    if (column.type != ValueType::boolean)
      fail(name, "'" + name.text + "' is not a truth; compare it, as in " + name.text + " == VALUE");
    return [get = column.get](const Record& record) { return std::get<bool>(get(record)); };
  }

  static Predicate text_comparison(const AnalysisColumn& column, const std::string& symbol,
                                   const std::string& text) {
    return [get = column.get, symbol, text](const Record& record) {
      return compare(symbol, std::get<std::string>(get(record)), text);
    };
  }

  Predicate number_comparison(const AnalysisColumn& column, const std::string& symbol,
                              const Token& value) const {
    return [a = number_column(column), b = number(column, value), symbol](const Record& record) {
      return compare(symbol, a(record), b(record));
    };
  }

  Number number(const AnalysisColumn& left, const Token& value) const {
    const auto constant = [](long double x) { return Number([x](const Record&) { return x; }); };
    if (value.kind == TokenKind::word) {
      if (const auto parsed = parse_number(value.text)) return constant(*parsed);
      if (left.type == ValueType::boolean && value.text == "true") return constant(1);
      if (left.type == ValueType::boolean && value.text == "false") return constant(0);
      const AnalysisColumn* column = find_analysis_column(value.text);
      if (column != nullptr && column->type != ValueType::text) return number_column(*column);
    }
    fail(value, "'" + left.name + "' is a " + (left.type == ValueType::boolean ? "truth" : "number") + ", '" +
                    value.text + "' is not");
  }

  const std::string& expression_;
  std::vector<Token> tokens_;
  std::size_t next_ = 0;
  int depth_ = 0;
};

}  // namespace

Filter::Filter(const std::string& expression)
    : expression_(expression), passes_(Parser(expression).parse()) {}

std::vector<Record> filtered(const std::vector<Record>& records, const Filter& filter) {
  if (!records.empty()) check_names(filter.expression(), records);
  std::vector<Record> passing;
  std::copy_if(records.begin(), records.end(), std::back_inserter(passing), filter);
  return passing;
}

}  // namespace raygauge
