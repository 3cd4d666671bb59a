// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/output/file_report.h"

#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <vector>

#include "cli/output/build_report.h"
#include "engine/numerics/number_text.h"

namespace raygauge::cli {
namespace {

/// The name and the description in an experiment's text; "" where it has none.
struct Title {
  std::string name;
  std::string description;
};

Title title_of(const std::string& experiment_text) {
  try {
    const toml::table root = toml::parse(experiment_text);
    return {root["name"].value_or(std::string()), root["description"].value_or(std::string())};
  } catch (const toml::parse_error&) {
    return {};  // a file of another program version; everything else in it still counts
  }
}

/// The distinct values of one column, in increasing order.
template <class Value>
std::vector<Value> distinct(const std::vector<Record>& records,
                            const std::function<Value(const Record&)>& value) {
  std::set<Value> values;
  for (const Record& record : records) values.insert(value(record));
  return {values.begin(), values.end()};
}

std::string generator_of(const Record& record) {
  const std::string& parameters = record.generator_parameters;
  return record.generator + (parameters.empty() ? "" : " (" + parameters + ")");
}

/// In the order of their first records, which is that of the experiment.
std::vector<std::string> generators_of(const std::vector<Record>& records) {
  std::set<std::string> seen;
  std::vector<std::string> generators;
  for (const Record& record : records) {
    std::string generator = generator_of(record);
    if (seen.insert(generator).second) generators.push_back(std::move(generator));
  }
  return generators;
}

/// Everything that is counted over the records.
struct Contents {
  std::vector<std::string> generators;
  std::vector<std::string> methods;
  std::vector<int> n;
  std::vector<int> N;
  std::vector<double> tolerance;
  std::vector<int> repetition;
  std::map<std::string, std::size_t> statuses;
  std::size_t disagreements = 0;
};

/// Each with its parameters, or names and numbers where that would be long.
std::string generators_text(const std::vector<Record>& records, const Contents& contents) {
  constexpr std::size_t kMost = 6;
  if (contents.generators.size() <= kMost) return fmt::format("{}", fmt::join(contents.generators, ", "));
  std::map<std::string, std::set<std::string>> parameters;
  for (const Record& record : records) parameters[record.generator].insert(record.generator_parameters);
  std::string text;
  for (const auto& [name, all] : parameters) {
    text += (text.empty() ? "" : ", ") + name;
    if (all.size() > 1) text += fmt::format(" ({} choices of parameters)", all.size());
  }
  return text;
}

/// "1e-6 1e-3".
std::string tolerance_text(const Contents& contents) {
  constexpr int kDigits = 6;
  std::string text;
  for (const double tolerance : contents.tolerance)
    text += (text.empty() ? "" : " ") + rounded_text(tolerance, kDigits);
  return text;
}

Contents contents_of(const std::vector<Record>& records) {
  Contents contents;
  contents.generators = generators_of(records);
  contents.methods = distinct<std::string>(records, &Record::method);
  contents.n = distinct<int>(records, &Record::n);
  contents.N = distinct<int>(records, &Record::N);
  contents.tolerance = distinct<double>(records, &Record::tolerance);
  contents.repetition = distinct<int>(records, &Record::repetition);
  for (const Record& record : records) {
    ++contents.statuses[std::string(to_string(record.status))];
    if (!record.agrees) ++contents.disagreements;
  }
  return contents;
}

Json calibration_json(const Calibration& calibration) {
  Json list = Json::array();
  for (const Calibration::Entry& entry : calibration.entries) {
    list.push_back({{"method", entry.method},
                    {"serial_seconds", entry.serial_seconds},
                    {"parallel_seconds", entry.parallel_seconds},
                    {"slowdown", entry.slowdown},
                    {"slowdown_is_noise", entry.is_noise()}});
  }
  return list;
}

Json session_json(const Session& session) {
  Json versions = Json::object();
  for (const ComponentVersion& component : session.versions) versions[component.name] = component.version;
  return {{"started_at", session.started_at},
          {"finished_at", session.finished_at},
          {"rank", session.rank},
          {"threads", session.threads},
          {"timing", session.timing},
          {"raygauge_version", session.build.raygauge_version},
          {"git_commit", session.build.git_commit},
          {"git_dirty", session.build.git_dirty},
          {"machine", machine_json(session.machine)},
          {"versions", versions},
          {"calibration", calibration_json(session.calibration)}};
}

std::string session_text(const Session& session) {
  const std::string end =
      session.finished_at.empty() ? "no end recorded (killed, or still running)" : session.finished_at;
  return fmt::format("{} to {}; {} {}, timing {}; raygauge {} commit {:.12}{}; {} on {}", session.started_at,
                     end, session.threads, session.threads == 1 ? "thread" : "threads", session.timing,
                     session.build.raygauge_version, session.build.git_commit,
                     session.build.git_dirty ? " modified" : "", session.machine.cpu_model,
                     session.machine.hostname);
}

/// A machine and what ran on it.
struct MachineUse {
  MachineInfo machine;
  int sessions = 0;
  std::size_t records = 0;
  std::map<std::string, std::vector<double>> slowdown;  ///< by method; without what is noise
};

/// One entry for each host.
std::map<std::string, MachineUse> machines_of(const ResultsFile& results) {
  const std::vector<Session>& sessions = results.provenance.sessions;
  std::map<std::string, MachineUse> machines;
  for (const Session& session : sessions) {
    MachineUse& use = machines[session.machine.hostname];
    use.machine = session.machine;
    ++use.sessions;
    for (const Calibration::Entry& entry : session.calibration.entries) {
      if (!entry.is_noise()) use.slowdown[entry.method].push_back(entry.slowdown);
    }
  }
  for (const Record& record : results.records) {
    const auto session = static_cast<std::size_t>(record.session);
    if (session < sessions.size()) ++machines[sessions[session].machine.hostname].records;
  }
  return machines;
}

double middle(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return (values[values.size() / 2] + values[(values.size() - 1) / 2]) / 2;
}

std::string machine_text(const MachineUse& use) {
  std::string slowdown;
  for (const auto& [method, ratios] : use.slowdown) {
    slowdown += fmt::format("{}{} {:.2f}", slowdown.empty() ? "; slowdown " : ", ", method, middle(ratios));
  }
  return fmt::format("{}: {}, {} cores, {:.1f} GiB; {} {}, {} records{}", use.machine.hostname,
                     use.machine.cpu_model, use.machine.cores,
                     static_cast<double>(use.machine.memory_bytes) / (1 << 30), use.sessions,
                     use.sessions == 1 ? "session" : "sessions", use.records, slowdown);
}

Json machines_json(const ResultsFile& results) {
  Json list = Json::array();
  for (const auto& [host, use] : machines_of(results)) {
    Json slowdown = Json::object();
    for (const auto& [method, ratios] : use.slowdown) slowdown[method] = middle(ratios);
    Json machine = machine_json(use.machine);
    machine["sessions"] = use.sessions;
    machine["records"] = use.records;
    machine["slowdown"] = slowdown;
    list.push_back(machine);
  }
  return list;
}

/// All sessions, or the first and the last of many.
std::string sessions_text(const std::vector<Session>& sessions) {
  constexpr std::size_t kMost = 20;
  std::string text;
  for (std::size_t i = 0; i < sessions.size(); ++i) {
    const bool shown = sessions.size() <= kMost || i + 2 < kMost || i + 1 == sessions.size();
    if (shown) text += labelled("session", session_text(sessions[i]));
    if (!shown && i + 2 == kMost) text += labelled("", fmt::format("… {} more", sessions.size() - kMost + 1));
  }
  return text;
}

std::string statuses_text(const std::map<std::string, std::size_t>& statuses) {
  std::string text;
  for (const auto& [status, number] : statuses)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", status, number);
  return text;
}

}  // namespace

Json results_json(const std::string& path, const ResultsFile& results) {
  const Title title = title_of(results.provenance.experiment_text);
  const Contents contents = contents_of(results.records);
  Json sessions = Json::array();
  for (const Session& session : results.provenance.sessions) sessions.push_back(session_json(session));
  return {{"file", path},
          {"experiment", title.name},
          {"description", title.description},
          {"finished", results.finished()},
          {"cells_done", results.cells().size()},
          {"cells", results.provenance.cell_count},
          {"records", results.records.size()},
          {"generators", contents.generators},
          {"methods", contents.methods},
          {"n", contents.n},
          {"N", contents.N},
          {"tolerance", contents.tolerance},
          {"repetitions", contents.repetition.size()},
          {"statuses", contents.statuses},
          {"disagreements", contents.disagreements},
          {"checksum", results.provenance.has_checksum},
          {"machines", machines_json(results)},
          {"sessions", sessions}};
}

std::string results_text(const std::string& path, const ResultsFile& results) {
  const Title title = title_of(results.provenance.experiment_text);
  const Contents contents = contents_of(results.records);
  std::string text =
      labelled("file", path) +
      labelled("experiment", title.name + (title.description.empty() ? "" : ": " + title.description)) +
      labelled("cells",
               fmt::format("{} of {}{}", results.cells().size(), results.provenance.cell_count,
                           results.finished() ? "" : " (unfinished: `raygauge run … --resume` goes on)")) +
      labelled("records", std::to_string(results.records.size())) +
      labelled("generators", generators_text(results.records, contents)) +
      labelled("methods", fmt::format("{}", fmt::join(contents.methods, ", "))) +
      labelled("n", fmt::format("{}", fmt::join(contents.n, " "))) +
      labelled("N", fmt::format("{}", fmt::join(contents.N, " "))) +
      labelled("tolerance", tolerance_text(contents)) +
      labelled("repetitions", std::to_string(contents.repetition.size())) +
      labelled("statuses", statuses_text(contents.statuses)) +
      labelled("disagreements",
               fmt::format("{} of {} records", contents.disagreements, results.records.size()));
  if (!results.provenance.has_checksum) text += labelled("checksum", kNoChecksum);
  for (const auto& [host, use] : machines_of(results)) text += labelled("machine", machine_text(use));
  return text + sessions_text(results.provenance.sessions);
}

}  // namespace raygauge::cli
