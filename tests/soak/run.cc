// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "tests/soak/run.h"

#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <mutex>
#include <sstream>
#include <thread>

#include "generators/registry.h"
#include "raygauge/exceptions.h"

namespace raygauge::soak {
namespace {

using Clock = std::chrono::steady_clock;

// What the threads share.
class Team {
 public:
  Team(const RunOptions& options, const std::function<bool()>& stop,
       const std::function<void(const Progress&)>& report)
      : options_(options), stop_(stop), report_(report), begin_(Clock::now()) {
    register_generators(registry_);
    names_ = point_set_generators(registry_);
  }

  RunResult run() {
    std::vector<std::thread> threads;
    for (int i = 0; i < options_.threads; ++i) threads.emplace_back([this] { work(); });
    for (std::thread& thread : threads) thread.join();
    if (error_) std::rethrow_exception(error_);
    result_.progress.bases = begun_;
    result_.progress.seconds = seconds();
    return std::move(result_);
  }

 private:
  struct Task {
    std::int64_t base = 0;
    std::int64_t solves = 0;  // 0: nothing is left to do
  };

  double seconds() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

  Task next() {
    const std::lock_guard<std::mutex> lock(mutex_);
    const std::int64_t left = options_.solves - solved_;
    if (left <= 0 || seconds() >= options_.seconds || stop_() || result_.violation || error_) return {};
    return {options_.first_base + begun_++, left};
  }

  void work() {
    try {
      Worker worker(registry_, names_, options_.seed);
      for (Task task = next(); task.solves > 0; task = next()) {
        std::optional<Violation> violation = worker.run(task.base, task.solves);
        collect(worker.take_tally(), std::move(violation));
      }
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex_);
      error_ = std::current_exception();
    }
  }

  void collect(const Tally& tally, std::optional<Violation> violation) {
    const std::lock_guard<std::mutex> lock(mutex_);
    result_.progress.tally.add(tally);
    solved_ += tally.total().solves;
    if (violation && !result_.violation) result_.violation = std::move(violation);
    if (seconds() < next_report_) return;
    next_report_ = seconds() + options_.seconds_between_reports;
    result_.progress.bases = begun_;
    result_.progress.seconds = seconds();
    report_(result_.progress);
  }

  const RunOptions& options_;
  const std::function<bool()>& stop_;
  const std::function<void(const Progress&)>& report_;
  GeneratorRegistry registry_{"generator"};
  std::vector<std::string> names_;
  Clock::time_point begin_;
  std::mutex mutex_;
  std::int64_t begun_ = 0;
  std::int64_t solved_ = 0;
  double next_report_ = 0;
  RunResult result_;
  std::exception_ptr error_;
};

void write_points(const Eigen::MatrixXd& points, const std::filesystem::path& path) {
  std::ofstream file(path);
  file << std::setprecision(17);
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    for (Eigen::Index k = 0; k < points.rows(); ++k) file << (k > 0 ? "," : "") << points(k, i);
    file << "\n";
  }
}

}  // namespace

RunResult run(const RunOptions& options, const std::function<bool()>& stop,
              const std::function<void(const Progress&)>& report) {
  return Team(options, stop, report).run();
}

Eigen::MatrixXd load_points(const std::string& path) {
  std::ifstream file(path);
  std::vector<std::vector<double>> rows;
  for (std::string line; std::getline(file, line);) {
    std::istringstream numbers(line);
    std::vector<double>& row = rows.emplace_back();
    for (std::string number; std::getline(numbers, number, ',');) row.push_back(std::stod(number));
  }
  if (rows.empty()) throw Error(path + " holds no points");
  Eigen::MatrixXd points(static_cast<Eigen::Index>(rows[0].size()), static_cast<Eigen::Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    points.col(static_cast<Eigen::Index>(i)) = Vector::Map(rows[i].data(), points.rows());
  }
  return points;
}

void save(const Violation& violation, const RunOptions& options, const std::string& folder) {
  std::filesystem::create_directories(folder);
  write_points(violation.A, std::filesystem::path(folder) / "A.csv");
  write_points(violation.Q, std::filesystem::path(folder) / "Q.csv");
  std::ofstream file(std::filesystem::path(folder) / "violation.txt");
  file << std::setprecision(17) << violation.what << "\nfamily " << violation.family << ", seed "
       << options.seed << ", base " << violation.base << ", variant " << violation.variant << "\nmethod "
       << violation.method << ", tolerance " << violation.tolerance << "\nstatus "
       << to_string(violation.result.status) << ", lower " << violation.result.lower << ", distance "
       << violation.result.distance << ", upper " << violation.result.upper << "\ntruth "
       << to_string(violation.truth.status) << " in [" << violation.truth.rounded.lower << ", "
       << violation.truth.rounded.upper << "]\n"
       << (violation.repeats_in_a_fresh_solver ? "a fresh solver repeats it\n"
                                               : "a fresh solver does not repeat it\n");
}

}  // namespace raygauge::soak
