// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// glTF 2.0, as far as the positions and triangles of meshes and the nodes that place them go.
#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/input/byte_reader.h"
#include "cli/input/input_file.h"
#include "cli/input/mesh_formats.h"
#include "raygauge/exceptions.h"

namespace raygauge::cli {
namespace {

using Json = nlohmann::json;
using Map = Eigen::Affine3d;

/// More nodes inside one another, instances or vertices of all instances than a mesh has use for.
constexpr int kDeepestNode = 64;
constexpr int kMostInstances = 100'000;
constexpr std::size_t kMostVertices = 50'000'000;

constexpr std::string_view kMagic = "glTF";
constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;

/// Numbers of an accessor, one after the other.
struct Accessor {
  const char* data = nullptr;
  std::size_t count = 0, stride = 0;
  int type = 0;
  bool normalized = false;
};

std::size_t size_of(int type) {
  return type == 5120 || type == 5121 ? 1 : type == 5122 || type == 5123 ? 2 : 4;
}

template <class T>
double number_at(const char* data, bool normalized) {
  T value;
  __builtin_memcpy(&value, data, sizeof(T));
  const double number = static_cast<double>(value);
  return normalized ? std::max(number / static_cast<double>(std::numeric_limits<T>::max()), -1.0) : number;
}

double number_at(const char* data, int type, bool normalized) {
  switch (type) {
    case 5120:
      return number_at<std::int8_t>(data, normalized);
    case 5121:
      return number_at<std::uint8_t>(data, normalized);
    case 5122:
      return number_at<std::int16_t>(data, normalized);
    case 5123:
      return number_at<std::uint16_t>(data, normalized);
    case 5125:
      return number_at<std::uint32_t>(data, false);
    default:
      return number_at<float>(data, false);
  }
}

std::optional<std::string> from_base64(std::string_view text) {
  static constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  while (text.ends_with('=')) text.remove_suffix(1);
  std::string bytes;
  std::uint32_t bits = 0;
  int have = 0;
  for (const char c : text) {
    const std::size_t digit = kDigits.find(c);
    if (digit == std::string_view::npos) return std::nullopt;
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    have += 6;
    if (have < 8) continue;
    have -= 8;
    bytes.push_back(static_cast<char>(bits >> have & 0xFF));
  }
  return bytes;
}

class GltfReader {
 public:
  GltfReader(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  MeshText read() {
    try {
      read_chunks();
      check_extensions();
      read_buffers();
      const Json& scene = scene_of();
      if (scene.contains("nodes")) {
        for (const Json& node : scene.at("nodes")) add_node(whole(node, "a node"), Map::Identity(), 0);
      }
    } catch (const Json::exception& error) {
      fail(std::string("not glTF that can be read: ") + error.what());
    }
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw InvalidParameterError(name_ + ": " + what); }

  /// A file in text is JSON alone; a binary one has it in a chunk, and its buffer in another.
  void read_chunks() {
    if (!bytes_.starts_with(kMagic)) {
      json_ = Json::parse(bytes_);
      return;
    }
    ByteReader reader(bytes_, name_);
    reader.bytes(kMagic.size());
    const auto version = reader.number<std::uint32_t>(false);
    if (version != 2) fail("glTF of version " + std::to_string(version) + "; 2 is read");
    if (reader.number<std::uint32_t>(false) != bytes_.size()) fail("its header promises another length");
    while (!reader.empty()) {
      const auto length = reader.number<std::uint32_t>(false), kind = reader.number<std::uint32_t>(false);
      const std::string_view chunk = reader.bytes(length);
      if (kind == kJsonChunk && json_.is_null()) json_ = Json::parse(chunk);
      if (kind == kBinaryChunk && !binary_) binary_ = chunk;
    }
    if (json_.is_null()) fail("it has no JSON chunk");
  }

  void check_extensions() const {
    if (json_.at("asset").at("version").get<std::string>().substr(0, 2) != "2.") fail("glTF 2 is read");
    if (!json_.contains("extensionsRequired")) return;
    for (const Json& extension : json_.at("extensionsRequired")) {
      const auto name = extension.get<std::string>();
      const bool looks = name.starts_with("KHR_materials_") || name.starts_with("KHR_texture_");
      if (!looks && name != "KHR_mesh_quantization")
        fail("it needs the extension " + name + ", which is not read");
    }
  }

  void read_buffers() {
    if (!json_.contains("buffers")) return;
    for (const Json& buffer : json_.at("buffers")) {
      const std::size_t length = whole(buffer.at("byteLength"), "byteLength");
      if (!buffer.contains("uri")) {
        if (!binary_ || !buffers_.empty()) fail("a buffer without a place");
        buffers_.emplace_back(*binary_);
      } else {
        buffers_.push_back(bytes_of(buffer.at("uri").get<std::string>()));
      }
      if (buffers_.back().size() < length) fail("a buffer is shorter than its byteLength");
    }
  }

  std::string bytes_of(const std::string& uri) const {
    if (!uri.starts_with("data:"))
      return read_text_input((std::filesystem::path(name_).parent_path() / uri).string());
    const std::size_t comma = uri.find(";base64,");
    auto bytes = from_base64(comma == std::string::npos ? "?" : std::string_view(uri).substr(comma + 8));
    if (!bytes) fail("a buffer whose data is not base64");
    return *std::move(bytes);
  }

  std::size_t whole(const Json& value, const std::string& what) const {
    if (!value.is_number_unsigned()) fail(what + " must be a count, got " + value.dump().substr(0, 40));
    return value.get<std::size_t>();
  }

  std::size_t whole(const Json& object, const char* key, std::size_t otherwise) const {
    return object.contains(key) ? whole(object.at(key), key) : otherwise;
  }

  /// The entry of a list of the file that `index` names.
  const Json& entry(const char* list, std::size_t index) const {
    if (!json_.contains(list) || index >= json_.at(list).size())
      fail(std::string(list) + " has no entry " + std::to_string(index));
    return json_.at(list).at(index);
  }

  const Json& scene_of() const {
    if (!json_.contains("scenes")) fail("it shows no scene");
    return entry("scenes", whole(json_, "scene", 0));
  }

  std::vector<double> numbers(const Json& list, std::size_t wanted) const {
    if (!list.is_array() || list.size() != wanted)
      fail("a node's placement needs " + std::to_string(wanted) + " numbers");
    return list.get<std::vector<double>>();
  }

  Map map_of(const Json& node) const {
    Map map = Map::Identity();
    if (node.contains("matrix")) {
      const std::vector<double> m = numbers(node.at("matrix"), 16);
      if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1)
        fail("the last row of a matrix must be 0 0 0 1");
      map.matrix() = Eigen::Matrix4d::Map(m.data());
      return map;
    }
    if (node.contains("translation"))
      map.translate(Eigen::Vector3d(numbers(node.at("translation"), 3).data()));
    if (node.contains("rotation")) {
      const std::vector<double> q = numbers(node.at("rotation"), 4);
      const Eigen::Quaterniond turn(q[3], q[0], q[1], q[2]);
      if (!(turn.norm() > 0)) fail("the rotation of a node is 0");
      map.rotate(turn.normalized());
    }
    if (node.contains("scale")) map.scale(Eigen::Vector3d(numbers(node.at("scale"), 3).data()));
    return map;
  }

