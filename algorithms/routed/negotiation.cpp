// Steps R.3 to R.5, negotiated congestion (PathFinder; McMurchie and Ebeling 1995): edges share
// points at first, for a price that grows, until the price has parted them; the vertices of edges in
// conflict, and those on routes, are moved meanwhile. Edges are searched in groups, side by side
// against the prices of that moment; their routes are then taken in turn, each only if it is still
// not dearer than the old one. So threads change the time, not the drawing. Cost: the searches.
#include "ar3d/algorithms/routed/negotiation.h"

#include <algorithm>
#include <set>

#include "ar3d/base/parallel.h"

namespace ar3d::routed {
namespace {

constexpr std::size_t kEdgesAtOnce = 32, kVerticesAtOnce = 8;  // in a group
constexpr EdgeId kEdgesWorthThreads = 400;
constexpr int kMostRounds = 250;
constexpr int kRoundsOfAll = 3;  // after them only edges in conflict are routed anew
constexpr int kPriceCap = 30 * 16;
constexpr int kMostIncrease = 64;  // of the history in a round, in quarters

}  // namespace

Negotiation::Negotiation(const Graph& graph, const PointClass& points, int bends, Routing given,
                         std::uint64_t seed)
    : graph_(graph),
      points_(points),
      now_(std::move(given)),
      box_(points_, now_.layout.limits),
      seed_(seed),
      random_(seed),
      conflicts_(graph.num_edges()) {
  const bool has_one = points.is_body() && std::ranges::max(now_.layout.frame) == 0;
  for (std::size_t f = 0; f < (has_one ? 1 : points.frames().size()); ++f) frames_.push_back(f);
  for (const Spot at : now_.layout.at) box_.put_vertex(box_.index(at));
  if (now_.routes.empty()) now_.routes.resize(graph.num_edges());
  for (EdgeId e = 0; e < graph_.num_edges(); ++e) put(e);
  const std::uint32_t threads = graph.num_edges() < kEdgesWorthThreads ? 1 : available_threads();
  for (std::uint32_t t = 0; t < threads; ++t) searchers_.emplace_back(points, bends, threads);
}

std::vector<EdgeId> Negotiation::conflicts() {
  std::vector<EdgeId> found;
  for (EdgeId e = 0; e < graph_.num_edges(); ++e) {
    if (is_in_conflict(e)) found.push_back(e);
  }
  conflicts_ = found.size();
  return found;
}

void Negotiation::search_side_by_side(
    std::size_t count, const std::function<void(RouteSearch&, std::size_t)>& search) {
  const std::size_t threads = count < kVerticesAtOnce / 2 ? 1 : searchers_.size();
  for_each_in_threads(static_cast<std::uint32_t>(threads), count,
                      [&](std::uint32_t thread, std::size_t i) { search(searchers_[thread], i); });
}

void Negotiation::route_group(std::span<const EdgeId> edges) {
  std::array<Route, kEdgesAtOnce> found;
  const std::uint64_t group = ++groups_;
  for (const EdgeId e : edges) take(e);
  search_side_by_side(edges.size(), [&](RouteSearch& search, std::size_t i) {
    const Edge ends = graph_.edge(edges[i]);
    RandomStream random(mix_seed(seed_, group), i);
    search.find(box_, end(ends.u), end(ends.v), cost_of(edges[i]) + tolerance(), conflicts_ <= 20,
                random, found[i]);
  });
  searches_ += edges.size();
  for (const EdgeId e : edges) put(e);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (!found[i]) continue;
    const EdgeId e = edges[i];
    take(e);
    if (box_.cost_of(start(e), found[i]) < cost_of(e) + tolerance()) now_.routes[e] = found[i];
    put(e);
  }
}

void Negotiation::route_all(std::vector<EdgeId>& edges) {
  random_.shuffle(std::span(edges));
  const std::size_t size = std::clamp<std::size_t>(edges.size() / 8, 1, kEdgesAtOnce);
  for (std::size_t i = 0; i < edges.size(); i += size) {
    route_group(std::span(edges).subspan(i, std::min(size, edges.size() - i)));
  }
}

void Negotiation::place(Vertex v, Spot at, std::size_t frame) {
  box_.take_vertex(box_.index(now_.layout.at[v]));
  now_.layout.at[v] = at;
  now_.layout.frame[v] = static_cast<std::uint8_t>(frame);
  box_.put_vertex(box_.index(at));
}

/// What a vertex and its edges cost, each beside all others.
int Negotiation::price_edges(Vertex v) {
  std::int64_t total = 0;
  for (const HalfEdge& half : graph_.incident(v)) {
    take(half.edge);
    total += cost_of(half.edge);
    put(half.edge);
  }
  total += box_.cost_of_vertex(box_.index(now_.layout.at[v]));
  return static_cast<int>(std::min<std::int64_t>(total, CostBox::kNoRoute));
}

