// Graphs of files as instances: what is read, kept, sampled and told apart.
#include "ar3d/bench/corpus/corpus.h"

#include <set>

#include "ar3d/base/error.h"
#include "bench/graph_files.h"

namespace ar3d::testing {
namespace {

class Files : public GraphFiles {
 protected:
  static std::vector<Graph> some() {
    std::vector<Graph> graphs;
    for (std::uint64_t i = 0; i < 30; ++i) {
      graphs.push_back(generate(find_family("random-cubic"), 10 + 2 * (i * 7 % 5), i));
    }
    return graphs;
  }
};

TEST_F(Files, AllGraphsComeBackBySizeAndPlace) {
  const std::vector<Graph> graphs = some();
  const Corpus corpus(write("a.s6", graphs), {});
  EXPECT_EQ(corpus.graphs_in_file(), graphs.size());
  ASSERT_EQ(corpus.size(), graphs.size());
  std::set<std::uint32_t> places;
  for (std::size_t i = 0; i < corpus.size(); ++i) {
    const std::uint32_t place = corpus.index(i);
    places.insert(place);
    EXPECT_EQ(corpus.n(i), graphs[place].num_vertices());
    EXPECT_EQ(graph_hash(corpus.graph(place)), graph_hash(graphs[place]));
    if (i == 0) continue;
    EXPECT_LE(std::pair(corpus.n(i - 1), corpus.index(i - 1)), std::pair(corpus.n(i), place));
  }
  EXPECT_EQ(places.size(), graphs.size());
  EXPECT_EQ(corpus.n(corpus.first_of_size(11, 3)), 12u);
  EXPECT_EQ(corpus.first_of_size(1000, 3), corpus.size() - 1);
  EXPECT_EQ(corpus.first_of_size(0, 2), 0u) << "none fits";
  EXPECT_THAT(problem([&] { corpus.graph(30); }), HasSubstr("no graph is taken at index 30"));
}

TEST_F(Files, TheHashIsTheGraphsWhateverTheFormatAndThePacking) {
  const std::string hash = Corpus(write("a.s6", some()), {}).hash();
  for (const char* name : {"a.g6", "a.edges", "a.mtx", "a.graphml", "a.metis"}) {
    const std::string path = write(name, some());
    EXPECT_EQ(Corpus(path, {}).hash(), hash) << name;
    expect_exit(0, run("gzip -k " + path));
    EXPECT_EQ(Corpus(path + ".gz", {}).hash(), hash) << name;
  }
  std::vector<Graph> other = some();
  std::swap(other[3], other[4]);
  EXPECT_NE(Corpus(write("b.s6", other), {}).hash(), hash);
}

TEST_F(Files, ALargeGraphSurvivesTheSpool) {
  const Graph graph = generate(find_family("random-4-regular"), 60000, 1);
  const Corpus corpus(write("large.s6", {petersen(), graph}), {});
  EXPECT_EQ(graph_hash(corpus.graph(1)), graph_hash(graph));
  EXPECT_EQ(graph_hash(corpus.graph(0)), graph_hash(petersen()));
}

TEST_F(Files, ASampleIsPartOfEveryLargerOne) {
  const std::string path = write("a.s6", some());
  const auto places = [&](std::uint64_t sample, std::uint64_t seed) {
    const Corpus corpus(path, {.sample = sample, .sample_seed = seed});
    EXPECT_EQ(corpus.graphs_in_file(), 30u);
    std::set<std::uint32_t> places;
    for (std::size_t i = 0; i < corpus.size(); ++i) {
      places.insert(corpus.index(i));
      EXPECT_EQ(graph_hash(corpus.graph(corpus.index(i))), graph_hash(some()[corpus.index(i)]));
    }
    EXPECT_EQ(places.size(), std::min<std::uint64_t>(sample, 30));
    return places;
  };
  EXPECT_TRUE(std::ranges::includes(places(12, 1), places(5, 1)));
  EXPECT_EQ(places(100, 1).size(), 30u);
  EXPECT_NE(places(5, 1), places(5, 2));
}

TEST_F(Files, TheLargestComponentIsTaken) {
  const Graph graph = disjoint_union({complete(4), petersen()});
  const Corpus corpus(write("a.s6", {graph}), {.largest_component = true});
  EXPECT_EQ(graph_hash(corpus.graph(0)), graph_hash(petersen()));
}

TEST(Subgraphs, APieceIsInducedAndHasTheFirstVerticesFound) {
  const Graph path(6, {{0, 5}, {5, 1}, {1, 4}, {4, 2}, {2, 3}});
  const Graph piece = breadth_first_piece(path, 3);
  EXPECT_THAT(piece.edges(), ElementsAre(Edge{0, 1}, Edge{1, 2}));
  const Graph apart(4, {{0, 1}, {2, 3}});
  EXPECT_THAT(breadth_first_piece(apart, 3).edges(), ElementsAre(Edge{0, 1}));
  EXPECT_EQ(graph_hash(breadth_first_piece(apart, 9)), graph_hash(apart));
}

TEST_F(Files, LoopsAndParallelEdgesAreDroppedOnlyIfAsked) {
  const struct {
    const char* name;
    const char* text;
  } texts[] = {
      {"a.edges", "# vertices 4\n0 1\n1 0\n2 2\n2 3\n0 1\n"},
      {"a.adj", "# vertices 4\n0: 1 1\n1: 0\n2: 2 3\n3: 2\n"},
      {"a.mtx", "%%MatrixMarket matrix coordinate pattern symmetric\n4 4 4\n2 1\n2 1\n3 3\n4 3\n"},
      {"b.mtx",
       "%%MatrixMarket matrix coordinate pattern general\n4 4 6\n2 1\n1 2\n2 1\n3 3\n4 3\n3 4\n"},
      {"a.metis", "4 4\n2 2\n1 1\n3 4\n3\n"},
      {"a.col", "p edge 4 4\ne 1 2\ne 2 1\ne 3 3\ne 3 4\n"},
      {"a.graphml",
       "<graphml><graph edgedefault=\"undirected\"><node id=\"a\"/><node id=\"b\"/><node id=\"c\"/>"
       "<node id=\"d\"/><edge source=\"a\" target=\"b\"/><edge source=\"b\" target=\"a\"/>"
       "<edge source=\"c\" target=\"c\"/><edge source=\"c\" target=\"d\"/></graph></graphml>"},
      {"a.s6", ":C_u\n"},  // (0,1) (0,1) (2,2) (2,3)
  };
  GraphsEntry simple;
  simple.reading.simplify = true;
  for (const auto& [name, text] : texts) {
    const std::string path = scratch_.write(name, text);
    EXPECT_NE(problem([&] { Corpus corpus(path, {}); }), "") << name;
    ReadOptions reading;
    reading.simplify = true;
    const Graph graph = read_graph(path, reading);
    EXPECT_EQ(graph.num_vertices(), 4u) << name;
    EXPECT_THAT(graph.edges(), ElementsAre(Edge{0, 1}, Edge{2, 3})) << name;
    EXPECT_EQ(Corpus(path, simple).size(), 1u) << name;
  }
}

TEST_F(Files, InstancesHaveTheirPlaceAndTheirKeysNoName) {
  write("a.s6", some());
  const StudyPlan plan = plan_study(study("graphs = \"a.s6\"\nrepetitions = 2\n"));
  ASSERT_EQ(plan.instances.size(), 30u);
  EXPECT_EQ(plan.instances.blocks().size(), 5u) << "one for every n";
  std::set<std::string> keys;
  for (const PlannedInstance& instance : plan.instances) {
    EXPECT_EQ(instance.choice.family->name, "a.s6");
    EXPECT_EQ(graph_hash(graph_of(instance)), graph_hash(some()[instance.index]));
    EXPECT_EQ(instance.n, some()[instance.index].num_vertices());
    for (const PlannedRun& run : instance.runs) keys.insert(run.row_key);
  }
  EXPECT_EQ(keys.size(), 60u);
  fs::rename(scratch_.path("a.s6"), scratch_.path("b.s6"));
  const StudyPlan renamed = plan_study(study("graphs = \"b.s6\"\n"));
  for (const PlannedInstance& instance : renamed.instances) {
    EXPECT_TRUE(keys.contains(instance.runs.front().row_key));
  }
}

TEST_F(Files, PartsOfAPlanShareItsInstances) {
  write("a.s6", some());
  const StudyPlan plan = plan_study(study("graphs = \"a.s6\"\n"));
  std::set<std::string> keys;
  for (std::size_t i = 0; i < 4; ++i) {
    for (const PlannedInstance& instance : plan.instances.every_nth(i, 4)) {
      keys.insert(instance.runs.front().row_key);
      EXPECT_EQ(graph_hash(graph_of(instance)), graph_hash(some()[instance.index]));
    }
  }
  std::set<std::string> all;
  for (const PlannedInstance& instance : plan.instances) all.insert(instance.runs.front().row_key);
  EXPECT_EQ(keys, all);
}

TEST_F(Files, ShufflesAreInstancesOfTheirOwn) {
  write("a.s6", {petersen()});
  const StudyPlan plan = plan_study(study("graphs = { file = \"a.s6\", shuffle = [0, 1, 2] }\n"));
  ASSERT_EQ(plan.instances.size(), 3u);
  EXPECT_EQ(plan.instances[0].parameters, "");
  EXPECT_EQ(plan.instances[2].parameters, "shuffle=2");
  std::set<std::string> hashes;
  for (const PlannedInstance& instance : plan.instances)
    hashes.insert(graph_hash(graph_of(instance)));
  EXPECT_EQ(hashes.size(), 3u);
  EXPECT_TRUE(hashes.contains(graph_hash(petersen())));
}

TEST_F(Files, PatternsTakeFilesByNameAndCellsCanBeLeftOut) {
  write("one.s6", {petersen()});
  write("two.s6", {complete(4)});
  const auto names = [](const StudyPlan& plan) {
    std::vector<std::string> names;
    for (const PlannedInstance& instance : plan.instances)
      names.push_back(instance.choice.family->name);
    return names;
  };
  EXPECT_THAT(names(plan_study(study("graphs = \"*.s6\"\n"))), ElementsAre("one.s6", "two.s6"));
  EXPECT_THAT(names(plan_study(study("graphs = \"*.s6\"\nexclude = { family = \"one.s6\" }\n"))),
              ElementsAre("two.s6"));
  EXPECT_THAT(names(plan_study(study("graphs = \"*.s6\"\ninclude = { to = 4 }\n"))),
              ElementsAre("two.s6"));
  EXPECT_THAT(names(plan_study(study("graphs = { file = \"one.s6\", name = \"mine\" }\n"
                                     "families = \"cycle\"\nsizes = 5\n"))),
              ElementsAre("cycle", "mine"));
}

TEST_F(Files, WhatCannotBeIsRefusedInOneLine) {
  write("a.s6", {petersen()});
  write("copy.s6", {petersen()});
  fs::create_directory(scratch_.path("sub"));
  write("sub/a.s6", {complete(4)});
  scratch_.write("cycle", ":C_u\n");
  scratch_.write("broken.s6", ":Ooo\n:!\n");
  const std::pair<const char*, const char*> cases[] = {
      {"graphs = \"none.s6\"", "t.toml:4: cannot read "},
      {"graphs = \"*.mtx\"", "t.toml:4: no file matches '*.mtx'"},
      {"graphs = { file = \"*.s6\", name = \"x\" }", "one name for the 3 files"},
      {"graphs = [\"a.s6\", \"copy.s6\"]", "holds the same graphs as"},
      {"graphs = [\"a.s6\", \"sub/a.s6\"]", "would both be called a.s6"},
      {"graphs = { file = \"a.s6\", name = \"cycle\" }",
       "is the name of a family of the catalogue"},
      {"graphs = \"broken.s6\"", "broken.s6:1:"},
      {"graphs = [\"a.s6\", { file = \"a.s6\", sample = 1 }]", "with different samples"},
      {"graphs = \"a.s6\"\nexclude = { family = \"b.s6\" }", "t.toml:5: unknown family 'b.s6'"},
  };
  for (const auto& [sweep, message] : cases) {
    const Study spec = study(std::string(sweep) + "\n");
    const std::string told = problem([&] { plan_study(spec); });
    EXPECT_THAT(told, HasSubstr(message)) << sweep;
    EXPECT_EQ(std::count(told.begin(), told.end(), '\n'), 0) << told;
  }
  const std::pair<const char*, const char*> unread[] = {
      {"graphs = 3", "is not a table"},
      {"graphs = []", "graphs is empty"},
      {"graphs = \"\"", "is no file"},
      {"graphs = \"-\"", "is no file"},
      {"graphs = { name = \"x\" }", "lacks 'file'"},
      {"graphs = { file = \"a\", name = \"a b\" }", "name 'a b' is not"},
      {"graphs = { file = \"a\", format = \"s7\" }", "unknown graph format 's7'"},
      {"graphs = { file = \"a\", first_line = \"x\" }", "neither 'edge' nor 'header'"},
      {"graphs = { file = \"a\", base = 2 }", "base = 2 is outside 0..1"},
      {"graphs = { file = \"a\", sample = 0 }", "sample = 0 is outside"},
      {"graphs = { file = \"a\", simple = 1 }", "simple is neither true nor false"},
      {"graphs = { file = \"a\", largest_component = \"x\" }", "neither true nor false"},
      {"graphs = { file = \"a\", shuffle = -1 }", "shuffle = -1 is outside"},
      {"graphs = { file = \"a\", shuffle = [] }", "shuffle is empty"},
      {"graphs = { file = \"a\", component = true }", "unknown key 'component'"},
      {"graphs = \"a\"\nfamilies = \"cycle\"", "lacks 'sizes'"},
      {"graphs = \"a\"\nsizes = 3", "unknown key 'sizes'"},
  };
  for (const auto& [sweep, message] : unread) {
    const std::string text = std::string(sweep) + "\n";
    EXPECT_THAT(problem([&] { study(text); }), HasSubstr(message)) << sweep;
  }
}

TEST_F(Files, AStudyThatBeganKeepsItsFilesAndNoticesAChange) {
  write("a.s6", some());
  Study spec = study("graphs = \"*.s6\"\n");
  std::vector<GraphFileRecord> files;
  for (const StudyCorpus& corpus : corpora_of(spec)) files.push_back(corpus.record);
  ASSERT_EQ(files.size(), 1u);
  write("b.s6", {petersen()});
  Study later = study("graphs = \"*.s6\"\n");
  later.begun_with = files;
  EXPECT_EQ(plan_study(later).instances.size(), 30u) << "b.s6 is no file of that study";
  write("a.s6", {petersen()});
  later.open_files = std::make_shared<OpenFiles>();
  const std::string told = problem([&] { plan_study(later); });
  EXPECT_THAT(told,
              HasSubstr("a.s6: its graphs are not those that the study began with (1 graphs"));
}

TEST(GraphFileTable, KeepsAnyPath) {
  StudyIdentity identity;
  const std::vector<GraphFileRecord> records = {
      {"a.s6", 0, 7, std::string(32, 'a'), "/tmp/with blank/100%/\xc3\xa4.s6"}};
  identity.tables = {side_table<GraphFileRecord>(records)};
  const std::vector<GraphFileRecord> read = side_records<GraphFileRecord>(identity);
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0].path, records[0].path);
  EXPECT_EQ(read[0].hash, records[0].hash);
  EXPECT_EQ(read[0].graphs, 7);
  EXPECT_EQ(read[0].groups, "");
  identity.tables = {side_table<SkippedFile>({{"a", std::string(100, 'f'), "caf\xc3\xa9"}})};
  ASSERT_EQ(side_records<SkippedFile>(identity).size(), 1u);
  EXPECT_EQ(side_records<SkippedFile>(identity)[0].reason, "caf\u00e9");
  EXPECT_THROW(side_table<GraphFileRecord>({{"a", 0, 1, "", std::string(1025, 'x')}}), InputError);
}

}  // namespace
}  // namespace ar3d::testing
