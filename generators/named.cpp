// Graphs with names of their own, most in LCF notation (Lederberg, Coxeter and Frucht), whose
// chords lcf_graph() checks from both ends: a wrong number of a table is found when the graph is
// made.

#include <fmt/format.h>

#include <algorithm>

#include "ar3d/base/error.h"
#include "ar3d/generators/families.h"

namespace ar3d {
namespace {

/// A graph given by its LCF notation.
NamedGraph lcf(std::string name, std::string summary, std::vector<int> shifts, Count repeats) {
  const auto n = static_cast<Vertex>(shifts.size() * repeats);
  return {std::move(name), std::move(summary), n,
          [shifts = std::move(shifts), repeats] { return lcf_graph(shifts, repeats); }};
}

/// Seven claws; the leaves of one kind form a cycle whose steps are 1, 2 or 3 modulo 7.
Graph coxeter_graph() {
  GraphBuilder builder(28, 42);
  for (Count i = 0; i < 7; ++i) {
    for (const Count kind : {1u, 2u, 3u}) {
      builder.edge(i, 7 * kind + i);
      builder.edge(7 * kind + i, 7 * kind + (i + kind) % 7);
    }
  }
  return builder.finish();
}

/// (x, y) in Z9 x Z3 is joined to (4x + 1, y - 1) and (4x - 1, y - 1).
Graph holt_graph() {
  GraphBuilder builder(27, 54);
  for (Count x = 0; x < 9; ++x) {
    for (Count y = 0; y < 3; ++y) {
      for (const Count sign : {1u, 8u})
        builder.edge(3 * x + y, 3 * ((4 * x + sign) % 9) + (y + 2) % 3);
    }
  }
  return builder.finish();
}

Graph chvatal_graph() {
  return Graph(12, {{0, 1},  {0, 4},  {0, 6},  {0, 9}, {1, 2},  {1, 5},  {1, 7},  {2, 3},
                    {2, 6},  {2, 8},  {3, 4},  {3, 7}, {3, 9},  {4, 5},  {4, 8},  {5, 10},
                    {5, 11}, {6, 10}, {6, 11}, {7, 8}, {7, 11}, {8, 10}, {9, 10}, {9, 11}});
}

Graph robertson_graph() {
  GraphBuilder builder(19, 38);
  builder.cycle(0, 19);
  const std::vector<std::vector<Vertex>> chords = {
      {0, 4, 9, 13, 17, 2, 6, 10, 15}, {1, 8, 16, 5, 12}, {7, 18, 11, 3, 14}};
  for (const std::vector<Vertex>& around : chords) {
    for (std::size_t i = 0; i < around.size(); ++i) {
      builder.edge(around[i], around[(i + 1) % around.size()]);
    }
  }
  return builder.finish();
}

/// Three fragments of 15 vertices (a 9-cycle, a 5-cycle and a centre) around one vertex.
Graph tutte_graph() {
  GraphBuilder builder(46, 69);
  for (Count i = 0; i < 3; ++i) {
    const Count f = 15 * i;
    builder.cycle(f, 9);
    builder.cycle(f + 9, 5);
    builder.edges(std::vector<Edge>{{13, 3}, {12, 1}, {11, 8}, {10, 7}, {6, 14}, {4, 14}, {9, 14}},
                  f);
    builder.edge(f + 5, 45);
    builder.edge(f + 2, 15 * ((i + 1) % 3));
  }
  return builder.finish();
}

// clang-format off
std::vector<NamedGraph> named_table() {
  std::vector<NamedGraph> graphs = {
    {"k4", "The complete graph on 4 vertices, the tetrahedron", 4, [] { return complete_graph(4); }},
    {"k5", "The complete graph on 5 vertices", 5, [] { return complete_graph(5); }},
    {"k33", "The complete bipartite graph K3,3, the (3,4)-cage", 6, [] { return complete_bipartite(3, 3); }},
    {"octahedron", "The octahedron K2,2,2", 6, [] { return octahedron_graph(); }},
    {"k44", "The complete bipartite graph K4,4, the (4,4)-cage", 8, [] { return complete_bipartite(4, 4); }},
    {"cube", "The cube Q3", 8, [] { return hypercube(3); }},
    lcf("wagner", "Wagner's graph, the Moebius ladder on 8 vertices", {4}, 8),
    {"petersen", "The Petersen graph, the (3,5)-cage (1898)", 10, [] { return generalised_petersen(5, 2); }},
    lcf("bidiakis", "The bidiakis cube", {6, 4, -4}, 4),
    lcf("franklin", "Franklin's graph, 6-colours the Klein bottle (1934)", {5, -5}, 6),
    lcf("frucht", "Frucht's cubic graph without symmetries (1939)", {-5, -2, -4, 2, 5, -2, 2, 5, -2, -5, 4, 2}, 1),
    lcf("truncated-tetrahedron", "The truncated tetrahedron", {2, 6, -2}, 4),
    {"tietze", "Tietze's graph (1910), the flower snark J_3", 12, [] { return flower_snark(3); }},
    {"duerer", "Duerer's graph GP(6, 2) (1514)", 12, [] { return generalised_petersen(6, 2); }},
    {"chvatal", "Chvatal's 4-regular triangle-free 4-chromatic graph (1970)", 12, chvatal_graph},
    lcf("heawood", "Heawood's graph, the (3,6)-cage (1890)", {5, -5}, 7),
    lcf("moebius-kantor", "The Moebius-Kantor graph GP(8, 3)", {5, -5}, 8),
    {"tesseract", "The tesseract Q4", 16, [] { return hypercube(4); }},
    lcf("pappus", "The Pappus graph", {5, 7, -7, 7, -7, -5}, 3),
    {"blanusa-1", "A Blanusa snark (1946), edges cut at distance 1", 18, [] { return blanusa_snark(1, 1); }},
    {"blanusa-2", "A Blanusa snark (1946), edges cut at distance 2", 18, [] { return blanusa_snark(1, 2); }},
    {"robertson", "Robertson's graph, the (4,5)-cage (1964)", 19, robertson_graph},
    lcf("desargues", "The Desargues graph GP(10, 3)", {5, -5, 9, -9}, 5),
    lcf("dodecahedron", "The dodecahedron GP(10, 2), the fullerene C20", {10, 7, 4, -4, -7, 10, -4, 7, -7, 4}, 2),
    {"flower-snark-5", "Isaacs' flower snark J_5 (1975)", 20, [] { return flower_snark(5); }},
    lcf("mcgee", "McGee's graph, the (3,7)-cage (1960)", {12, 7, -7}, 8),
    lcf("nauru", "The Nauru graph GP(12, 5), F24A", {5, -9, 7, -7, 9, -5}, 4),
    lcf("truncated-cube", "The truncated cube", {2, 9, -2, 2, -9, -2}, 4),
    lcf("truncated-octahedron", "The truncated octahedron", {3, -7, 7, -3}, 6),
    lcf("f26a", "The symmetric cubic graph F26A", {-7, 7}, 13),
    {"holt", "Holt's half-transitive 4-regular graph (Doyle 1976, Holt 1981)", 27, holt_graph},
    {"coxeter", "Coxeter's graph F28A, girth 7, not Hamiltonian", 28, coxeter_graph},
    {"double-star-snark", "Isaacs' double-star snark (1975)", 30, double_star_snark},
    lcf("tutte-coxeter", "The Tutte-Coxeter graph, the (3,8)-cage (1947)", {-13, -9, 7, -7, 9, 13}, 5),
    lcf("dyck", "The Dyck graph F32A (1881)", {5, -5, 13, -13}, 8),
    {"odd-4", "The odd graph O_4, 4-regular", 35, [] { return odd_graph(4); }},
    lcf("f40", "The bipartite double of the dodecahedron, F40A", {15, 9, -9, -15}, 10),
    {"goldberg-snark-5", "Goldberg's snark G_5 (1981)", 40, [] { return goldberg_snark(5); }},
    {"tutte", "Tutte's planar cubic graph that is not Hamiltonian (1946)", 46, tutte_graph},
    {"szekeres-snark", "The Szekeres snark (1973)", 50, szekeres_snark},
    {"watkins-snark", "The Watkins snark (1989)", 50, watkins_snark},
    lcf("gray", "Gray's graph, semisymmetric (Bouwer 1968)", {-25, 7, -7, 13, -13, 25}, 9),
    {"c60", "The fullerene C60, the truncated icosahedron", 60, [] { return goldberg_coxeter(1, 1); }},
    {"truncated-dodecahedron", "The truncated dodecahedron", 60, [] { return truncated(generalised_petersen(10, 2)); }},
    lcf("harries", "Harries' graph, a (3,10)-cage (1972)",
        {-29, -19, -13, 13, 21, -27, 27, 33, -13, 13, 19, -21, -33, 29}, 5),
    lcf("balaban-10-cage", "Balaban's (3,10)-cage (1972)",
        {-9, -25, -19, 29, 13, 35, -13, -29, 19, 25, 9, -29, 29, 17, 33, 21, 9, -13, -31, -9, 25, 17, 9, -31,
         27, -9, 17, -19, -29, 27, -17, -9, -29, 33, -25, 25, -21, 17, -17, 29, 35, -29, 17, -17, 21, -25, 25,
         -33, 29, 9, 17, -27, 29, 19, -17, 9, -27, 31, -9, -17, -25, 9, 31, 13, -9, -21, -33, -17, -29, 29}, 1),
    lcf("foster", "Foster's graph F90A, girth 10 (1932)", {17, -9, 37, -37, 9, -17}, 15),
    lcf("biggs-smith", "The Biggs-Smith graph F102A, girth 9 (1971)",
        {16, 24, -38, 17, 34, 48, -19, 41, -35, 47, -20, 34, -36, 21, 14, 48, -16, -36, -43, 28, -17, 21, 29,
         -43, 46, -24, 28, -38, -14, -50, -45, 21, 8, 27, -21, 20, -37, 39, -34, -44, -8, 38, -21, 25, 15, -34,
         18, -28, -41, 36, 8, -29, -21, -48, -28, -20, -47, 14, -8, -15, -27, 38, 24, -48, -18, 25, 38, 31, -25,
         24, -46, -14, 28, 11, 21, 35, -39, 43, 36, -38, 14, 50, 43, 36, -11, -36, -24, 45, 8, 19, -25, 38, 20,
         -24, -14, -21, -8, 44, -31, -38, -28, 37}, 1),
    lcf("balaban-11-cage", "Balaban's graph, the (3,11)-cage (1973)",
        {44, 26, -47, -15, 35, -39, 11, -27, 38, -37, 43, 14, 28, 51, -29, -16, 41, -11, -26, 15, 22, -51, -35,
         36, 52, -14, -33, -26, -46, 52, 26, 16, 43, 33, -15, 17, -53, 23, -42, -35, -28, 30, -22, 45, -44, 16,
         -38, -16, 50, -55, 20, 28, -17, -43, 47, 34, -26, -41, 11, -36, -23, -16, 41, 17, -51, 26, -33, 47, 17,
         -11, -20, -30, 21, 29, 36, -43, -52, 10, 39, -28, -17, -52, 51, 26, 37, -17, 10, -10, -45, -34, 17, -26,
         27, -21, 46, 53, -10, 29, -50, 35, 15, -47, -29, -41, 26, 33, 55, -17, 42, -26, -36, 16}, 1),
    lcf("ljubljana", "The Ljubljana graph, semisymmetric (Brouwer, Dejter, Thomassen 1993)",
        {47, -23, -31, 39, 25, -21, -31, -41, 25, 15, 29, -41, -19, 15, -49, 33, 39, -35, -21, 17, -33, 49, 41,
         31, -15, -29, 41, 31, -15, -25, 21, 31, -51, -25, 23, 9, -17, 51, 35, -29, 21, -51, -39, 33, -9, -51,
         51, -47, -33, 19, 51, -21, 29, 21, -31, -39}, 2),
    lcf("tutte-12-cage", "Tutte's (3,12)-cage, semisymmetric (Benson 1966)",
        {17, 27, -13, -59, -35, 35, -11, 13, -53, 53, -27, 21, 57, 11, -21, -57, 59, -17}, 7),
  };
  std::stable_sort(graphs.begin(), graphs.end(), [](const NamedGraph& a, const NamedGraph& b) {
    return a.num_vertices < b.num_vertices;
  });
  return graphs;
}
// clang-format on

}  // namespace

Graph lcf_graph(const std::vector<int>& shifts, Count repeats) {
  const Count n = shifts.size() * repeats;
  const auto end_of = [&](Count i) {
    const auto target = static_cast<std::int64_t>(i) + shifts[i % shifts.size()];
    const auto signed_n = static_cast<std::int64_t>(n);
    return static_cast<Count>(((target % signed_n) + signed_n) % signed_n);
  };
  GraphBuilder builder(n, 3 * n / 2);
  builder.cycle(0, n);
  for (Count i = 0; i < n; ++i) {
    const Count j = end_of(i);
    if (end_of(j) != i) {
      throw InputError(
          fmt::format("LCF notation: the chord {} {} is not met again from {}", i, j, j));
    }
    if (i <= j) builder.edge(i, j);
  }
  return builder.finish();
}

const std::vector<NamedGraph>& named_graphs() {
  static const std::vector<NamedGraph> graphs = named_table();
  return graphs;
}

}  // namespace ar3d
