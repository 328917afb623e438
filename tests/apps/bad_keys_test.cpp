// Every key of `graphs` and `[[algorithm]]`, and every format of graphs, with a bad value: one
// line that names the place, and exit code 2.
#include <fmt/format.h>

#include "support/program.h"

namespace ar3d::testing {
namespace {

TEST(BadKeys, OfGraphsAreRefused) {
  const ScratchDirectory scratch;
  must("{} generate cycle -n 5 -o " + scratch.path("a.s6"));
  for (const auto& [entry, message] : std::vector<std::pair<const char*, const char*>>{
           {"file = 1", "file is not a string"},
           {"file = 'b.s6'", "cannot read "},
           {"file = 'a.s6', name = 'a b'", "name 'a b' is not 1 to 47 letters"},
           {"file = 'a.s6', name = 3", "name is not a string"},
           {"file = 'a.s6', format = 's7'", "unknown graph format 's7'"},
           {"file = 'a.s6', format = 'dimacs'", "a.s6:1:1: "},
           {"file = 'a.s6', base = 2", "base = 2 is outside 0..1"},
           {"file = 'a.s6', first_line = 'second'", "neither 'edge' nor 'header'"},
           {"file = 'a.s6', simple = 'yes'", "simple is neither true nor false"},
           {"file = 'a.s6', largest_component = 1", "largest_component is neither true nor false"},
           {"file = 'a.s6', sample = 0", "sample = 0 is outside"},
           {"file = 'a.s6', shuffle = [0.5]", "shuffle is not an integer"},
           {"file = 'a.s6', shuffel = 1", "unknown key 'shuffel'"}}) {
    const std::string spec = scratch.write(
        "s.toml",
        fmt::format("study = 's'\n[[sweep]]\ngraphs = {{ {} }}\nalgorithms = 'grid'\n", entry));
    expect_one_line(run("{} study plan " + spec), message);
    EXPECT_THAT(run("{} study run " + spec + " -o " + scratch.path("s.h5")).err,
                HasSubstr(message));
    EXPECT_FALSE(fs::exists(scratch.path("s.h5"))) << entry;
  }
}

TEST(BadKeys, OfAProgramAreRefused) {
  const ScratchDirectory scratch;
  const std::string guarantee = "name = 'm'\ncommand = 'cat'\nguarantee = ";
  for (const auto& [keys, message] : std::vector<std::pair<std::string, const char*>>{
           {"command = 'cat'", "lacks 'name'"},
           {"name = 'm'", "lacks 'command'"},
           {"name = 'diamond'\ncommand = 'cat'", "is an algorithm of the catalogue"},
           {"name = 'm'\ncommand = 5", "command is not a string"},
           {"name = 'm'\ncommand = 'cat {steps}'", "names no option of it"},
           {"name = 'm'\ncommand = 'cat {steps}'\nsteps = 'many'", "steps is not an integer"},
           {"name = 'm'\ncommand = 'cat'\nsteps = 5", "unknown key 'steps'"},
           {"name = 'm'\ncommand = 'cat'\ninput = 'gml'", "input 'gml' is none of"},
           {"name = 'm'\ncommand = 'cat'\ntime_limit_s = 'long'", "time_limit_s is not a number"},
           {"name = 'm'\ncommand = 'cat'\ntime_limit_s_per_vertex = -1", "outside"},
           {"name = 'm'\ncommand = 'cat'\none_graph_per_process = 2", "neither true nor false"},
           {guarantee + "{ max_bends = 3, cosine = [-1, 3] }", "lacks 'max_degree'"},
           {guarantee + "{ max_degree = -1, max_bends = 3, cosine = [-1, 3] }", "max_degree = -1"},
           {guarantee + "{ max_degree = 4, max_bends = 'x', cosine = [-1, 3] }", "max_bends is"},
           {guarantee + "{ max_degree = 4, max_bends = 3, cosine = -0.3 }", "cosine is not"},
           {guarantee + "{ max_degree = 4, max_bends = 3, cosine = [3, 1] }", "cosine is not"},
           {guarantee + "{ max_degree = 4, max_bends = 3, cosine = [-1, 3], box = 5 }",
            "unknown key 'box'"}}) {
    const std::string spec = scratch.write(
        "s.toml", fmt::format("study = 's'\n[[algorithm]]\n{}\n[[sweep]]\nfamilies = 'cycle'\n"
                              "sizes = 5\nalgorithms = 'm'\n",
                              keys));
    const Outcome outcome = run("{} study plan " + spec);
    expect_one_line(outcome, message);
    EXPECT_THAT(outcome.err, HasSubstr("s.toml:")) << keys;
  }
}

TEST(BadKeys, FilesOfEveryFormatAreRefusedByTheirLine) {
  const ScratchDirectory scratch;
  for (const auto& [name, text] : std::vector<std::pair<const char*, const char*>>{
           {"a.g6", "D?\n"},
           {"a.s6", ":D\x01\n"},
           {"a.is6", ":B\n;\x01\n"},
           {"a.d6", "&B?\n"},
           {"a.edges", "0 1\n1 x\n"},
           {"a.adj", "0 1\n1: two\n"},
           {"a.col", "p edge 3 1\ne 1 9\n"},
           {"a.graph", "3 5\n2\n1\n\n"},
           {"a.mtx", "%%MatrixMarket matrix coordinate pattern symmetric\n3 3 1\n7 1\n"},
           {"a.graphml", "<graphml><graph edgedefault='undirected'><edge source='a'/>"}}) {
    const std::string path = scratch.write(name, text);
    expect_one_line(
        run("{} study run --graphs " + path + " --algorithm grid -o " + scratch.path("s.h5")),
        path);
    EXPECT_FALSE(fs::exists(scratch.path("s.h5"))) << name;
  }
}

}  // namespace
}  // namespace ar3d::testing
