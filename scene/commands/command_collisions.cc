// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/console/exit_status.h"
#include "cli/console/input_options.h"
#include "cli/input/mesh_object_file.h"
#include "cli/output/json_text.h"
#include "cli/output/output_file.h"
#include "cli/output/terminal.h"
#include "raygauge/exceptions.h"
#include "raygauge/sets/half_space.h"
#include "results/run/output_place.h"
#include "results/text/language.h"
#include "results/text/words.h"
#include "scene/commands/collision_journal.h"
#include "scene/commands/command_scene.h"
#include "scene/commands/scene_input.h"
#include "scene/input/srdf_file.h"
#include "scene/planning/collision_matrix.h"

namespace raygauge::cli {
namespace {

struct CollisionArguments {
  SceneInput input;  ///< of a robot: path, packages, missing meshes
  std::string srdf, compare, as, journal;
  std::int64_t boxes = CollisionMatrixOptions().max_boxes;
  int threads = 0;
  bool force = false;
  bool json = false;
};

const char* name_of(LinkContact contact) {
  switch (contact) {
    case LinkContact::never:
      return "never";
    case LinkContact::always:
      return "always";
    case LinkContact::sometimes:
      return "sometimes";
    case LinkContact::undecided:
      break;
  }
  return "undecided";
}

/// A robot, its bodies, and what is said of each pair.
struct Matrix {
  Robot robot;
  RobotModel model;
  std::vector<std::pair<int, int>> joined;  ///< sorted
  std::vector<LinkVerdict> verdicts;
  std::vector<std::string> differences;  ///< from an SRDF file
  double seconds = 0;

