// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace raygauge::testing {

/// How the program ended and what it printed.
struct ProgramResult {
  int status = -1;  ///< exit status; 128 + signal if a signal ended it
  std::string out;
  std::string err;
};

/// The raygauge program, running as a user would run it. Standard streams are files of
/// `folder`.
class Program {
 public:
  /// Starts it with `arguments`, in `folder`, with `input` on standard input. `file_size_limit` is the
  /// largest file it may write, 0 for any.
  Program(std::string folder, const std::vector<std::string>& arguments, std::size_t file_size_limit = 0,
          const std::string& input = "");
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  void signal(int number) const;

  /// Waits until it has a handler of its own for a signal; false if it has none within a minute.
  bool comes_to_handle(int number) const;

  /// Waits for its end. Call once.
  ProgramResult wait();

 private:
  std::string stream_file(const char* name) const;

  std::string folder_;
  pid_t process_ = -1;
};

ProgramResult run_program(const std::string& folder, const std::vector<std::string>& arguments,
                          const std::string& input = "");

}  // namespace raygauge::testing