/// Routes the edges of the trial's vertex to the best place near it, in different arms.
void Negotiation::search_trial(Trial& trial, RouteSearch& search) {
  RandomStream random(mix_seed(seed_, groups_), 1000 + trial.vertex);
  const auto edges = graph_.incident(trial.vertex);
  std::vector<End> neighbours;
  for (const HalfEdge& half : edges) neighbours.push_back(end(half.to));
  trial.searches += edges.size();
  if (search.find_place(box_, now_.layout.at[trial.vertex], neighbours, frames_,
                        points_.is_body() ? 6 : 4, trial.limit, random, trial) >= trial.limit)
    return;
  const auto routes = std::span(trial.routes).first(edges.size());
  trial.is_found = std::ranges::all_of(routes, [](const Route& route) { return bool{route}; });
  for (std::size_t k = 0; k < edges.size(); ++k) {
    if (graph_.edge(edges[k].edge).u == trial.vertex) routes[k] = routes[k].reversed();
  }
}

/// Moves the vertex if the routes found are not dearer than the present ones by now.
bool Negotiation::settle(const Trial& trial) {
  const Vertex v = trial.vertex;
  const auto edges = graph_.incident(v);
  const Spot old_at = now_.layout.at[v];
  const std::size_t old_frame = now_.layout.frame[v];
  if (!(trial.at == old_at) && box_.has_vertex(box_.index(trial.at))) return false;
  const int before = price_edges(v);
  std::array<Route, 4> old;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    take(edges[k].edge);
    old[k] = now_.routes[edges[k].edge];
  }
  place(v, trial.at, trial.frame);
  std::int64_t after = box_.cost_of_vertex(box_.index(trial.at));
  std::size_t added = 0;
  while (added < edges.size() && after < before + tolerance()) {
    const EdgeId e = edges[added].edge;
    now_.routes[e] = trial.routes[added];
    after += cost_of(e);
    if (after >= before + tolerance()) break;
    put(e);
    ++added;
  }
  if (added == edges.size()) return true;
  for (std::size_t k = 0; k < added; ++k) take(edges[k].edge);
  place(v, old_at, old_frame);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    now_.routes[edges[k].edge] = old[k];
    put(edges[k].edge);
  }
  return false;
}

void Negotiation::move_group(std::span<Trial> trials) {
  ++groups_;
  std::set<EdgeId> edges;
  for (Trial& trial : trials) {
    trial.limit = price_edges(trial.vertex) + tolerance();
    for (const HalfEdge& half : graph_.incident(trial.vertex)) edges.insert(half.edge);
  }
  for (const EdgeId e : edges) take(e);
  search_side_by_side(trials.size(),
                      [&](RouteSearch& search, std::size_t i) { search_trial(trials[i], search); });
  for (const EdgeId e : edges) put(e);
  std::set<Vertex> moved;
  for (const Trial& trial : trials) {
    searches_ += trial.searches;
    const auto around = graph_.incident(trial.vertex);
    const bool is_stale = std::any_of(around.begin(), around.end(),
                                      [&](HalfEdge half) { return moved.contains(half.to); });
    if (!is_stale && trial.is_found && settle(trial)) moved.insert(trial.vertex);
  }
}

void Negotiation::move_vertices(const std::vector<EdgeId>& edges) {
  std::set<Vertex> found;
  for (const EdgeId e : edges) found.insert({graph_.edge(e).u, graph_.edge(e).v});
  for (Vertex v = 0; v < graph_.num_vertices(); ++v) {
    if (box_.uses(box_.index(now_.layout.at[v])) > 0) found.insert(v);
  }
  std::vector<Vertex> vertices(found.begin(), found.end());
  random_.shuffle(std::span(vertices));
  const std::size_t size = std::clamp<std::size_t>(vertices.size() / 8, 1, kVerticesAtOnce);
  std::vector<Trial> trials;
  for (std::size_t i = 0; i < vertices.size(); i += size) {
    trials.clear();
    for (std::size_t k = i; k < std::min(vertices.size(), i + size); ++k) {
      trials.emplace_back().vertex = vertices[k];
    }
    move_group(trials);
  }
}

void Negotiation::raise_prices(int round) {
  box_.remember_shared(increase_ / 4);
  if (round > 6) increase_ = std::min(kMostIncrease, increase_ + std::max(1, increase_ * 3 / 20));
  const int before = price_ / 16;
  price_ = std::min(kPriceCap, price_ + price_ / 4);
  if (price_ / 16 == before) return;
  box_.set_price(price_ / 16);
  for (EdgeId e = 0; e < graph_.num_edges(); ++e) box_.refresh(start(e), now_.routes[e]);
  for (const Spot at : now_.layout.at) box_.refresh(box_.index(at));
}

std::size_t Negotiation::run(int patience, std::uint64_t most_searches) {
  std::size_t fewest = graph_.num_edges() + 1;
  int without_gain = 0;
  std::vector<EdgeId> edges = conflicts();
  const int rounds_of_all = edges.size() == graph_.num_edges() ? kRoundsOfAll : 0;
  for (int round = 0; round < kMostRounds && conflicts_ > 0; ++round) {
    if (searches_ >= most_searches) break;
    route_all(edges);
    edges = conflicts();
    if (round >= 2) {
      move_vertices(edges);
      edges = conflicts();
    }
    raise_prices(round);
    if (edges.size() * 100 < fewest * 97) {
      fewest = edges.size();
      without_gain = 0;
    } else if (round > 12 && ++without_gain > patience) {
      break;
    }
    if (round < rounds_of_all) {
      edges.resize(graph_.num_edges());
      for (EdgeId e = 0; e < graph_.num_edges(); ++e) edges[e] = e;
    }
  }
  return conflicts_;
}

}  // namespace ar3d::routed