  const std::string& name(int body) const { return model.bodies[static_cast<std::size_t>(body)].name; }
  bool is_joined(const LinkVerdict& verdict) const {
    return std::binary_search(joined.begin(), joined.end(), std::pair(verdict.body_a, verdict.body_b));
  }
};

/// The whole turn of a joint without limits.
std::vector<JointRange> ranges_of(const Robot& robot) {
  std::vector<JointRange> ranges;
  const std::vector<JointLimits> limits = limits_of(robot);
  for (std::size_t i = 0; i < limits.size(); ++i) {
    JointRange range{limits[i].lower, limits[i].upper};
    const bool limited = std::isfinite(range.lower) && std::isfinite(range.upper);
    if (!limited && !limits[i].turns)
      throw InvalidParameterError("joint '" + robot.joints[i] + "' is shifted and has no limits");
    if (!limited) range = {-EIGEN_PI, EIGEN_PI};
    if (!(range.lower <= range.upper))
      throw InvalidParameterError("the limits of joint '" + robot.joints[i] +
                                  "' and of those that follow it leave no value");
    ranges.push_back(range);
  }
  return ranges;
}

Matrix matrix_of(const CollisionArguments& arguments) {
  Matrix matrix;
  if (!arguments.as.empty()) check_way_to_take_a_mesh(arguments.as, "--as", "");
  RobotMeshes meshes = meshes_of(arguments.input);
  meshes.as = arguments.as;
  matrix.robot = read_robot(arguments.input.path, meshes);
  if (!arguments.as.empty()) check_has_meshes(matrix.robot, "--as");
  RobotModel& model = matrix.model;
  model.tree = matrix.robot.tree;
  model.joints = static_cast<int>(matrix.robot.joints.size());
  for (std::size_t i = 0; i < matrix.robot.links.size(); ++i) {
    const RobotLink& link = matrix.robot.links[i];
    if (link.shapes.empty()) continue;
    if (as_half_space(*link.shapes.front()) != nullptr) {
      matrix.robot.left_out.push_back("the plane '" + link.name + "', which is not bounded");
      continue;
    }
    model.bodies.push_back({link.name, static_cast<int>(i), link.shapes});
    if (!arguments.srdf.empty()) language::xml_attribute(link.name);  // refused before hours of proofs
  }
  if (model.bodies.size() < 2)
    throw EmptySetError(arguments.input.path + ": fewer than two links have a collision shape");
  matrix.joined = joined_bodies(model);
  std::sort(matrix.joined.begin(), matrix.joined.end());
  CollisionMatrixOptions options;
  options.max_boxes = arguments.boxes;
  options.threads = arguments.threads > 0 ? arguments.threads : omp_get_num_procs();
  const std::vector<JointRange> ranges = ranges_of(matrix.robot);
  std::optional<CollisionJournal> journal;
  CollisionMatrixHooks hooks;
  if (!arguments.journal.empty()) {
    journal.emplace(arguments.journal, model, ranges, options);
    hooks.known = journal->known();
    hooks.proven = [&journal](const LinkVerdict& verdict) { journal->append(verdict); };
  }
  const auto begin = std::chrono::steady_clock::now();
  matrix.verdicts = collision_matrix(model, ranges, options, hooks);
  matrix.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return matrix;
}

/// What an SRDF file says of a pair and the proof does not, one line each.
std::vector<std::string> differences(const Matrix& matrix, const std::string& path) {
  const RobotSemantics semantics = read_srdf(path, matrix.robot);
  std::vector<std::string> lines;
  for (const LinkVerdict& verdict : matrix.verdicts) {
    const auto link = [&](int body) { return matrix.model.bodies[static_cast<std::size_t>(body)].link; };
    const auto found =
        std::find_if(semantics.disabled.begin(), semantics.disabled.end(), [&](const DisabledPair& pair) {
          return pair.link_a == link(verdict.body_a) && pair.link_b == link(verdict.body_b);
        });
    const bool disabled = found != semantics.disabled.end();
    const std::string reason = disabled ? found->reason : "";
    const std::string proven = name_of(verdict.contact);
    const std::string pair = matrix.name(verdict.body_a) + " and " + matrix.name(verdict.body_b);
    const bool wrong = (reason == "Never" && !verdict.contact_at.empty()) ||
                       (reason == "Always" && !verdict.free_at.empty());
    if (wrong) lines.push_back(pair + ": the file says " + reason + ", proven: " + proven);
    const bool decided = verdict.contact == LinkContact::never || verdict.contact == LinkContact::always;
    if (!disabled && decided && !matrix.is_joined(verdict))
      lines.push_back(pair + ": not disabled in the file, proven: " + proven);
  }
  return lines;
}

std::string values_text(const Matrix& matrix, const std::vector<double>& q) {
  std::string text;
  for (std::size_t i = 0; i < q.size(); ++i) {
    char value[32];
    std::snprintf(value, sizeof value, "%.6g", q[i]);
    text += (i == 0 ? "" : " ") + matrix.robot.joints[i] + "=" + value;
  }
  return language::printable(text);
}

std::string text_of(const Matrix& matrix) {
  std::string text;
  int counts[4] = {};
  double undecided = 0;
  for (const LinkVerdict& verdict : matrix.verdicts) {
    ++counts[static_cast<int>(verdict.contact)];
    undecided += verdict.undecided;
    char line[160];
    std::snprintf(line, sizeof line, "%-9s  %s%s", name_of(verdict.contact),
                  verdict.joints == 0 ? "fixed " : "", matrix.is_joined(verdict) ? "adjacent " : "");
    text += line + language::printable(matrix.name(verdict.body_a) + " " + matrix.name(verdict.body_b));
    if (verdict.contact == LinkContact::never) {
      std::snprintf(line, sizeof line, ": at least %.3g apart", verdict.least);
      text += line;
    }
    if (verdict.contact == LinkContact::sometimes)
      text += ": in contact at " + values_text(matrix, verdict.contact_at);
    if (verdict.contact == LinkContact::undecided) {
      std::snprintf(line, sizeof line, ": %.3g %% of the volume is not proven", 100 * verdict.undecided);
      text += line;
    }
    text += "\n";
  }
  for (const std::string& line : matrix.differences) text += "differs    " + language::printable(line) + "\n";
  char line[240];
  std::snprintf(line, sizeof line,
                "%s of links: %d never, %d always, %d sometimes, %d undecided; %.3g %% of all volume "
                "undecided; %.3g s\n",
                counted(matrix.verdicts.size(), "pair").c_str(), counts[0], counts[1], counts[2], counts[3],
                100 * undecided / static_cast<double>(matrix.verdicts.size()), matrix.seconds);
  return text + line;
}

Json json_of(const Matrix& matrix) {
  Json json;
  json["robot"] = matrix.robot.name;
  json["joints"] = matrix.robot.joints;
  json["seconds"] = matrix.seconds;
  json["pairs"] = Json::array();
  for (const LinkVerdict& verdict : matrix.verdicts) {
    Json pair;
    pair["links"] = {matrix.name(verdict.body_a), matrix.name(verdict.body_b)};
    pair["contact"] = name_of(verdict.contact);
    pair["adjacent"] = matrix.is_joined(verdict);
    pair["joints_between"] = verdict.joints;
    pair["undecided"] = verdict.undecided;
    if (verdict.contact == LinkContact::never) pair["least_distance"] = verdict.least;
    if (!verdict.contact_at.empty()) pair["contact_at"] = verdict.contact_at;
    if (!verdict.free_at.empty()) pair["free_at"] = verdict.free_at;
    pair["boxes"] = verdict.boxes;
    json["pairs"].push_back(pair);
  }
  json["differences"] = matrix.differences;
  return json;
}

std::string srdf_of(const Matrix& matrix) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<robot name=\"" + language::xml_attribute(matrix.robot.name) + "\">\n";
  for (const LinkVerdict& verdict : matrix.verdicts) {
    std::string reason;
    if (verdict.contact == LinkContact::never) reason = "Never";
    if (verdict.contact == LinkContact::always) reason = "Always";
    if (matrix.is_joined(verdict)) reason = "Adjacent";
    if (reason.empty()) continue;
    text += "  <disable_collisions link1=\"" + language::xml_attribute(matrix.name(verdict.body_a)) +
            "\" link2=\"" + language::xml_attribute(matrix.name(verdict.body_b)) + "\" reason=\"" + reason +
            "\"/>\n";
  }
  return text + "</robot>\n";
}

int collisions(const CollisionArguments& arguments) {
  std::vector<std::string> inputs = {arguments.input.path};
  if (!arguments.compare.empty()) inputs.push_back(arguments.compare);
  if (!arguments.journal.empty()) {
    output_place({arguments.journal, OutputKind::results, {".jsonl"}, inputs, false});
    inputs.push_back(arguments.journal);
  }
  OutputPlace place;
  if (!arguments.srdf.empty())
    place = output_place({arguments.srdf, OutputKind::text, {".srdf", ".xml"}, inputs, arguments.force});
  Matrix matrix = matrix_of(arguments);
  std::vector<std::string> notes = lines_of_left_out(matrix.robot);
  notes.insert(notes.end(), matrix.robot.notes.begin(), matrix.robot.notes.end());
  print_notes(notes);
  if (!arguments.compare.empty()) matrix.differences = differences(matrix, arguments.compare);
  const bool to_output = !arguments.srdf.empty() && place.way == OutputWay::standard_output;
  if (!arguments.srdf.empty() && !to_output) write_output(place, srdf_of(matrix));
  const std::string told = arguments.json ? json_text(json_of(matrix)) + "\n" : text_of(matrix);
  std::fputs((to_output ? srdf_of(matrix) : told).c_str(), stdout);
  return kAnswered;
}

}  // namespace

