// SPDX-License-Identifier: Apache-2.0
// Reads the file of a sweep into a struct.
#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <set>
#include <span>
#include <type_traits>

#include "avo_io/printable.h"
#include "avo_io/scene.h"
#include "io/files/regular_file.h"
#include "io/scene/reader.h"
#include "io/sweep/runs.h"

namespace avo_io {
namespace {

constexpr std::array<std::string_view, 9> kSweepKeys{"version",       "scenes", "methods",
                                                     "parameters",    "seeds",  "threads",
                                                     "until_arrived", "line",   "judged"};
constexpr avo::Range kSweepText{1.0, 4096.0, false};
constexpr avo::Range kAnySeed{0.0, 18446744073709551615.0, false};
constexpr avo::Range kSweepThreads{1.0, 1024.0, false};
constexpr avo::Range kSweepSeeds{1.0, static_cast<double>(kMostSweepRuns), false};

/// Converts a value back to text, in one line of YAML.
std::string flow_text(const Reader& reader, const YamlNode& node, const std::string& path) {
  if (node.kind == YamlNode::Kind::list) {
    std::string items;
    for (const YamlNode& item : node.children)
      items += (items.empty() ? "" : ", ") + flow_text(reader, item, path);
    return "[" + items + "]";
  }
  std::string text = reader.name(node, path, kSweepText);
  if (!node.quoted) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("''") : std::string(1, c);
  return quoted + "'";
}

class SweepReader {
 public:
  SweepReader(const Document& document, std::vector<OwnMethod> own_methods)
      : root_(document.root), reader_(document) {
    spec_.own_methods = std::move(own_methods);
  }

  SweepSpec read(const std::string& name) {
    reader_.check_keys(root_, "", {kSweepKeys.begin(), kSweepKeys.end()});
    reader_.require_version(root_);
    spec_.name = name;
    read_scenes();
    read_methods();
    read_parameters();
    read_seeds();
    if (const YamlNode* threads = root_.find("threads"))
      spec_.threads = static_cast<int>(reader_.whole_number(*threads, "threads", kSweepThreads));
    if (const YamlNode* ends = root_.find("until_arrived"))
      spec_.until_arrived = reader_.truth(*ends, "until_arrived");
    read_line();
    read_judged();
    check_count();
    return std::move(spec_);
  }

 private:
  /// Calls read(item, path) for each item of a list, which must have at least one and no
  /// duplicates.
  template <class Read>
  void read_list(const YamlNode& list, const std::string& path, const Read& read) const {
    reader_.require_list(list, path);
    if (list.children.empty()) reader_.fail(list, path, "an empty list", "must have an item");
    std::set<std::decay_t<decltype(read(list, path))>> items;
    for (const YamlNode& node : list.children) {
      const std::string place = path_to(path, fmt::format("{}", items.size()));
      if (!items.insert(read(node, place)).second)
        reader_.fail(node, place, shown(node) + " twice", "must be there once");
    }
  }

  void read_scenes() {
    const YamlNode* list = root_.find("scenes");
    if (list == nullptr)
      reader_.fail_missing(root_, "", "scenes", "names of built-in scenes, or files");
    read_list(*list, "scenes", [&](const YamlNode& node, const std::string& path) {
      spec_.scenes.push_back(reader_.name(node, path, kSweepText));
      if (spec_.scenes.back() == "-")
        reader_.fail(node, path, "\"-\"", "must be a name or a file, not the standard input");
      return spec_.scenes.back();
    });
  }

  void read_methods() {
    const YamlNode* list = root_.find("methods");
    if (list == nullptr) return;
    read_list(*list, "methods", [&](const YamlNode& node, const std::string& path) {
      spec_.methods.push_back(method_named(node, path));
      return spec_.methods.back();
    });
  }

  /// One of avo's methods, or of the caller's: an external method has a name of its own.
  std::string method_named(const YamlNode& node, const std::string& path) const {
    const std::vector<OwnMethod>& own = spec_.own_methods;
    const auto is_named = [&](const OwnMethod& method) { return method.name == node.text; };
    if (std::any_of(own.begin(), own.end(), is_named)) return node.text;
    constexpr std::size_t kExternal = 2;  // the last ones
    const std::span words(kWords<avo::Method>);
    return avo::to_string(reader_.choice(node, path, words.first(words.size() - kExternal)));
  }

