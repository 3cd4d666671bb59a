// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/output/build_report.h"

#include <fmt/format.h>

#include <array>
#include <vector>

#include "baselines/registry.h"
#include "cli/input/registries.h"
#include "cli/input/shapes.h"
#include "raygauge/queries/solver.h"
#include "results/provenance/provenance.h"
#include "results/text/language.h"

namespace raygauge::cli {
namespace {

/// The instruction sets that both this build and this machine have.
std::vector<std::string> instruction_sets() {
  constexpr std::array<InstructionSet, 3> kAll = {InstructionSet::baseline, InstructionSet::avx2,
                                                  InstructionSet::avx512};
  std::vector<std::string> present;
  for (const InstructionSet isa : kAll) {
    DistanceOptions options;
    options.instruction_set = isa;
    try {
      const DistanceSolver solver(options);
      present.emplace_back(to_string(isa));
    } catch (const InvalidParameterError&) {
      continue;  // that is how a solver says that the machine lacks it
    }
  }
  return present;
}

Json parameter_value_json(const ParameterValue& value) {
  return std::visit([](const auto& held) { return Json(held); }, value);
}

template <class T>
Json components_json(const Registry<T>& registry) {
  Json list = Json::array();
  for (const std::string& name : registry.names()) {
    const Component<T>& component = registry.find(name);
    Json parameters = Json::object();
    for (const ParameterInfo& info : component.parameters) {
      parameters[info.name] = {{"default", parameter_value_json(info.default_value)},
                               {"description", info.description}};
      if (!info.choices.empty()) parameters[info.name]["choices"] = info.choices;
    }
    list.push_back({{"name", name}, {"description", component.description}, {"parameters", parameters}});
  }
  return list;
}

template <class T>
std::string components_text(const std::string& title, const Registry<T>& registry) {
  std::string text = "\n" + title + "\n";
  for (const std::string& name : registry.names()) {
    const Component<T>& component = registry.find(name);
    text += fmt::format("  {:<20} {}\n", name, component.description);
    for (const ParameterInfo& info : component.parameters) {
      text += fmt::format("      {} = {}: {}", info.name, to_string(info.default_value), info.description);
      if (!info.choices.empty()) text += fmt::format(" ({})", fmt::join(info.choices, ", "));
      text += "\n";
    }
  }
  return text;
}

Json shapes_json() {
  Json list = Json::array();
  for (const Shape& shape : shapes()) {
    Json parameters = Json::object();
    for (const ShapeParameter& parameter : shape.parameters) {
      parameters[parameter.name] = {{"type", parameter.type}, {"description", parameter.description}};
      if (parameter.usual) parameters[parameter.name]["default"] = *parameter.usual;
    }
    list.push_back({{"name", shape.name}, {"description", shape.description}, {"parameters", parameters}});
  }
  return list;
}

std::string shapes_text() {
  std::string text = "\nshapes\n";
  for (const Shape& shape : shapes()) {
    text += fmt::format("  {:<20} {}\n", shape.name, shape.description);
    for (const ShapeParameter& parameter : shape.parameters) {
      const std::string usual = parameter.usual ? fmt::format(" = {}", *parameter.usual) : "";
      text += fmt::format("      {}{}: {}{}{}\n", parameter.name, usual, parameter.type,
                          parameter.description.empty() ? "" : ", ", parameter.description);
    }
  }
  return text;
}

std::string kibibytes(std::int64_t bytes) {
  return bytes == 0 ? "unknown" : fmt::format("{} KiB", bytes / 1024);
}

std::string versions_text() {
  std::string text;
  for (const auto& [name, version] : library_versions()) text += labelled("  " + name, version);
  for (const auto& [name, version] : solver_versions())
    text += labelled("  " + name, version + " (baseline)");
  return text;
}

}  // namespace

std::string labelled(const std::string& label, const std::string& text) {
  return fmt::format("{:<18} {}\n", label, language::printable(text));
}

Json machine_json(const MachineInfo& machine) {
  return {{"cpu_model", machine.cpu_model},
          {"cores", machine.cores},
          {"l1d_bytes", machine.l1d_bytes},
          {"l2_bytes", machine.l2_bytes},
          {"l3_bytes", machine.l3_bytes},
          {"memory_bytes", machine.memory_bytes},
          {"operating_system", machine.operating_system},
          {"kernel", machine.kernel},
          {"hostname", machine.hostname}};
}

Json build_json() {
  const BuildInfo build = build_info();
  Json libraries = Json::object();
  for (const auto& [name, version] : library_versions()) libraries[name] = version;
  Json solvers = Json::object();
  for (const auto& [name, version] : solver_versions()) solvers[name] = version;
  return {{"raygauge_version", build.raygauge_version},
          {"git_commit", build.git_commit},
          {"git_dirty", build.git_dirty},
          {"compiler", build.compiler},
          {"compiler_flags", build.compiler_flags},
          {"build_type", build.build_type},
          {"machine", machine_json(machine_info())},
          {"instruction_sets", instruction_sets()},
          {"libraries", libraries},
          {"solvers", solvers},
          {"methods", components_json(sweep_methods())},
          {"generators", components_json(sweep_generators(""))},
          {"shapes", shapes_json()}};
}

std::string build_text() {
  const BuildInfo build = build_info();
  const MachineInfo machine = machine_info();
  return "build\n" +
         labelled("  raygauge", build.raygauge_version + ", commit " + build.git_commit +
                                    (build.git_dirty ? " with modified sources" : "")) +
         labelled("  compiler", build.compiler + ", " + build.build_type + ": " + build.compiler_flags) +
         versions_text() + "\nmachine\n" +
         labelled("  CPU", fmt::format("{}, {} {}", machine.cpu_model, machine.cores,
                                       machine.cores == 1 ? "core" : "cores")) +
         labelled("  caches", "L1 data " + kibibytes(machine.l1d_bytes) + ", L2 " +
                                  kibibytes(machine.l2_bytes) + ", L3 " + kibibytes(machine.l3_bytes)) +
         labelled("  memory",
                  fmt::format("{:.1f} GiB", static_cast<double>(machine.memory_bytes) / (1 << 30))) +
         labelled("  instruction sets", fmt::format("{}", fmt::join(instruction_sets(), " "))) +
         labelled("  system", machine.operating_system + ", " + machine.kernel) +
         components_text("methods", sweep_methods()) + components_text("generators", sweep_generators("")) +
         shapes_text();
}

}  // namespace raygauge::cli
