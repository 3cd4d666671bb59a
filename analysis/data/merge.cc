// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/data/merge.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "raygauge/exceptions.h"
#include "results/run/results_file.h"
#include "results/text/number_words.h"
#include "results/text/words.h"

namespace raygauge {
namespace {

std::string slowdown_text(const Calibration& calibration) {
  std::string text;
  for (const Calibration::Entry& entry : calibration.entries) {
    if (entry.is_noise()) continue;
    text += (text.empty() ? "" : ", ") + entry.method + " " + padded_significant(entry.slowdown, 3);
  }
  return text;
}

/// What each machine has measured of its slowdown, in its first calibration.
std::string slowdowns_text(const Provenance& provenance) {
  constexpr std::size_t kMost = 4;
  std::map<std::string, std::string> by_host;
  for (const Session& session : provenance.sessions) {
    const std::string text = slowdown_text(session.calibration);
    if (!text.empty()) by_host.emplace(session.machine.hostname, text);
  }
  if (by_host.size() == 1) return by_host.begin()->second;
  std::string all;
  std::size_t shown = 0;
  for (const auto& [host, text] : by_host) {
    if (++shown > kMost) return all + " and on " + std::to_string(by_host.size() - kMost) + " more machines";
    all += (all.empty() ? "on " : "; on ") + host + " " + text;
  }
  return all;
}

/// How the times of a run came about, where that matters.
std::string timing_note(const Provenance& provenance) {
  int threads = 1;
  for (const Session& session : provenance.sessions) {
    if (session.timing != "parallel") continue;
    threads = std::max({threads, session.threads, session.calibration.threads});
  }
  if (threads < 2) return "";
  const std::string slowdown = slowdowns_text(provenance);
  return "timed with " + std::to_string(threads) + " threads at once" +
         (slowdown.empty() ? "" : "; slowdown of single solves: " + slowdown);
}

std::string unfinished_note(const ResultsFile& file) {
  const std::size_t done = file.cells().size();
  if (done == file.provenance.cell_count) return "";
  return "unfinished, " + std::to_string(done) + " of " + counted(file.provenance.cell_count, "cell");
}

/// What tells one run from another.
std::string run_key(const Provenance& provenance) {
  std::string key = provenance.identity;
  for (const Session& session : provenance.sessions)
    key += "\n" + session.started_at + " " + session.machine.hostname;
  return key;
}

/// Says of times that they come from different processors or machines; "" where they do not.
std::string machines_note(const std::vector<MergedFile>& files) {
  const auto hosts = hosts_by_processor(files);
  if (hosts.empty()) return "";
  if (hosts.size() == 1) {
    const auto& [processor, names] = *hosts.begin();
    if (names.size() < 2) return "";
    return "times from different machines are mixed: " + host_words(names) + ", each with " + processor;
  }
  std::string note = "times from different processors are mixed:";
  for (const auto& [processor, names] : hosts) note += " " + processor + " (" + host_words(names) + ");";
  return note.substr(0, note.size() - 1);
}

}  // namespace

std::map<std::string, std::set<std::string>> hosts_by_processor(const std::vector<MergedFile>& files) {
  std::map<std::string, std::set<std::string>> hosts;
  for (const MergedFile& file : files) {
    for (const Session& session : file.provenance.sessions) {
      hosts[session.machine.cpu_model].insert(session.machine.hostname);
    }
  }
  return hosts;
}

std::string host_words(const std::set<std::string>& hosts) {
  constexpr std::size_t kMost = 4;
  std::string words;
  std::size_t shown = 0;
  for (const std::string& host : hosts) {
    if (shown == kMost) return words + " and " + std::to_string(hosts.size() - kMost) + " more";
    words += (shown++ == 0 ? "" : ", ") + host;
  }
  return words;
}

MergedResults read_merged(const std::vector<std::string>& paths) {
  MergedResults merged;
  std::map<std::string, std::string> runs;
  for (const std::string& path : paths) {
    ResultsFile file = read_results(path);
    const auto [place, first] = runs.emplace(run_key(file.provenance), path);
    if (!first) throw InvalidParameterError(path + " holds the same run as " + place->second);
    for (const std::string& note : {unfinished_note(file), timing_note(file.provenance)}) {
      if (!note.empty()) merged.notes.push_back(path + ": " + note);
    }
    if (merged.records.empty()) {
      merged.records = std::move(file.records);
    } else {
      merged.records.insert(merged.records.end(), std::make_move_iterator(file.records.begin()),
                            std::make_move_iterator(file.records.end()));
    }
    merged.files.push_back({path, std::move(file.provenance)});
  }
  const std::string note = machines_note(merged.files);
  if (!note.empty()) merged.notes.push_back(note);
  return merged;
}

}  // namespace raygauge
