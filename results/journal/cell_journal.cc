// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/journal/cell_journal.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "results/disk/run_directory.h"
#include "results/exceptions.h"
#include "results/journal/csv.h"
#include "results/schema/schema.h"

namespace raygauge {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kCellMark = "# cell ";

std::string format_mark() { return "# " + std::string(kFormatName) + ", schema version "; }

std::string journal_head() { return format_mark() + std::to_string(kSchemaVersion) + "\n" + csv_header(); }

/// `path`, where there is now a journal without cells.
fs::path created(const fs::path& path) {
  write_part(path, journal_head());
  return path;
}

/// The line before the rows of a cell.
std::string cell_heading(std::uint64_t cell, std::string_view rows) {
  std::array<char, 9> checksum{};
  std::snprintf(checksum.data(), checksum.size(), "%08lx",
                ::crc32_z(0, reinterpret_cast<const Bytef*>(rows.data()), rows.size()));
  return std::string(kCellMark) + std::to_string(cell) + ": " + std::to_string(rows.size()) +
         " bytes, CRC-32 " + checksum.data() + "\n";
}

/// The number at the front of `text`, which is taken off.
std::optional<std::uint64_t> take_number(std::string_view& text) {
  std::uint64_t number = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
  return number;
}

struct JournalCell {
  std::uint64_t cell;
  std::string_view rows;
  std::size_t size;  ///< of heading and rows
};

/// The cell at the front of `text`, if it is whole.
std::optional<JournalCell> whole_cell(std::string_view text) {
  const std::string_view heading = text.substr(0, std::min(text.find('\n'), text.size() - 1) + 1);
  std::string_view rest = heading.substr(std::min(kCellMark.size(), heading.size()));
  const auto cell = take_number(rest);
  rest.remove_prefix(std::min<std::size_t>(2, rest.size()));
  const auto size = take_number(rest);
  if (!cell || !size || *size == 0 || *size > text.size() - heading.size()) return std::nullopt;
  const std::string_view rows = text.substr(heading.size(), *size);
  if (cell_heading(*cell, rows) != heading) return std::nullopt;
  return JournalCell{*cell, rows, heading.size() + rows.size()};
}

/// The columns of the journal that `text` is; its head is taken off.
CsvColumns take_head(std::string_view& text, const std::string& file) {
  const std::string mark = format_mark();
  std::string_view rest = text.substr(std::min(mark.size(), text.size()));
  const auto version = text.starts_with(mark) ? take_number(rest) : std::nullopt;
  if (!version || !rest.starts_with('\n')) throw ResultsError(file + ": not a journal of raygauge's cells");
  constexpr std::uint64_t kLargest = std::numeric_limits<std::int64_t>::max();
  require_schema_version(file, static_cast<std::int64_t>(std::min(*version, kLargest)), kReadSchemas);
  rest.remove_prefix(1);
  const std::string_view header = rest.substr(0, std::min(rest.find('\n'), rest.size() - 1) + 1);
  rest.remove_prefix(header.size());
  text = rest;
  try {
    return csv_columns(header, record_columns());
  } catch (const ResultsError& error) {
    throw ResultsError(file + ": has other columns than a journal of cells: " + error.what());
  }
}

std::vector<Record> records_of(const JournalCell& cell, const CsvColumns& columns, const std::string& file) {
  const std::string place = file + ": cell " + std::to_string(cell.cell);
  std::vector<Record> records;
  try {
    records = read_csv_rows(cell.rows, columns);
  } catch (const ResultsError& error) {
    throw ResultsError(place + ": " + error.what());
  }
  for (const Record& record : records) {
    if (record.cell != cell.cell) throw ResultsError(place + " holds records of another cell");
  }
  return records;
}

}  // namespace

CellJournal::CellJournal(const fs::path& path) : file_(created(path)) {}

void CellJournal::append(std::uint64_t cell, const std::vector<Record>& records) {
  const std::string rows = csv_rows(records);
  file_.append(cell_heading(cell, rows) + rows);
}

std::vector<Record> read_cell_journal(const fs::path& path) {
  const std::string bytes = file_bytes(path);
  std::string_view rest(bytes);
  const CsvColumns columns = take_head(rest, path.string());
  std::vector<Record> records;
  std::set<std::pair<std::uint64_t, int>> known;
  std::set<std::uint64_t> headed;  // cells of which a piece was read
  while (!rest.empty()) {
    if (const auto cell = whole_cell(rest)) {
      rest.remove_prefix(cell->size);
      std::vector<Record> part;
      try {
        part = records_of(*cell, columns, path.string());
      } catch (const ResultsError&) {
        if (headed.count(cell->cell) == 0) throw;
        continue;  // a damaged heading, which now tells of a cell that was there before
      }
      headed.insert(cell->cell);
      const int first_repetition = part.empty() ? 0 : part.front().repetition;
      if (!known.emplace(cell->cell, first_repetition).second) continue;  // again, after an error of the disk
      records.insert(records.end(), std::make_move_iterator(part.begin()),
                     std::make_move_iterator(part.end()));
    } else {
      rest.remove_prefix(std::min(rest.find(kCellMark, 1), rest.size()));
    }
  }
  return records;
}

}  // namespace raygauge
