// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/disk/run_directory.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <string_view>
#include <system_error>
#include <utility>

#include "results/disk/atomic_file.h"
#include "results/exceptions.h"

namespace raygauge {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kLockName = "lock";
constexpr PartKind kJournal = {"cells-", ".csv", 4};
constexpr PartKind kSession = {"session-", ".h5", 4};

/// The number of a part, if `name` is exactly what part_name makes of it.
std::optional<std::uint64_t> part_number(const PartKind& kind, std::string_view name) {
  if (!name.starts_with(kind.prefix)) return std::nullopt;
  std::uint64_t number = 0;
  std::from_chars(name.data() + kind.prefix.size(), name.data() + name.size(), number);
  if (part_name(kind, number) != name) return std::nullopt;
  return number;
}

void create_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw ResultsError(folder.string() + ": cannot create the folder: " + error.message());
}

void remove_all_of(const std::map<std::uint64_t, fs::path>& files) {
  for (const auto& [number, path] : files) {
    std::error_code error;
    fs::remove(path, error);
    if (error) throw ResultsError(path.string() + ": cannot remove: " + error.message());
  }
}

void remove_temporary_files(const fs::path& folder) {
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    if (entry.path().extension() == kTemporarySuffix) fs::remove(entry.path(), ignored);
  }
}

}  // namespace

fs::path parts_folder(const fs::path& target) { return target.string() + ".parts"; }

std::string part_name(const PartKind& kind, std::uint64_t number) {
  const std::string digits = std::to_string(number);
  const std::string zeros(digits.size() < kind.digits ? kind.digits - digits.size() : 0, '0');
  return std::string(kind.prefix) + zeros + digits + std::string(kind.suffix);
}

void write_part(const fs::path& path, std::string_view bytes) {
  write_atomically(path, bytes, path.string() + std::string(kTemporarySuffix));
}

std::vector<fs::path> parts_named(const fs::path& target, std::string_view prefix) {
  std::vector<fs::path> parts;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(parts_folder(target), error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(prefix) && name.ends_with(".h5")) parts.push_back(entry.path());
  }
  std::sort(parts.begin(), parts.end());
  return parts;
}

PartList list_parts(const fs::path& target) {
  PartList result;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(parts_folder(target), error)) {
    const std::string name = entry.path().filename().string();
    if (const auto session = part_number(kJournal, name)) result.journals[*session] = entry.path();
    if (const auto session = part_number(kSession, name)) result.sessions[*session] = entry.path();
  }
  if (error && error != std::errc::no_such_file_or_directory && error != std::errc::not_a_directory) {
    throw ResultsError(parts_folder(target).string() + ": cannot read the folder: " + error.message());
  }
  return result;
}

fs::path journal_path(const fs::path& target, std::uint64_t session) {
  return parts_folder(target) / part_name(kJournal, session);
}

bool is_being_written(const fs::path& target) { return is_locked(parts_folder(target) / kLockName); }

RunDirectory::RunDirectory(fs::path target) : target_(std::move(target)), folder_(parts_folder(target_)) {
  create_folder(folder_);
  lock_.emplace(folder_ / kLockName);
  for (const auto& [session, path] : parts().journals) {  // of a rank that outlives the one with the lock
    if (is_locked(path)) throw RunLockedError(path.string() + ": another process is writing this run");
  }
  remove_temporary_files(folder_);
}

RunDirectory::~RunDirectory() {
  lock_.reset();
  std::error_code not_empty;
  fs::remove(folder_, not_empty);
}

fs::path RunDirectory::journal_path(std::uint64_t session) const {
  return raygauge::journal_path(target_, session);
}

void RunDirectory::store_session(std::uint64_t session, const std::string& bytes) const {
  write_part(folder_ / part_name(kSession, session), bytes);
}

void RunDirectory::store_target(const std::string& bytes) const {
  write_atomically(target_, bytes, folder_ / ("merged" + std::string(kTemporarySuffix)));
}

void RunDirectory::require_room(const std::string& bytes) const {
  const fs::path path = folder_ / ("room" + std::string(kTemporarySuffix));
  write_atomically(path, bytes, path);
  std::error_code ignored;  // the next run removes it
  fs::remove(path, ignored);
}

void RunDirectory::clear() const {
  const PartList present = parts();
  remove_all_of(present.journals);
  remove_all_of(present.sessions);
}

}  // namespace raygauge
