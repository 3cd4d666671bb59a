// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Every string in every language: read back by the language itself where it can be.
#include "results/text/language.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "raygauge/exceptions.h"
#include "results/text/utf8.h"
#include "tests/results/support.h"

namespace raygauge::test_language {
namespace {

using testing::error_of;

/// Every byte, every character with a meaning somewhere, and what once ended a string.
std::vector<std::string> hostile_texts() {
  std::vector<std::string> texts = {"",
                                    "a b",
                                    "a\nb",
                                    "$(touch pwned)",
                                    "`touch pwned`",
                                    "'; touch pwned; '",
                                    "\"; touch pwned; \"",
                                    "\\",
                                    "\\\\'",
                                    "</script>",
                                    "<!--<script>",
                                    "a,b\"c\"",
                                    "-->",
                                    "]]>",
                                    "#",
                                    "%s%n",
                                    "\xff\xfe",
                                    "\xc3",
                                    "\xed\xa0\x80",
                                    "\xf0\x9f\x98\x80 ε"};
  for (int byte = 1; byte < 256; ++byte) texts.push_back("x" + std::string(1, static_cast<char>(byte)) + "y");
  return texts;
}

/// What a command prints.
std::string output_of(const std::string& command) {
  std::FILE* pipe = popen(command.c_str(), "r");
  std::string out;
  std::array<char, 4096> buffer{};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe))
    out.append(buffer.data(), count);
  EXPECT_EQ(pclose(pipe), 0) << command;
  return out;
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::string_view character = utf8::first_character(text);
    if (character.empty()) return false;
    text.remove_prefix(character.size());
  }
  return true;
}

TEST(Printable, ShowsControlCharactersByTheirPictures) {
  EXPECT_EQ(language::printable("a\nb\x1b[31m\x7f"), "a␊b␛[31m␡");
  EXPECT_EQ(language::printable(std::string_view("\0", 1)), "␀");
  EXPECT_EQ(language::printable("ε – 物 \xf0\x9f\x98\x80"), "ε – 物 \xf0\x9f\x98\x80");
}

TEST(Printable, ReplacesWhatIsNotUtf8OrTurnsTheDirectionOfWriting) {
  for (const char* broken :
       {"\xff", "\xc3", "\xe2\x82", "\xc0\xaf", "\xed\xa0\x80", "\xf5\x80\x80\x80", "\x80"})
    EXPECT_EQ(language::printable(broken).find("�"), 0U) << broken;
  EXPECT_EQ(language::printable("\xe2\x80\xae"
                                "a\xc2\x9b"
                                "b"),
            "�a�b");
}

TEST(Printable, IsOneLineOfUtf8OfEveryText) {
  for (const std::string& text : hostile_texts()) {
    const std::string shown = language::printable(text);
    EXPECT_TRUE(is_utf8(shown)) << text;
    EXPECT_EQ(shown.find('\n'), std::string::npos);
  }
}

TEST(Shell, GivesEveryTextBackAsOneWord) {
  std::string script;
  std::string expected;
  for (const std::string& text : hostile_texts()) {
    script += "printf '%s\\0' " + language::shell(text) + "\n";
    expected += text + '\0';
  }
  const testing::TemporaryFolder folder;
  testing::write_bytes(folder.file("words.sh"), script);
  EXPECT_EQ(output_of("cd " + folder.path() + " && bash words.sh"), expected);
  EXPECT_EQ(testing::entries_of(folder.path()), std::vector<std::string>{"words.sh"}) << "no command has run";
}

TEST(Shell, QuotesWhereItMustOnly) {
  EXPECT_EQ(language::shell("out/x-1.h5"), "out/x-1.h5");
  EXPECT_EQ(language::shell("sweep.n=3,4"), "sweep.n=3,4");
  EXPECT_EQ(language::shell("sweep.n=[3, 4]"), "'sweep.n=[3, 4]'");
  EXPECT_EQ(language::shell("it's"), "'it'\\''s'");
  EXPECT_EQ(language::shell(""), "''");
  EXPECT_EQ(error_of([] { language::shell(std::string_view("a\0b", 3)); }),
            "'a␀b': no word of a shell can hold a NUL");
}

