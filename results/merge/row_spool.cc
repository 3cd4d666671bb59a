// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/merge/row_spool.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

#include "results/disk/atomic_file.h"
#include "results/exceptions.h"

namespace raygauge {

RowSpool::RowSpool(const std::filesystem::path& beside)
    : path_(beside.string() + "." + std::to_string(::getpid()) + ".rows.tmp") {
  descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  if (descriptor_ < 0) throw ResultsError(path_.string() + ": cannot create: " + system_reason(errno));
  ::unlink(path_.c_str());
}

RowSpool::~RowSpool() { ::close(descriptor_); }

void RowSpool::append(std::uint32_t part, const std::vector<char>& rows) {
  const std::size_t width = layout_.row_bytes();
  const RowLayout::Field& cell = layout_.field("cell");
  const RowLayout::Field& repetition = layout_.field("repetition");
  for (std::size_t at = 0; at < rows.size(); at += width, ++size_) {
    const auto its_cell = entry_of<std::uint64_t>(&rows[at], cell);
    const auto its_repetition = entry_of<std::int32_t>(&rows[at], repetition);
    RowRun* run = runs_.empty() ? nullptr : &runs_.back();
    const bool goes_on = run != nullptr && run->part == part && run->cell == its_cell &&
                         (its_repetition == run->last || its_repetition == run->last + 1);
    if (!goes_on) {
      runs_.push_back({its_cell, its_repetition, its_repetition, part, 0, size_});
      run = &runs_.back();
    }
    run->last = its_repetition;
    ++run->rows;
  }
  for (std::size_t done = 0; done < rows.size();) {
    const ssize_t written = ::write(descriptor_, rows.data() + done, rows.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw ResultsError(path_.string() + ": cannot write: " + system_reason(errno));
    done += static_cast<std::size_t>(written);
  }
}

void RowSpool::read(std::uint64_t first, std::size_t count, char* rows) const {
  const std::size_t width = layout_.row_bytes();
  for (std::size_t done = 0; done < count * width;) {
    const auto place = static_cast<off_t>(first * width + done);
    const ssize_t got = ::pread(descriptor_, rows + done, count * width - done, place);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) throw ResultsError(path_.string() + ": cannot read: " + system_reason(errno));
    done += static_cast<std::size_t>(got);
  }
}

}  // namespace raygauge