  void read_parameters() {
    const YamlNode* map = root_.find("parameters");
    if (map == nullptr) return;
    if (map->kind != YamlNode::Kind::map)
      reader_.fail(*map, "parameters", shown(*map), "must be a map from keys to lists of values");
    for (std::size_t i = 0; i < map->children.size(); i += 2) {
      const YamlNode& key = map->children[i];
      const std::string path = path_to("parameters", key.text);
      if (key.text == "method" || key.text == "seed")
        reader_.fail(key, path, "a parameter", fmt::format("must be in \"{}s\"", key.text));
      const bool known =
          std::any_of(spec_.parameters.begin(), spec_.parameters.end(),
                      [&](const SweepParameter& parameter) { return parameter.key == key.text; });
      if (known) reader_.fail(key, path, "the key twice", "must be there once");
      SweepParameter& parameter = spec_.parameters.emplace_back();
      parameter.key = key.text;
      read_list(map->children[i + 1], path, [&](const YamlNode& node, const std::string& place) {
        parameter.values.push_back(flow_text(reader_, node, place));
        return parameter.values.back();
      });
    }
  }

  void read_seeds() {
    const YamlNode* seeds = root_.find("seeds");
    if (seeds == nullptr) return;
    if (seeds->kind != YamlNode::Kind::map) {
      read_list(*seeds, "seeds", [&](const YamlNode& node, const std::string& path) {
        return spec_.seeds.emplace_back(reader_.whole_number(node, path, kAnySeed));
      });
      return;
    }
    reader_.check_keys(*seeds, "seeds", {"from", "count"});
    std::uint64_t first = 1;
    if (const YamlNode* from = seeds->find("from"))
      first = reader_.whole_number(*from, "seeds.from", kAnySeed);
    const YamlNode* count = seeds->find("count");
    if (count == nullptr) reader_.fail_missing(*seeds, "seeds", "count", "how many");
    const std::uint64_t number = reader_.whole_number(*count, "seeds.count", kSweepSeeds);
    if (first + (number - 1) < first)
      reader_.fail(*count, "seeds.count", shown(*count), "must end with a seed < 2^64");
    for (std::uint64_t k = 0; k < number; ++k) spec_.seeds.push_back(first + k);
  }

  void read_line() {
    const YamlNode* node = root_.find("line");
    if (node == nullptr) return;
    const std::vector<avo::Vec2> ends = reader_.points(*node, "line", avo::kAnyValue, "m");
    constexpr const char* kTwoPoints = "must be two points, [[x, y], [x, y]]";
    if (ends.size() != 2)
      reader_.fail(*node, "line", fmt::format("a list of {}", ends.size()), kTwoPoints);
    if (!(norm_squared(ends[1] - ends[0]) > 0.0))
      reader_.fail(*node, "line", "one point", kTwoPoints);
    spec_.line = {ends[0], ends[1]};
  }

  void read_judged() {
    const YamlNode* list = root_.find("judged");
    if (list == nullptr) return;
    constexpr avo::Range kRobot{0.0, static_cast<double>(avo::kMostRobots) - 1.0, false};
    read_list(*list, "judged", [&](const YamlNode& node, const std::string& path) {
      return spec_.judged.emplace_back(reader_.whole_number(node, path, kRobot));
    });
  }

  void check_count() const {
    double runs = static_cast<double>(spec_.scenes.size());
    runs *= static_cast<double>(std::max<std::size_t>(spec_.methods.size(), 1));
    runs *= static_cast<double>(std::max<std::size_t>(spec_.seeds.size(), 1));
    for (const SweepParameter& parameter : spec_.parameters)
      runs *= static_cast<double>(parameter.values.size());
    if (runs > static_cast<double>(kMostSweepRuns))
      reader_.fail(root_, "", fmt::format("{:.0f} runs in all", runs),
                   fmt::format("must be at most {}", kMostSweepRuns));
  }