void add_collisions_command(Command& scene, int& status) {
  const auto arguments = std::make_shared<CollisionArguments>();
  Command command = scene.add_subcommand(
      "collisions", "Which links of a robot never, always or sometimes meet within its limits: proven");
  command.add_option("robot", arguments->input.path, "Robot (URDF)").required().type_name("ROBOT.urdf");
  command
      .add_option("--srdf", arguments->srdf,
                  "Write the pairs that never or always meet, and adjacent links, as an SRDF file")
      .type_name("FILE.srdf");
  command
      .add_option("--compare", arguments->compare, "Name the pairs for which this SRDF file says otherwise")
      .type_name("FILE.srdf");
  command
      .add_option("--boxes", arguments->boxes,
                  "Boxes of joint values looked at for one pair; what is left then is undecided")
      .type_name("K");
  command
      .add_option(
          "--journal", arguments->journal,
          "Keep each pair in this file as soon as it is proven; pairs that it has are not proven again")
      .type_name("FILE.jsonl");
  command.add_option("--threads", arguments->threads, "Threads; 0: one for each core")
      .range(0, 65536)
      .type_name("K");
  add_mesh_options(command, arguments->input);
  command
      .add_option("--as", arguments->as,
                  "What meshes are taken as: hull, surface, solid or parts; else as they are")
      .type_name("WAY");
  command.add_flag("--force", arguments->force, "Replace a file of another kind");
  command.add_flag("--json", arguments->json, "Print one JSON object");
  command.callback([arguments, &status] {
    if (arguments->boxes < 1) throw InvalidParameterError("--boxes must be at least 1");
    status = collisions(*arguments);
  });
}

}  // namespace raygauge::cli
