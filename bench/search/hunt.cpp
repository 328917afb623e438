// Searches for graphs whose drawings come close to a bound, by small random steps, and shrinks a
// graph while a property holds (delta debugging).
#include "ar3d/bench/search/hunt.h"

#include <chrono>
#include <numeric>

#include "ar3d/base/error.h"
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

class Hunter {
 public:
  Hunter(const Subject& subject, const HuntOptions& options,
         const std::function<void(const HuntResult&)>& progress)
      : subject_(subject), options_(options), progress_(progress) {}

  HuntResult run() {
    while (!is_over()) climb_from_new_start();
    return std::move(result_);
  }

 private:
  bool is_over() const {
    if (result_.evaluations == 0) return false;
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
    return !result_.best.failure.empty() || result_.evaluations >= options_.evaluations ||
           (options_.seconds > 0 && elapsed.count() >= options_.seconds);
  }

  void climb_from_new_start() {
    const std::uint64_t number = result_.starts++;
    start_ = options_.families[number % options_.families.size()];
    start_seed_ = mix_seed(options_.seed, number);
    RandomStream random(start_seed_, kStepStream);
    const std::uint64_t round = number / options_.families.size();
    const Corpus* const corpus = start_.corpus ? start_.corpus->graphs.get() : nullptr;
    Graph graph = corpus != nullptr
                      ? drawable_graph(*corpus, round)
                      : generate(*start_.family, options_.n, start_seed_, start_.parameters);
    if (round >= (corpus != nullptr ? corpus->size() : 1)) graph = shuffled_labels(graph, random);
    Trial current = evaluate(std::move(graph));
    for (std::uint64_t stale = 0; stale < options_.patience && !is_over(); ++stale) {
      Trial next = evaluate(neighbour(current.graph, random));
      if (next.ratio < current.ratio) continue;
      if (next.ratio > current.ratio) stale = 0;
      current = std::move(next);
    }
  }

  // That of the round, or the next one whose degrees the algorithm can draw.
  Graph drawable_graph(const Corpus& corpus, std::uint64_t round) {
    const std::uint32_t limit = subject_.choice.algorithm->guarantee.max_degree;
    for (std::size_t i = 0; i < corpus.size(); ++i) {
      start_place_ = corpus.place((round + i) % corpus.size());
      Graph graph = corpus.graph(start_place_);
      if (graph.max_degree() <= limit) return graph;
    }
    throw InputError(fmt::format("{}: no graph has maximum degree {} or less, as {} needs",
                                 start_.family->name, limit, subject_.choice.algorithm->name));
  }

  Trial evaluate(Graph graph) {
    Trial trial = try_graph(subject_, std::move(graph));
    ++result_.evaluations;
    const bool is_first = result_.evaluations == 1;
    if (is_first || !trial.failure.empty() || trial.ratio > result_.best.ratio) {
      result_.best = trial;
      result_.start = start_;
      result_.start_seed = start_seed_;
      result_.start_place = start_place_;
      if (progress_) progress_(result_);
    }
    return trial;
  }

  const Subject& subject_;
  const HuntOptions& options_;
  const std::function<void(const HuntResult&)>& progress_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  FamilyChoice start_;
  std::uint64_t start_seed_ = 0;
  std::uint32_t start_place_ = 0;
  HuntResult result_;
};

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

/// One kind of part that can be removed.
struct RemovablePart {
  std::size_t (*count)(const Graph&);
  Graph (*without)(const Graph&, std::size_t first, std::size_t last);
};

const std::vector<RemovablePart>& kinds_of_parts() {
  static const std::vector<RemovablePart> kinds = {
      {[](const Graph& g) { return std::size_t{connected_components_of(g).count}; },
       without_components},
      {[](const Graph& g) { return std::size_t{g.num_vertices()}; }, without_vertices},
      {[](const Graph& g) { return std::size_t{g.num_edges()}; }, without_edges}};
  return kinds;
}

/// One pass over all chunks of that size, from the end, so that the places of the others stay.
bool remove_once(const RemovablePart& parts, std::size_t chunk,
                 const std::function<bool(const Graph&)>& keeps, std::uint64_t max_evaluations,
                 ShrinkResult& result) {
  bool removed = false;
  std::size_t last = parts.count(result.graph);
  while (last > 0 && result.evaluations < max_evaluations) {
    const std::size_t first = last > chunk ? last - chunk : 0;
    Graph candidate = parts.without(result.graph, first, last);
    ++result.evaluations;
    if (keeps(candidate)) {
      result.graph = std::move(candidate);
      removed = true;
    }
    last = std::min(first, parts.count(result.graph));
  }
  return removed;
}

/// Chunks of half of the parts, then a quarter, … then single ones until none can go.
bool remove_chunks(const RemovablePart& parts, const std::function<bool(const Graph&)>& keeps,
                   std::uint64_t max_evaluations, ShrinkResult& result) {
  bool has_shrunk = false;
  std::size_t chunk = std::max<std::size_t>(1, parts.count(result.graph) / 2);
  while (true) {
    const bool removed = remove_once(parts, chunk, keeps, max_evaluations, result);
    has_shrunk |= removed;
    if (chunk == 1 && !removed) return has_shrunk;
    if (result.evaluations >= max_evaluations) return true;
    if (!removed || chunk > parts.count(result.graph)) chunk = std::max<std::size_t>(1, chunk / 2);
  }
}

}  // namespace

HuntResult hunt(const Subject& subject, const HuntOptions& options,
                const std::function<void(const HuntResult&)>& progress) {
  expect(!options.families.empty(), "a hunt has a family to start from");
  return Hunter(subject, options, progress).run();
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

ShrinkResult shrink(const Graph& graph, const std::function<bool(const Graph&)>& keeps,
                    std::uint64_t max_evaluations) {
  ShrinkResult result;
  result.graph = graph;
  bool has_shrunk = true;
  while (has_shrunk && result.evaluations < max_evaluations) {
    has_shrunk = false;
    for (const RemovablePart& parts : kinds_of_parts()) {
      has_shrunk |= remove_chunks(parts, keeps, max_evaluations, result);
    }
  }
  result.minimal = !has_shrunk;
  return result;
}

}  // namespace ar3d
