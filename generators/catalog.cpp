// The table of families: one row says all that studies, programs and tests know of a family, and
// every row's generator is a pure function. A table and no self-registering objects, which a static
// library would drop.
#include "ar3d/generators/catalog.h"

#include <fmt/format.h>

#include "ar3d/base/error.h"
#include "ar3d/base/nearest_name.h"
#include "ar3d/base/open_table.h"
#include "ar3d/generators/families.h"
#include "ar3d/generators/random_graphs.h"
#include "ar3d/generators/sizes.h"

namespace ar3d {
namespace {

using S = std::uint64_t;    // seed
using P = const Settings&;  // complete parameters

Drawing straight_drawing(const char* name, const std::pair<Graph, std::vector<Point>>& piece) {
  return drawing_from_points(name, piece.first, piece.second);
}

const SettingSpec kTorusRows = {"rows", 3, 1000000, 4, "length of the short cycles"};
const SettingSpec kJump = {"k", 1, 1000000, 2, "step of the inner edges"};
const SettingSpec kDegree = {"degree", 1, 4, 3, "degree of every vertex"};
const SettingSpec kMaxDegree = {"degree", 1, 4, 4, "largest degree allowed"};
const SettingSpec kEdgesPerVertex = {"edges-per-vertex", 0, 2000000, 1400000,
                                     "edges per vertex, in parts per million"};
const SettingSpec kLeafSize = {"leaf", 5, 7, 5, "vertices of a leaf block, 5 or 7"};
const SettingSpec kTreeShape = {"shape", 0, 1, 0, "0 balanced, 1 a caterpillar"};
const SettingSpec kLeaves = {"leaves", 1, 4, 3, "leaves of a star"};
const SettingSpec kStepA = {"a", 1, 1000000, 1, "the smaller step"};
const SettingSpec kStepB = {"b", 2, 1000000, 4, "the larger step"};
const SettingSpec kOuterJump = {"j", 1, 1000000, 2, "step of the outer edges"};
const SettingSpec kInnerJump = {"k", 1, 1000000, 3, "step of the inner edges"};
const SettingSpec kSnarkType = {"type", 1, 2, 1, "distance of the two edges cut in each link"};
const SettingSpec kAround = {"around", 5, 6, 5, "vertices of the caps"};
const SettingSpec kTurn = {"b", 0, 8000, 0, "b of GC(a, b), n = 20 (a^2 + ab + b^2) with a >= b"};
const SettingSpec kKeep = {"keep", 0, 1000000, 800000,
                           "probability of an edge, in parts per million"};
const SettingSpec kTreeDegree = {"degree", 2, 4, 3, "largest degree allowed"};
const SettingSpec kCycleLength = {"length", 3, 1000000, 5, "vertices of a cycle"};
const SettingSpec kBridges = {"bridges", 0, 1000000, 3, "number of bridges"};
const SettingSpec kLegs = {"legs", 1, 2, 1, "pendant vertices of a spine vertex"};

SettingSpec named_graph_index() {
  return {"index", 0, static_cast<std::int64_t>(named_graphs().size()) - 1, 7, "0 is the smallest"};
}
std::uint32_t keep(P parameters) {
  return static_cast<std::uint32_t>(count_of(parameters, "keep"));
}

// clang-format off
std::vector<Family> catalogue() {
  // name, one sentence, maximum degree, random?, parameters, sizes, generator
  return {
      {"edgeless", "No edges at all", 0, false, {}, from<0>,
       [](Count n, S, P) { return Graph(n, {}); }},
      {"perfect-matching", "Disjoint edges", 1, false, {}, steps<2, 2>,
       [](Count n, S, P) { return stars(n / 2, 1); }},
      {"path", "The path", 2, false, {}, from<1>, [](Count n, S, P) { return path_graph(n); }},
      {"cycle", "The cycle", 2, false, {}, from<3>, [](Count n, S, P) { return cycle_graph(n); }},
      {"stars", "Disjoint stars", 3, false, {kLeaves},
       [](Count n, P p) { return multiple(n, count_of(p, "leaves") + 1); },
       [](Count n, S, P p) { return stars(n / (count_of(p, "leaves") + 1), count_of(p, "leaves")); }},
      {"caterpillar", "A path whose vertices carry one or two pendant vertices each", 3, false,
       {kLegs}, [](Count n, P p) { return multiple(n, count_of(p, "legs") + 1); },
       [](Count n, S, P p) { return caterpillar(n / (count_of(p, "legs") + 1), count_of(p, "legs")); }},
      {"binary-tree", "The heap-shaped binary tree", 3, false, {}, from<1>,
       [](Count n, S, P) { return binary_tree(n); }},
      {"spine-with-pendant-trees", "A path whose vertices carry trees of 3, 5, 9 vertices in turn",
       3, false, {}, steps<20, 20>,
       [](Count n, S, P) { return spine_with_pendant_trees(n / 20); }},

      {"random-tree", "Every vertex joined to a random earlier one of degree below the limit", 3,
       true, {kTreeDegree}, from<1>,
       [](Count n, S seed, P p) { return random_tree(n, count_of(p, "degree"), seed); }},

      {"ladder", "Two paths with rungs", 3, false, {}, steps<2, 2>,
       [](Count n, S, P) { return ladder(n / 2); }},
      {"prism", "Two cycles with rungs", 3, false, {}, steps<6, 2>,
       [](Count n, S, P) { return prism(n / 2); }},
      {"moebius-ladder", "A cycle with all its long diagonals", 3, false, {}, steps<4, 2>,
       [](Count n, S, P) { return moebius_ladder(n / 2); }},
      {"squared-cycle", "A cycle with all chords of length 2; antiprisms for even n", 4, false, {},
       from<5>, [](Count n, S, P) { return squared_cycle(n); }},
      {"circulant", "C_n(a, b): every i joined to i +- a and i +- b", 4, false, {kStepA, kStepB},
       [](Count n, P p) { return std::max(n, 2 * count_of(p, "b") + 1); },
       [](Count n, S, P p) { return circulant(n, count_of(p, "a"), count_of(p, "b")); }},
      {"hypercube", "Q_0 to Q_4", 4, false, {}, hypercube_sizes,
       [](Count n, S, P) { return hypercube(static_cast<Count>(std::countr_zero(n))); }},
      {"square-grid", "The square patch of k by k vertices", 4, false, {}, squares<1>,
       [](Count n, S, P) { return square_grid(root(n), root(n)); }},
      {"torus", "The product of two cycles", 4, false, {kTorusRows},
       [](Count n, P p) { return nearest_step(n, 3 * count_of(p, "rows"), count_of(p, "rows")); },
       [](Count n, S, P p) { return torus(count_of(p, "rows"), n / count_of(p, "rows")); }},
      {"honeycomb", "The hexagonal patch of the honeycomb with k hexagons on a side", 3, false, {},
       squares<6>, [](Count n, S, P) { return honeycomb(root(n / 6)); }},
      {"diamond-lattice", "Breadth-first piece of the diamond lattice", 4, false, {}, from<1>,
       [](Count n, S, P) { return diamond_lattice_piece(n).first; },
       [](Count n, S, P) { return straight_drawing("diamond-lattice", diamond_lattice_piece(n)); }},
      {"laves-graph", "Breadth-first piece of the Laves graph", 3, false, {}, from<1>,
       [](Count n, S, P) { return laves_piece(n).first; },
       [](Count n, S, P) { return straight_drawing("laves-graph", laves_piece(n)); }},
      {"percolated-square-grid", "Random edges of the square patch", 4, true, {kKeep}, squares<1>,
       [](Count n, S seed, P p) { return thinned(square_grid(root(n), root(n)), keep(p), seed); }},
      {"percolated-honeycomb", "Random edges of the hexagonal patch of the honeycomb", 3, true,
       {kKeep}, squares<6>,
       [](Count n, S seed, P p) { return thinned(honeycomb(root(n / 6)), keep(p), seed); }},
      {"percolated-diamond-lattice", "Random edges of a piece of the diamond lattice", 4, true,
       {kKeep}, from<1>,
       [](Count n, S seed, P p) { return thinned(diamond_lattice_piece(n).first, keep(p), seed); }},
      {"percolated-laves-graph", "Random edges of a piece of the Laves graph", 3, true, {kKeep},
       from<1>, [](Count n, S seed, P p) { return thinned(laves_piece(n).first, keep(p), seed); }},

      {"nested-triangles", "Triangles inside one another, neighbours joined by three edges", 4, false,
       {}, steps<3, 3>, [](Count n, S, P) { return nested_triangles(n / 3); }},
      {"iterated-truncation", "K4 truncated again and again", 3, false, {}, truncation_sizes,
       [](Count n, S, P) { return iterated_truncation(n); }},
      {"nested-truncation", "K4 whose innermost vertex is truncated again and again", 3, false, {},
       steps<4, 2>, [](Count n, S, P) { return nested_truncation((n - 4) / 2); }},
      {"nanotube", "Fullerene tubes (5, 0) and (6, 0) with their caps", 3, false, {kAround},
       [](Count n, P p) { return multiple(n, 2 * count_of(p, "around"), 2); },
       [](Count n, S, P p) {
         return nanotube(count_of(p, "around"), n / (2 * count_of(p, "around")) - 1);
       }},
      {"fullerene", "Icosahedral fullerenes (Goldberg 1937, Coxeter 1971)", 3, false, {kTurn},
       fullerene_sizes, fullerene_of_size},

      {"generalised-petersen", "GP(N, k) with N = n/2 (Watkins 1969)", 3, false, {kJump},
       [](Count n, P p) { return nearest_step(n, 4 * count_of(p, "k") + 2, 2); },
       [](Count n, S, P p) { return generalised_petersen(n / 2, count_of(p, "k")); }},
      {"flower-snark", "Isaacs' flower snarks J_k with odd k = n/4 (Isaacs 1975)", 3, false, {},
       steps<12, 8>, [](Count n, S, P) { return flower_snark(n / 4); }},
      {"i-graph", "I(N, j, k) with N = n/2 (Foster census)", 3, false, {kOuterJump, kInnerJump},
       [](Count n, P p) {
         return nearest_step(n, 4 * std::max(count_of(p, "j"), count_of(p, "k")) + 2, 2);
       },
       [](Count n, S, P p) { return i_graph(n / 2, count_of(p, "j"), count_of(p, "k")); }},
      {"blanusa-snark", "Chain of Petersen graphs by dot products (Blanusa 1946, Watkins 1983)", 3,
       false, {kSnarkType}, steps<10, 8>,
       [](Count n, S, P p) { return blanusa_snark((n - 10) / 8, count_of(p, "type")); }},
      {"goldberg-snark", "Goldberg's snarks G_k with odd k = n/8 (Goldberg 1981)", 3, false, {},
       steps<40, 16>, [](Count n, S, P) { return goldberg_snark(n / 8); }},
      {"odd-graph", "The odd graphs O_2, O_3 and O_4 (Kneser graphs)", 4, false, {}, 
       [](Count n, P) { return n >= 35 ? Count{35} : n >= 10 ? Count{10} : Count{3}; },
       [](Count n, S, P) { return odd_graph(n == 35 ? 4 : n == 10 ? 3 : 2); }},
      {"named", "One of the named graphs, by its place in their list; n is its own", 4, false,
       {named_graph_index()},
       [](Count, P p) { return Count{named_graphs()[count_of(p, "index")].num_vertices}; },
       [](Count, S, P p) { return named_graphs()[count_of(p, "index")].make(); }},

      {"cubic-tree", "Cubic graph whose bridges form a tree that ends in leaf blocks", 3, false,
       {kLeafSize, kTreeShape}, cubic_tree_sizes, cubic_tree_of_size},
      {"random-cubic-tree", "Cubic graph whose bridges form a random tree with 5- and 7-vertex leaf "
       "blocks", 3, true, {}, steps<10, 2>, random_cubic_tree_of_size},
      {"random-cubic-bridges", "Cubic with exactly b bridges: random bridgeless pieces in a random tree", 3,
       true, {kBridges},
       [](Count n, P p) { return nearest_step(n, 6 * count_of(p, "bridges") + 4, 2); },
       [](Count n, S seed, P p) { return random_cubic_with_bridges(n, count_of(p, "bridges"), seed); }},
      {"block-chain", "Diamonds between two leaf blocks, joined by bridges", 3, false, {},
       steps<10, 4>, [](Count n, S, P) { return block_chain((n - 10) / 4); }},
      {"diamond-necklace", "A ring of diamonds (K4 without an edge)", 3, false, {}, steps<8, 4>,
       [](Count n, S, P) { return diamond_necklace(n / 4); }},
      {"random-cactus", "Cycles glued together at random single vertices", 4, true, {kCycleLength},
       
       [](Count n, P p) { return nearest_step(n, count_of(p, "length"), count_of(p, "length") - 1); },
       [](Count n, S seed, P p) {
         const Count length = count_of(p, "length");
         return random_cactus((n - 1) / (length - 1), length, seed);
       }},

      {"contained-cycles", "A long cycle with a triangle on every other of six vertices (hard for "
       "diamond)", 4, false, {}, steps<12, 6>,
       [](Count n, S, P) { return contained_cycles(n / 6); }},
      {"mixed-union", "Small dense components of many kinds in turn (hard for grid)", 3, false, {},
       steps<36, 36>, [](Count n, S, P) { return mixed_union(n / 36); }},
      {"true-sinks", "Leaf blocks of 7 vertices on their own (hard for two-bend)", 3, false, {},
       steps<7, 7>, [](Count n, S, P) { return copies_of(leaf_block(7), n / 7); }},

      {"union-triangle", "Disjoint triangles", 2, false, {}, steps<3, 3>,
       [](Count n, S, P) { return copies_of(complete_graph(3), n / 3); }},
      {"union-k4", "Disjoint copies of K4", 3, false, {}, steps<4, 4>,
       [](Count n, S, P) { return copies_of(complete_graph(4), n / 4); }},
      {"union-k5", "Disjoint copies of K5", 4, false, {}, steps<5, 5>,
       [](Count n, S, P) { return copies_of(complete_graph(5), n / 5); }},
      {"union-k33", "Disjoint copies of K3,3", 3, false, {}, steps<6, 6>,
       [](Count n, S, P) { return copies_of(complete_bipartite(3, 3), n / 6); }},
      {"union-octahedron", "Disjoint octahedra", 4, false, {}, steps<6, 6>,
       [](Count n, S, P) { return copies_of(octahedron_graph(), n / 6); }},
      {"union-petersen", "Disjoint copies of the Petersen graph", 3, false, {}, steps<10, 10>,
       [](Count n, S, P) { return copies_of(generalised_petersen(5, 2), n / 10); }},
      {"union-flower-snark", "Disjoint copies of the flower snark J_5", 3, false, {},
       steps<20, 20>, [](Count n, S, P) { return copies_of(flower_snark(5), n / 20); }},

      {"random-regular", "Uniform over the labelled simple d-regular graphs", 3, true, {kDegree},
       regular_sizes,
       [](Count n, S seed, P p) {
         return random_regular(n, static_cast<std::uint32_t>(count_of(p, "degree")), seed);
       }},
      {"random-cubic", "Uniform over the labelled simple cubic graphs", 3, true, {}, steps<4, 2>,
       [](Count n, S seed, P) { return random_regular(n, 3, seed); }},
      {"random-4-regular", "Uniform over the labelled simple 4-regular graphs", 4, true, {},
       from<5>, [](Count n, S seed, P) { return random_regular(n, 4, seed); }},
      {"random-max-degree", "Part of a random pairing: maximum degree and number of edges given", 4,
       true, {kMaxDegree, kEdgesPerVertex}, from<1>, random_max_degree_of_size},
      {"random-connected-cubic", "Uniform over the connected labelled simple cubic graphs", 3, true,
       {}, steps<4, 2>, [](Count n, S seed, P) { return random_connected_regular(n, 3, seed); }},
      {"random-connected-4-regular", "Uniform over the connected labelled simple 4-regular graphs", 4,
       true, {}, from<5>, [](Count n, S seed, P) { return random_connected_regular(n, 4, seed); }},
      {"random-bipartite-cubic", "Uniform over the simple cubic graphs with two given sides", 3, true,
       {}, steps<6, 2>, [](Count n, S seed, P) { return random_bipartite_cubic(n, seed); }},
      {"random-subcubic", "Random edges of a uniformly random cubic graph", 3, true, {kKeep},
       steps<4, 2>,
       [](Count n, S seed, P p) { return thinned(random_regular(n, 3, seed), keep(p), seed); }},
  };
}
// clang-format on

constexpr Count kMostVertices = (Count{1} << 30) - 1;  // 2n edges keep Graph's limit of 2^31 - 1

const SettingSpec kShuffle{"shuffle", 0, 1, 0, "1: labels permuted at random by the seed"};
constexpr std::uint64_t kShuffleStream = 0x73687566666c65;  // "shuffle"

OpenTable<Family>& table() {
  static OpenTable<Family> rows("family", catalogue(), [](const Family& row) {
    return row.nearest_n != nullptr && row.generate != nullptr;
  });
  return rows;
}

}  // namespace

const std::vector<Family>& families() { return table().rows(); }

void register_family(Family row) { table().add(std::move(row)); }

const Family& find_family(std::string_view name) {
  if (const Family* family = table().find(name)) return *family;
  throw InputError(fmt::format("unknown family '{}'{} (see: ar3d list families)", name,
                               did_you_mean(name, names_of(families()))));
}

bool is_shuffled(const Settings& parameters) {
  return !parameters.empty() && parameters.back() == Setting{kShuffle.name, 1};
}

bool depends_on_seed(const Family& family, const Settings& parameters) {
  return family.is_random || is_shuffled(parameters);
}

Settings complete_parameters(const Family& family, const Settings& given) {
  std::vector<SettingSpec> specs = family.parameters;
  specs.push_back(kShuffle);
  Settings parameters =
      complete_settings(fmt::format("family {}", family.name), "parameter", specs, given);
  if (!is_shuffled(parameters)) parameters.pop_back();
  return parameters;
}

Graph generate(const Family& family, std::uint64_t n, std::uint64_t seed, const Settings& given) {
  Settings parameters = complete_parameters(family, given);
  const bool shuffle = is_shuffled(parameters);
  if (shuffle) parameters.pop_back();
  if (n > kMostVertices || family.nearest_n(n, parameters) > kMostVertices) {
    throw InputError(fmt::format("family {}: {} vertices are too many, the limit is {}",
                                 family.name, n, kMostVertices));
  }
  const Count own_n = family.nearest_n(n, parameters);
  Graph graph = family.generate(own_n, seed, parameters);
  expect(graph.num_vertices() == own_n, "a family's graph has nearest_n vertices");
  if (!shuffle) return graph;
  RandomStream random(seed, kShuffleStream);
  return shuffled_labels(graph, random);
}

}  // namespace ar3d
