// Searches a small drawing on the cube grid with two bends per edge and all angles at least
// arccos(-1/3):
//
//   g++ -O2 -std=c++20 -ffp-contract=off small_drawings.cpp -o small_drawings
//   ./small_drawings GRAPH6 SIDE NORM SEED STEPS THRESHOLD
//   ./small_drawings FUzro 60 9 12 2000000 0.15 | ar3d verify - --algorithm two-bend-109
//
// The stubs of a vertex are multiples of the vectors of a regular tetrahedron: that of the cube's
// diagonals, turned by an integer quaternion of norm at most NORM. A state gives each vertex a
// point in a box, a tetrahedron and an order of its edges, and each stub a length. Its cost is how
// much bends are too sharp and bends leave the box. STEPS random changes are tried, and those taken
// that raise the cost by less than a threshold that falls from THRESHOLD to 0. The first state of
// cost 0 in which nothing meets is a drawing; from there smaller and smaller boxes are tried in the
// same way with a quarter of the steps. Same arguments, same result; exit code 1 if nothing was
// found. The drawing is written as a line of JSON on the points of two-bend-109, which are those of
// the cube grid seen along (1, 1, 1), and its box on the cube grid goes to standard error.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cube_geometry.h"

namespace {

using namespace cube;

using Edge = std::array<std::size_t, 2>;

/// Nothing if it is no graph6 of 2 to 62 vertices of degree at most 4.
std::optional<std::vector<Edge>> read_graph6(const std::string& word) {
  const auto value = [&](std::size_t i) { return i < word.size() ? word[i] - 63 : -1; };
  const int n = value(0);
  if (n < 2 || n > 62) return std::nullopt;
  std::vector<Edge> edges;
  std::vector<int> degree(static_cast<std::size_t>(n));
  std::size_t k = 0;
  for (std::size_t v = 1; v < degree.size(); ++v) {
    for (std::size_t u = 0; u < v; ++u, ++k) {
      const int six = value(1 + k / 6);
      if (six < 0 || six > 63) return std::nullopt;
      if ((six >> (5 - k % 6) & 1) == 0) continue;
      edges.push_back({u, v});
      if (++degree[u] > 4 || ++degree[v] > 4) return std::nullopt;
    }
  }
  return edges;
}

using Line = std::array<V, 4>;  // vertex, two bends, vertex

/// Two stubs at one vertex share that point and no other.
bool cross_each_other(const Line& e, const Line& f) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const bool are_stubs = i != 1 && j != 1;
      if (are_stubs && e[i == 0 ? 0 : 3] == f[j == 0 ? 0 : 3]) continue;
      if (meet(e[i], e[i + 1], f[j], f[j + 1])) return true;
    }
  }
  return false;
}

struct State {
  std::vector<V> at;
  std::vector<std::size_t> tetrahedron;
  std::vector<std::array<std::uint8_t, 4>> port;  // of each vertex: the vector of its i-th edge
  std::vector<std::array<Int, 2>> length;         // of each edge's two stubs
};

class StateSearch {
 public:
  StateSearch(std::vector<Edge> edges, V box, Int norm, std::uint64_t seed)
      : edges_(std::move(edges)),
        box_(box),
        all_(tetrahedra(norm)),
        turns_(near_turns(all_)),
        random_(seed) {
    for (const Edge& edge : edges_) {
      incident_.resize(std::max(incident_.size(), edge[1] + 1));
      slot_.push_back({incident_[edge[0]].size(), incident_[edge[1]].size()});
      for (const std::size_t v : edge) incident_[v].push_back(slot_.size() - 1);
    }
    for (std::size_t v = 0; v < incident_.size(); ++v) {
      state.at.push_back(anywhere());
      state.tetrahedron.push_back(random_.below(all_.size()));
      state.port.push_back({0, 1, 2, 3});
    }
    state.length.assign(edges_.size(), {1, 1});
  }

  /// Whether a drawing was found: it is the state then.
  bool run(Int steps, double threshold) {
    double total = cost();
    for (Int i = 0; i < steps; ++i) {
      total += step(threshold * double(steps - i) / double(steps));
      if (total < 1e-9 || i % 65536 == 0) total = cost();  // without what rounding has added up
      if (total < 1e-9 && nothing_meets()) return true;
    }
    return false;
  }

