// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Collada 1.4 and 1.5, as far as the vertices of meshes and the nodes that place them go.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string_view>

#include "cli/input/byte_reader.h"
#include "cli/input/mesh_formats.h"
#include "cli/input/number_word.h"
#include "cli/input/xml_values.h"

namespace raygauge::cli {
namespace {

using Map = Eigen::Affine3d;

/// More nodes inside one another, or more instances, than a mesh has use for.
constexpr int kDeepestNode = 64;
constexpr int kMostInstances = 100'000;

const XmlElement* first(const XmlElement* parent, const char* name) {
  return parent == nullptr ? nullptr : parent->FirstChildElement(name);
}

class ColladaReader {
 public:
  ColladaReader(std::string_view bytes, const std::string& name) : file_(std::string(bytes), name) {}

  MeshText read() {
    const XmlElement& root = file_.root();
    if (std::string_view(root.Name()) != "COLLADA")
      file_.refuse(root, std::string("not a Collada file: its root is <") + root.Name() + ">, not <COLLADA>");
    collect(root);
    const XmlElement* unit = first(first(&root, "asset"), "unit");
    const double meter = unit == nullptr ? 1 : file_.number(*unit, "meter", 1);
    if (!(meter > 0)) file_.refuse(*unit, "the unit must be positive");
    add_children(scene_of(root), Map(Eigen::Scaling(meter)), 0);
    return std::move(mesh_);
  }

 private:
  /// The elements that others name.
  void collect(const XmlElement& root) {
    std::vector<const XmlElement*> open = {&root};
    while (!open.empty()) {
      const XmlElement* element = open.back();
      open.pop_back();
      if (const char* id = element->Attribute("id")) ids_.emplace(id, element);
      for (const XmlElement* child = element->FirstChildElement(); child != nullptr;
           child = child->NextSiblingElement())
        open.push_back(child);
    }
  }

  /// What "#id" in an attribute names; it must be an element of that kind.
  const XmlElement& named(const XmlElement& element, const char* attribute, std::string_view kind) const {
    const std::string url = file_.text(element, attribute);
    const auto found = url.starts_with("#") ? ids_.find(url.substr(1)) : ids_.end();
    if (found == ids_.end() || found->second->Name() != kind)
      file_.refuse(element, std::string(attribute) + " names no <" + std::string(kind) +
                                "> of this file: " + quoted(url));
    return *found->second;
  }

  const XmlElement& scene_of(const XmlElement& root) const {
    if (const XmlElement* instance = first(first(&root, "scene"), "instance_visual_scene"))
      return named(*instance, "url", "visual_scene");
    const XmlElement* only = first(first(&root, "library_visual_scenes"), "visual_scene");
    if (only == nullptr || only->NextSiblingElement("visual_scene") != nullptr)
      file_.refuse(root, "it does not say which scene it shows");
    return *only;
  }

  void add_children(const XmlElement& parent, const Map& map, int depth) {
    if (depth > kDeepestNode || ++instances_ > kMostInstances)
      file_.refuse(parent, "nodes that contain themselves, or too many");
    for (const XmlElement* child = parent.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      const std::string_view kind = child->Name();
      if (kind == "node") add_node(*child, map, depth + 1);
      if (kind == "instance_node") add_node(named(*child, "url", "node"), map, depth + 1);
      if (kind == "instance_geometry") add_geometry(named(*child, "url", "geometry"), map);
      if (kind == "instance_controller") add_controller(named(*child, "url", "controller"), map);
    }
  }

  void add_node(const XmlElement& node, Map map, int depth) {
    for (const XmlElement* step = node.FirstChildElement(); step != nullptr;
         step = step->NextSiblingElement())
      map = map * step_of(*step);
    add_children(node, map, depth);
  }

