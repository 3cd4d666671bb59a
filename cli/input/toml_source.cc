// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/toml_source.h"

#include <cstdint>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

#include "cli/input/input_file.h"
#include "cli/input/toml_keys.h"
#include "raygauge/exceptions.h"

namespace raygauge::cli {
namespace {

constexpr std::string_view kOverrideMark = "--set ";

/// An override has no lines.
std::string line_text(const std::string& path, std::uint32_t line) {
  return path.starts_with(kOverrideMark) ? path : path + ":" + std::to_string(line);
}

std::string region_text(const toml::source_region& source) {
  // What --set has made stands in no file.
  if (!source.path && source.begin.line == 0) return "--set";
  return line_text(source.path ? *source.path : std::string(), source.begin.line);
}

/// Where a node stands. A table that --set has made stands where its first value does.
const toml::source_region& source_of(const toml::node& node) {
  const toml::table* table = node.as_table();
  const bool is_made = !node.source().path && table != nullptr && !table->empty();
  return is_made ? source_of(table->begin()->second) : node.source();
}

[[noreturn]] void reject_endless_key(const std::string& place) {
  throw InvalidParameterError(place + ": a key of more than " + std::to_string(kMostKeyParts) + " parts");
}

toml::table parse_bounded(const std::string& text, const std::string& path) {
  if (const std::uint32_t line = line_of_endless_key(text); line > 0)
    reject_endless_key(line_text(path, line));
  return toml::parse(text, path);
}

toml::table parse(const std::string& text, const std::string& path) {
  try {
    return parse_bounded(text, path);
  } catch (const toml::parse_error& error) {
    std::string message(error.description());
    for (char& c : message) c = c == '\n' ? ' ' : c;
    throw InvalidParameterError(region_text(error.source()) + ": " + message);
  }
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// A word that needs no quotes on the command line: serial, glpk_dual, out-2.
bool is_word(const std::string& text) {
  return !text.empty() && text.find_first_not_of(
                              "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                              "0123456789_-.") == std::string::npos;
}

/// The table {value = TEXT}; empty if TEXT is not TOML.
std::optional<toml::table> parse_value(const std::string& text, const std::string& mark) {
  try {
    return parse_bounded("value = " + text, mark);
  } catch (const toml::parse_error&) {
    return std::nullopt;
  }
}

/// An item as TOML: itself, or in quotes if it is a word.
std::string quoted_if_word(const std::string& item, const std::string& mark) {
  if (parse_value(item, mark)) return item;
  if (is_word(item)) return '"' + item + '"';
  throw InvalidParameterError(mark + ": '" + item + "' is no TOML value");
}

/// TEXT as TOML if it is, else as a list without brackets, words without quotes.
toml::table override_value(const std::string& text, const std::string& mark) {
  if (auto value = parse_value(text, mark)) return std::move(*value);
  std::string items;
  for (const std::string& part : split(text, ',')) {
    if (!items.empty()) items += ", ";
    items += quoted_if_word(trimmed(part), mark);
  }
  const bool is_list = text.find(',') != std::string::npos;
  auto value = parse_value(is_list ? "[" + items + "]" : items, mark);
  if (!value) throw InvalidParameterError(mark + ": '" + text + "' is no TOML value");
  return std::move(*value);
}

bool is_called(const toml::table& entry, const std::string& name) {
  return entry["name"].value<std::string>() == name || entry["label"].value<std::string>() == name;
}

/// The entry of an array of tables that the rest of a key speaks of; `next` moves past a part that chose it.
toml::table& chosen_entry(toml::array& entries, const std::vector<std::string>& parts, std::size_t& next,
                          const std::string& mark) {
  for (std::size_t i = 0; i < entries.size(); ++i) {
    toml::table* entry = entries[i].as_table();
    if (entry != nullptr && (is_called(*entry, parts[next]) || std::to_string(i) == parts[next])) {
      ++next;
      return *entry;
    }
  }
  if (entries.size() == 1 && entries[0].is_table()) return *entries[0].as_table();
  std::string names;
  for (const toml::node& entry : entries) {
    const toml::table* table = entry.as_table();
    if (table == nullptr) continue;
    const auto name = (*table)[table->contains("label") ? "label" : "name"].value<std::string>();
    names += (names.empty() ? "" : ", ") + name.value_or("?");
  }
  throw InvalidParameterError(mark + ": '" + parts[next] + "' is none of the " +
                              std::to_string(entries.size()) + " [[" + parts[next - 1] + "]] entries (" +
                              names + "); write " + parts[next - 1] + ".NAME." + parts[next] + "=VALUE");
}

/// The table that holds the last part of a key, created where it is missing.
toml::table& owner_of(toml::table& root, const std::vector<std::string>& parts, std::size_t& next,
                      const std::string& mark) {
  toml::table* table = &root;
  while (next + 1 < parts.size()) {
    toml::node* node = table->get(parts[next]);
    if (node == nullptr) node = &table->insert(parts[next], toml::table()).first->second;
    ++next;
    if (toml::array* entries = node->as_array(); entries != nullptr && entries->is_array_of_tables()) {
      table = &chosen_entry(*entries, parts, next, mark);
    } else if (node->is_table()) {
      table = node->as_table();
    } else {
      throw InvalidParameterError(mark + ": '" + parts[next - 1] +
                                  "' is a value or a list of values, not a table");
    }
  }
  return *table;
}

void apply_override(toml::table& root, const std::string& text) {
  const std::string mark = std::string(kOverrideMark) + text;
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw InvalidParameterError(mark + ": expected KEY=VALUE, as in sweep.n=3,4");
  }
  const std::vector<std::string> parts = split(trimmed(text.substr(0, equals)), '.');
  if (parts.size() > kMostKeyParts) reject_endless_key(mark);
  toml::table value = override_value(trimmed(text.substr(equals + 1)), mark);
  std::size_t next = 0;
  toml::table& owner = owner_of(root, parts, next, mark);
  if (next == parts.size()) throw InvalidParameterError(mark + ": a key of this entry is missing");
  value.get("value")->visit([&](auto& node) { owner.insert_or_assign(parts[next], std::move(node)); });
}

std::string effective_text(const toml::table& root, const std::string& path,
                           const std::vector<std::string>& overrides) {
  std::ostringstream text;
  text << "# " << path;
  for (const std::string& override_text : overrides) text << " --set " << override_text;
  text << "\n" << toml::toml_formatter(root) << "\n";
  return text.str();
}

}  // namespace

std::string place_of(const toml::node& node) { return region_text(source_of(node)); }

std::string place_of(const toml::key& key, const toml::node& value) {
  return region_text(key.source().begin.line > 0 ? key.source() : source_of(value));
}

TomlSource toml_from_text(const std::string& text, const std::string& place) {
  return {place, parse(text, place), text};
}

TomlSource read_toml(const std::string& path, const std::vector<std::string>& overrides) {
  TomlSource source;
  source.path = input_name(path);
  source.text = read_text_input(path);
  source.root = parse(source.text, source.path);
  for (const std::string& text : overrides) apply_override(source.root, text);
  if (!overrides.empty()) source.text = effective_text(source.root, source.path, overrides);
  return source;
}

}  // namespace raygauge::cli