  /// Tries smaller and smaller boxes; the box of the smallest drawing, which is the state then.
  V shrink(Int steps, double threshold) {
    V box = settle();
    State best = state;
    Int part = 8;  // of the longest side is cut off
    for (int failures = 0; failures < 9;) {
      const Int longest = *std::max_element(box.begin(), box.end());
      box_ = box;
      if (part <= longest) {
        for (Int& side : box_) side = std::min(side, longest - std::max<Int>(1, longest / part));
      } else {
        --box_[static_cast<std::size_t>(failures % 3)];
      }
      for (V& p : state.at) p = inside(p);
      if (run(steps, threshold)) {
        box = settle();
        best = state;
        failures = 0;
      } else {
        state = best;
        part <= longest ? part *= 2 : ++failures;
      }
    }
    return box;
  }

  std::vector<Line> lines() const {
    std::vector<Line> all;
    for (std::size_t e = 0; e < edges_.size(); ++e) all.push_back(line(e));
    return all;
  }
  const std::vector<Edge>& edges() const { return edges_; }

  State state;

 private:
  V anywhere() {
    const Int x = random_.in(0, box_[0]), y = random_.in(0, box_[1]), z = random_.in(0, box_[2]);
    return {x, y, z};
  }
  V inside(V p) const {
    for (std::size_t k = 0; k < 3; ++k) p[k] = std::clamp<Int>(p[k], 0, box_[k]);
    return p;
  }
  V vector_of(std::size_t e, std::size_t end) const {
    const std::size_t v = edges_[e][end];
    return all_[state.tetrahedron[v]][state.port[v][slot_[e][end]]];
  }
  Line line(std::size_t e) const {
    const V p = state.at[edges_[e][0]], q = state.at[edges_[e][1]];
    return {p, p + state.length[e][0] * vector_of(e, 0), q + state.length[e][1] * vector_of(e, 1),
            q};
  }
  double outside(V p) const {
    const V far = p - inside(p);
    return double(std::abs(far[0]) + std::abs(far[1]) + std::abs(far[2]));
  }
  double cost(std::size_t e) const {
    const Line l = line(e);
    const V middle = l[2] - l[1];
    double sum = 0.25 * (outside(l[1]) + outside(l[2]));
    if (middle == V{}) return sum + 4;
    for (std::size_t end = 0; end < 2; ++end) {
      const V d = vector_of(e, end);
      const Int along = end == 0 ? dot(middle, d) : -dot(middle, d);
      const Int lengths = dot(middle, middle) * dot(d, d);
      if (along > 0 && 9 * along * along >= lengths) continue;  // a turn of at most 70.53 degrees
      sum += 1.0 / 3 + 0.02 - double(along) / std::sqrt(double(lengths));
    }
    return sum;
  }
  double cost() const {
    double sum = 0;
    for (std::size_t e = 0; e < edges_.size(); ++e) sum += cost(e);
    return sum;
  }
  double cost_around(std::size_t v) const {
    double sum = 0;
    for (const std::size_t e : incident_[v]) sum += cost(e);
    return sum;
  }
  bool nothing_meets() const {
    const std::vector<Line> all = lines();
    for (std::size_t e = 0; e < all.size(); ++e) {
      if (meet(all[e][0], all[e][1], all[e][2], all[e][3])) return false;
      for (std::size_t f = 0; f < e; ++f) {
        if (cross_each_other(all[e], all[f])) return false;
      }
    }
    return true;
  }
  /// Moves the drawing to the origin; its extents.
  V settle() {
    V low = state.at[0], high = low;
    for (const Line& l : lines()) {
      for (const V& p : l) {
        for (std::size_t k = 0; k < 3; ++k) {
          low[k] = std::min(low[k], p[k]);
          high[k] = std::max(high[k], p[k]);
        }
      }
    }
    for (V& p : state.at) p = p - low;
    return high - low;
  }