  const YamlNode& root_;
  Reader reader_;
  SweepSpec spec_;
};

}  // namespace

SweepSpec parse_sweep(std::string_view yaml, const std::string& name,
                      std::vector<OwnMethod> own_methods) {
  Document document;
  document.root = parse_yaml(yaml, name, document);
  SweepSpec spec = SweepReader(document, std::move(own_methods)).read(name);
  spec.text = yaml;
  return spec;
}

SweepSpec load_sweep(const std::string& path, std::vector<OwnMethod> own_methods) {
  return parse_sweep(read_regular_file(path), path, std::move(own_methods));
}

std::int64_t run_count(const SweepSpec& spec) {
  std::size_t runs = spec.scenes.size() * std::max<std::size_t>(spec.methods.size(), 1) *
                     std::max<std::size_t>(spec.seeds.size(), 1);
  for (const SweepParameter& parameter : spec.parameters) runs *= parameter.values.size();
  return static_cast<std::int64_t>(runs);
}

SweepRun run_of(const SweepSpec& spec, std::int64_t run) {
  auto rest = static_cast<std::size_t>(run);
  const auto next = [&rest](std::size_t count) {
    const std::size_t index = rest % count;
    rest /= count;
    return index;
  };
  SweepRun result{.number = run, .values = std::vector<std::string>(spec.parameters.size())};
  if (!spec.seeds.empty()) result.seed = spec.seeds[next(spec.seeds.size())];
  for (std::size_t i = spec.parameters.size(); i > 0; --i) {
    const std::vector<std::string>& values = spec.parameters[i - 1].values;
    result.values[i - 1] = values[next(values.size())];
  }
  if (!spec.methods.empty()) result.method = spec.methods[next(spec.methods.size())];
  result.scene = spec.scenes[next(spec.scenes.size())];
  return result;
}

std::string run_name(const SweepSpec& spec, std::int64_t run) {
  const SweepRun found = run_of(spec, run);
  std::string name = found.scene;
  if (!found.method.empty()) name += " " + found.method;
  for (std::size_t i = 0; i < found.values.size(); ++i)
    name += fmt::format(" {}={}", spec.parameters[i].key, found.values[i]);
  if (found.seed) name += fmt::format(" seed={}", *found.seed);
  return printable(name);
}

// The name as YAML, so that no name is read as something else.
std::string quoted(const std::string& name) {
  std::string text = "\"";
  for (const char letter : name) {
    const auto number = static_cast<unsigned char>(letter);
    if (number < 0x20)
      text += fmt::format("\\x{:02x}", number);
    else
      text.append(letter == '"' || letter == '\\' ? "\\" : "").append(1, letter);
  }
  return text + "\"";
}

std::vector<std::string> overrides_of(const OwnMethod& method) {
  const avo::Method kind = method.clamped ? avo::Method::external_clamped : avo::Method::external;
  const avo::Certificate certificate =
      method.certified ? avo::Certificate::braking_trajectories : avo::Certificate::none;
  return {std::string("method=") + to_string(kind), "external_method=" + quoted(method.name),
          std::string("certificate=") + to_string(certificate)};
}

const OwnMethod* own_method_of(const SweepSpec& spec, const SweepRun& run) {
  const auto place = std::find_if(spec.own_methods.begin(), spec.own_methods.end(),
                                  [&](const OwnMethod& own) { return own.name == run.method; });
  return place == spec.own_methods.end() ? nullptr : &*place;
}

std::vector<std::string> overrides_of(const SweepSpec& spec, const SweepRun& run) {
  std::vector<std::string> overrides;
  if (const OwnMethod* own = own_method_of(spec, run))
    overrides = overrides_of(*own);
  else if (!run.method.empty())
    overrides.push_back("method=" + run.method);
  for (std::size_t i = 0; i < run.values.size(); ++i)
    overrides.push_back(spec.parameters[i].key + "=" + run.values[i]);
  if (run.seed) overrides.push_back(fmt::format("seed={}", *run.seed));
  return overrides;
}

std::string scene_of(const SweepSpec& spec, const SweepRun& run) {
  if (is_builtin_scene(run.scene)) return run.scene;
  return (std::filesystem::path(spec.name).parent_path() / run.scene).string();
}

}  // namespace avo_io
