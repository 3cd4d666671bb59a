// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/schema/schema.h"

#include <array>

#include "engine/methods/counters.h"
#include "results/exceptions.h"

namespace raygauge {
namespace {

Column<Record> status_column() {
  return column_of_words(
      "status",
      "outcome: optimal, contains_origin, unreachable, precision_limit, iteration_limit or time_limit",
      &Record::status, distance_status_from_string);
}

Column<Record> role_column() {
  return column_of_words("role", "whose the method is: engine, baseline or oracle", &Record::role,
                         role_from_string);
}

}  // namespace

std::string_view to_string(ValueType type) noexcept {
  constexpr std::array<std::string_view, 6> kNames = {"boolean", "int32",   "int64",
                                                      "uint64",  "float64", "text"};
  return kNames[static_cast<std::size_t>(type)];
}

void require_schema_version(const std::string& place, std::int64_t version, SchemaVersions read) {
  if (version >= read.first && version <= read.last) return;
  const std::string found = place + ": schema version " + std::to_string(version);
  if (version < read.first)
    throw SchemaVersionError(found + ", from before the first release (0.2), is not read: measure anew");
  const std::string first = std::to_string(read.first);
  const std::string last = std::to_string(read.last);
  throw SchemaVersionError(
      found + ", this raygauge reads " +
      (read.first == read.last ? "version " + last : "versions " + first + " to " + last));
}

// clang-format off
namespace {

std::vector<Column<Record>> columns_before_counters() {
  return {
    column("cell", "1", "index of the cell in the experiment's grid: generator slowest, then n, N, tolerance", &Record::cell),
    column("session", "1", "row of /provenance/sessions in which the record was made", &Record::session),
    column("generator", "", "registered name of the instance generator", &Record::generator),
    column("generator_parameters", "", "every parameter of the generator as name=value, separated by blanks", &Record::generator_parameters),
    column("method", "", "label of the method in the experiment", &Record::method),
    column("method_parameters", "", "every parameter of the method as name=value, separated by blanks", &Record::method_parameters),
    column("method_name", "", "registered name of the method", &Record::method_name),
    role_column(),
    column("n", "1", "dimension of the space", &Record::n),
    column("N", "1", "number of points in each set", &Record::N),
    column("tolerance", "1", "requested relative gap (upper - lower) / upper", &Record::tolerance),
    column("seed", "1", "seed of the experiment", &Record::seed),
    column("repetition", "1", "number of the instance in its cell, from 0", &Record::repetition),
    column("seconds", "s", "wall time of one solve: total time of the inner repetitions / their number", &Record::seconds),
    column("inner_repetitions", "1", "solves timed together because one alone is too short for the clock", &Record::inner_repetitions),
    column("load_seconds", "s", "wall time of building the method's model of the instance", &Record::load_seconds),
    column("distance", "1", "generalized distance d_Q(A); inf for unreachable", &Record::distance),
    column("lower", "1", "certified lower bound of the distance; nan where nothing could be certified", &Record::lower),
    column("upper", "1", "certified upper bound of the distance; nan where nothing could be certified", &Record::upper),
    column("exact_distance", "1", "distance that the generator knows from its construction; nan where it knows none", &Record::exact_distance),
    column("exact_distance_rounding", "1", "relative rounding error of exact_distance; 0 where exact_distance is exact for the stored coordinates", &Record::exact_distance_rounding),
    column("hardness_label", "", "what hardness is, as in 1/δ; empty where the generator has no such parameter", &Record::hardness_label),
    column("hardness", "1", "how hard the generator's parameters make the instance; nan where it has no such parameter", &Record::hardness),
    status_column(),
    column("agrees", "", "whether the method agrees with all others on the instance; times of records that do not are not to be averaged", &Record::agrees),
  };
}

std::vector<Column<Record>> columns_after_counters() {
  return {
    column("host", "", "name of the machine that ran the cell", &Record::host),
    column("rank", "1", "MPI rank that ran the cell; 0 without MPI", &Record::rank),
    column("thread", "1", "OpenMP thread that ran the cell", &Record::thread),
    column("concurrency", "1", "threads that were solving during this run", &Record::concurrency),
    column("started_at", "s", "start of the solve, counted from the start of its session", &Record::started_at),
  };
}
// clang-format on

std::vector<Column<Record>> make_record_columns() {
  std::vector<Column<Record>> columns = columns_before_counters();
  for (const CounterInfo& counter : kCounters)
    columns.push_back(column(counter.name, "1", counter.description, &Record::counters, counter.member));
  for (Column<Record>& column : columns_after_counters()) columns.push_back(std::move(column));
  return columns;
}

}  // namespace

const std::vector<Column<Record>>& record_columns() {
  static const std::vector<Column<Record>> kColumns = make_record_columns();
  return kColumns;
}

// clang-format off

const std::vector<Column<MachineInfo>>& machine_columns() {
  static const std::vector<Column<MachineInfo>> kColumns = {
    column("hostname", "", "name of the machine", &MachineInfo::hostname),
    column("cpu_model", "", "processor", &MachineInfo::cpu_model),
    column("l1d_bytes", "B", "first-level data cache of one core; 0 if unknown", &MachineInfo::l1d_bytes),
    column("l2_bytes", "B", "second-level cache that one core sees; 0 if unknown", &MachineInfo::l2_bytes),
    column("l3_bytes", "B", "third-level cache that one core sees; 0 if unknown or none", &MachineInfo::l3_bytes),
    column("memory_bytes", "B", "main memory", &MachineInfo::memory_bytes),
    column("operating_system", "", "operating system", &MachineInfo::operating_system),
    column("kernel", "", "kernel, its release and architecture", &MachineInfo::kernel),
  };
  return kColumns;
}

const std::vector<Column<Session>>& session_columns() {
  static const std::vector<Column<Session>> kColumns = {
    column("started_at", "", "start of the session, ISO 8601, UTC", &Session::started_at),
    column("finished_at", "", "end of the session, ISO 8601, UTC; empty if it was killed or still runs", &Session::finished_at),
    column("threads", "1", "threads that ran cells", &Session::threads),
    column("timing", "", "serial: timed solves ran alone; parallel: cells filled the threads", &Session::timing),
    column("raygauge_version", "", "version of raygauge", &Session::build, &BuildInfo::raygauge_version),
    column("git_commit", "", "commit that raygauge was built from, or unknown", &Session::build, &BuildInfo::git_commit),
    column("git_dirty", "", "whether the sources differed from that commit", &Session::build, &BuildInfo::git_dirty),
    column("compiler", "", "compiler and its version", &Session::build, &BuildInfo::compiler),
    column("compiler_flags", "", "flags of the compiler", &Session::build, &BuildInfo::compiler_flags),
    column("build_type", "", "CMake build type", &Session::build, &BuildInfo::build_type),
    column("machine", "1", "row of /provenance/machines", &Session::machine_row),
    column("rank", "1", "MPI rank of the process; 0 without MPI", &Session::rank),
    column("cores", "1", "logical cores that the process could use", &Session::machine, &MachineInfo::cores),
  };
  return kColumns;
}

const std::vector<Column<VersionRow>>& version_columns() {
  static const std::vector<Column<VersionRow>> kColumns = {
    column("session", "1", "row of /provenance/sessions", &VersionRow::session),
    column("name", "", "library or solver", &VersionRow::name),
    column("version", "", "its version", &VersionRow::version),
  };
  return kColumns;
}

const std::vector<Column<CalibrationRow>>& calibration_columns() {
  static const std::vector<Column<CalibrationRow>> kColumns = {
    column("session", "1", "row of /provenance/sessions", &CalibrationRow::session),
    column("threads", "1", "threads that solved at once", &CalibrationRow::threads),
    column("method", "", "label of the method", &CalibrationRow::method),
    column("serial_seconds", "s", "median time of a solve alone", &CalibrationRow::serial_seconds),
    column("parallel_seconds", "s", "median time of a solve with all threads busy", &CalibrationRow::parallel_seconds),
    column("slowdown", "1", "median ratio of the time with all threads busy to the time alone", &CalibrationRow::slowdown),
    column("slowdown_lower", "1", "lower end of the 95 % interval of slowdown; 0 where there are fewer than 6 instances", &CalibrationRow::slowdown_lower),
    column("slowdown_upper", "1", "its upper end; inf where there are fewer than 6 instances", &CalibrationRow::slowdown_upper),
  };
  return kColumns;
}
// clang-format on

}  // namespace raygauge
