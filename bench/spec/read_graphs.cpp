// Reads the `graphs` of a specification, and writes the specification of a study that the command
// line names by its files of graphs.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "ar3d/base/error.h"
#include "ar3d/base/printable.h"
#include "ar3d/bench/spec/read_parts.h"
#include "ar3d/bench/spec/toml_table.h"
#include "ar3d/formats/catalog.h"

namespace ar3d {
namespace {

constexpr std::int64_t kMostSampled = 10000000;  // a study has no more rows
constexpr std::int64_t kMostShuffles = 1000000;

FirstLine first_line(const std::string& file, const toml::node& node) {
  const std::string word = toml_text(file, node, "first_line");
  if (word == "edge") return FirstLine::edge;
  if (word == "header") return FirstLine::header;
  refuse_toml(file, node,
              fmt::format("first_line = '{}' is neither 'edge' nor 'header'", printable(word)));
}

std::vector<std::int64_t> shuffles(const std::string& file, const toml::node& node) {
  std::vector<std::int64_t> numbers;
  for (const toml::node* entry : one_or_many(node)) {
    numbers.push_back(toml_integer(file, *entry, "shuffle", 0, kMostShuffles));
  }
  if (numbers.empty()) refuse_toml(file, node, "shuffle is empty");
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

void read_table(const std::string& file, const toml::node& node, GraphsEntry& entry) {
  TomlTable table(file, node, "graphs");
  entry.is_collection = table.has("files");
  std::vector<std::string_view> keys = {"name",       "skip",   "format",     "base",
                                        "first_line", "simple", "undirected", "largest_component",
                                        "sample",     "shuffle"};
  if (entry.is_collection) keys.insert(keys.end(), {"files", "groups"});
  if (!entry.is_collection) keys.push_back("file");
  table.refuse_all_but(keys);
  entry.file = table.text(entry.is_collection ? "files" : "file");
  entry.name = entry.is_collection ? table.text("name") : table.text("name", "");
  if (entry.is_collection) entry.groups = table.text("groups", "");
  entry.options.skip = table.boolean("skip", false);
  if (const toml::node* name = table.find("name"); name != nullptr && !is_graphs_name(entry.name)) {
    refuse_toml(file, *name,
                fmt::format("name '{}' is not 1 to {} letters, digits, '.', '-' or '_'",
                            printable(entry.name), kLongestGraphsName));
  }
  ReadOptions& reading = entry.options.reading;
  reading.format = table.text("format", "");
  if (const toml::node* format = table.find("format")) {
    with_place(file, *format, [&] { find_graph_format(reading.format); });
  }
  reading.base = static_cast<unsigned>(table.integer("base", 0, 1, 0));
  if (const toml::node* line = table.find("first_line"))
    reading.first_line = first_line(file, *line);
  reading.undirected = table.boolean("undirected", false);
  reading.simplify = table.boolean("simple", false) || reading.undirected;
  entry.options.largest_component = table.boolean("largest_component", false);
  entry.options.sample = static_cast<std::uint64_t>(table.integer("sample", 1, kMostSampled, 0));
  if (const toml::node* shuffle = table.find("shuffle")) entry.shuffles = shuffles(file, *shuffle);
}

std::string toml_quoted(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') quoted += '\\';
    if (byte < 32 || byte == 127) {
      quoted += fmt::format("\\u{:04X}", byte);
    } else {
      quoted += c;
    }
  }
  return quoted + '"';
}

/// What a folder's collection is called; empty if it is no folder.
std::string folder_name(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_directory(path, error)) return "";
  return own_graphs_name(std::filesystem::canonical(path, error).string());
}

}  // namespace

std::string own_graphs_name(const std::string& path) {
  std::string name = std::filesystem::path(path).filename().string();
  for (char& c : name) {
    if (!is_graphs_name(std::string("a") + c)) c = '_';
  }
  const bool is_family =
      std::ranges::any_of(families(), [&](const Family& family) { return family.name == name; });
  std::string own = !is_graphs_name(name.substr(0, 1)) || is_family ? "_" : "";
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

std::vector<GraphsEntry> read_graphs(const std::string& file, const toml::node& node) {
  std::vector<GraphsEntry> entries;
  for (const toml::node* given : one_or_many(node)) {
    GraphsEntry entry;
    entry.place = fmt::format("{}:{}: ", file, given->source().begin.line);
    if (given->is_string()) {
      entry.file = toml_text(file, *given, "graphs");
    } else {
      read_table(file, *given, entry);
    }
    if (entry.file.empty() || entry.file == "-") {
      refuse_toml(file, *given, fmt::format("graphs: '{}' is no file", entry.file));
    }
    entries.push_back(std::move(entry));
  }
  if (entries.empty()) refuse_toml(file, node, "graphs is empty");
  return entries;
}

std::string graphs_study_text(const GraphsStudy& study) {
  const ReadOptions& reading = study.reading;
  std::string text =
      fmt::format("study = \"graphs\"\nseed = {}\n{}\n[[sweep]]\n{}graphs = [\n", study.seed,
                  study.count ? "count = true\n" : "",
                  study.timed > 0 ? fmt::format("timed_repetitions = {}\n", study.timed) : "");
  for (const std::string& file : study.files) {
    const std::string name = study.name.empty() ? folder_name(file) : study.name;
    text += name.empty() ? "  { file = " : "  { files = ";
    text += toml_quoted(file);
    if (!name.empty()) text += ", name = " + toml_quoted(name);
    if (!study.groups.empty()) text += ", groups = " + toml_quoted(study.groups);
    if (study.skip) text += ", skip = true";
    if (study.sample > 0) text += fmt::format(", sample = {}", study.sample);
    if (!reading.format.empty()) text += ", format = " + toml_quoted(reading.format);
    if (reading.base != 0) text += fmt::format(", base = {}", reading.base);
    if (reading.first_line == FirstLine::edge) text += ", first_line = \"edge\"";
    if (reading.first_line == FirstLine::header) text += ", first_line = \"header\"";
    if (study.simple) text += ", simple = true";
    if (reading.undirected) text += ", undirected = true";
    if (study.largest_component) text += ", largest_component = true";
    if (study.shuffle) text += ", shuffle = 1";
    text += " },\n";
  }
  text += "]\nalgorithms = [";
  for (const std::string& algorithm : study.algorithms) text += toml_quoted(algorithm) + ", ";
  return text + (study.algorithms.empty() ? "\"all\"]\n" : "]\n");
}

}  // namespace ar3d
