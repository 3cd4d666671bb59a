// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/render/formats/text_table.h"

#include <algorithm>
#include <vector>

#include "results/text/language.h"

namespace raygauge {
namespace {

constexpr std::size_t kGap = 2;

/// Characters on the screen: code points, for texts without combining marks.
std::size_t display_width(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::vector<std::size_t> column_widths(const Table& table) {
  std::vector<std::size_t> widths(table.header.empty() ? 0 : table.header.front().size(), 0);
  for (std::size_t c = 0; c < widths.size(); ++c) {
    for (const auto& line : table.header)
      widths[c] = std::max(widths[c], display_width(language::printable(line[c])));
    for (const TableRow& row : table.rows)
      widths[c] = std::max(widths[c], display_width(language::printable(row.cells[c].text)));
  }
  return widths;
}

std::string colored(const std::string& text, Emphasis emphasis, bool color) {
  if (!color || emphasis == Emphasis::none || text.empty()) return text;
  const char* code = emphasis == Emphasis::strong ? "1" : emphasis == Emphasis::muted ? "2" : "1;31";
  return "\033[" + std::string(code) + "m" + text + "\033[0m";
}

TableCell printable(TableCell cell) {
  cell.text = language::printable(cell.text);
  return cell;
}

/// The columns that are printed side by side: keys, and values from `begin` to `end`.
struct Block {
  std::size_t begin = 0;
  std::size_t end = 0;
};

std::vector<Block> blocks_of(const Table& table, const std::vector<std::size_t>& widths, std::size_t width) {
  std::size_t keys = 0;
  for (std::size_t c = 0; c < table.key_columns; ++c) keys += widths[c] + kGap;
  std::vector<Block> blocks;
  std::size_t begin = table.key_columns;
  while (begin < widths.size()) {
    std::size_t end = begin;
    std::size_t used = keys - (table.key_columns > 0 ? 0 : kGap);
    while (end < widths.size() && (end == begin || width == 0 || used + widths[end] <= width)) {
      used += widths[end] + kGap;
      ++end;
    }
    blocks.push_back({begin, end});
    begin = end;
  }
  if (blocks.empty()) blocks.push_back({begin, begin});
  return blocks;
}

class BlockPrinter {
 public:
  BlockPrinter(const Table& table, const std::vector<std::size_t>& widths, Block block, bool color)
      : table_(table), widths_(widths), color_(color) {
    for (std::size_t c = 0; c < table.key_columns; ++c) columns_.push_back(c);
    for (std::size_t c = block.begin; c < block.end; ++c) columns_.push_back(c);
  }

  std::string print() const {
    std::string text;
    for (const auto& header : table_.header)
      text += line([&](std::size_t c) { return TableCell{header[c]}; });
    text += std::string(total_width(), '-') + "\n";
    for (const TableRow& row : table_.rows) {
      if (row.starts_group && &row != &table_.rows.front()) text += "\n";
      text += line([&](std::size_t c) { return row.cells[c]; });
    }
    return text;
  }

 private:
  template <class CellOf>
  std::string line(const CellOf& cell_of) const {
    std::string text;
    std::size_t pending = 0;  // blanks are written only before something: lines have none at their end
    for (const std::size_t c : columns_) {
      const TableCell cell = printable(cell_of(c));
      const std::size_t blanks = widths_[c] - display_width(cell.text);
      const bool left = c < table_.key_columns;
      if (!left) pending += blanks;
      if (!cell.text.empty()) {
        text += std::string(pending, ' ') + colored(cell.text, cell.emphasis, color_);
        pending = 0;
      }
      pending += kGap + (left ? blanks : 0);
    }
    return text + "\n";
  }

  std::size_t total_width() const {
    std::size_t total = 0;
    for (const std::size_t c : columns_) total += widths_[c] + kGap;
    return total > kGap ? total - kGap : 0;
  }

  const Table& table_;
  const std::vector<std::size_t>& widths_;
  bool color_;
  std::vector<std::size_t> columns_;
};

}  // namespace

std::string text_table(const Table& table, std::size_t width, bool color) {
  const std::vector<std::size_t> widths = column_widths(table);
  std::string text;
  if (!table.title.empty())
    text += colored(language::printable(table.title), Emphasis::strong, color) + "\n\n";
  const std::vector<Block> blocks = blocks_of(table, widths, width);
  for (const Block& block : blocks) {
    if (&block != &blocks.front()) text += "\n";
    text += BlockPrinter(table, widths, block, color).print();
  }
  if (!table.notes.empty()) text += "\n";
  for (const std::string& note : table.notes) text += language::printable(note) + "\n";
  return text;
}

}  // namespace raygauge
