#pragma once

#include <string>
#include <vector>

#include "ar3d/bench/plan/plan.h"
#include "ar3d/formats/catalog.h"
#include "support/graphs.h"
#include "support/problem.h"
#include "support/program.h"

namespace ar3d::testing {

/// A folder with files of graphs, and studies of them.
class GraphFiles : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::vector<Graph>& graphs) const {
    std::string path = scratch_.path(name);
    write_graphs(graphs, *graph_format_of_path(name), path);
    return path;
  }
  Study study(const std::string& sweep) const {
    return {parse_study("study = \"t\"\n[[sweep]]\nalgorithms = \"diamond\"\n" + sweep, "t.toml"),
            scratch_.path("")};
  }

  ScratchDirectory scratch_;
};

}  // namespace ar3d::testing
