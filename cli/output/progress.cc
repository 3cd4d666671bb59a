// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/output/progress.h"

#include "cli/output/terminal.h"
#include "results/text/words.h"

namespace raygauge::cli {
namespace {

constexpr int kBarWidth = 30;

}  // namespace

ProgressDisplay::ProgressDisplay(std::FILE* stream, std::uint64_t resumed_cells, const char* unit)
    : stream_(stream), in_place_(is_terminal(stream)), resumed_cells_(resumed_cells), unit_(unit) {}

ProgressDisplay::~ProgressDisplay() { clear(); }

void ProgressDisplay::show(const SweepProgress& progress) {
  const std::uint64_t done = resumed_cells_ + progress.cells_done;
  const std::uint64_t total = resumed_cells_ + progress.cells_total;
  const std::string text = std::to_string(done) + " of " + counted(total, unit_) + ", " +
                           duration_text(progress.elapsed_seconds) + " so far, about " +
                           duration_text(progress.remaining_seconds) + " left";
  const double fraction = static_cast<double>(done) / static_cast<double>(total);
  if (in_place_) {
    draw_bar(text, fraction);
    return;
  }
  const int tenths = static_cast<int>(10 * fraction);
  if (tenths == tenths_shown_) return;
  tenths_shown_ = tenths;
  std::fprintf(stream_, "%s\n", text.c_str());
  std::fflush(stream_);
}

void ProgressDisplay::draw_bar(const std::string& text, double fraction) {
  const int filled = static_cast<int>(kBarWidth * fraction);
  const std::string bar = std::string(filled, '#') + std::string(kBarWidth - filled, '-');
  std::fprintf(stream_, "\r\033[K[%s] %s", bar.c_str(), text.c_str());
  std::fflush(stream_);
  bar_on_screen_ = true;
}

void ProgressDisplay::clear() {
  if (!bar_on_screen_) return;
  std::fputs("\r\033[K", stream_);
  std::fflush(stream_);
  bar_on_screen_ = false;
}

}  // namespace raygauge::cli
