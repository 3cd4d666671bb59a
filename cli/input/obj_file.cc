// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// OBJ as in Appendix B1 of the Advanced Visualizer manual (Wavefront), as far as polygons go.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "cli/input/byte_reader.h"
#include "cli/input/mesh_formats.h"
#include "cli/input/number_word.h"
#include "raygauge/exceptions.h"

namespace raygauge::cli {
namespace {

using Words = std::vector<std::string_view>;

template <std::size_t N>
bool is_among(std::string_view word, const std::array<std::string_view, N>& list) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

/// Names, groups, materials and ways of drawing: no vertex depends on them.
constexpr std::array<std::string_view, 12> kWithoutEffect = {"s",        "mg",     "usemtl",     "mtllib",
                                                             "usemap",   "maplib", "bevel",      "c_interp",
                                                             "d_interp", "lod",    "shadow_obj", "trace_obj"};

constexpr std::array<std::string_view, 24> kFreeForm = {
    "vp",  "deg",  "cstype", "curv",  "curv2", "surf", "parm", "trim", "hole", "scrv", "sp",   "end",
    "con", "bmat", "step",   "ctech", "stech", "bsp",  "bzp",  "cdc",  "cdp",  "res",  "call", "csh"};

class ObjReader {
 public:
  ObjReader(std::string_view text, const std::string& name) : reader_(text, name) {}

  MeshText read() {
    while (!reader_.empty()) {
      next_line();
      if (!words_.empty()) take_line();
    }
    if (greatest_ > static_cast<long>(vertices_.size()))
      throw InvalidParameterError(place_of_greatest_ + "vertex " + std::to_string(greatest_) +
                                  " is not there: the file has " + std::to_string(vertices_.size()));
    check_promise();
    std::vector<FaceRun> runs = of_use(objects_.empty() ? groups_ : objects_);
    return {std::move(vertices_), std::move(polygons_), std::move(runs)};
  }

 private:
  /// The words of the next line, and of those that a backslash at its end joins to it.
  void next_line() {
    std::string_view line = content();
    if (!line.ends_with('\\')) return split_words(line, words_);
    joined_.clear();
    while (line.ends_with('\\')) {
      joined_.append(line.substr(0, line.size() - 1)).append(" ");
      if (reader_.empty()) reader_.fail("the last line ends in a backslash");
      line = content();
    }
    split_words(joined_.append(line), words_);
  }

  std::string_view content() {
    const std::string_view line = reader_.line();
    return line.substr(0, line.find('#'));
  }

  void take_line() {
    const std::string_view keyword = words_.front();
    if (keyword == "v") return take_vertex();
    if (keyword == "f" || keyword == "l" || keyword == "p") return take_element();
    if (keyword == "vt") return require_numbers(1, 3);
    if (keyword == "vn") return require_numbers(3, 3);
    if (keyword == "o") return begin_run(objects_);
    if (keyword == "g") return begin_run(groups_);
    if (is_among(keyword, kWithoutEffect)) return;
    if (is_among(keyword, kFreeForm))
      reader_.fail("free-form curves and surfaces are not read, here " + quoted(keyword));
    if (took_promise()) return;
    reader_.fail(quoted(keyword) + " is no keyword of an OBJ file");
  }

  /// Faces before the first name belong to a run without one.
  void begin_run(std::vector<FaceRun>& runs) {
    if (runs.empty()) runs.push_back({"", 0});
    std::string name;
    for (std::size_t i = 1; i < words_.size(); ++i) name.append(i > 1 ? " " : "").append(words_[i]);
    runs.push_back({std::move(name), polygons_.ends.size()});
  }

  /// Without those that have neither a name nor faces.
  std::vector<FaceRun> of_use(const std::vector<FaceRun>& runs) const {
    std::vector<FaceRun> kept;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const std::size_t end = i + 1 < runs.size() ? runs[i + 1].first : polygons_.ends.size();
      if (runs[i].first < end || !runs[i].name.empty()) kept.push_back(runs[i]);
    }
    return kept;
  }

