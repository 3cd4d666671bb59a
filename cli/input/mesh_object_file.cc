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
#include "raygauge/meshes/mesh_object.h"
#include "raygauge/sets/point_set.h"

namespace raygauge::cli {
namespace {

using SetPointer = std::shared_ptr<const ConvexSet>;

SetPointer mesh_object(const MeshFile& file, const std::string& path, MeshKind kind) {
  return placed(path,
                [&] { return std::make_shared<MeshObject>(Mesh(file.vertices, file.triangles, kind)); });
}

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

std::vector<SetPointer> parts_of_file(const std::string& path, Notes& notes) {
  const MeshFile file = read_mesh(path);
  std::vector<std::string> names;
  std::map<std::string, std::vector<Triangle>> objects;
  for (const MeshRun& run : file.runs) {
    const auto own = std::span(file.triangles).subspan(run.begin, run.end - run.begin);
    if (own.empty()) continue;
    std::vector<Triangle>& all = objects[run.name];
    if (all.empty()) names.push_back(run.name);
    all.insert(all.end(), own.begin(), own.end());
  }
  if (names.size() < 2)
    throw InvalidParameterError(path + ": as = \"parts\" needs a folder or a list of meshes, a convex part " +
                                "each, or an OBJ file with two objects or groups (o, g) or more");
  std::vector<SetPointer> parts;
  for (const std::string& name : names) {
    const MeshFile own = own_mesh(file, objects[name]);
    add_note(hull_note(path + ", object '" + name + "'", own), notes);
    parts.push_back(std::make_shared<PointSet>(distinct_vertices(own)));
  }
  add_note(path + ": " + std::to_string(parts.size()) + " parts, each the convex hull of an object", notes);
  return parts;
}

}  // namespace

SetPointer read_mesh_as(const std::string& path, const std::string& as) {
  if (as != "hull" && as != "surface" && as != "solid")
    throw UnknownNameError("way to take a mesh", as, {"hull", "surface", "solid"});
  const MeshFile file = read_mesh(path);
  if (as == "hull") return std::make_shared<PointSet>(distinct_vertices(file));
  return mesh_object(file, path, as == "solid" ? MeshKind::solid : MeshKind::surface);
}

SetPointer read_cloud(const std::string& source, double radius) {
  const Eigen::MatrixXd points = read_point_source(source);
  if (points.rows() != 3)
    throw DimensionMismatchError(source + ": a cloud has points of R^3, these are of R^" +
                                 std::to_string(points.rows()));
  return placed(source, [&] { return std::make_shared<MeshObject>(Mesh::cloud(points, radius)); });
}

SetPointer read_mesh_as_it_is(const std::string& path, Notes& notes) {
  const MeshFile file = read_mesh(path);
  if (file.triangles.empty())
    add_note(
        path + ": points without faces, taken as their convex hull; shape = \"cloud\" with a radius takes " +
            "them one by one",
        notes);
  const HullCost cost =
      file.triangles.empty() ? HullCost{.convex = true} : hull_cost(file.vertices, file.triangles);
  if (cost.convex) return std::make_shared<PointSet>(distinct_vertices(file));
  SetPointer set = mesh_object(file, path, cost.closed ? MeshKind::solid : MeshKind::surface);
  add_note(path + ": this mesh is not convex and is taken as it is, as a " +
               (cost.closed ? "solid" : "surface") + " of " + std::to_string(file.triangles.size()) +
               " triangles; as = \"hull\" takes its convex hull" + volumes_of(cost),
           notes);
  return set;
}

std::vector<SetPointer> read_parts(const std::vector<std::string>& sources, Notes& notes) {
  const bool folder = sources.size() == 1 && std::filesystem::is_directory(sources.front());
  if (sources.size() == 1 && !folder) return parts_of_file(sources.front(), notes);
  const std::vector<std::string> files = folder ? meshes_of_folder(sources.front()) : sources;
  std::vector<SetPointer> parts;
  for (const std::string& file : files) {
    const MeshFile mesh = read_mesh(file);
    add_note(hull_note(file, mesh), notes);
    parts.push_back(std::make_shared<PointSet>(distinct_vertices(mesh)));
  }
  if (!files.empty())
    add_note((folder ? sources.front() : files.front() + ", ...") + ": " + std::to_string(files.size()) +
                 " parts, each the convex hull of a file",
             notes);
  return parts;
}

}  // namespace raygauge::cli
