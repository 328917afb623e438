#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "ar3d/formats/graphs/graph_format.h"

namespace ar3d {

/// How a graph file is to be read, as every verb that reads one is told.
struct GraphInput {
  ReadOptions options;
  std::string first_line = "automatic";
  bool trust_sizes = false;

  ReadOptions read_options() const;
};

/// The options --base and --first-line.
void add_edge_list_options(CLI::App& verb, GraphInput& input);

/// These and --from and --trust-sizes.
void add_graph_input_options(CLI::App& verb, GraphInput& input);

}  // namespace ar3d
