// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "cli/input/shapes.h"
#include "cli/input/toml_source.h"

namespace raygauge::cli {

/// Whether `source` names a set file: it ends in .toml.
bool is_set_file(const std::string& source);

/// How the sets are read that a set file names by a file of their own; a relative name has been given the
/// folder of the set file. Throws Error.
using ReadNamedSet = std::function<SetPointer(const std::string& source)>;

/// Called with every other file that a set is made of, a mesh, after the same folder.
using NoteNamedFile = std::function<void(const std::string& path)>;

/// The set that a TOML file describes,
///
///     shape = "capsule"      # a name of shapes()
///     p = [0, 0, 1]          # every parameter of the shape, and nothing else
///     q = [0, 0, 3]
///     radius = 0.5
///
/// where a set among the parameters is a table of the same kind, up to kDeepestSet of them inside one
/// another. Throws Error, with file and line: unreadable file, TOML syntax, unknown shape or key, a missing
/// key, values that the shape does not take.
SetPointer read_set_file(const std::string& path, const ReadNamedSet& read_named,
                         const NoteNamedFile& note_file = {});

/// The set of one such table inside a file of another kind, whose relative names start at `folder`.
SetPointer read_set_table(const toml::table& table, const std::filesystem::path& folder,
                          const ReadNamedSet& read_named);

inline constexpr int kDeepestSet = 16;

}  // namespace raygauge::cli
