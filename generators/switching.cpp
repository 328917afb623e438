// Uniform regular graphs by switchings (McKay and Wormald 1990); the proof stands below.
#include "ar3d/generators/switching.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "ar3d/base/error.h"
#include "ar3d/base/parallel.h"

// Points are the nd places for ends of edges; point p belongs to vertex p / d. A defect is a loop
// or a double edge. C(l, k) is the set of pairings with l loops and k double edges, no triple edge,
// and every vertex on at most one defect.
//
// A switching takes a pairing P of C(l, k) to one P' of C(l - 1, k), or of C(0, k) to C(0, k - 1):
// it removes one chosen defect and changes no other. Forward options: every P has the same number
// of them (all choices of labelled points below); an option that is no switching ends the attempt.
// So P' is reached with probability proportional to b(P'), the number of switchings that lead to
// it, if P is uniform. Then P' is kept with probability b_low / b(P') for a constant b_low <= b of
// its class, which makes it uniform again. Whatever ends an attempt, the next one starts from a new
// pairing.
//
// b(P') is never counted. The inverse options of P' number X = M s, where M counts its "centres" (a
// vertex without defect and two of its points, in order) and s the choices a centre leaves; of
// these, at most c are bad for any centre, so b_low = M (s - c). With r = bad / X, the wanted
// probability is (1 - c/s) / (1 - r): that of leaving the loop "with probability 1 - c/s accept;
// else draw a centre, and with probability bad(centre) / c go round again; else refuse".
namespace ar3d {
namespace {

using Point32 = std::uint32_t;
using PointPair = std::pair<Point32, Point32>;

/// Vertices that one thread looks through at a time.
constexpr Count kVertexChunk = Count{1} << 15;

struct Defects {
  std::vector<PointPair> loops;                          // the two points of each
  std::vector<std::pair<PointPair, PointPair>> doubles;  // first points at the same vertex
  bool crowded = false;                                  // some vertex is on several
};

class SwitchedPairing {
 public:
  SwitchedPairing(Count n, std::uint32_t d, RandomStream& random)
      : n_(n), d_(d), reciprocal_(((std::uint64_t{1} << 33) + d - 1) / d), random_(random) {}

  /// Draws a uniform pairing and removes its defects; false: start again.
  bool attempt(Count most_loops, Count most_doubles) {
    partner_ = random_matching(n_ * d_, random_);
    if (!find_defects() || loops_.size() > most_loops || doubles_.size() > most_doubles)
      return false;
    while (!loops_.empty()) {
      if (!switch_loop() || !keep_after_loop()) return false;
    }
    while (!doubles_.empty()) {
      if (!switch_double() || !keep_after_double()) return false;
    }
    return true;
  }

  /// The pairs of a simple pairing as edges (u, v), u < v, in order of u.
  std::vector<Edge> edges() const;

 private:
  /// p / d, exactly: reciprocal_ is at most 1 / d above 2^33 / d for d = 2, 3, 4.
  Vertex vertex(Point32 p) const { return static_cast<Vertex>((p * reciprocal_) >> 33); }
  Point32 any_point() { return random_.below(static_cast<std::uint32_t>(partner_.size())); }
  std::uint32_t pairs_between(Vertex u, Vertex v) const {
    std::uint32_t count = 0;
    for (Point32 p = u * d_; p < (u + 1) * d_; ++p) count += vertex(partner_[p]) == v ? 1 : 0;
    return count;
  }
  /// The pair of p is neither a loop nor one of several parallel ones.
  bool clean(Point32 p) const {
    const Vertex u = vertex(p);
    const Vertex v = vertex(partner_[p]);
    return u != v && pairs_between(u, v) == 1;
  }
  bool clean_vertex(Vertex v) const {
    for (Point32 p = v * d_; p < (v + 1) * d_; ++p) {
      if (!clean(p)) return false;
    }
    return true;
  }
  void join(PointPair pair) {
    partner_[pair.first] = pair.second;
    partner_[pair.second] = pair.first;
  }
  template <std::size_t k>
  static bool all_distinct(const std::array<Point32, k>& points) {
    for (std::size_t i = 0; i < k; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (points[i] == points[j]) return false;
      }
    }
    return true;
  }
  /// Pairs the points anew; true iff the last `must_be_clean` new ones are clean.
  template <std::size_t k>
  bool rejoin(const std::array<PointPair, k>& new_pairs, std::size_t must_be_clean) {
    for (const PointPair& pair : new_pairs) join(pair);
    return std::all_of(new_pairs.end() - static_cast<std::ptrdiff_t>(must_be_clean),
                       new_pairs.end(), [&](const PointPair& pair) { return clean(pair.first); });
  }

