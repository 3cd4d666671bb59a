// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace raygauge::cli {

/// What commands ask of the parser of the command line, CLI11. Only command_line.cc includes its headers,
/// whose templates take longer to compile than a command.

/// An option or a positional argument of a command.
class Option {
 public:
  explicit Option(CLI::Option& option) : option_(&option) {}

  Option& required();
  /// What stands for the value in the help text, as in FILE.
  Option& type_name(const std::string& name);
  /// The default that the help text shows; "" shows none.
  Option& default_str(const std::string& text);
  /// So many words at each use.
  Option& expected(int words);
  Option& expected(int least, int most);
  /// The option may be repeated, and every value counts.
  Option& take_all();
  /// One word may be a list with this separator.
  Option& delimiter(char separator);
  /// Values outside [least, most] are refused.
  Option& range(int least, int most);
  /// Not together with `other`.
  Option& excludes(const Option& other);
  /// Only together with `other`.
  Option& needs(const Option& other);

  /// How often the command line gave it.
  std::size_t count() const;

 private:
  CLI::Option* option_;
};

/// The program, or a command of it.
class Command {
 public:
  explicit Command(CLI::App& app) : app_(&app) {}

  Command add_subcommand(const std::string& name, const std::string& description);

  /// `names` is as in "-o,--output", or without dashes for a positional argument. What is parsed goes to
  /// `value`, which holds the default and must outlive the parsing. T: std::string, int, std::int64_t,
  /// double, optional ones, or a vector of strings.
  template <class T>
  Option add_option(const std::string& names, T& value, const std::string& description);

  /// What is parsed goes to `take`, which throws where it understands nothing.
  Option add_option_function(const std::string& names, const std::function<void(const std::string&)>& take,
                             const std::string& description);

  Option add_flag(const std::string& names, bool& value, const std::string& description);

  /// Text below the options in the help text.
  void footer(const std::string& text);
  /// The command cannot stand without one of its subcommands.
  void require_subcommand();
  /// Called when the command was chosen and its options are parsed.
  void callback(std::function<void()> action);

 private:
  CLI::App* app_;
};

/// What is wrong with the words on a command line, whole: the program's name is part of it.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The words with which the program was called.
class CommandLine {
 public:
  CommandLine(const std::string& name, const std::string& description, const std::string& version,
              const std::string& footer);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// Where commands are added.
  Command program() { return Command(*app_); }

  /// Calls the command that the words choose, or prints what --help or --version ask for. Throws UsageError:
  /// a line that says what is wrong: an unknown command or option with the nearest known one, or the parser's
  /// own complaint, and where help is.
  void parse(int argc, char** argv);

 private:
  std::unique_ptr<CLI::App> app_;
};

}  // namespace raygauge::cli
