// Reads the files whose paths come on standard input, each with options behind a tab ("base=1 simple"), and answers
// each with a line of JSON: the graphs with their names, edges and notes, or why the file is refused.
#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "ar3d/base/error.h"
#include "ar3d/formats/catalog.h"

namespace ar3d {
namespace {

/// Every byte as the character of its number, so that none is lost.
std::vector<std::string> as_latin1(std::vector<std::string> names) {
  for (std::string& name : names) {
    std::string text;
    for (const char c : name) {
      const auto byte = static_cast<unsigned char>(c);
      if (byte >= 0x80) text += static_cast<char>(0xc0 | byte >> 6);
      text += static_cast<char>(byte >= 0x80 ? 0x80 | (byte & 0x3f) : byte);
    }
    name = text;
  }
  return names;
}

ReadOptions options_of(const std::string& words) {
  ReadOptions options;
  std::istringstream text(words);
  for (std::string word; text >> word;) {
    const std::string value = word.substr(word.find('=') + 1);
    if (word.starts_with("format=")) options.format = value;
    if (word.starts_with("base=")) options.base = static_cast<unsigned>(std::stoul(value));
    if (word == "first_line=edge") options.first_line = FirstLine::edge;
    if (word == "first_line=header") options.first_line = FirstLine::header;
    options.simplify = options.simplify || word == "simple";
    options.undirected = options.undirected || word == "undirected";
  }
  return options;
}

}  // namespace
}  // namespace ar3d

int main() {
  std::string path;
  while (std::getline(std::cin, path)) {
    nlohmann::json answer;
    try {
      const std::size_t tab = std::min(path.find('\t'), path.size());
      ar3d::GraphReader reader(path.substr(0, tab), ar3d::options_of(path.substr(tab)));
      answer["graphs"] = nlohmann::json::array();
      while (const std::optional<ar3d::Graph> graph = reader.next()) {
        nlohmann::json edges = nlohmann::json::array();
        for (const ar3d::Edge& edge : graph->edges()) edges.push_back({edge.u, edge.v});
        answer["graphs"].push_back({{"n", graph->num_vertices()},
                                    {"edges", edges},
                                    {"names", ar3d::as_latin1(reader.names())}});
      }
      answer["notes"] = reader.take_notes();
    } catch (const ar3d::InputError& error) {
      answer["refused"] = error.what();
    }
    std::cout << answer.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace) << std::endl;
  }
}
