// Searches for graphs whose drawings come close to a bound, by small random steps, and shrinks a
// graph while a property holds (delta debugging).
#include "ar3d/bench/search/hunt.h"

#include <fmt/format.h>

#include <numeric>

#include "ar3d/base/error.h"
#include "ar3d/bench/corpus/corpus.h"
#include "ar3d/generators/random_graphs.h"

namespace ar3d {
namespace {

constexpr std::uint64_t kStepStream = 1;
constexpr int kSwitchTries = 20;

/// A few labels exchanged.
Graph exchanged_labels(const Graph& graph, RandomStream& random) {
  std::vector<Vertex> names(graph.num_vertices());
  std::iota(names.begin(), names.end(), Vertex{0});
  if (names.empty()) return graph;
  for (std::uint32_t pairs = 1 + random.below(3); pairs > 0; --pairs) {
    std::swap(names[random.below(graph.num_vertices())], names[random.below(graph.num_vertices())]);
  }
  return relabelled(graph, names);
}

Graph neighbour(const Graph& graph, RandomStream& random) {
  return random.chance(1, 2) ? with_switched_edges(graph, random) : exchanged_labels(graph, random);
}

// That of the round, or the next one whose degrees the algorithm can draw. @param index  becomes
// where it stands in its file.
Graph drawable_graph(const FamilyChoice& start, const Algorithm& algorithm, std::uint64_t round,
                     std::uint32_t& index) {
  const Corpus& corpus = *start.corpus;
  const std::uint32_t limit = algorithm.guarantee.max_degree;
  for (std::size_t i = 0; i < corpus.size(); ++i) {
    index = corpus.index((round + i) % corpus.size());
    Graph graph = corpus.graph(index);
    if (graph.max_degree() <= limit) return graph;
  }
  throw InputError(fmt::format("{}: no graph has maximum degree {} or less, as {} needs",
                               start.family->name, limit, algorithm.name));
}

Graph without_components(const Graph& graph, std::size_t first, std::size_t last) {
  const Components components = connected_components_of(graph);
  std::vector<bool> keep(graph.num_vertices());
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    keep[v] = components.of[v] < first || components.of[v] >= last;
  }
  return induced(graph, keep);
}

Graph without_vertices(const Graph& graph, std::size_t first, std::size_t last) {
  std::vector<bool> keep(graph.num_vertices(), true);
  for (std::size_t v = first; v < last; ++v) keep[v] = false;
  return induced(graph, keep);
}

Graph without_edges(const Graph& graph, std::size_t first, std::size_t last) {
  std::vector<Edge> edges(graph.edges().begin(), graph.edges().end());
  edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(first),
              edges.begin() + static_cast<std::ptrdiff_t>(last));
  return Graph(graph.num_vertices(), std::move(edges));
}

using CountParts = std::size_t (*)(const Graph&);
using WithoutParts = Graph (*)(const Graph&, std::size_t first, std::size_t last);

/// Removes chunks of half of the parts of one kind, then a quarter, … then single ones until none
/// can go. A pass over all chunks of a size begins with the last, so that the places of the others
/// stay.
bool remove_chunks(CountParts count, WithoutParts without,
                   const std::function<bool(const Graph&)>& keeps, std::uint64_t& evaluations,
                   Graph& graph) {
  bool has_shrunk = false;
  std::size_t chunk = std::max<std::size_t>(1, count(graph) / 2);
  while (true) {
    bool removed = false;
    std::size_t last = count(graph);
    for (; last > 0 && evaluations > 0; --evaluations) {
      const std::size_t first = last > chunk ? last - chunk : 0;
      Graph candidate = without(graph, first, last);
      if (keeps(candidate)) {
        graph = std::move(candidate);
        removed = true;
      }
      last = std::min(first, count(graph));
    }
    has_shrunk |= removed;
    if (chunk == 1 && !removed) return has_shrunk;
    if (evaluations == 0) return true;
    if (!removed || chunk > count(graph)) chunk = std::max<std::size_t>(1, chunk / 2);
  }
}

}  // namespace