  /// Returns by how much the cost changed.
  double step(double threshold) {
    const std::size_t kind = random_.below(9);
    if (kind < 2) return change_length(threshold);
    const std::size_t v = random_.below(incident_.size());
    if (incident_[v].empty()) return 0;
    const V at = state.at[v];
    const std::size_t tetrahedron = state.tetrahedron[v];
    const auto port = state.port[v];
    const double before = cost_around(v);
    if (kind < 5) {
      move(v);
    } else if (kind < 7) {
      std::swap(state.port[v][random_.below(4)], state.port[v][random_.below(4)]);
    } else {
      turn(v);
    }
    const double change = cost_around(v) - before;
    if (change <= threshold) return change;
    state.at[v] = at;
    state.tetrahedron[v] = tetrahedron;
    state.port[v] = port;
    return 0;
  }
  double change_length(double threshold) {
    const std::size_t e = random_.below(edges_.size());
    Int& length = state.length[e][random_.below(2)];
    const Int old = length;
    const double before = cost(e);
    length = std::max<Int>(1, old + (random_.below(2) == 0 ? 1 : -1));
    const double change = cost(e) - before;
    if (change <= threshold) return change;
    length = old;
    return 0;
  }
  void move(std::size_t v) {
    if (random_.below(16) == 0) {
      state.at[v] = anywhere();
      return;
    }
    const Int x = random_.in(-1, 1), y = random_.in(-1, 1), z = random_.in(-1, 1);
    state.at[v] = inside(state.at[v] + V{x, y, z});
  }
  void turn(std::size_t v) {
    const std::vector<NearTurn>& near = turns_[state.tetrahedron[v]];
    if (random_.below(8) == 0 || near.empty()) {
      state.tetrahedron[v] = random_.below(all_.size());
      return;
    }
    const NearTurn& chosen = near[random_.below(near.size())];
    state.tetrahedron[v] = chosen.to;
    for (std::uint8_t& p : state.port[v]) p = chosen.image[p];
  }

  std::vector<Edge> edges_;
  V box_;
  std::vector<Tetrahedron> all_;
  std::vector<std::vector<NearTurn>> turns_;
  Random random_;
  std::vector<std::vector<std::size_t>> incident_;
  std::vector<std::array<std::size_t, 2>> slot_;  // of each edge: its places among its ends' edges
};

std::string json(V p) {
  const V seen = {p[0] + p[1] - 2 * p[2], p[0] - p[1], 2 * (p[0] + p[1] + p[2])};
  return "[" + std::to_string(seen[0]) + "," + std::to_string(seen[1]) + "," +
         std::to_string(seen[2]) + "]";
}

void print(const StateSearch& search) {
  std::string vertices, edges;
  for (const V& p : search.state.at) vertices += (vertices.empty() ? "" : ",") + json(p);
  const std::vector<Line> lines = search.lines();
  for (std::size_t e = 0; e < lines.size(); ++e) {
    const Edge& edge = search.edges()[e];
    edges += (edges.empty() ? "[" : ",[") + std::to_string(edge[0]) + "," +
             std::to_string(edge[1]) + ",[" + json(lines[e][1]) + "," + json(lines[e][2]) + "]]";
  }
  std::printf(
      "{\"n\":%zu,\"algorithm\":\"search\",\"gram\":[[2,0,0],[0,6,0],[0,0,1]],"
      "\"gram_denominator\":1,\"vertices\":[%s],\"edges\":[%s]}\n",
      search.state.at.size(), vertices.c_str(), edges.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  const auto edges = argc == 7 ? read_graph6(argv[1]) : std::nullopt;
  const Int side = argc == 7 ? std::atoll(argv[2]) : 0, norm = argc == 7 ? std::atoll(argv[3]) : 0;
  if (!edges || edges->empty() || side < 1 || side > 1000 || norm < 1 || norm > 100) {
    std::fprintf(stderr,
                 "usage: small_drawings GRAPH6 SIDE NORM SEED STEPS THRESHOLD: degrees of at "
                 "most 4, sides from 1 to 1000, norms from 1 to 100\n");
    return 2;
  }
  const Int steps = std::atoll(argv[5]);
  const double threshold = std::atof(argv[6]);
  StateSearch search(*edges, {side, side, side}, norm,
                     static_cast<std::uint64_t>(std::atoll(argv[4])));
  if (!search.run(steps, threshold)) {
    std::fprintf(stderr, "nothing found\n");
    return 1;
  }
  const V box = search.shrink(steps / 4, threshold / 2);
  std::fprintf(stderr, "box %lld x %lld x %lld\n", static_cast<long long>(box[0]),
               static_cast<long long>(box[1]), static_cast<long long>(box[2]));
  print(search);
  return 0;
}
