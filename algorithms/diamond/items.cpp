// Step 1.2. The components of one colour laid end to end in one array, so that later stages read
// memory forwards. Paths come first, then cycles, each by its smallest start: the order depends on
// nothing but the colouring. O(n).
#include "ar3d/algorithms/diamond/items.h"

#include "ar3d/base/parallel.h"

namespace ar3d::diamond {

void Items::close_at(std::uint32_t item, std::uint32_t p) {
  const auto rotate = [&](auto& list) {
    const auto start = list.begin() + begin[item];
    std::rotate(start, start + (p + 1) % size(item), list.begin() + begin[item + 1]);
  };
  rotate(vertex);
  rotate(edge);
}

Items extract_items(const std::vector<HalfEdge>& next) {
  const std::size_t n = next.size();
  Items items;
  items.vertex.reserve(n);
  items.edge.reserve(n);
  std::vector<std::uint8_t> reached(n, 0);  // has a predecessor; later: is placed
  for (const HalfEdge& half : next) {
    if (half.to != kNone) reached[half.to] = 1;
  }
  const auto follow = [&](Vertex start) {
    Vertex v = start;
    do {
      reached[v] = 2;
      items.vertex.push_back(v);
      items.edge.push_back(next[v].edge);
      v = next[v].to;
    } while (v != kNone && v != start);
    items.begin.push_back(static_cast<std::uint32_t>(items.vertex.size()));
  };
  for (Vertex v = 0; v < n; ++v) {
    if (reached[v] == 0) follow(v);
  }
  for (Vertex v = 0; v < n; ++v) {
    if (reached[v] == 1) follow(v);
  }
  return items;
}

std::uint32_t count_cycles(const Items& items) {
  std::uint32_t cycles = 0;
  for (std::uint32_t item = 0; item < items.count(); ++item) cycles += items.is_cycle(item);
  return cycles;
}

Whereabouts whereabouts(const Items& items) {
  const std::size_t n = items.vertex.size();
  Whereabouts result(n);
  const auto threads = threads_for(n);
  for_ranges_in_threads(threads, n, [&](std::uint32_t, std::size_t begin, std::size_t end) {
    for_each_position(items, begin, end, [&](std::uint32_t p, std::uint32_t item) {
      if (p + kAhead < n) __builtin_prefetch(&result[items.vertex[p + kAhead]], 1);
      result[items.vertex[p]] = {p, item};
    });
  });
  return result;
}

Items arranged(Items items, const Arrangement& arrangement) {
  std::uint32_t number = 0;
  const auto stands = [&](ItemInOrder next) { return next.item == number++ && !next.reversed; };
  if (std::all_of(arrangement.begin(), arrangement.end(), stands)) return items;
  Items result;
  result.vertex.reserve(items.vertex.size());
  result.edge.reserve(items.edge.size());
  for (const auto [item, reversed] : arrangement) {
    const auto start = static_cast<std::ptrdiff_t>(result.vertex.size());
    const auto from = items.begin[item];
    const auto to = items.begin[item + 1];
    result.vertex.insert(result.vertex.end(), items.vertex.begin() + from,
                         items.vertex.begin() + to);
    result.edge.insert(result.edge.end(), items.edge.begin() + from, items.edge.begin() + to);
    if (reversed) {
      std::reverse(result.vertex.begin() + start, result.vertex.end());
      std::reverse(result.edge.begin() + start, result.edge.end() - 1);
    }
    result.begin.push_back(static_cast<std::uint32_t>(result.vertex.size()));
  }
  return result;
}

}  // namespace ar3d::diamond
