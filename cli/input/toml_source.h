// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <toml++/toml.h>

namespace raygauge::cli {

/// A TOML document and where it came from. Every value in it knows its place: "x.toml:7" for a value of the
/// file, "--set sweep.n=3" for one that replaced it.
struct TomlSource {
  std::string path;
  toml::table root;
  std::string text;  ///< the file as it stands or, with overrides, the document that resulted from them
};

/// Reads `path` and applies `overrides`, each "dotted.key=value" as in the file:
///   - the value in TOML syntax; a list may go without brackets, a word without quotes: 3,4 and serial,
///   - [[generator]] and [[method]] entries by name, label or position: method.glpk_dual.presolve=true; where
///     there is one entry only, the name may be left out: generator.separation=2.
/// A key that is not there is added; whether it is a known one is for the reader of the document to say.
/// Throws InvalidParameterError, with file and line: unreadable file, TOML syntax, malformed override.
TomlSource read_toml(const std::string& path, const std::vector<std::string>& overrides);

/// The document of `text`, which came from `place`.
TomlSource toml_from_text(const std::string& text, const std::string& place);

/// Where a node stands: "x.toml:7" or "--set sweep.n=3".
std::string place_of(const toml::node& node);
std::string place_of(const toml::key& key, const toml::node& value);

}  // namespace raygauge::cli
