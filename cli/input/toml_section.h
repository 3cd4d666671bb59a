// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "cli/input/toml_source.h"
#include "cli/input/toml_values.h"
#include "raygauge/exceptions.h"

namespace raygauge::cli {

/// A table of a TOML document. Keys that are absent leave alone what they would set.
class TomlSection {
 public:
  /// `name` stands before its keys in messages; "": it is the root.
  TomlSection(const toml::table& table, std::string name) : name_(std::move(name)), table_(&table) {}

  /// The section [name], which need not be there, with no keys but the `known` ones.
  TomlSection(const TomlSource& source, std::string name, const std::vector<std::string>& known)
      : name_(std::move(name)), table_(&source.root) {
    if (!name_.empty()) {
      const toml::node* node = source.root.get(name_);
      table_ = node == nullptr ? nullptr : node->as_table();
      if (node != nullptr && table_ == nullptr)
        throw InvalidParameterError(place_of(*node) + ": " + name_ + " must be a table, [" + name_ + "]");
    }
    if (table_ != nullptr) reject_unknown_keys(*table_, name_.empty() ? "key" : "[" + name_ + "] key", known);
  }

  /// `apply(node, full key)` if the key is there.
  template <class Apply>
  void with(const std::string& key, const Apply& apply) const {
    const toml::node* node = table_ == nullptr ? nullptr : table_->get(key);
    if (node != nullptr) apply(*node, name_.empty() ? key : name_ + "." + key);
  }

  template <class Integer>
  void integer(const std::string& key, const Range& range, Integer& value) const {
    with(key, [&](const toml::node& node, const std::string& full) {
      value = static_cast<Integer>(read_integer(node, full, range));
    });
  }
  void integers(const std::string& key, const Range& range, std::vector<int>& values) const {
    with(key, [&](const toml::node& node, const std::string& full) {
      const std::vector<std::int64_t> read = read_integers(node, full, range);
      values.assign(read.begin(), read.end());
    });
  }
  template <class Real>
  void real(const std::string& key, const Range& range, Real& value) const {
    with(key, [&](const toml::node& node, const std::string& full) { value = read_real(node, full, range); });
  }
  void reals(const std::string& key, const Range& range, std::vector<double>& values) const {
    with(key,
         [&](const toml::node& node, const std::string& full) { values = read_reals(node, full, range); });
  }
  void boolean(const std::string& key, bool& value) const {
    with(key, [&](const toml::node& node, const std::string& full) { value = read_boolean(node, full); });
  }
  void text(const std::string& key, std::string& value) const {
    with(key, [&](const toml::node& node, const std::string& full) { value = read_text(node, full); });
  }

  /// One of a few words.
  template <class T>
  void choice(const std::string& key, const std::vector<std::pair<std::string, T>>& choices, T& value) const {
    with(key, [&](const toml::node& node, const std::string& full) {
      const std::string word = read_text(node, full);
      std::vector<std::string> known;
      for (const auto& [name, meaning] : choices) {
        if (name == word) {
          value = meaning;
          return;
        }
        known.push_back(name);
      }
      throw UnknownNameError(full, word, known, place_of(node));
    });
  }

 private:
  std::string name_;
  const toml::table* table_ = nullptr;
};

}  // namespace raygauge::cli
