// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/usage_error.h"

#include <algorithm>
#include <vector>

#include "engine/exceptions.h"

namespace raygauge::cli {
namespace {

std::string suggestion(const std::string& name, const std::vector<std::string>& known) {
  const std::string nearest = nearest_name(name, known);
  return nearest.empty() ? "" : "; did you mean '" + nearest + "'?";
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(command->get_name());
  }
  return names;
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

/// The command that was chosen, or the program itself.
const CLI::App& chosen_command(const CLI::App& app) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  return chosen.empty() ? app : *chosen.front();
}

bool is_option(const std::string& word) { return word.size() > 1 && word[0] == '-'; }

std::string complaint(const CLI::App& app, const CLI::App& command, const CLI::ParseError& error) {
  const std::vector<std::string> left_over = command.remaining();
  if (&command == &app && !left_over.empty() && !is_option(left_over.front())) {
    return "unknown command '" + left_over.front() + "'" + suggestion(left_over.front(), command_names(app));
  }
  if (const auto option = std::find_if(left_over.begin(), left_over.end(), is_option);
      option != left_over.end()) {
    const std::string name = option->substr(0, option->find('='));
    return "unknown option '" + name + "'" + suggestion(name, option_names(command));
  }
  if (&command == &app) return "a command is needed";
  if (!left_over.empty()) return "unexpected argument '" + left_over.front() + "'";
  return error.what();
}

}  // namespace

std::string on_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

std::string usage_message(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = chosen_command(app);
  const std::string name = &command == &app ? "raygauge" : "raygauge " + command.get_name();
  return on_one_line(name + ": " + complaint(app, command, error) + " (" + name + " --help)");
}

}  // namespace raygauge::cli