  /// False if a vertex is on several.
  bool find_defects();
  void add_defects(Vertex begin, Vertex end, Defects& defects) const;
  bool switch_loop();
  bool keep_after_loop();
  std::uint32_t bad_loop_options(Vertex v, Point32 p2, Point32 p3);
  bool is_inverse_loop(Point32 p2, Point32 p3, Point32 p5);
  bool switch_double();
  bool keep_after_double();
  std::uint32_t bad_double_options(Point32 a1, Point32 a2);
  bool is_inverse_double(Point32 a1, Point32 a2, Point32 b1, Point32 b2);
  /// A vertex without defects and two of its points, all equally likely.
  std::pair<Point32, Point32> random_centre();
  /// A point of every vertex at distance at most `radius` from v, each of their points once or
  /// more.
  void collect_near(Vertex v, int radius, std::vector<Point32>& points) const;

  Count n_;
  std::uint32_t d_;
  std::uint64_t reciprocal_;
  RandomStream& random_;
  UnwrittenVector<Point32> partner_;
  std::vector<PointPair> loops_;
  std::vector<std::pair<PointPair, PointPair>> doubles_;
};

/// Adds the defects of the vertices begin..end-1.
void SwitchedPairing::add_defects(Vertex begin, Vertex end, Defects& defects) const {
  for (Vertex v = begin; v < end; ++v) {
    int here = 0;
    for (Point32 p = v * d_; p < (v + 1) * d_; ++p) {
      const Vertex u = vertex(partner_[p]);
      if (u == v && partner_[p] > p) {
        defects.loops.push_back({p, partner_[p]});
        ++here;
      }
      for (Point32 q = p + 1; u != v && q < (v + 1) * d_; ++q) {
        if (vertex(partner_[q]) != u) continue;
        ++here;  // a triple edge counts three times
        if (v < u) defects.doubles.push_back({{p, partner_[p]}, {q, partner_[q]}});
      }
    }
    defects.crowded |= here > 1;
  }
}

bool SwitchedPairing::find_defects() {
  const Count chunks = (n_ + kVertexChunk - 1) / kVertexChunk;
  std::vector<Defects> found(chunks);
  for_each_in_threads(threads_for(n_), chunks, [&](std::uint32_t, Count i) {
    add_defects(static_cast<Vertex>(i * kVertexChunk),
                static_cast<Vertex>(std::min(n_, (i + 1) * kVertexChunk)), found[i]);
  });
  loops_.clear();
  doubles_.clear();
  bool crowded = false;
  for (const Defects& defects : found) {
    crowded |= defects.crowded;
    loops_.insert(loops_.end(), defects.loops.begin(), defects.loops.end());
    doubles_.insert(doubles_.end(), defects.doubles.begin(), defects.doubles.end());
  }
  return !crowded;
}

std::vector<Edge> SwitchedPairing::edges() const {
  const Count chunks = (n_ + kVertexChunk - 1) / kVertexChunk;
  const Count chunk_points = kVertexChunk * d_;
  std::vector<Count> first(chunks + 1, 0);  // of each chunk's first edge
  std::vector<Edge> edges(partner_.size() / 2);
  const auto for_each_edge = [&](Count chunk, auto&& use) {
    const Count end = std::min<Count>(partner_.size(), (chunk + 1) * chunk_points);
    for (Count p = chunk * chunk_points; p < end; ++p) {
      const Edge e = {vertex(static_cast<Point32>(p)), vertex(partner_[p])};
      if (e.u < e.v) use(e);
    }
  };
  for_each_in_threads(threads_for(n_), chunks, [&](std::uint32_t, Count i) {
    for_each_edge(i, [&](Edge) { ++first[i + 1]; });
  });
  std::partial_sum(first.begin(), first.end(), first.begin());
  for_each_in_threads(threads_for(n_), chunks, [&](std::uint32_t, Count i) {
    Edge* next = edges.data() + first[i];
    for_each_edge(i, [&](Edge e) { *next++ = e; });
  });
  return edges;
}

std::pair<Point32, Point32> SwitchedPairing::random_centre() {
  Vertex v = 0;
  do {
    v = random_.below(static_cast<std::uint32_t>(n_));
  } while (!clean_vertex(v));
  const std::uint32_t i = random_.below(d_);
  const std::uint32_t j = random_.below(d_ - 1);
  return {v * d_ + i, v * d_ + (j < i ? j : j + 1)};
}

void SwitchedPairing::collect_near(Vertex v, int radius, std::vector<Point32>& points) const {
  for (Point32 p = v * d_; p < (v + 1) * d_; ++p) {
    points.push_back(p);
    if (radius > 0) collect_near(vertex(partner_[p]), radius - 1, points);
  }
}

/// The loop p2 p3 and two pairs p1 p5, p4 p6 become p1 p2, p3 p4, p5 p6. Options: 2 l (nd)^2.
bool SwitchedPairing::switch_loop() {
  const auto i = random_.below(static_cast<std::uint32_t>(loops_.size()));
  auto [p2, p3] = loops_[i];
  if (random_.chance(1, 2)) std::swap(p2, p3);
  const Point32 p1 = any_point();
  const Point32 p4 = any_point();
  const Point32 p5 = partner_[p1];
  const Point32 p6 = partner_[p4];
  if (!all_distinct<6>({p1, p2, p3, p4, p5, p6}) || !clean(p1) || !clean(p4)) return false;
  loops_.erase(loops_.begin() + i);
  return rejoin<3>({{{p1, p2}, {p3, p4}, {p5, p6}}}, 3);
}

/// Inverse options: a centre (v; p2, p3), with p1, p4 the partners, and any point p5 with its
/// partner p6: s = nd. Bad p5: on a loop or double edge, 2 l + 4 k; one of the points p1..p4, 4; p1
/// p5 a loop or parallel to another pair, its vertex then is within distance 1 of p1's: d + d^2;
/// likewise p6 and p4: d + d^2; p1 p5 and p4 p6 parallel: d.
bool SwitchedPairing::keep_after_loop() {
  const auto s = static_cast<std::uint32_t>(partner_.size());
  const auto c = static_cast<std::uint32_t>(2 * loops_.size() + 4 * doubles_.size()) + 4 +
                 2 * (d_ + d_ * d_) + d_;
  expect(c < s, "switchings are used for large enough graphs only");
  while (random_.below(s) < c) {
    const auto [p2, p3] = random_centre();
    const std::uint32_t bad = bad_loop_options(vertex(p2), p2, p3);
    expect(bad <= c, "bad inverse loop options of a centre are bounded");
    if (random_.below(c) >= bad) return false;
  }
  return true;
}

std::uint32_t SwitchedPairing::bad_loop_options(Vertex v, Point32 p2, Point32 p3) {
  std::vector<Point32> candidates;
  collect_near(v, 3, candidates);  // every p5 with p5 or p6 near p1 or p4, and p1..p4 themselves
  for (const auto& [p, q] : loops_) candidates.insert(candidates.end(), {p, q});
  for (const auto& [one, two] : doubles_) {
    candidates.insert(candidates.end(), {one.first, one.second, two.first, two.second});
  }
  std::sort(candidates.begin(), candidates.end());
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  return static_cast<std::uint32_t>(
      std::count_if(candidates.begin(), candidates.end(),
                    [&](Point32 p5) { return !is_inverse_loop(p2, p3, p5); }));
}

bool SwitchedPairing::is_inverse_loop(Point32 p2, Point32 p3, Point32 p5) {
  const Point32 p1 = partner_[p2];
  const Point32 p4 = partner_[p3];
  const Point32 p6 = partner_[p5];
  if (!all_distinct<6>({p1, p2, p3, p4, p5, p6}) || !clean(p5)) return false;
  const bool good = rejoin<3>({{{p2, p3}, {p1, p5}, {p4, p6}}}, 2);
  rejoin<3>({{{p1, p2}, {p3, p4}, {p5, p6}}}, 0);
  return good;
}

/// The double edge a1 b1, a2 b2 and two pairs x1 y1, x2 y2 become a1 x1, b1 y1, a2 x2, b2 y2.
/// Options: 4 k (nd)^2.
bool SwitchedPairing::switch_double() {
  const auto i = random_.below(static_cast<std::uint32_t>(doubles_.size()));
  auto [first, second] = doubles_[i];
  if (random_.chance(1, 2)) std::swap(first, second);
  if (random_.chance(1, 2)) {
    std::swap(first.first, first.second);
    std::swap(second.first, second.second);
  }
  const auto [a1, b1] = first;
  const auto [a2, b2] = second;
  const Point32 x1 = any_point();
  const Point32 x2 = any_point();
  const Point32 y1 = partner_[x1];
  const Point32 y2 = partner_[x2];
  if (!all_distinct<8>({a1, b1, a2, b2, x1, y1, x2, y2}) || !clean(x1) || !clean(x2)) return false;
  doubles_.erase(doubles_.begin() + i);
  return rejoin<4>({{{a1, x1}, {b1, y1}, {a2, x2}, {b2, y2}}}, 4) &&
         pairs_between(vertex(a1), vertex(b1)) == 0;  // as every inverse option demands
}

/// Inverse options: a centre (u; a1, a2) and another one (w; b1, b2), w != u without defect: s = (n
/// - 2k - 1) d (d - 1). Bad ones: w adjacent to u, d * d (d - 1); x1 y1 a loop or parallel to
/// another pair, y1 then is one of the d + d^2 points within distance 1 of x1's vertex, and b2 any
/// of d - 1: (d + d^2)(d - 1); the same for x2 y2; x1 y1 parallel to x2 y2, y1 then is at x2's
/// vertex: d (d - 1).
bool SwitchedPairing::keep_after_double() {
  const auto clean_vertices = static_cast<std::uint32_t>(n_ - 2 * doubles_.size());
  const std::uint32_t s = (clean_vertices - 1) * d_ * (d_ - 1);
  const std::uint32_t c = (d_ * d_ + 2 * (d_ + d_ * d_) + d_) * (d_ - 1);
  expect(c < s, "switchings are used for large enough graphs only");
  while (random_.below(s) < c) {
    const auto [a1, a2] = random_centre();
    const std::uint32_t bad = bad_double_options(a1, a2);
    expect(bad <= c, "bad inverse double options of a centre are bounded");
    if (random_.below(c) >= bad) return false;
  }
  return true;
}

std::uint32_t SwitchedPairing::bad_double_options(Point32 a1, Point32 a2) {
  const Vertex u = vertex(a1);
  std::vector<Point32> near;
  collect_near(u, 3, near);  // b1 or b2 is a partner of a point within distance 2 of u
  std::vector<Vertex> candidates;
  for (const Point32 p : near) candidates.push_back(vertex(p));
  std::sort(candidates.begin(), candidates.end());
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  std::uint32_t bad = 0;
  for (const Vertex w : candidates) {
    if (w == u || !clean_vertex(w)) continue;
    for (Point32 b1 = w * d_; b1 < (w + 1) * d_; ++b1) {
      for (Point32 b2 = w * d_; b2 < (w + 1) * d_; ++b2) {
        if (b1 != b2 && !is_inverse_double(a1, a2, b1, b2)) ++bad;
      }
    }
  }
  return bad;
}

bool SwitchedPairing::is_inverse_double(Point32 a1, Point32 a2, Point32 b1, Point32 b2) {
  const Point32 x1 = partner_[a1];
  const Point32 x2 = partner_[a2];
  const Point32 y1 = partner_[b1];
  const Point32 y2 = partner_[b2];
  if (!all_distinct<8>({a1, a2, b1, b2, x1, x2, y1, y2})) return false;
  if (pairs_between(vertex(a1), vertex(b1)) > 0) return false;  // would be a triple edge
  const bool good = rejoin<4>({{{a1, b1}, {a2, b2}, {x1, y1}, {x2, y2}}}, 2);
  rejoin<4>({{{a1, x1}, {b1, y1}, {a2, x2}, {b2, y2}}}, 0);
  return good;
}

}  // namespace

std::vector<Edge> random_regular_by_switching(Count n, std::uint32_t d, RandomStream& random,
                                              Count most_loops, Count most_doubles) {
  SwitchedPairing pairing(n, d, random);
  while (!pairing.attempt(most_loops, most_doubles)) {
  }
  return pairing.edges();
}

}  // namespace ar3d
