// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace raygauge::cli {

/// The sources, in alphabetical order, whose file's name matches the pattern (`*`, `?`, `[a-z]`, as in a
/// shell) below `folder`; relative to it as the pattern is. A pattern without these characters, or that is
/// the name of a file itself, is what comes back. A dataset behind the name, FILE.h5:/DATASET, may be a
/// pattern as well, of the datasets of points in the file. Throws InvalidParameterError where nothing
/// matches, and for standard input.
std::vector<std::string> matching_sources(const std::string& pattern, const std::filesystem::path& folder);

/// What the first to the last of these characters of `pattern` stand for in a source that matches it; ""
/// where there are none.
std::string matched_text(const std::string& pattern, const std::string& source);

/// A short name for each source: that of the file without folder and extensions, with the dataset behind it;
/// the source itself where another one has the same short name.
std::map<std::string, std::string> short_names(const std::vector<std::string>& sources);

}  // namespace raygauge::cli
