// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace raygauge::language {

// Text put into another language. Names of bodies, queries, methods and files are a stranger's: each language
// has one function, which expresses every string or refuses it, and nothing else may put a text into it. JSON
// is written by nlohmann's dump(), TOML by nobody.

/// A text on a line that people read, as valid UTF-8: control characters, which could drive a terminal or end
/// the line, become their pictures (a line feed is ␊); what is not UTF-8, and what turns the direction of
/// writing, becomes U+FFFD.
std::string printable(std::string_view text);

/// A field of a CSV file (RFC 4180), quoted where it must be; read back, it is the same bytes.
std::string csv(std::string_view text);

/// A word of bash. Throws InvalidParameterError for a text with a NUL, which no word can hold.
std::string shell(std::string_view text);

/// A word of a line that begins with #SBATCH. Throws InvalidParameterError for a text that Slurm cannot read
/// back: with control characters, double quotes, backslashes or bytes that are not UTF-8.
std::string sbatch(std::string_view text);

/// A string of gnuplot, with its quotes, that its enhanced mode shows as printable(text): letters, digits,
/// blanks and characters beyond ASCII as they are, all others by their number, so that none has a meaning.
std::string gnuplot(std::string_view text);

/// printable(text) within an element or an attribute of HTML or SVG.
std::string markup(std::string_view text);

/// The value of an attribute of XML 1.0, without its quotes; read back, it is the same bytes. Throws
/// InvalidParameterError for a text that no XML file can hold: with bytes that are not UTF-8, U+FFFE, U+FFFF,
/// or control characters other than tabs and ends of lines.
std::string xml_attribute(std::string_view text);

/// JSON within a script element of HTML: no "<" can begin or end anything there.
std::string script(std::string_view json);

/// printable(text) within a line or a cell of Markdown.
std::string markdown(std::string_view text);

/// `text` so that LaTeX sets it as it stands: its special characters escaped, Greek letters and mathematical
/// signs (ε, µ, ≤, …) as mathematics; control characters and bytes that are not UTF-8 by their number, as
/// \x0A.
std::string latex(std::string_view text);

}  // namespace raygauge::language
