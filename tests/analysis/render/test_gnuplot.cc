// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/render/gnuplot.h"

#include <gtest/gtest.h>
#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): setenv is POSIX

#include <string>

#include "tests/analysis/records.h"

namespace raygauge::test_gnuplot {
namespace {

using testing::message_of;

constexpr const char* kLine = "plot x\n";

/// Sets PATH for the length of a test.
class PathOverride {
 public:
  explicit PathOverride(const std::string& path) : saved_(getenv("PATH")) { setenv("PATH", path.c_str(), 1); }
  ~PathOverride() { setenv("PATH", saved_.c_str(), 1); }
  PathOverride(const PathOverride&) = delete;
  PathOverride& operator=(const PathOverride&) = delete;

 private:
  std::string saved_;
};

TEST(Gnuplot, DrawsEachFormat) {
  const std::string svg = draw_with_gnuplot(kLine, ImageFormat::svg, 3, 2);
  EXPECT_NE(svg.find("<svg"), std::string::npos);
  EXPECT_NE(svg.find("width=\"288\" height=\"192\""), std::string::npos) << "96 pixels an inch";
  EXPECT_TRUE(svg.ends_with("</svg>\n\n")) << svg.substr(svg.size() - 20);
  EXPECT_TRUE(draw_with_gnuplot(kLine, ImageFormat::png, 3, 2).starts_with("\x89PNG\r\n"));
  EXPECT_TRUE(draw_with_gnuplot(kLine, ImageFormat::pdf, 3, 2).starts_with("%PDF-"));
  EXPECT_TRUE(draw_with_gnuplot(kLine, ImageFormat::eps, 3, 2).starts_with("%!PS-Adobe-3.0 EPSF"));
  const std::string tikz =
      draw_with_gnuplot("set xlabel 'ε = 10^{-6} at 95 %'\n" + std::string(kLine), ImageFormat::tikz, 3, 2);
  EXPECT_TRUE(tikz.starts_with("\\begin{tikzpicture}"));
  EXPECT_NE(tikz.find("{$\\varepsilon$ = 10$^{-6}$ at 95 \\%}"), std::string::npos) << tikz;
}

TEST(Gnuplot, DrawsTheSamePictureAgain) {
  EXPECT_EQ(draw_with_gnuplot(kLine, ImageFormat::svg, 3, 2),
            draw_with_gnuplot(kLine, ImageFormat::svg, 3, 2));
}

TEST(Gnuplot, PassesAComplaintOnAsOneLine) {
  const std::string message =
      message_of<GnuplotError>([] { draw_with_gnuplot("nonsense\n", ImageFormat::svg, 3, 2); });
  EXPECT_TRUE(message.starts_with("gnuplot failed: ")) << message;
  EXPECT_NE(message.find("invalid command"), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos);
}

TEST(Gnuplot, SaysWhatToInstallWhereItIsMissing) {
  const PathOverride path("/nonexistent");
  EXPECT_EQ(message_of<GnuplotError>([] { draw_with_gnuplot(kLine, ImageFormat::svg, 3, 2); }),
            "gnuplot is not installed, figures need it: apt-get install gnuplot-nox");
}

TEST(ImageFormat, FollowsTheExtension) {
  EXPECT_EQ(image_format_of("a/b.svg"), ImageFormat::svg);
  EXPECT_EQ(image_format_of("b.png"), ImageFormat::png);
  EXPECT_EQ(image_format_of("b.x.pdf"), ImageFormat::pdf);
  EXPECT_EQ(image_format_of("b.eps"), ImageFormat::eps);
  EXPECT_EQ(image_format_of("b.tikz"), ImageFormat::tikz);
  EXPECT_EQ(message_of<InvalidParameterError>([] { image_format_of("b.jpg"); }),
            "b.jpg: a figure is a file ending in .svg, .png, .pdf, .eps, .tikz or .tex");
}

}  // namespace
}  // namespace raygauge::test_gnuplot
