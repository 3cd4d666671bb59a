// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "tests/cli/program.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <thread>
#include <utility>

#include "tests/results/support.h"

namespace raygauge::testing {
namespace {

void redirect(int descriptor, const std::string& file, int flags) {
  const int opened = open(file.c_str(), flags, 0644);
  if (opened < 0 || dup2(opened, descriptor) < 0) std::_Exit(126);
  close(opened);
}

void limit_file_size(std::size_t bytes) {
  const rlimit limit = {bytes, bytes};
  setrlimit(RLIMIT_FSIZE, &limit);
  std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace

Program::Program(std::string folder, const std::vector<std::string>& arguments, std::size_t file_size_limit,
                 const std::string& input)
    : folder_(std::move(folder)) {
  std::vector<char*> argv = {const_cast<char*>(RAYGAUGE_PROGRAM)};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  const std::string in = stream_file("in");
  const std::string out = stream_file("out");
  const std::string err = stream_file("err");
  write_bytes(in, input);
  process_ = fork();
  if (process_ != 0) return;
  if (chdir(folder_.c_str()) != 0) std::_Exit(126);
  redirect(STDIN_FILENO, in, O_RDONLY);
  redirect(STDOUT_FILENO, out, O_WRONLY | O_CREAT | O_TRUNC);
  redirect(STDERR_FILENO, err, O_WRONLY | O_CREAT | O_TRUNC);
  if (file_size_limit > 0) limit_file_size(file_size_limit);
  execv(argv.front(), argv.data());
  std::_Exit(127);
}

Program::~Program() {
  if (process_ <= 0) return;
  signal(SIGKILL);
  waitpid(process_, nullptr, 0);
}

void Program::signal(int number) const { kill(process_, number); }

bool Program::comes_to_handle(int number) const {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (std::chrono::steady_clock::now() < deadline) {
    std::ifstream status("/proc/" + std::to_string(process_) + "/status");
    for (std::string line; std::getline(status, line);) {
      if (!line.starts_with("SigCgt:")) continue;
      const std::uint64_t handled = std::stoull(line.substr(line.find('\t')), nullptr, 16);
      if ((handled >> (number - 1) & 1) != 0) return true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

ProgramResult Program::wait() {
  int status = 0;
  waitpid(std::exchange(process_, -1), &status, 0);
  return {WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status), read_bytes(stream_file("out")),
          read_bytes(stream_file("err"))};
}

std::string Program::stream_file(const char* name) const { return folder_ + "/.program-" + name; }

ProgramResult run_program(const std::string& folder, const std::vector<std::string>& arguments,
                          const std::string& input) {
  return Program(folder, arguments, 0, input).wait();
}

}  // namespace raygauge::testing
