// SPDX-License-Identifier: Apache-2.0
// Reads structs from the tree of a scene file, by the table of fields.
#pragma once
#include <cstddef>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "io/fields/fields.h"
#include "io/text/words.h"
#include "io/text/yaml_tree.h"

namespace avo_io {

/// Returns a value's dotted path, e.g. "robots.3.radius"; empty for the scene itself.
std::string path_to(const std::string& parent, std::string_view key);

/// Returns "in robots.3: ", or nothing for the scene itself.
std::string in_front(const std::string& path);

/// Returns the value in words, for messages: `a list`, `-0.2`, `"fast"`, `nothing`.
std::string shown(const YamlNode& node);

class Reader {
 public:
  explicit Reader(const Document& document) : document_(document) {}

  [[noreturn]] void fail(const YamlNode& node, const std::string& path, const std::string& given,
                         const std::string& allowed) const;
  [[nodiscard]] const Document& document() const { return document_; }

  /// Refuses anything but a map, unknown keys and keys given twice.
  void check_keys(const YamlNode& map, const std::string& path,
                  const std::vector<std::string_view>& allowed) const;
  void require_list(const YamlNode& node, const std::string& path) const;

  double number(const YamlNode& node, const std::string& path, const avo::Range& range,
                std::string_view unit) const;
  std::uint64_t whole_number(const YamlNode& node, const std::string& path,
                             const avo::Range& range) const;
  avo::Vec2 point(const YamlNode& node, const std::string& path, const avo::Range& range,
                  std::string_view unit) const;
  /// Refuses a file if its key `version` is not 1.
  void require_version(const YamlNode& root) const;
  /// Reads [x, y, z].
  avo::Vec3 place(const YamlNode& node, const std::string& path, const avo::Range& range,
                  std::string_view unit) const;
  std::vector<avo::Vec2> points(const YamlNode& node, const std::string& path,
                                const avo::Range& range, std::string_view unit) const;
  /// Reads triples [time, x, y].
  std::vector<avo::TimedPlace> places(const YamlNode& node, const std::string& path,
                                      const avo::Range& range) const;
  /// Reads a list of layers, each once.
  avo::LayerSet layers(const YamlNode& node, const std::string& path,
                       const avo::Range& range) const;
  bool truth(const YamlNode& node, const std::string& path) const;
  /// Reads a name. `bytes`: the range of its length.
  std::string name(const YamlNode& node, const std::string& path, const avo::Range& bytes) const;
  template <class Names>
  auto choice(const YamlNode& node, const std::string& path, const Names& names) const {
    std::vector<std::string_view> words;
    for (const auto& [word, value] : names) {
      if (node.kind == YamlNode::Kind::text && node.text == word) return value;
      words.push_back(word);
    }
    fail_choice(node, path, words);
  }
  [[noreturn]] void fail_choice(const YamlNode& node, const std::string& path,
                                const std::vector<std::string_view>& words) const;
  [[noreturn]] void fail_missing(const YamlNode& map, const std::string& path, std::string_view key,
                                 std::string_view doc) const;

  /// Reads the values of `map` that the table describes; all keys have been checked. patch: a
  /// missing value stays unchanged.
  template <class T>
  void read(const YamlNode& map, const std::string& path, const std::vector<Field<T>>& table,
            T& target, bool patch = false) const {
    for (const Field<T>& field : table) {
      const YamlNode* node = map.find(field.key);
      const auto set_member = [&](auto member) {
        if constexpr (!std::is_same_v<decltype(member), std::monostate>)
          set(target.*member, *node, path_to(path, field.key), {field.range, field.unit});
      };
      if (node != nullptr)
        std::visit(set_member, field.member);
      else if (field.need == Need::required && !patch)
        fail_missing(map, path, field.key, field.doc);
    }
  }

  /// Reads a map that has the keys of T alone.
  template <class T>
  void read_map(const YamlNode& map, const std::string& path, T& target, bool patch = false) const {
    check_keys(map, path, keys_of(fields<T>()));
    read(map, path, fields<T>(), target, patch);
  }

 private:
  /// Reads a list of N numbers, which messages call `form`.
  template <std::size_t N>
  [[nodiscard]] std::array<double, N> coordinates(const YamlNode& node, const std::string& path,
                                                  const avo::Range& range, std::string_view unit,
                                                  std::string_view form) const;
  /// The rule of a field for its value.
  struct Rule {
    const avo::Range& range;
    std::string_view unit;
  };
  using Path = std::string;
  void set(double& value, const YamlNode& node, const Path& path, const Rule& rule) const;
  void set(int& value, const YamlNode& node, const Path& path, const Rule& rule) const;
  void set(std::uint64_t& value, const YamlNode& node, const Path& path, const Rule& rule) const;
  void set(std::string& value, const YamlNode& node, const Path& path, const Rule& rule) const;
  void set(avo::Vec2& value, const YamlNode& node, const Path& path, const Rule& rule) const;
  void set(avo::Vec3& value, const YamlNode& node, const Path& path, const Rule& rule) const;
  template <class Choice>
  requires std::is_enum_v<Choice>
  void set(Choice& value, const YamlNode& node, const Path& path, const Rule&) const {
    value = choice(node, path, kWords<Choice>);
  }
  template <class Value>
  void set(std::optional<Value>& value, const YamlNode& node, const Path& path,
           const Rule& rule) const {
    set(value.emplace(), node, path, rule);
  }
  void set(avo::LayerSet& value, const YamlNode& node, const Path& path, const Rule& rule) const;
  void set(bool& value, const YamlNode& node, const Path& path, const Rule& rule) const;
  void set(std::vector<avo::Vec2>& value, const YamlNode& node, const Path& path,
           const Rule& rule) const;
  void set(std::vector<avo::TimedPlace>& value, const YamlNode& node, const Path& path,
           const Rule& rule) const;

  const Document& document_;
};

}  // namespace avo_io