TEST(Sbatch, QuotesOrRefuses) {
  EXPECT_EQ(language::sbatch("--time=1:00:00"), "--time=1:00:00");
  EXPECT_EQ(language::sbatch("--output=x y.log"), "\"--output=x y.log\"");
  EXPECT_EQ(language::sbatch("--comment=it's"), "\"--comment=it's\"");
  EXPECT_EQ(language::sbatch("--comment=a#b"), "\"--comment=a#b\"");
  for (const char* text : {"a\nb", "a\"b", "a\\b", "a\tb", "\xff"})
    EXPECT_NE(error_of([text] { language::sbatch(text); }), "") << text;
}

TEST(CsvField, QuotesWhatSeparatesOrEnds) {
  EXPECT_EQ(language::csv("plain text"), "plain text");
  EXPECT_EQ(language::csv("a,b"), "\"a,b\"");
  EXPECT_EQ(language::csv("say \"a\"\n"), "\"say \"\"a\"\"\n\"");
  EXPECT_EQ(language::csv("# a"), "\"# a\"");
}

TEST(Gnuplot, NeverEndsAString) {
  EXPECT_EQ(language::gnuplot("n 1"), "\"n 1\"");
  for (const std::string& text : hostile_texts()) {
    const std::string quoted = language::gnuplot(text);
    const std::string inside = quoted.substr(1, quoted.size() - 2);
    EXPECT_EQ(inside.find_first_of("\"\n\r`'!@$#"), std::string::npos) << text;
    for (std::size_t i = inside.find('\\'); i != std::string::npos; i = inside.find('\\', i + 1))
      EXPECT_GE(std::min(inside.find_first_not_of("01234567", i + 1), inside.size()), i + 5) << inside;
  }
}

TEST(Markup, HasNoTagAndNoQuote) {
  EXPECT_EQ(language::markup("<b a='\"'>&\n"), "&lt;b a=&#39;&quot;&#39;&gt;&amp;␊");
}

TEST(XmlAttribute, HoldsEveryTextOrRefusesIt) {
  EXPECT_EQ(language::xml_attribute("<b a='\"'>&é\x7F"), "&lt;b a=&#39;&quot;&#39;&gt;&amp;é\x7F");
  EXPECT_EQ(language::xml_attribute("a\nb\tc\rd"), "a&#10;b&#9;c&#13;d");
  for (const char* text : {"a\x01", "\x1B[0m", "\xFF", "\xEF\xBF\xBF"})
    EXPECT_NE(error_of([text] { language::xml_attribute(text); }), "") << text;
  EXPECT_NE(error_of([] { language::xml_attribute(std::string_view("\0", 1)); }), "");
}

TEST(Script, HasNoTag) {
  EXPECT_EQ(language::script("[\"<!--<script></script>\"]"), "[\"\\u003c!--\\u003cscript>\\u003c/script>\"]");
}

TEST(Markdown, HasNoMark) {
  EXPECT_EQ(language::markdown("a|b*_<i>`\n![x](y)&lt;$x$"),
            "a\\|b\\*\\_\\<i\\>\\`␊\\!\\[x\\](y)\\&lt;\\$x\\$");
}

TEST(Latex, ShowsEveryCharacter) {
  EXPECT_EQ(language::latex("50% of a_b & {c} $#~^\\"),
            "50\\% of a\\_b \\& \\{c\\} \\$\\#\\textasciitilde{}\\textasciicircum{}\\textbackslash{}");
  EXPECT_EQ(language::latex("a<b|c>d"), "a\\textless{}b\\textbar{}c\\textgreater{}d");
  EXPECT_EQ(language::latex("[2pt]*`x`\n\xff"),
            "{[}2pt{]}{*}\\textasciigrave{}x\\textasciigrave{}\\textbackslash{}x0A\\textbackslash{}xFF");
}

}  // namespace
}  // namespace raygauge::test_language
