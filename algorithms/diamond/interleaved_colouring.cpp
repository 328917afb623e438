// Step 1.1 for large graphs. A chain of edges is a chain of dependent cache misses, so the chains
// are cut at every so many-th vertex, and the stretches between cuts are walked in turns, without
// writing anything but the way; linked in order, they say in which direction and from where the
// plain walk takes each chain. Then the directions, or colours, are written along the ways, whose
// places are known beforehand, so the memory fetches many at a time. Cost: O(n + m), and 40 bytes
// per vertex.
#include "ar3d/algorithms/diamond/in_threads.h"
#include "ar3d/algorithms/diamond/interleaved.h"
#include "ar3d/algorithms/diamond/trails.h"
#include "ar3d/model/error.h"
#include "ar3d/model/long_vector.h"

namespace ar3d::diamond {
namespace {

/// How many arrivals ahead a record is asked for when the way is known.
constexpr std::uint32_t kAhead = 16;

struct Neighbourhoods {
  Records records;
  bool all_linked = true;  ///< all degrees are 4 or 0
};

Neighbourhoods neighbourhoods_of(const Graph& graph, std::uint32_t threads) {
  expect(graph.max_degree() <= 4, "four entries are for maximum degree 4");
  Neighbourhoods result{Records(graph.num_vertices()), true};
  std::atomic<bool> all_linked{true};
  for_ranges_in_threads(threads, graph.num_vertices(), [&](std::size_t begin, std::size_t end) {
    bool linked = true;
    for (auto v = static_cast<Vertex>(begin); v < end; ++v) {
      Record record{kNoNeighbour, kNoNeighbour, kNoNeighbour, kNoNeighbour};
      const auto row = graph.incident(v);
      for (std::size_t i = 0; i < row.size(); ++i) record[i] = row[i].to;
      result.records[v] = record;
      linked = linked && row.size() % 4 == 0;
    }
    if (!linked) all_linked = false;
  });
  result.all_linked = all_linked;
  return result;
}

/// Visits the records that a stretch passes, forwards: visit(record, arrival's entry, number of the
/// arriving edge in the stretch from 0 on, whether the stretch goes on from there).
template <class Visit>
void for_each_arrival(Records& records, const Port* arrivals, std::uint32_t size, Visit visit) {
  for (std::uint32_t i = 0; i < size; ++i) {
    if (i + kAhead < size) __builtin_prefetch(&records[vertex_of(arrivals[i + kAhead])], 1);
    visit(records[vertex_of(arrivals[i])], entry_of(arrivals[i]), i, i + 1 < size);
  }
}

/// LinkSameDirection of a record that other threads mark; the entry is known to have a linked one.
std::uint32_t same_direction(Record& record, std::uint32_t entry) {
  const auto direction = [&](std::uint32_t e) {
    return std::atomic_ref<std::uint32_t>(record[e]).load(std::memory_order_relaxed) & (kOut | kIn);
  };
  const std::uint32_t own = direction(entry);
  std::uint32_t other = 0;
  while (other == entry || direction(other) != own) ++other;
  return other;
}

std::uint32_t& at(Records& records, Port p) { return records[vertex_of(p)][entry_of(p)]; }

/// Calls walk(v, entry) for every port of an edge that lacks all of the marks, in order; it marks.
template <class Walk>
void for_each_unmarked(Records& records, std::uint32_t marks, Walk walk) {
  for (Vertex v = 0; v < records.size(); ++v) {
    for (std::uint32_t entry = 0; entry < 4; ++entry) {
      if (neighbour(records[v], entry) != kNoNeighbour && (records[v][entry] & marks) == 0) {
        walk(v, entry);
      }
    }
  }
}

std::uint32_t entry_to(const Record& record, Vertex v) {
  std::uint32_t entry = 0;
  while (neighbour(record, entry) != v) ++entry;
  return entry;
}

/// A piece of a trail as it is written: backwards or not, and the number of its first edge in the
/// trail, or of its last one if it is backwards.
struct WrittenPiece {
  const Stretch* stretch;
  bool backwards;
  std::uint64_t first;
};

/// The pieces of all trails. Each has its own edges, so they can be written in any order.
template <class Link>
std::vector<WrittenPiece> pieces_of(Trails<Link>& trails) {
  std::vector<WrittenPiece> pieces;
  trails.for_each([&](const Trail& trail) {
    std::uint64_t edges = trail.first;  // before the piece at hand; only whether it is odd matters
    for (const auto& [stretch, backwards] : trail.pieces) {
      pieces.push_back({stretch, backwards, edges + (backwards ? stretch->size - 1 : 0)});
      edges += stretch->size;
    }
  });
  return pieces;
}

constexpr std::size_t kPiecesAtATime = 16;

/// balanced_orientation() as marks kOut and kIn.
void orient(Records& records, bool all_linked, const WalkSizes& sizes) {
  Trails<LinkPairs> trails(records, all_linked, sizes);
  const std::vector<WrittenPiece> pieces = pieces_of(trails);
  for_each_in_threads(sizes.threads, pieces.size(), kPiecesAtATime, [&](std::size_t p) {
    const auto& [stretch, backwards, first] = pieces[p];
    const std::uint32_t leaving = backwards ? kIn : kOut;
    const std::uint32_t arriving = kOut + kIn - leaving;
    at(records, stretch->start) |= leaving;
    for_each_arrival(records, trails.arrivals(*stretch), stretch->size,
                     [&](Record& record, std::uint32_t entry, std::uint32_t, bool goes_on) {
                       record[entry] |= arriving;
                       if (goes_on) record[entry ^ 1u] |= leaving;
                     });
  });
  for_each_unmarked(records, kOut | kIn, [&](Vertex v, std::uint32_t entry) {
    do {  // a closed chain without a cut
      const Vertex from = v;
      records[from][entry] |= kOut;
      v = neighbour(records[from], entry);
      const std::uint32_t arrival = entry_to(records[v], from);
      records[v][arrival] |= kIn;
      entry = arrival ^ 1u;
    } while ((records[v][entry] & kOut) == 0);
  });
}

/// The colours of two_colouring() as marks kIsRed, and kColoured everywhere.
void colour(Records& records, bool all_linked, const WalkSizes& sizes) {
  constexpr std::array<std::uint32_t, 2> marks{kColoured, kColoured | kIsRed};
  Trails<LinkSameDirection> trails(records, all_linked, sizes);
  const std::vector<WrittenPiece> pieces = pieces_of(trails);
  // A record belongs to two chains, and a thread reads the directions of all its entries.
  const auto mark = [](std::uint32_t& entry, std::uint32_t marks) {
    std::atomic_ref<std::uint32_t> shared(entry);
    shared.store(shared.load(std::memory_order_relaxed) | marks, std::memory_order_relaxed);
  };
  for_each_in_threads(sizes.threads, pieces.size(), kPiecesAtATime, [&](std::size_t p) {
    const auto& [stretch, backwards, first_edge] = pieces[p];
    const std::uint64_t first = first_edge;
    mark(at(records, stretch->start), marks[first % 2]);
    for_each_arrival(records, trails.arrivals(*stretch), stretch->size,
                     [&](Record& record, std::uint32_t entry, std::uint32_t i, bool goes_on) {
                       mark(record[entry], marks[(first + i) % 2]);
                       if (!goes_on) return;
                       mark(record[same_direction(record, entry)], marks[(first + i + 1) % 2]);
                     });
  });
  constexpr LinkSameDirection link;
  for_each_unmarked(records, kColoured, [&](Vertex v, std::uint32_t entry) {
    for (unsigned i = 0; (records[v][entry] & kColoured) == 0; ++i) {
      const Vertex from = v;
      records[from][entry] |= marks[i % 2];
      v = neighbour(records[from], entry);
      const std::uint32_t arrival = entry_to(records[v], from);
      records[v][arrival] |= marks[i % 2];
      entry = link(records[v], arrival);
    }
  });
}

bool has_long_chains(const Graph& graph) {
  return 5 * std::uint64_t{graph.num_edges()} >= 8 * std::uint64_t{graph.num_vertices()};
}

}  // namespace

TwoColouring colouring_of(const Graph& graph) {
  if (graph.num_vertices() >= kManyVertices && has_long_chains(graph)) {
    const auto threads = static_cast<std::uint32_t>(threads_for(graph.num_vertices()));
    return interleaved_colouring(graph, {.threads = threads});
  }
  const PaddedNeighbours neighbours = padded_neighbours(graph);
  return two_colouring(graph, neighbours, balanced_orientation(neighbours));
}

TwoColouring interleaved_colouring(const Graph& graph, const WalkSizes& sizes) {
  auto [records, all_linked] = neighbourhoods_of(graph, sizes.threads);
  orient(records, all_linked, sizes);
  colour(records, all_linked, sizes);
  TwoColouring result;
  for (auto& next : result.next) {
    reserve_long(next, records.size());
    next.assign(records.size(), {kNone, kNone});
  }
  for_ranges_in_threads(sizes.threads, records.size(),
                        [&, &marked = records](std::size_t begin, std::size_t end) {
                          for (auto v = static_cast<Vertex>(begin); v < end; ++v) {
                            const auto row = graph.incident(v);
                            for (std::uint32_t entry = 0; entry < row.size(); ++entry) {
                              const std::uint32_t mark = marked[v][entry];
                              if (mark & kOut)
                                result.next[mark & kIsRed ? kRed : kGreen][v] = row[entry];
                            }
                          }
                        });
  return result;
}

}  // namespace ar3d::diamond
