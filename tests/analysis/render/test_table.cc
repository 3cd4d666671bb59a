// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/render/table.h"

#include <gtest/gtest.h>

#include "analysis/render/formats/latex_table.h"
#include "raygauge/exceptions.h"

namespace raygauge::test_table {
namespace {

Table sample() {
  Table table;
  table.title = "Times in µs";
  table.header = {{"", "N=200", "N=400"}, {"method", "ours", "ours"}};
  table.key_columns = 1;
  table.rows = {{{{"zheng_yamane"}, {"1.5", 1.5000000000000002}, {"20", 20, Emphasis::strong}}, false},
                {{{"glpk, dual"}, {"300", 300}, {""}}, true}};
  table.notes = {"all agree at ε ≤ 1e-6"};
  return table;
}

std::string rendered(TableFormat format) {
  RenderOptions options;
  options.format = format;
  return render(sample(), options);
}

TEST(Table, AsTextIsAligned) {
  EXPECT_EQ(rendered(TableFormat::text),
            "Times in µs\n"
            "\n"
            "              N=200  N=400\n"
            "method         ours   ours\n"
            "--------------------------\n"
            "zheng_yamane    1.5     20\n"
            "\n"
            "glpk, dual      300\n"
            "\n"
            "all agree at ε ≤ 1e-6\n");
}

TEST(Table, AsTextIsContinuedBelowWhereTheTerminalIsNarrow) {
  RenderOptions options;
  options.width = 20;
  EXPECT_EQ(render(sample(), options),
            "Times in µs\n"
            "\n"
            "              N=200\n"
            "method         ours\n"
            "-------------------\n"
            "zheng_yamane    1.5\n"
            "\n"
            "glpk, dual      300\n"
            "\n"
            "              N=400\n"
            "method         ours\n"
            "-------------------\n"
            "zheng_yamane     20\n"
            "\n"
            "glpk, dual\n"
            "\n"
            "all agree at ε ≤ 1e-6\n");
}

TEST(Table, AsTextHasColoursOnlyWhereAskedFor) {
  RenderOptions options;
  EXPECT_EQ(render(sample(), options).find('\033'), std::string::npos);
  options.color = true;
  EXPECT_NE(render(sample(), options).find("\033[1m20\033[0m"), std::string::npos);
}

TEST(Table, AsMarkdownIsAPipeTable) {
  EXPECT_EQ(rendered(TableFormat::markdown),
            "**Times in µs**\n"
            "\n"
            "| method | N=200<br>ours | N=400<br>ours |\n"
            "| --- | ---: | ---: |\n"
            "| zheng\\_yamane | 1.5 | **20** |\n"
            "| glpk, dual | 300 |  |\n"
            "\n"
            "- all agree at ε ≤ 1e-6\n");
}

TEST(Table, AsLatexIsEscaped) {
  EXPECT_EQ(rendered(TableFormat::latex),
            "\\begin{table}\n"
            "\\centering\n"
            "\\caption{Times in $\\mu$s}\n"
            "\\begin{tabular}{lrr}\n"
            "  \\hline\n"
            "   & N=200 & N=400 \\\\\n"
            "  method & ours & ours \\\\\n"
            "  \\hline\n"
            "  zheng\\_yamane & 1.5 & \\textbf{20} \\\\\n"
            "  \\hline\n"
            "  glpk, dual & 300 &  \\\\\n"
            "  \\hline\n"
            "\\end{tabular}\n"
            "\n"
            "\\footnotesize\n"
            "all agree at $\\varepsilon$ $\\le$ 1e-6\\par\n"
            "\\end{table}\n");
}

TEST(Table, AsCsvHasNumbersInFullAndQuotesWhatNeedsIt) {
  EXPECT_EQ(rendered(TableFormat::csv),
            "method,N=200 ours,N=400 ours\n"
            "zheng_yamane,1.5000000000000002,20\n"
            "\"glpk, dual\",300,\n");
}

TEST(Table, MustBeARectangle) {
  Table table = sample();
  table.rows[0].cells.pop_back();
  EXPECT_THROW(render(table), DimensionMismatchError);
}

TEST(TableFormat, IsChosenByName) {
  EXPECT_EQ(table_format_from_string("latex"), TableFormat::latex);
  EXPECT_THROW(table_format_from_string("html"), UnknownNameError);
}

}  // namespace
}  // namespace raygauge::test_table