  /// Some programs write how many vertices and faces there are in front of them.
  bool took_promise() {
    const bool first = vertices_.empty() && faces_ == 0 && place_of_promise_.empty();
    if (!first || words_.size() != 2 || !integer_of(words_[0]) || !integer_of(words_[1])) return false;
    place_of_promise_ = reader_.place();
    promised_ = {count_word(words_[0], reader_), count_word(words_[1], reader_)};
    return true;
  }

  void check_promise() const {
    if (place_of_promise_.empty() || promised_ == std::array<std::uint64_t, 2>{vertices_.size(), faces_})
      return;
    throw InvalidParameterError(place_of_promise_ + std::to_string(promised_[0]) + " vertices and " +
                                std::to_string(promised_[1]) + " faces are promised, the file has " +
                                std::to_string(vertices_.size()) + " and " + std::to_string(faces_));
  }

  void take_vertex() {
    const std::size_t numbers = words_.size() - 1;
    if (numbers != 3 && numbers != 4 && numbers != 6)
      reader_.fail("a vertex has " + std::to_string(numbers) +
                   " numbers; 3 are read, also with a weight of 1 or a colour of three behind them");
    Vertex vertex{};
    for (std::size_t i = 0; i < 3; ++i) vertex[i] = real_word(words_[i + 1], reader_);
    for (std::size_t i = 4; i <= numbers; ++i) real_word(words_[i], reader_);
    if (numbers == 4 && real_word(words_[4], reader_) != 1)
      reader_.fail("a vertex of the weight " + std::string(words_[4]) + "; only the weight 1 is read");
    vertices_.push_back(vertex);
  }

  void require_numbers(std::size_t least, std::size_t most) {
    const std::size_t numbers = words_.size() - 1;
    if (numbers < least || numbers > most)
      reader_.fail(quoted(words_.front()) + " with " + std::to_string(numbers) + " numbers");
    for (std::size_t i = 1; i < words_.size(); ++i) {
      if (!number_of(words_[i])) reader_.fail(quoted(words_[i]) + " is not a number");
    }
  }

  void take_element() {
    if (words_.size() < 2) reader_.fail(quoted(words_.front()) + " names no vertex");
    for (std::size_t i = 1; i < words_.size(); ++i) take_corner(words_[i]);
    if (words_.front() != "f") return;
    ++faces_;
    polygons_.close();
  }

  /// 7, 7/1, 7//2 or 7/1/2: a vertex, a point of a texture, a normal. Negative ones count from the last so
  /// far.
  void take_corner(std::string_view corner) {
    std::string_view rest = corner;
    for (int part = 0; part < 3; ++part) {
      const std::size_t slash = std::min(rest.find('/'), rest.size());
      const std::string_view text = rest.substr(0, slash);
      const std::optional<long> index = integer_of(text);
      const bool left_out = part > 0 && text.empty();
      if (!left_out && (!index || *index == 0)) break;
      if (part == 0) take_index(*index);
      if (slash == rest.size()) return;
      rest.remove_prefix(slash + 1);
    }
    reader_.fail(quoted(corner) + " names no vertex");
  }

  void take_index(long index) {
    if (index < 0 && -index > static_cast<long>(vertices_.size()))
      reader_.fail("vertex " + std::to_string(index) + " is not there: " + std::to_string(vertices_.size()) +
                   " stand above");
    if (words_.front() == "f")
      polygons_.add(
          static_cast<std::uint32_t>(index < 0 ? static_cast<long>(vertices_.size()) + index : index - 1));
    if (index <= greatest_) return;
    greatest_ = index;
    place_of_greatest_ = reader_.place();
  }

  ByteReader reader_;
  std::vector<Vertex> vertices_;
  Polygons polygons_;
  std::vector<FaceRun> objects_, groups_;
  Words words_;
  std::string joined_;
  std::uint64_t faces_ = 0;
  std::array<std::uint64_t, 2> promised_{};  ///< vertices and faces
  std::string place_of_promise_;             ///< empty: none
  long greatest_ = 0;                        ///< index of a vertex, counted from the first one
  std::string place_of_greatest_;            ///< the first line with it
};

}  // namespace

MeshText obj_mesh(std::string_view text, const std::string& name) { return ObjReader(text, name).read(); }

}  // namespace raygauge::cli
