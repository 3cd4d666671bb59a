// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/hull_note.h"

#include <algorithm>
#include <cstdio>

#include "results/text/language.h"

namespace raygauge::cli {
namespace {

std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

}  // namespace

std::string volumes_of(const HullCost& cost) {
  if (!cost.closed) return ": the surface is not closed, so it bounds no volume";
  if (!(cost.hull_volume > cost.volume)) return "";  // also where there is no hull to compare with
  return ": the hull has " + number_text(cost.hull_volume) + " of volume, the mesh " +
         number_text(cost.volume);
}

std::string hull_note(const std::string& name, const MeshFile& mesh) {
  if (mesh.triangles.empty()) return "";
  const HullCost cost = hull_cost(mesh.vertices, mesh.triangles);
  if (cost.convex) return "";
  return name + ": this mesh is not convex, and its convex hull stands for it" + volumes_of(cost) +
         "; shape = \"mesh\" of a set file takes it as it is, and so does a scene without as = \"hull\"; "
         "convex "
         "parts (as = \"parts\") have a depth, too";
}

void add_note(const std::string& note, Notes& notes) {
  if (!note.empty() && std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
}

void print_notes(const Notes& notes) {
  for (const std::string& note : notes) std::fprintf(stderr, "note: %s\n", language::printable(note).c_str());
}

}  // namespace raygauge::cli
