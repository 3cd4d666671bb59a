// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/mesh_object_file.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <span>

#include "cli/input/mesh_file.h"
#include "cli/input/point_source.h"
#include "cli/input/toml_refusal.h"
#include "engine/meshes/convexity.h"
#include "raygauge/exceptions.h"
#include "raygauge/meshes/mesh.h"
#include "raygauge/sets/point_set.h"

namespace raygauge::cli {
namespace {

using SetPointer = std::shared_ptr<const ConvexSet>;

SetPointer mesh_object(const MeshFile& file, const std::string& name, MeshKind kind) {
  return placed(name,
                [&] { return std::make_shared<MeshObject>(Mesh(file.vertices, file.triangles, kind)); });
}

SetPointer hull_of(const MeshFile& file) { return std::make_shared<PointSet>(distinct_vertices(file)); }

std::vector<std::string> meshes_of_folder(const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (is_mesh_file(entry.path().string())) files.push_back(entry.path().string());
  if (files.empty()) throw EmptySetError(folder + ": no mesh in this folder");
  std::sort(files.begin(), files.end());
  return files;
}

/// The triangles of an object, and of their vertices those that they use.
MeshFile own_mesh(const MeshFile& file, const std::vector<Triangle>& triangles) {
  MeshFile own;
  std::map<std::int32_t, std::int32_t> number;
  for (const Triangle& triangle : triangles)
    for (const std::int32_t i : triangle) number.emplace(i, 0);
  own.vertices.resize(3, static_cast<Eigen::Index>(number.size()));
  std::int32_t next = 0;
  for (auto& [given, here] : number) {
    own.vertices.col(next) = file.vertices.col(given);
    here = next++;
  }
  for (const auto& [a, b, c] : triangles) own.triangles.push_back({number[a], number[b], number[c]});
  return own;
}

/// Triangles of an object, runs of the same name together; those without faces have none.
struct Objects {
  std::vector<std::string> names;  ///< in the order of the file
  std::map<std::string, std::vector<Triangle>> triangles;
  std::string without_faces;  ///< their names
};

Objects objects_of(const MeshFile& file) {
  Objects objects;
  for (const MeshRun& run : file.runs) {
    const auto own = std::span(file.triangles).subspan(run.begin, run.end - run.begin);
    const auto [found, is_new] = objects.triangles.try_emplace(run.name);
    if (is_new) objects.names.push_back(run.name);
    found->second.insert(found->second.end(), own.begin(), own.end());
  }
  std::erase_if(objects.names, [&](const std::string& name) {
    const bool empty = objects.triangles.at(name).empty();
    if (empty && !name.empty())
      objects.without_faces += (objects.without_faces.empty() ? "'" : ", '") + name + "'";
    return empty;
  });
  return objects;
}

std::vector<SetPointer> parts_of(const MeshFile& file, const std::string& name, Notes& notes) {
  Objects objects = objects_of(file);
  if (objects.names.size() < 2)
    throw InvalidParameterError(
        name + ": as = \"parts\" needs a folder or a list of meshes, a convex part " +
        "each, or an OBJ or glTF file with two objects or groups (o, g) with faces or more");
  std::vector<SetPointer> parts;
  for (const std::string& object : objects.names) {
    const MeshFile own = own_mesh(file, objects.triangles.at(object));
    add_note(hull_note(name + ", object '" + object + "'", own), notes);
    parts.push_back(hull_of(own));
  }
  add_note(name + ": " + std::to_string(parts.size()) + " parts, each the convex hull of an object", notes);
  if (!objects.without_faces.empty())
    add_note(name + ": left out, for these objects have no faces: " + objects.without_faces, notes);
  return parts;
}

SetPointer as_it_is(const MeshFile& file, const std::string& name, Notes& notes) {
  if (file.triangles.empty()) {
    add_note(name + ": points without faces, taken as their convex hull; shape = \"cloud\" with a radius " +
                 "takes them one by one",
             notes);
    return hull_of(file);
  }
  const HullCost cost = hull_cost(file.vertices, file.triangles);
  if (cost.convex) return hull_of(file);
  SetPointer set = mesh_object(file, name, cost.closed ? MeshKind::solid : MeshKind::surface);
  add_note(name + ": this mesh is not convex and is taken as it is, as a " +
               (cost.closed ? "solid" : "surface") + " of " + std::to_string(file.triangles.size()) +
               " triangles; as = \"hull\" takes its convex hull" + volumes_of(cost),
           notes);
  return set;
}

const std::vector<std::string> kWays = {"hull", "surface", "solid", "parts"};

}  // namespace

bool has_objects(const MeshFile& file) { return objects_of(file).names.size() > 1; }

void check_way_to_take_a_mesh(const std::string& as, const std::string& what, const std::string& place) {
  if (std::find(kWays.begin(), kWays.end(), as) == kWays.end())
    throw UnknownNameError(what, as, kWays, place);
}

std::vector<SetPointer> take_mesh(const MeshFile& file, const std::string& name, const std::string& as,
                                  Notes& notes) {
  if (as.empty()) return {as_it_is(file, name, notes)};
  check_way_to_take_a_mesh(as, "way to take a mesh", "");
  if (as == "parts") return parts_of(file, name, notes);
  if (as == "hull") {
    add_note(hull_note(name, file), notes);
    return {hull_of(file)};
  }
  add_note(
      name + ": taken as it is, as a " + as + " of " + std::to_string(file.triangles.size()) + " triangles",
      notes);
  return {mesh_object(file, name, as == "solid" ? MeshKind::solid : MeshKind::surface)};
}

SetPointer read_mesh_as(const std::string& path, const std::string& as) {
  if (as != "hull" && as != "surface" && as != "solid")
    throw UnknownNameError("way to take a mesh", as, {"hull", "surface", "solid"});
  Notes without_use;
  return take_mesh(read_mesh(path), path, as, without_use).front();
}

SetPointer read_cloud(const std::string& source, double radius) {
  const Eigen::MatrixXd points = read_point_source(source);
  if (points.rows() != 3)
    throw DimensionMismatchError(source + ": a cloud has points of R^3, these are of R^" +
                                 std::to_string(points.rows()));
  return placed(source, [&] { return std::make_shared<MeshObject>(Mesh::cloud(points, radius)); });
}

std::vector<SetPointer> read_parts(const std::vector<std::string>& sources, Notes& notes) {
  const bool folder = sources.size() == 1 && std::filesystem::is_directory(sources.front());
  if (sources.size() == 1 && !folder) return parts_of(read_mesh(sources.front()), sources.front(), notes);
  const std::vector<std::string> files = folder ? meshes_of_folder(sources.front()) : sources;
  std::vector<SetPointer> parts;
  for (const std::string& file : files) {
    const MeshFile mesh = read_mesh(file);
    add_note(hull_note(file, mesh), notes);
    parts.push_back(hull_of(mesh));
  }
  if (!files.empty())
    add_note((folder ? sources.front() : files.front() + ", ...") + ": " + std::to_string(files.size()) +
                 " parts, each the convex hull of a file",
             notes);
  return parts;
}

}  // namespace raygauge::cli