HuntResult hunt(const Subject& subject, const HuntOptions& options,
                const std::function<void(const HuntResult&)>& progress) {
  expect(!options.families.empty(), "a hunt has a family to start from");
  const auto begin = std::chrono::steady_clock::now();
  HuntResult result;
  FamilyChoice start;
  std::uint64_t start_seed = 0;
  std::uint32_t start_index = 0;
  const auto is_over = [&] {
    if (result.evaluations == 0) return false;
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    return !result.best.failure.empty() || result.evaluations >= options.evaluations ||
           (options.seconds > 0 && elapsed.count() >= options.seconds);
  };
  const auto evaluate = [&](Graph graph) {
    Trial trial = try_graph(subject, std::move(graph));
    const bool is_first = ++result.evaluations == 1;
    if (is_first || !trial.failure.empty() || trial.ratio > result.best.ratio) {
      result.best = trial;
      result.start = start;
      result.start_seed = start_seed;
      result.start_index = start_index;
      if (progress) progress(result);
    }
    return trial;
  };
  while (!is_over()) {  // climbs from a new start
    const std::uint64_t number = result.starts++;
    const std::uint64_t round = number / options.families.size();
    start = options.families[number % options.families.size()];
    start_seed = mix_seed(options.seed, number);
    RandomStream random(start_seed, kStepStream);
    Graph graph = start.corpus
                      ? drawable_graph(start, *subject.choice.algorithm, round, start_index)
                      : generate(*start.family, options.n, start_seed, start.parameters);
    if (round >= (start.corpus ? start.corpus->size() : 1)) graph = shuffled_labels(graph, random);
    Trial current = evaluate(std::move(graph));
    for (std::uint64_t stale = 0; stale < options.patience && !is_over(); ++stale) {
      Trial next = evaluate(neighbour(current.graph, random));
      if (next.ratio < current.ratio) continue;
      if (next.ratio > current.ratio) stale = 0;
      current = std::move(next);
    }
  }
  return result;
}

std::vector<FamilyChoice> fitting_families(const Algorithm& algorithm, std::uint64_t n) {
  std::vector<FamilyChoice> fitting;
  for (const Family& family : families()) {
    const Settings parameters = complete_parameters(family, {});
    const Graph graph = generate(family, n, 0, parameters);
    if (graph.max_degree() <= algorithm.guarantee.max_degree && graph.num_edges() > 0) {
      fitting.push_back({&family, parameters});
    }
  }
  return fitting;
}

Graph with_switched_edges(const Graph& graph, RandomStream& random) {
  if (graph.num_edges() < 2) return graph;
  for (int tries = 0; tries < kSwitchTries; ++tries) {
    const EdgeId first = random.below(graph.num_edges());
    const EdgeId second = random.below(graph.num_edges());
    Edge ab = graph.edge(first), cd = graph.edge(second);
    if (random.chance(1, 2)) std::swap(cd.u, cd.v);
    const bool is_simple = ab.u != cd.u && ab.u != cd.v && ab.v != cd.u && ab.v != cd.v &&
                           !has_edge(graph, ab.u, cd.u) && !has_edge(graph, ab.v, cd.v);
    if (!is_simple) continue;
    std::vector<Edge> edges(graph.edges().begin(), graph.edges().end());
    edges[first] = {ab.u, cd.u};
    edges[second] = {ab.v, cd.v};
    return Graph(graph.num_vertices(), std::move(edges));
  }
  return graph;
}

bool shrink(Graph& graph, const std::function<bool(const Graph&)>& keeps,
            std::uint64_t& evaluations) {
  bool has_shrunk = true;
  while (has_shrunk && evaluations > 0) {
    has_shrunk =
        remove_chunks([](const Graph& g) { return std::size_t{connected_components_of(g).count}; },
                      without_components, keeps, evaluations, graph);
    has_shrunk |= remove_chunks([](const Graph& g) { return std::size_t{g.num_vertices()}; },
                                without_vertices, keeps, evaluations, graph);
    has_shrunk |= remove_chunks([](const Graph& g) { return std::size_t{g.num_edges()}; },
                                without_edges, keeps, evaluations, graph);
  }
  return !has_shrunk;
}

}  // namespace ar3d