  void add_node(std::size_t number, const Map& outer, int depth) {
    if (depth > kDeepestNode || ++instances_ > kMostInstances)
      fail("nodes that contain themselves, or too many");
    const Json& node = entry("nodes", number);
    const Map map = outer * map_of(node);
    if (node.contains("skin")) fail("a mesh with a skin is not read");
    if (node.contains("mesh")) {
      const Json& mesh = entry("meshes", whole(node.at("mesh"), "mesh"));
      const Json& named = node.contains("name") ? node : mesh;
      const std::string name = named.contains("name") ? named.at("name").get<std::string>() : "";
      mesh_.runs.push_back({name.empty() ? "node " + std::to_string(number) : name, mesh_.faces.ends.size()});
      for (const Json& primitive : mesh.at("primitives")) add_primitive(primitive, map);
    }
    if (!node.contains("children")) return;
    for (const Json& child : node.at("children")) add_node(whole(child, "a node"), map, depth + 1);
  }

  Accessor accessor_of(const Json& index, const char* kind, std::size_t components) const {
    const Json& accessor = entry("accessors", whole(index, "an accessor"));
    if (accessor.contains("sparse") || !accessor.contains("bufferView"))
      fail("an accessor that is sparse or has no buffer view is not read");
    if (accessor.at("type").get<std::string>() != kind) fail(std::string("an accessor must be ") + kind);
    const Json& view = entry("bufferViews", whole(accessor.at("bufferView"), "bufferView"));
    const std::size_t buffer = whole(view.at("buffer"), "buffer");
    if (buffer >= buffers_.size()) fail("buffers has no entry " + std::to_string(buffer));
    Accessor numbers;
    const std::size_t type = whole(accessor.at("componentType"), "componentType");
    if (type < 5120 || type > 5126 || type == 5124)
      fail("componentType " + std::to_string(type) + " is not read");
    numbers.type = static_cast<int>(type);
    numbers.count = whole(accessor.at("count"), "count");
    numbers.normalized = accessor.value("normalized", false);
    const std::size_t size = components * size_of(numbers.type);
    numbers.stride = whole(view, "byteStride", size);
    const std::size_t begin = whole(view, "byteOffset", 0),
                      length = whole(view.at("byteLength"), "byteLength");
    const std::size_t offset = whole(accessor, "byteOffset", 0);
    const std::size_t all = buffers_[buffer].size();
    if (begin > all || length > all - begin || offset > length) fail("a buffer view reads beyond its buffer");
    const std::size_t room = length - offset;
    if (numbers.stride < size || numbers.stride > 252 + size ||
        (numbers.count > 0 && (room < size || (numbers.count - 1) > (room - size) / numbers.stride)))
      fail("an accessor reads beyond its buffer view");
    numbers.data = buffers_[buffer].data() + begin + offset;
    return numbers;
  }