  /// The identity for an element that moves nothing.
  Map step_of(const XmlElement& step) const {
    const std::string_view kind = step.Name();
    if (kind == "matrix") return matrix_of(step);
    if (kind == "translate") {
      const std::vector<double> v = numbers_of(step, 3);
      return Map(Eigen::Translation3d(v[0], v[1], v[2]));
    }
    if (kind == "scale") {
      const std::vector<double> v = numbers_of(step, 3);
      return Map(Eigen::Scaling(v[0], v[1], v[2]));
    }
    if (kind == "rotate") {
      const std::vector<double> v = numbers_of(step, 4);
      const Eigen::Vector3d axis(v[0], v[1], v[2]);
      if (v[3] == 0) return Map::Identity();
      if (!(axis.norm() > 0)) file_.refuse(step, "a rotation without an axis");
      return Map(Eigen::AngleAxisd(v[3] * M_PI / 180, axis.normalized()));
    }
    if (kind == "lookat" || kind == "skew") file_.refuse(step, "<" + std::string(kind) + "> is not read");
    return Map::Identity();
  }

  Map matrix_of(const XmlElement& element) const {
    const std::vector<double> m = numbers_of(element, 16);
    if (m[12] != 0 || m[13] != 0 || m[14] != 0 || m[15] != 1)
      file_.refuse(element, "the last row of a matrix must be 0 0 0 1");
    Map map = Map::Identity();
    for (int i = 0; i < 12; ++i) map.matrix()(i / 4, i % 4) = m[static_cast<std::size_t>(i)];
    return map;
  }

  void add_controller(const XmlElement& controller, const Map& map) {
    const XmlElement* skin = first(&controller, "skin");
    if (skin == nullptr) file_.refuse(controller, "a controller that is no skin is not read");
    const XmlElement* shape = first(skin, "bind_shape_matrix");
    add_geometry(named(*skin, "source", "geometry"), shape == nullptr ? map : map * matrix_of(*shape));
  }

  void add_geometry(const XmlElement& geometry, const Map& map) {
    const XmlElement* mesh = first(&geometry, "mesh");
    if (mesh == nullptr) file_.refuse(geometry, "a geometry that is no mesh is not read");
    const XmlElement* corners = first(mesh, "vertices");
    if (corners == nullptr) file_.refuse(*mesh, "a mesh without <vertices>");
    const XmlElement* input = first(corners, "input");
    while (input != nullptr && file_.text(*input, "semantic") != "POSITION")
      input = input->NextSiblingElement("input");
    if (input == nullptr) file_.refuse(*corners, "vertices without positions");
    const std::size_t before = mesh_.vertices.size(), first_face = mesh_.faces.ends.size();
    const std::size_t count = add_positions(named(*input, "source", "source"), map);
    for (const XmlElement* child = mesh->FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement())
      add_faces(*child, before, count);
    if (map.linear().determinant() < 0) mesh_.faces.turn_about(first_face);
  }

  std::size_t add_positions(const XmlElement& source, const Map& map) {
    const XmlElement* array = first(&source, "float_array");
    const XmlElement* accessor = first(first(&source, "technique_common"), "accessor");
    if (array == nullptr || accessor == nullptr)
      file_.refuse(source, "positions need <float_array> and <accessor>");
    const std::vector<double> numbers = numbers_of(*array, whole(*array, "count", 0));
    const std::size_t count = whole(*accessor, "count", 0), stride = whole(*accessor, "stride", 1);
    const std::size_t offset = accessor->Attribute("offset") == nullptr ? 0 : whole(*accessor, "offset", 0);
    if (stride < 3 || offset > numbers.size() || count > (numbers.size() - offset) / stride)
      file_.refuse(*accessor,
                   "it reads beyond the numbers that there are, or fewer than three for a position");
    for (std::size_t i = 0; i < count; ++i) {
      const double* p = &numbers[offset + i * stride];
      const Eigen::Vector3d at = map * Eigen::Vector3d(p[0], p[1], p[2]);
      mesh_.vertices.push_back({at[0], at[1], at[2]});
    }
    return count;
  }

