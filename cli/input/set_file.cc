// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/set_file.h"

#include <filesystem>
#include <utility>

#include "cli/input/input_file.h"
#include "cli/input/toml_refusal.h"
#include "cli/input/toml_source.h"
#include "cli/input/toml_values.h"
#include "raygauge/exceptions.h"

namespace raygauge::cli {
namespace {

/// What is the same for every table of one set file.
struct SetFile {
  std::filesystem::path folder;
  const ReadNamedSet& read_named;
  const NoteNamedFile& note_file;

  SetPointer set_of(const toml::table& table, int depth) const;
};

/// The values in the table of one set, `depth` tables inside its file.
class SetTable final : public ShapeValues {
 public:
  SetTable(const SetFile& file, const toml::table& table, const Shape& shape, int depth)
      : file_(file), table_(table), shape_(shape), depth_(depth) {}

  double number(const std::string& name) const override {
    const std::optional<double>& usual = shape_.parameter(name).usual;
    return usual && !table_.contains(name) ? *usual : read_number(node(name), full(name));
  }
  Vector vector(const std::string& name) const override { return read_vector(node(name), full(name)); }
  Eigen::MatrixXd matrix(const std::string& name) const override {
    return read_matrix(node(name), full(name));
  }
  SetPointer set(const std::string& name) const override { return operand(node(name), name); }

  std::vector<SetPointer> sets(const std::string& name) const override {
    const toml::array* list = node(name).as_array();
    if (list == nullptr || list->empty()) {
      throw InvalidParameterError(place_of(node(name)) + ": " + full(name) + " must be a list of sets, [[" +
                                  name + "]]");
    }
    std::vector<SetPointer> operands;
    for (const toml::node& element : *list) operands.push_back(operand(element, name));
    return operands;
  }

  SetPointer file(const std::string& name) const override {
    return placed(place_of(node(name)), [&] { return file_.read_named(resolved(name)); });
  }

  std::string text(const std::string& name) const override { return read_text(node(name), full(name)); }

  std::string path(const std::string& name) const override {
    std::string found = resolved(name);
    if (file_.note_file) placed(place_of(node(name)), [&] { file_.note_file(found); });
    return found;
  }

 private:
  std::string resolved(const std::string& name) const {
    const std::string source = text(name);
    return placed(place_of(node(name)), [&] {
      if (source == kStandardInput) throw InvalidParameterError("a set file cannot name standard input");
      return (file_.folder / source).string();
    });
  }

  /// Which is there: see require_keys.
  const toml::node& node(const std::string& name) const { return *table_.get(name); }

  std::string full(const std::string& name) const { return shape_.name + "." + name; }

  SetPointer operand(const toml::node& operand_node, const std::string& name) const {
    if (const toml::table* table = operand_node.as_table()) return file_.set_of(*table, depth_ + 1);
    throw InvalidParameterError(place_of(operand_node) + ": " + full(name) +
                                " must be a set, that is a table with a shape");
  }

  const SetFile& file_;
  const toml::table& table_;
  const Shape& shape_;
  int depth_;
};

void require_keys(const toml::table& table, const Shape& shape, const std::string& place) {
  std::string missing;
  int count = 0;
  for (const ShapeParameter& parameter : shape.parameters) {
    if (parameter.usual || table.contains(parameter.name)) continue;
    missing += (count++ > 0 ? ", '" : "'") + parameter.name + "'";
  }
  if (count == 0) return;
  throw InvalidParameterError(place + ": " + shape.name + " needs the key" + (count > 1 ? "s " : " ") +
                              missing);
}

SetPointer SetFile::set_of(const toml::table& table, int depth) const {
  if (depth > kDeepestSet) {
    throw InvalidParameterError(place_of(table) + ": more than " + std::to_string(kDeepestSet) +
                                " sets inside one another");
  }
  const toml::node* name = table.get("shape");
  if (name == nullptr)
    throw InvalidParameterError(place_of(table) + ": a set needs a shape, as in shape = \"ball\"");
  const std::string place = place_of(*name);
  const Shape& shape = find_shape(read_text(*name, "shape"), place);
  std::vector<std::string> known = {"shape"};
  for (const ShapeParameter& parameter : shape.parameters) known.push_back(parameter.name);
  reject_unknown_keys(table, "key of " + shape.name, known);
  require_keys(table, shape, place);
  return placed(place, shape.bind(SetTable(*this, table, shape, depth)));
}

}  // namespace

bool is_set_file(const std::string& source) { return source.ends_with(".toml"); }

SetPointer read_set_file(const std::string& path, const ReadNamedSet& read_named,
                         const NoteNamedFile& note_file) {
  const TomlSource source = read_toml(path, {});
  return SetFile{std::filesystem::path(path).parent_path(), read_named, note_file}.set_of(source.root, 0);
}

SetPointer read_set_table(const toml::table& table, const std::filesystem::path& folder,
                          const ReadNamedSet& read_named) {
  return SetFile{folder, read_named, {}}.set_of(table, 0);
}

}  // namespace raygauge::cli
