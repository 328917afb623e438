#include "graph_input.h"

#include <limits>

#include "numbers.h"
#include "words.h"

namespace ar3d {

ReadOptions GraphInput::read_options() const {
  ReadOptions chosen = options;
  if (first_line == "edge") chosen.first_line = FirstLine::edge;
  if (trust_sizes) chosen.free_vertices = std::numeric_limits<Vertex>::max();
  if (first_line == "header") chosen.first_line = FirstLine::header;
  return chosen;
}

void add_edge_list_options(CLI::App& verb, GraphInput& input) {
  verb.add_option("--base", input.options.base,
                  "smallest vertex id of edge and adjacency lists: 0 or 1")
      ->check(whole_number(0, 1));
  verb.add_option("--first-line", input.first_line,
                  "what a first line 'a b' of an edge list is where that is open: edge, or header "
                  "(numbers of vertices and edges)")
      ->check(one_of({"automatic", "edge", "header"}));
}

void add_graph_input_options(CLI::App& verb, GraphInput& input) {
  verb.add_option("--from", input.options.format,
                  "format of the graphs that are read; detected by content if left out");
  add_edge_list_options(verb, input);
  verb.add_flag("--trust-sizes", input.trust_sizes,
                "believe a file's number of vertices, however few bytes stand behind it");
}

}  // namespace ar3d
