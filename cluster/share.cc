// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cluster/share.h"

#include <algorithm>
#include <cstdlib>
#include <iomanip>
#include <limits>
#include <map>
#include <sstream>
#include <utility>

namespace raygauge {
namespace {

enum Counter : int { kNext = 0, kFinished = 1 };

/// Beyond every list of pieces, and far from an overflow.
constexpr std::uint64_t kBeyond = std::uint64_t{1} << 62;

void put(std::ostream& out, const std::vector<int>& numbers) {
  out << numbers.size();
  for (const int number : numbers) out << ' ' << number;
  out << '\n';
}

std::vector<int> take_numbers(std::istream& in) {
  std::size_t size = 0;
  in >> size;
  std::vector<int> numbers(size);
  for (int& number : numbers) in >> number;
  return numbers;
}

}  // namespace

std::uint64_t RankCounter::next() { return ranks_.fetch_and_add(kNext, 1); }
std::uint64_t RankCounter::finish() { return ranks_.fetch_and_add(kFinished, 1) + 1; }

void RankCounter::abandon() {
  if (ranks_.fetch_and_add(kNext, 0) < kBeyond) ranks_.fetch_and_add(kNext, kBeyond);
}

std::vector<RankDuty> rank_duties(const std::vector<RankPlace>& places, int threads, bool pin) {
  std::map<std::pair<std::string, std::vector<int>>, int> sharing;  // ranks that may use the same CPUs
  for (const RankPlace& place : places) ++sharing[{place.host, place.cpus}];
  std::map<std::pair<std::string, std::vector<int>>, std::size_t> taken;
  std::map<std::string, int> on_host;
  std::vector<RankDuty> duties;
  for (const RankPlace& place : places) {
    RankDuty duty;
    const int ranks = sharing.at({place.host, place.cpus});
    duty.threads = threads > 0 ? threads : std::max(1, static_cast<int>(place.cpus.size()) / ranks);
    if (pin && static_cast<std::size_t>(duty.threads) * ranks <= place.cpus.size()) {
      std::size_t& first = taken[{place.host, place.cpus}];
      const auto begin = place.cpus.begin() + static_cast<std::ptrdiff_t>(first);
      duty.cpus.assign(begin, begin + duty.threads);
      first += static_cast<std::size_t>(duty.threads);
    }
    duty.calibrates = on_host[place.host] == 0;
    on_host[place.host] += duty.threads;
    duties.push_back(std::move(duty));
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    duties[i].concurrency = on_host.at(places[i].host);
    duties[i].calibrates = duties[i].calibrates && duties[i].concurrency > 1;
  }
  return duties;
}

std::string to_text(const RankPlace& place) {
  std::ostringstream out;
  out << place.host << '\n';
  put(out, place.cpus);
  return out.str();
}

RankPlace place_from_text(const std::string& text) {
  std::istringstream in(text);
  RankPlace place;
  std::getline(in, place.host);
  place.cpus = take_numbers(in);
  return place;
}

std::string to_text(const std::vector<RankDuty>& duties) {
  std::ostringstream out;
  out << duties.size() << '\n';
  for (const RankDuty& duty : duties) {
    out << duty.threads << ' ' << duty.concurrency << ' ' << duty.calibrates << ' ';
    put(out, duty.cpus);
  }
  return out.str();
}

std::vector<RankDuty> duties_from_text(const std::string& text) {
  std::istringstream in(text);
  std::size_t size = 0;
  in >> size;
  std::vector<RankDuty> duties(size);
  for (RankDuty& duty : duties) {
    in >> duty.threads >> duty.concurrency >> duty.calibrates;
    duty.cpus = take_numbers(in);
  }
  return duties;
}

std::string to_text(const DoneCells& done) {
  std::ostringstream out;
  out << done.whole().size();
  for (const std::uint64_t cell : done.whole()) out << ' ' << cell;
  out << '\n' << done.partial().size() << '\n';
  for (const auto& [cell, repetitions] : done.partial()) {
    out << cell << ' ';
    put(out, {repetitions.begin(), repetitions.end()});
  }
  return out.str();
}

DoneCells done_from_text(const std::string& text) {
  std::istringstream in(text);
  DoneCells done;
  std::size_t size = 0;
  std::uint64_t cell = 0;
  for (in >> size; size > 0 && in >> cell; --size) done.add_whole(cell);
  for (in >> size; size > 0 && in >> cell; --size) {
    for (const int repetition : take_numbers(in)) {
      done.add(cell, repetition, std::numeric_limits<int>::max());
    }
  }
  return done;
}

std::string to_text(const MachineInfo& machine) {
  std::ostringstream out;
  out << machine.cpu_model << '\n'
      << machine.operating_system << '\n'
      << machine.kernel << '\n'
      << machine.hostname << '\n'
      << machine.cores << ' ' << machine.l1d_bytes << ' ' << machine.l2_bytes << ' ' << machine.l3_bytes
      << ' ' << machine.memory_bytes << '\n';
  return out.str();
}

MachineInfo machine_from_text(const std::string& text) {
  std::istringstream in(text);
  MachineInfo machine;
  std::getline(in, machine.cpu_model);
  std::getline(in, machine.operating_system);
  std::getline(in, machine.kernel);
  std::getline(in, machine.hostname);
  in >> machine.cores >> machine.l1d_bytes >> machine.l2_bytes >> machine.l3_bytes >> machine.memory_bytes;
  return machine;
}

std::string to_text(const Calibration& calibration) {
  std::ostringstream out;
  out << std::setprecision(std::numeric_limits<double>::max_digits10) << calibration.threads << '\n';
  for (const Calibration::Entry& entry : calibration.entries) {
    for (const double value : {entry.serial_seconds, entry.parallel_seconds, entry.slowdown,
                               entry.slowdown_lower, entry.slowdown_upper})
      out << value << ' ';
    out << entry.method << '\n';
  }
  return out.str();
}

Calibration calibration_from_text(const std::string& text) {
  std::istringstream in(text);
  Calibration calibration;
  in >> calibration.threads;
  Calibration::Entry entry;
  // operator>> reads no infinity.
  const auto read = [&in](double& value) {
    std::string word;
    in >> word;
    value = std::strtod(word.c_str(), nullptr);
    return static_cast<bool>(in);
  };
  while (read(entry.serial_seconds) && read(entry.parallel_seconds) && read(entry.slowdown) &&
         read(entry.slowdown_lower) && read(entry.slowdown_upper) &&
         std::getline(in >> std::ws, entry.method)) {
    calibration.entries.push_back(entry);
  }
  return calibration;
}

}  // namespace raygauge
