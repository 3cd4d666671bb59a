// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/commands/collision_journal.h"

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>

#include "engine/meshes/box_tree.h"
#include "raygauge/meshes/mesh.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/prepared_set.h"
#include "results/exceptions.h"
#include "results/provenance/provenance.h"

namespace raygauge::cli {
namespace {

using Json = nlohmann::json;

constexpr const char* kFormat = "raygauge-collisions";

void add(std::string& text, double number) {
  char digits[32];
  std::snprintf(digits, sizeof digits, " %.17g", number);
  text += digits;
}

void add(std::string& text, const Placement& place) {
  for (const double number : place.R.reshaped()) add(text, number);
  for (const double number : place.t) add(text, number);
}

void add(std::string& text, const Mesh& mesh) {
  text += " mesh";
  for (const double number : {static_cast<double>(mesh.kind()), mesh.radius()}) add(text, number);
  for (std::ptrdiff_t i = 0; i < mesh.tree().size(); ++i) {
    for (const Vector3& corner : mesh.tree().triangle(static_cast<std::int32_t>(i)).corner)
      for (const double number : {corner.x, corner.y, corner.z}) add(text, number);
  }
}

/// All triangles of a mesh and points of a hull; of a shape, which has a few numbers, its support function in
/// more directions than these.
void add(std::string& text, const ConvexSet& part) {
  if (const Mesh* mesh = as_mesh(part)) return add(text, *mesh);
  const auto* prepared = dynamic_cast<const PreparedSet*>(&part);
  const auto* points = prepared != nullptr ? &prepared->points() : dynamic_cast<const PointSet*>(&part);
  if (points != nullptr) {
    const DenseMatrix all = points->points();
    for (const double number : all.reshaped()) add(text, number);
    return;
  }
  Vector u(3);
  for (int k = 1; k <= 49; ++k) {
    const int row = k / 7;
    u << k % 7 - 3, row - 3, k % 5 - 2.5;
    for (const double sign : {1.0, -1.0}) add(text, part.support_function(Vector(sign * u)));
  }
}

/// FNV-1a, 64 bits.
std::string hash_of(std::string_view text) {
  std::uint64_t hash = 14695981039346656037U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
  char digits[20];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
  return digits;
}

/// What a matrix is made of: two of the same text have the same verdicts.
std::string matrix_identity(const RobotModel& robot, const std::vector<JointRange>& ranges,
                            const CollisionMatrixOptions& options) {
  std::string text = build_info().raygauge_version;
  add(text, options.contact);
  add(text, static_cast<double>(options.max_boxes));
  for (const JointRange& range : ranges) {
    add(text, range.lower);
    add(text, range.upper);
  }
  for (const TreeLink& link : robot.tree.links) {
    for (const int number : {link.parent, static_cast<int>(link.kind), link.joint}) add(text, number);
    for (const double number : link.axis) add(text, number);
    add(text, link.scale);
    add(text, link.offset);
    add(text, link.origin);
  }
  for (const RobotBody& body : robot.bodies) {
    text += "\n" + body.name;
    add(text, body.link);
    add(text, body.origin);
    for (const auto& part : body.parts) add(text, *part);
  }
  return hash_of(text);
}

Json json_of(const LinkVerdict& verdict) {
  return {{"bodies", {verdict.body_a, verdict.body_b}},
          {"contact", static_cast<int>(verdict.contact)},
          {"undecided", verdict.undecided},
          {"contact_at", verdict.contact_at},
          {"free_at", verdict.free_at},
          {"least", verdict.least},
          {"joints", verdict.joints},
          {"boxes", verdict.boxes}};
}

LinkVerdict verdict_of(const Json& line, const RobotModel& robot) {
  LinkVerdict verdict;
  verdict.body_a = line.at("bodies").at(0).get<int>();
  verdict.body_b = line.at("bodies").at(1).get<int>();
  const int contact = line.at("contact").get<int>();
  verdict.contact = static_cast<LinkContact>(contact);
  verdict.undecided = line.at("undecided").get<double>();
  verdict.contact_at = line.at("contact_at").get<std::vector<double>>();
  verdict.free_at = line.at("free_at").get<std::vector<double>>();
  verdict.least = line.at("least").get<double>();
  verdict.joints = line.at("joints").get<int>();
  verdict.boxes = line.at("boxes").get<std::int64_t>();
  const auto is_configuration = [&](const std::vector<double>& q) {
    return q.empty() || static_cast<int>(q.size()) == robot.joints;
  };
  if (contact < 0 || contact > static_cast<int>(LinkContact::undecided) || verdict.body_a < 0 ||
      verdict.body_a >= verdict.body_b || verdict.body_b >= static_cast<int>(robot.bodies.size()) ||
      !is_configuration(verdict.contact_at) || !is_configuration(verdict.free_at))
    throw ResultsError("is not a verdict about this robot");
  return verdict;
}

/// `path`, whose folder is there now.
std::string in_its_folder(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::error_code ignored;  // what follows says that it cannot write
  if (!folder.empty()) std::filesystem::create_directories(folder, ignored);
  return path;
}

/// The whole lines of a journal of this matrix.
std::vector<std::string_view> lines_of(const std::string& path, std::string_view bytes,
                                       const std::string& head) {
  std::vector<std::string_view> lines;
  if (bytes.empty() || head.starts_with(bytes)) return lines;  // killed while it was begun
  for (std::size_t end = bytes.find('\n'); end != std::string_view::npos; end = bytes.find('\n')) {
    lines.push_back(bytes.substr(0, end));
    bytes.remove_prefix(end + 1);
  }
  if (lines.empty() || !lines[0].starts_with(std::string(R"({"format":")") + kFormat))
    throw ResultsError(path + ": is no journal of a collision matrix; choose another file");
  if (lines[0] != head) {
    throw ResultsError(path +
                       ": is of another robot, other limits, other --boxes or another version of raygauge; "
                       "choose another file, or remove it");
  }
  lines.erase(lines.begin());
  return lines;
}

}  // namespace

CollisionJournal::CollisionJournal(const std::string& path, const RobotModel& robot,
                                   const std::vector<JointRange>& ranges,
                                   const CollisionMatrixOptions& options)
    : lock_(in_its_folder(path) + ".lock") {
  const std::string head =
      Json({{"format", kFormat}, {"matrix", matrix_identity(robot, ranges, options)}}).dump();
  const std::string bytes = std::filesystem::exists(path) ? file_bytes(path) : "";
  std::string kept = head + "\n";
  for (const std::string_view line : lines_of(path, bytes, head)) {
    try {
      known_.push_back(verdict_of(Json::parse(line), robot));
    } catch (const std::exception& error) {
      throw ResultsError(path + ": line " + std::to_string(known_.size() + 2) + ": " + error.what());
    }
    kept.append(line).append("\n");
  }
  write_atomically(path, kept);
  file_.emplace(path);
}

void CollisionJournal::append(const LinkVerdict& verdict) { file_->append(json_of(verdict).dump() + "\n"); }

}  // namespace raygauge::cli
