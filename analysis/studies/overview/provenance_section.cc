// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/data/columns.h"
#include "analysis/render/report/blocks.h"
#include "analysis/studies/compare/compare_circumstances.h"
#include "analysis/studies/sections.h"
#include "results/schema/schema.h"
#include "results/schema/session_tables.h"
#include "results/text/number_words.h"

namespace raygauge::report {
namespace {

std::string value_words(const Value& value) {
  const std::string text = text_of(value);
  return text.empty() ? "-" : text;
}

/// Every column of a session, one a row; sessions side by side.
Table sessions_table(const MergedFile& file) {
  Table table;
  table.title = file.path;
  table.header = {{"session"}};
  for (std::size_t s = 0; s < file.provenance.sessions.size(); ++s)
    table.header[0].push_back(std::to_string(s));
  for (const Column<Session>& column : session_columns()) {
    TableRow row{{{column.name + (column.unit == "B" ? " (B)" : "")}}};
    for (const Session& session : file.provenance.sessions)
      row.cells.emplace_back(value_words(column.get(session)));
    table.rows.push_back(std::move(row));
  }
  TableRow versions{{{"versions"}}};
  for (const Session& session : file.provenance.sessions) {
    versions.cells.emplace_back(versions_text(session));
  }
  table.rows.push_back(std::move(versions));
  return table;
}

/// Every column of a machine, one a row; machines side by side.
Table machines_table(const MergedFile& file) {
  std::vector<Session> sessions = file.provenance.sessions;
  const std::vector<MachineInfo> machines = distinct_machines(sessions);
  Table table;
  table.title = "machines";
  table.header = {{"machine"}};
  for (std::size_t i = 0; i < machines.size(); ++i) table.header[0].push_back(std::to_string(i));
  for (const Column<MachineInfo>& column : machine_columns()) {
    TableRow row{{{column.name + (column.unit == "B" ? " (B)" : "")}}};
    for (const MachineInfo& machine : machines) row.cells.emplace_back(value_words(column.get(machine)));
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table calibration_table(const MergedFile& file) {
  Table table;
  table.title = "time with all threads busy over time alone";
  table.header = {{"session", "host", "threads", "method", "alone", "busy", "median ratio"}};
  for (std::size_t s = 0; s < file.provenance.sessions.size(); ++s) {
    const Session& session = file.provenance.sessions[s];
    const Calibration& calibration = session.calibration;
    for (const Calibration::Entry& entry : calibration.entries) {
      table.rows.push_back({{{std::to_string(s)},
                             {session.machine.hostname},
                             {std::to_string(calibration.threads)},
                             {entry.method},
                             {time_words(entry.serial_seconds)},
                             {time_words(entry.parallel_seconds)},
                             {entry.is_noise() ? "noise" : padded_significant(entry.slowdown, 3)}}});
    }
  }
  return table;
}

}  // namespace

std::optional<Section> provenance_section(const Input& input) {
  Section section{"provenance", "Provenance", {}};
  for (const MergedFile& file : input.merged.files) {
    section.blocks.emplace_back(sessions_table(file));
    section.blocks.emplace_back(machines_table(file));
    const Table calibration = calibration_table(file);
    if (!calibration.rows.empty()) section.blocks.emplace_back(calibration);
    section.blocks.emplace_back(Verbatim{"experiment of " + file.path, file.provenance.experiment_text});
  }
  return section;
}

}  // namespace raygauge::report
