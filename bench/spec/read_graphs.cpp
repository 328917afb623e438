// Reads the `graphs` of a specification.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "ar3d/base/error.h"
#include "ar3d/base/printable.h"
#include "ar3d/bench/spec/read_parts.h"
#include "ar3d/bench/spec/toml_table.h"
#include "ar3d/formats/catalog.h"
#include "ar3d/generators/catalog.h"

namespace ar3d {
namespace {

constexpr std::int64_t kMostSampled = 10000000;  // a study has no more rows
constexpr std::int64_t kMostShuffles = 1000000;

FirstLine first_line(const std::string& word) {
  if (word == "edge") return FirstLine::edge;
  if (word == "header") return FirstLine::header;
  throw InputError(
      fmt::format("first_line = '{}' is neither 'edge' nor 'header'", printable(word)));
}

void read_table(const toml::node& node, GraphsEntry& entry) {
  entry.is_collection = has_toml_key(node, "files");
  ReadOptions& reading = entry.reading;
  const auto name = [](const std::string& text) {
    if (is_graphs_name(text)) return text;
    throw InputError(fmt::format("name '{}' is not 1 to {} letters, digits, '.', '-' or '_'",
                                 printable(text), kLongestGraphsName));
  };
  const auto format = [](const std::string& text) {
    find_graph_format(text);
    return text;
  };
  const auto read_shuffles = [&](const toml::node& shuffles, const std::string& key) {
    std::set<std::int64_t> numbers;
    for (const toml::node* number : toml_list(shuffles, key)) {
      numbers.insert(toml_integer(*number, key, 0, kMostShuffles));
    }
    entry.shuffles = {numbers.begin(), numbers.end()};
  };
  const auto base = [&](const toml::node& value, const std::string& key) {
    reading.base = static_cast<unsigned>(toml_integer(value, key, 0, 1));
  };
  std::vector<TomlKey> keys = {{entry.is_collection ? "files" : "file", into(entry.file), true},
                               {"name", parsed_into(entry.name, name), entry.is_collection},
                               {"skip", into(entry.skip)},
                               {"format", parsed_into(reading.format, format)},
                               {"base", base},
                               {"first_line", parsed_into(reading.first_line, first_line)},
                               {"undirected", into(reading.undirected)},
                               {"simple", into(reading.simplify)},
                               {"largest_component", into(entry.largest_component)},
                               {"sample", into(entry.sample, 1, kMostSampled)},
                               {"shuffle", read_shuffles}};
  if (entry.is_collection) keys.push_back({"groups", into(entry.groups)});
  read_toml_table(node, "graphs", keys);
  reading.simplify = reading.simplify || reading.undirected;
}

}  // namespace

bool is_family(const std::string& name) {
  return std::ranges::find(families(), name, &Family::name) != families().end();
}

std::string own_graphs_name(const std::string& path) {
  std::string name = std::filesystem::path(path).filename().string();
  for (char& c : name) {
    if (!is_graphs_name(std::string("a") + c)) c = '_';
  }
  const std::string own = !is_graphs_name(name.substr(0, 1)) || is_family(name) ? "_" : "";
  return (own + name).substr(0, kLongestGraphsName);
}

bool is_graphs_name(const std::string& name) {
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '.';
  };
  return !name.empty() && name.size() <= kLongestGraphsName && name[0] != '-' && name[0] != '.' &&
         std::all_of(name.begin(), name.end(), is_plain);
}

std::vector<GraphsEntry> read_graphs(const toml::node& node) {
  std::vector<GraphsEntry> entries;
  for (const toml::node* given : toml_list(node, "graphs")) {
    GraphsEntry& entry = entries.emplace_back();
    entry.location = toml_location(*given);
    if (given->is_string()) {
      entry.file = toml_text(*given, "graphs");
    } else {
      read_table(*given, entry);
    }
    if (entry.file.empty() || entry.file == "-") {
      refuse_toml(*given, fmt::format("graphs: '{}' is no file", entry.file));
    }
  }
  return entries;
}

}  // namespace ar3d
