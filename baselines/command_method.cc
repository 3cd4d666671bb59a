// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/command_method.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): kill() is POSIX
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "baselines/certify.h"
#include "baselines/gauge_lp.h"
#include "raygauge/exceptions.h"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX leaves it to the program

namespace raygauge {
namespace {

constexpr const char* kName = "command";

using Clock = std::chrono::steady_clock;

constexpr std::size_t kLongestLine = std::size_t{1} << 26U;  // bytes

/// A running program and the socket that is its standard input and output.
class Child {
 public:
  explicit Child(const std::string& command) {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
      throw Error("method 'command': no socket for '" + command + "'");
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    std::string text = "exec " + command;
    std::string shell = "sh";
    std::string option = "-c";
    std::array<char*, 4> arguments = {shell.data(), option.data(), text.data(), nullptr};
    // A process group of its own: what the program starts in its turn ends with it.
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes, 0);
    const int error = ::posix_spawn(&process_, "/bin/sh", &actions, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    socket_ = ends[0];
    if (error == 0) return;
    ::close(socket_);
    throw Error("method 'command': cannot start '" + command + "'");
  }
  ~Child() {
    ::close(socket_);
    ::kill(-process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Whether all of `text` was taken before `end`.
  bool send(std::string_view text, Clock::time_point end) const {
    while (!text.empty()) {
      if (!wait_for(POLLOUT, end)) return false;
      const ssize_t sent = ::send(socket_, text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
      if (sent < 0 && (errno == EINTR || errno == EAGAIN)) continue;
      if (sent < 0) return false;
      text.remove_prefix(static_cast<std::size_t>(sent));
    }
    return true;
  }

  /// The next line, if it comes before `end` and the program does not end.
  std::optional<std::string> line(Clock::time_point end) {
    while (true) {
      if (const std::size_t at = received_.find('\n'); at != std::string::npos) {
        std::string line = received_.substr(0, at);
        received_.erase(0, at + 1);
        return line;
      }
      // A program that goes on sending without a line end is as late as one that sends nothing.
      if (Clock::now() > end || received_.size() > kLongestLine) return std::nullopt;
      if (!wait_for(POLLIN, end)) return std::nullopt;
      std::array<char, 4096> block{};
      const ssize_t got = ::recv(socket_, block.data(), block.size(), 0);
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) return std::nullopt;
      received_.append(block.data(), static_cast<std::size_t>(got));
    }
  }

 private:
  bool wait_for(short events, Clock::time_point end) const {
    while (true) {
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
      pollfd poll = {socket_, events, 0};
      const int ready = ::poll(&poll, 1, static_cast<int>(std::clamp<std::int64_t>(left + 1, 0, 1 << 30)));
      if (ready > 0) return true;
      if (ready == 0 || errno != EINTR) return false;
    }
  }

  pid_t process_ = -1;
  int socket_ = -1;
  std::string received_;
};

/// The time `seconds` from now; far away where that is more than a year.
Clock::time_point in_seconds(double seconds) {
  constexpr double kYear = 3e7;
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(
                            std::chrono::duration<double>(std::clamp(seconds, 0.0, kYear)));
}

void append_number(std::string& text, double value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  text.append(buffer.data(), end);
}

void append_points(std::string& text, const PointSet& points) {
  for (std::ptrdiff_t i = 0; i < points.size(); ++i) {
    const auto point = points.point(i);
    for (Eigen::Index k = 0; k < point.size(); ++k) {
      if (k > 0) text += ' ';
      append_number(text, point[k]);
    }
    text += '\n';
  }
}

/// How a program says that it has stopped before its answer was good enough.
constexpr std::array<std::string_view, 3> kLimits = {"time_limit", "iteration_limit", "precision_limit"};

DistanceStatus status_of(double distance) {
  if (!std::isfinite(distance)) return DistanceStatus::unreachable;
  return distance == 0 ? DistanceStatus::contains_origin : DistanceStatus::optimal;
}

/// The words of an answer.
class Answer {
 public:
  Answer(const std::string& line, const GaugeLp& lp) : line_(line), lp_(lp) {}

  LpAnswer parse() {
    LpAnswer answer;
    std::string_view first = word();
    const auto limit = std::find(kLimits.begin(), kLimits.end(), first);
    if (limit != kLimits.end()) first = word();
    answer.objective = number(first);
    if (std::isnan(answer.objective) || answer.objective < 0) fail();
    answer.status = limit != kLimits.end() ? distance_status_from_string(std::string(*limit))
                                           : status_of(answer.objective);
    for (std::string_view mark = word(); !mark.empty();) {
      if (mark == "u") {
        answer.u.resize(lp_.rows() - 1);
        for (double& value : answer.u) value = number(word());
        mark = word();
      } else if (mark == "a" || mark == "q") {
        mark = take_indices(mark == "q", answer.basis);
      } else {
        fail();
      }
    }
    return answer;
  }

 private:
  std::string_view word() {
    const std::size_t begin = std::min(line_.find_first_not_of(" \t\r", at_), line_.size());
    const std::size_t end = std::min(line_.find_first_of(" \t\r", begin), line_.size());
    at_ = end;
    return std::string_view(line_).substr(begin, end - begin);
  }

  double number(std::string_view word) const {
    double value = 0;
    const char* const end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    if (error != std::errc() || stop != end) fail();
    return value;
  }

  /// Indices up to the next mark, which is returned.
  std::string_view take_indices(bool of_Q, std::vector<std::ptrdiff_t>& basis) {
    while (true) {
      const std::string_view next = word();
      if (next.empty() || next == "u" || next == "a" || next == "q") return next;
      const double index = number(next);
      const std::ptrdiff_t size = of_Q ? lp_.Q().size() : lp_.A().size();
      if (!(index >= 0 && index < static_cast<double>(size) && index == std::floor(index))) fail();
      basis.push_back(static_cast<std::ptrdiff_t>(index) + (of_Q ? lp_.A().size() : 0));
    }
  }

  [[noreturn]] void fail() const {
    throw Error("method 'command': an answer that is not understood: '" + line_.substr(0, 60) + "'");
  }

  const std::string& line_;
  const GaugeLp& lp_;
  std::size_t at_ = 0;
};

class CommandMethod final : public SolveMethod {
 public:
  explicit CommandMethod(const Parameters& parameters)
      : command_(string_parameter(parameters, "program")),
        load_limit_(real_parameter(parameters, "load_limit")) {
    if (command_.empty()) throw InvalidParameterError("method 'command' needs a program = \"…\"");
  }

  void load(const Instance& instance) override {
    lp_.emplace(instance, kName);
    result_ = {};
    const int n = lp_->A().dimension();
    std::string text = "points " + std::to_string(lp_->A().size()) + " " + std::to_string(lp_->Q().size()) +
                       " " + std::to_string(n) + "\n";
    append_points(text, lp_->A());
    append_points(text, lp_->Q());
    if (!child_) child_.emplace(command_);
    const Clock::time_point end = in_seconds(load_limit_);
    if (!child_->send(text, end) || child_->line(end) != "ready") {
      child_.reset();
      fail_to_load();
    }
    text_ = std::move(text);
  }

  void solve(const SolveRequest& request) override {
    if (!lp_) throw Error("method 'command': solve before load");
    const Clock::time_point end = in_seconds(request.time_limit);
    if (!child_ && !restart(std::min(end, in_seconds(load_limit_)))) {
      if (Clock::now() < end) fail_to_load();
      result_ = {};
      result_.status = DistanceStatus::time_limit;
      return;
    }
    std::string text = "solve ";
    append_number(text, request.tolerance);
    text += ' ';
    append_number(text, request.time_limit);
    const std::optional<std::string> line = child_->send(text + '\n', end) ? child_->line(end) : std::nullopt;
    if (line) {
      result_ = certified_result(*lp_, Answer(*line, *lp_).parse());
      return;
    }
    // Too late, or it has ended: the next solve begins with a new one.
    result_ = {};
    result_.status = Clock::now() >= end ? DistanceStatus::time_limit : DistanceStatus::precision_limit;
    child_.reset();
  }

  DistanceResult result() override { return result_; }

 private:
  bool restart(Clock::time_point end) {
    child_.emplace(command_);
    if (child_->send(text_, end) && child_->line(end) == "ready") return true;
    child_.reset();
    return false;
  }

  [[noreturn]] void fail_to_load() const {
    throw Error("method 'command': '" + command_ + "' did not take the points and say ready");
  }

  std::string command_;
  double load_limit_;
  std::optional<GaugeLp> lp_;
  std::string text_;  ///< what the program was given
  std::optional<Child> child_;
  DistanceResult result_;
};

}  // namespace

void register_command_method(MethodRegistry& registry) {
  registry.add({kName,
                "a program of your own: points in, distance out, line by line (docs/baselines.md)",
                {{"program", std::string(), {}, {}, "what sh is to run, as in 'python3 my_solver.py'", {}},
                 {"load_limit", 60.0, 0.0, 1e6, "seconds for taking the points", {}}},
                [](const Parameters& parameters) { return std::make_unique<CommandMethod>(parameters); },
                true,
                Role::baseline});
}

}  // namespace raygauge