  void add_primitive(const Json& primitive, const Map& map) {
    const std::size_t before = mesh_.vertices.size();
    const Accessor at = accessor_of(primitive.at("attributes").at("POSITION"), "VEC3", 3);
    if (at.count > kMostVertices - before) fail("more than " + std::to_string(kMostVertices) + " vertices");
    const std::size_t step = size_of(at.type);
    for (std::size_t i = 0; i < at.count; ++i) {
      const char* p = at.data + i * at.stride;
      const Eigen::Vector3d given(number_at(p, at.type, at.normalized),
                                  number_at(p + step, at.type, at.normalized),
                                  number_at(p + 2 * step, at.type, at.normalized));
      const Eigen::Vector3d placed = map * given;
      mesh_.vertices.push_back({placed[0], placed[1], placed[2]});
    }
    const std::size_t first = mesh_.faces.ends.size();
    add_faces(corners_of(primitive, before, at.count), whole(primitive, "mode", 4));
    if (map.linear().determinant() < 0) mesh_.faces.turn_about(first);
  }

  std::vector<std::uint32_t> corners_of(const Json& primitive, std::size_t before, std::size_t count) const {
    std::vector<std::uint32_t> corners;
    if (!primitive.contains("indices")) {
      for (std::size_t i = 0; i < count; ++i) corners.push_back(static_cast<std::uint32_t>(before + i));
      return corners;
    }
    const Accessor at = accessor_of(primitive.at("indices"), "SCALAR", 1);
    if (at.type != 5121 && at.type != 5123 && at.type != 5125) fail("indices must be counts");
    for (std::size_t i = 0; i < at.count; ++i) {
      const auto index = static_cast<std::size_t>(number_at(at.data + i * at.stride, at.type, false));
      if (index >= count)
        fail("vertex " + std::to_string(index) + " is not there: " + std::to_string(count) +
             " are, counted from 0");
      corners.push_back(static_cast<std::uint32_t>(before + index));
    }
    return corners;
  }

  /// Triangles, strips and fans; points and lines have no faces.
  void add_faces(const std::vector<std::uint32_t>& corners, std::size_t mode) {
    if (mode > 6) fail("a primitive of mode " + std::to_string(mode));
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
      for (const std::size_t i : {a, b, c}) mesh_.faces.add(corners[i]);
      mesh_.faces.close();
    };
    if (mode == 4 && corners.size() % 3 != 0) fail("the corners of triangles are not three for each");
    for (std::size_t i = 2; i < corners.size(); i += mode == 4 ? 3 : 1) {
      if (mode == 4) add(i - 2, i - 1, i);
      if (mode == 5) i % 2 == 0 ? add(i - 2, i - 1, i) : add(i - 1, i - 2, i);
      if (mode == 6) add(0, i - 1, i);
    }
  }

  std::string_view bytes_;
  const std::string& name_;
  Json json_;
  std::optional<std::string_view> binary_;
  std::vector<std::string> buffers_;
  MeshText mesh_;
  int instances_ = 0;
};

}  // namespace

MeshText gltf_mesh(std::string_view bytes, const std::string& name) { return GltfReader(bytes, name).read(); }

}  // namespace raygauge::cli