  /// Numbers in <p> and <h> of a primitive must be whole, and those that name vertices must name some that
  /// are there.
  void add_faces(const XmlElement& primitive, std::size_t before, std::size_t count) {
    std::size_t stride = 0, vertex = 0;
    for (const XmlElement* input = first(&primitive, "input"); input != nullptr;
         input = input->NextSiblingElement("input")) {
      const std::size_t offset = input->Attribute("offset") == nullptr ? 0 : whole(*input, "offset", 0);
      if (file_.text(*input, "semantic") == "VERTEX") vertex = offset;
      stride = std::max(stride, offset + 1);
    }
    for (const XmlElement* list = first(&primitive, "p"); list != nullptr;
         list = list->NextSiblingElement("p")) {
      const std::string text = list->GetText() == nullptr ? "" : list->GetText();
      std::vector<std::uint32_t> corners;
      std::size_t at = 0;
      for (const std::string_view word : words_of(text)) {
        const std::optional<long> index = integer_of(word);
        if (!index || *index < 0) file_.refuse(*list, quoted(word) + " is not a count");
        if (stride == 0 || at++ % stride != vertex) continue;
        if (static_cast<std::size_t>(*index) >= count)
          file_.refuse(*list, "vertex " + std::string(word) + " is not there: " + std::to_string(count) +
                                  " are, counted from 0");
        corners.push_back(static_cast<std::uint32_t>(before + static_cast<std::size_t>(*index)));
      }
      add_polygons(primitive, corners);
    }
  }

  /// The faces of one <p>, by the kind of what it is in; lines are none.
  void add_polygons(const XmlElement& primitive, const std::vector<std::uint32_t>& corners) {
    const std::string_view kind = primitive.Name();
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
      for (const std::size_t i : {a, b, c}) mesh_.faces.add(corners[i]);
      mesh_.faces.close();
    };
    const std::size_t size = corners.size();
    if (kind == "triangles") {
      for (std::size_t i = 2; i < size; i += 3) add(i - 2, i - 1, i);
    } else if (kind == "tristrips") {
      for (std::size_t i = 2; i < size; ++i) i % 2 == 0 ? add(i - 2, i - 1, i) : add(i - 1, i - 2, i);
    } else if (kind == "trifans") {
      for (std::size_t i = 2; i < size; ++i) add(0, i - 1, i);
    } else if (kind == "polygons") {
      for (const std::uint32_t corner : corners) mesh_.faces.add(corner);
      mesh_.faces.close();
    } else if (kind == "polylist") {
      add_counted(primitive, corners);
    }
  }

  void add_counted(const XmlElement& primitive, const std::vector<std::uint32_t>& corners) {
    const XmlElement* counts = first(&primitive, "vcount");
    const std::string text = counts == nullptr || counts->GetText() == nullptr ? "" : counts->GetText();
    std::size_t at = 0;
    for (const std::string_view word : words_of(text)) {
      const std::optional<long> count = integer_of(word);
      if (!count || *count < 0 || static_cast<std::size_t>(*count) > corners.size() - at)
        file_.refuse(*counts, "<vcount> and <p> do not fit together");
      for (long i = 0; i < *count; ++i) mesh_.faces.add(corners[at++]);
      mesh_.faces.close();
    }
    if (at != corners.size()) file_.refuse(primitive, "<vcount> and <p> do not fit together");
  }

  std::size_t whole(const XmlElement& element, const char* name, long least) const {
    const std::string value = file_.text(element, name);
    const std::optional<long> number = integer_of(value);
    if (!number || *number < least)
      file_.refuse(element, std::string(name) + " must be a count, got " + quoted(value));
    return static_cast<std::size_t>(*number);
  }

  /// The numbers in an element, which must be so many.
  std::vector<double> numbers_of(const XmlElement& element, std::size_t wanted) const {
    const std::string text = element.GetText() == nullptr ? "" : element.GetText();
    std::vector<double> numbers;
    for (const std::string_view word : words_of(text)) {
      const std::optional<double> number = number_of(word);
      if (!number || !std::isfinite(*number)) file_.refuse(element, quoted(word) + " is not a finite number");
      numbers.push_back(*number);
    }
    if (numbers.size() != wanted)
      file_.refuse(element, "<" + std::string(element.Name()) + "> has " + std::to_string(numbers.size()) +
                                " numbers, " + std::to_string(wanted) + " are expected");
    return numbers;
  }

  XmlFile file_;
  std::map<std::string, const XmlElement*> ids_;
  MeshText mesh_;
  int instances_ = 0;
};

}  // namespace

MeshText collada_mesh(std::string_view text, const std::string& name) {
  return ColladaReader(text, name).read();
}

}  // namespace raygauge::cli
