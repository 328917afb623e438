// Reads the files whose paths come on standard input, and answers each with a line of JSON: the graphs with their
// names, edges and notes, or why the file is refused.
#include <iostream>
#include <nlohmann/json.hpp>

#include "ar3d/base/error.h"
#include "ar3d/formats/catalog.h"

int main() {
  std::string path;
  while (std::getline(std::cin, path)) {
    nlohmann::json answer;
    try {
      ar3d::GraphReader reader(path);
      answer["graphs"] = nlohmann::json::array();
      while (const std::optional<ar3d::Graph> graph = reader.next()) {
        nlohmann::json edges = nlohmann::json::array();
        for (const ar3d::Edge& edge : graph->edges()) edges.push_back({edge.u, edge.v});
        answer["graphs"].push_back(
            {{"n", graph->num_vertices()}, {"edges", edges}, {"names", reader.names()}});
      }
      answer["notes"] = reader.take_notes();
    } catch (const ar3d::InputError& error) {
      answer["refused"] = error.what();
    }
    std::cout << answer.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace) << std::endl;
  }
}
