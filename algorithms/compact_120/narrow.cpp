// What efforts 1 and 2 draw: a strip with about one cell per vertex, filled greedily at random near
// the columns where the order wants the vertices, with ejections (Pagh and Rodler 2001). Rules (a)
// to (e) of Lemma D.6 are all that a right drawing needs, so no zones are kept; Lemma D.3 names the
// rows in which all lengths are positive. Nothing proves that this ends well, hence the bounded
// ejections and the zones behind it. Cost: O(n + ejections) cells tried, each in O(1) expected.
#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

#include "ar3d/algorithms/compact_120/fill.h"
#include "ar3d/algorithms/strips/search.h"

namespace ar3d::compact_120 {
namespace {

constexpr int kTrials = 12;

/// Columns, or rows, from the first to the last; there are none if the first is larger.
using SiteRange = std::pair<std::int32_t, std::int32_t>;
constexpr SiteRange kNone = {0, -1};

std::int32_t quotient_down(std::int32_t a, std::int32_t b) { return a / b - (a % b < 0 ? 1 : 0); }

/// Puts vertices at random cells of one strip.
class OrderedPlacer {
 public:
  OrderedPlacer(Strip& strip, const NarrowOrder& order, strips::NumbersAhead& random,
                Census& census)
      : strip_(strip), random_(random), census_(census) {
    std::array<std::int64_t, 102> before{};  // by position, the vertices of N before it
    kinds_.reserve(order.position.size());
    for (std::size_t v = 0; v < order.position.size(); ++v) {
      const auto of = static_cast<std::uint8_t>(order.links.of[v]);
      if (of == 0) ++before[order.position[v] + 1u];
      kinds_.push_back(of == 0 ? order.position[v] : static_cast<std::uint8_t>(kLastPosition + of));
    }
    std::partial_sum(before.begin(), before.end(), before.begin());
    for (std::size_t kind = 0; kind < homes_.size(); ++kind) {
      const bool is_empty = kind <= kLastPosition && before[kind] == before[kind + 1];
      if (!is_empty) homes_[kind] = home(kind, before);
    }
  }

  bool place(const std::vector<Vertex>& waiting) {
    const auto after = [&](std::size_t i) {
      return waiting[waiting.size() - std::min(waiting.size(), i + 1)];
    };
    strip_.prefetch_edges(after(2 * kAhead));
    strip_.prefetch_neighbours(after(kAhead));
    const Vertex v = waiting.back();
    const auto [left, right] = columns_for(v);
    if (left > right) {
      prefetch_ejection(v);
      return false;
    }
    for (int trial = 0; trial < kTrials; ++trial) {
      if (trial == kTrials / 3) prefetch_ejection(v);
      if (trial == 2 * kTrials / 3) strip_.prefetch_removal_of_neighbours(v);
      ++census_.trials;
      Site site{pick(left, right), 0, class_of(v)};
      const auto [low, high] = rows_for(v, site);
      if (low > high) continue;
      site.row = pick(low, high);
      const std::int32_t start = site.row;
      site.row = strip_.free().next_row(site, high);
      if (site.row > high) {
        site.row = low;
        site.row = strip_.free().next_row(site, start);
        if (site.row > start) continue;
      }
      if (strip_.try_place(v, site)) return true;
    }
    return false;
  }

  strips::FewVertices placed_neighbours(Vertex v) const {
    strips::FewVertices placed;
    for (const ArmLink& link : strip_.links().at[v]) {
      if (link.is_set() && strip_.is_placed(link.to)) placed.push_back(link.to);
    }
    return placed;
  }

  void remove(Vertex v) { strip_.remove(v); }

 private:
  void prefetch_ejection(Vertex v) const {
    strip_.prefetch_edges_of_neighbours(v);
    for (const ArmLink& link : strip_.links().at[v]) {
      if (link.is_set()) __builtin_prefetch(&kinds_[link.to]);
    }
  }

  std::int32_t pick(std::int32_t low, std::int32_t high) {
    return low +
           static_cast<std::int32_t>(random_.below(static_cast<std::uint32_t>(high - low + 1)));
  }

  Class class_of(Vertex v) const {
    return kinds_[v] > kLastPosition ? static_cast<Class>(kinds_[v] - kLastPosition) : Class::n;
  }

  /// The columns where vertices of a kind belong: of class N those that hold as many vertices of N
  /// as have their position, and a margin, so that rare positions have room; the ends of the strip
  /// for sources and sinks.
  SiteRange home(std::size_t kind, const std::array<std::int64_t, 102>& before) const {
    const std::int32_t columns = strip_.size().columns;
    const std::int32_t share = kSourceShare * columns / 100;
    if (kind == kLastPosition + 1) return {0, share};
    if (kind == kLastPosition + 2) return {columns - 1 - share, columns - 1};
    const auto low = static_cast<std::int32_t>(columns * before[kind] / before.back());
    const auto high = static_cast<std::int32_t>(columns * before[kind + 1] / before.back());
    const std::int32_t margin =
        std::max(kMargin * columns / 100, (kLeastShare * columns / 100 - (high - low)) / 2);
    return {std::max(low - margin, 0), std::min(high + margin, columns - 1)};
  }

  /// The columns where v belongs that its placed neighbours leave.
  SiteRange columns_for(Vertex v) const {
    auto [low, high] = homes_[kinds_[v]];
    for (const ArmLink& link : strip_.links().at[v]) {
      if (!link.is_set() || !strip_.is_placed(link.to)) continue;
      const std::int32_t at = strip_.site(link.to).column;
      if (link.is_right != 0) {
        high = std::min(high, at);
      } else {
        low = std::max(low, at);
      }
    }
    return {low, high};
  }

  /// The rows of the column in which all lengths to placed neighbours are at least 1: with d the
  /// slant of the head minus that of the tail, d <= 3/2 |Dt| - 2 and d >= 2 - 5/2 |Dt|.
  SiteRange rows_for(Vertex v, Site site) const {
    const std::int32_t t = t_of(site);
    const std::int32_t base = slant(site);
    std::int32_t low = base;
    std::int32_t high = base + 4 * (strip_.size().rows - 1);
    for (const ArmLink& link : strip_.links().at[v]) {
      if (!link.is_set() || !strip_.is_placed(link.to)) continue;
      const Site& other = strip_.site(link.to);
      const std::int32_t across = (t_of(other) - t) * (link.is_right != 0 ? 1 : -1);
      if (across <= 0) return kNone;
      const std::int32_t shallow = 3 * across / 2 - 2;
      const std::int32_t deep = 5 * across / 2 - 2;
      const std::int32_t at = slant(other);
      low = std::max(low, at - (link.is_out != 0 ? shallow : deep));
      high = std::min(high, at + (link.is_out != 0 ? deep : shallow));
      const std::int32_t tail_t = link.is_out != 0 ? t : t_of(other);
      const std::int32_t least = strip_.least_slant(link, tail_t, across);
      if ((link.is_out != 0) != link.is_steep()) {
        low = std::max(low, least);
      } else if (at < least) {
        return kNone;
      }
    }
    return {quotient_down(low - base + 3, 4), quotient_down(high - base, 4)};
  }

  static constexpr std::size_t kAhead = 8;
  static constexpr std::int32_t kMargin = 2;        ///< hundredths of the strip
  static constexpr std::int32_t kLeastShare = 40;   ///< hundredths of the strip
  static constexpr std::int32_t kSourceShare = 60;  ///< hundredths of the strip

  static constexpr unsigned kLastPosition = 100;

  Strip& strip_;
  LongVector<std::uint8_t> kinds_;  ///< by vertex: of N its position, else kLastPosition + class
  std::array<SiteRange, 103> homes_{};  ///< by kind
  strips::NumbersAhead& random_;
  Census& census_;
};

/// Sources and sinks last: they find room at the ends of the strip, whatever their neighbours do.
std::vector<Vertex> sources_and_sinks_last(const Links& links) {
  std::vector<Vertex> waiting;
  waiting.reserve(links.of.size());
  for (const bool extreme : {true, false}) {
    for (auto v = static_cast<Vertex>(links.of.size()); v > 0; --v) {
      if ((links.of[v - 1] != Class::n) == extreme) waiting.push_back(v - 1);
    }
  }
  return waiting;
}

}  // namespace

StripSize narrow_size(const NarrowOrder& order, const Tightness& tightness) {
  const auto n = static_cast<std::int64_t>(order.position.size());
  const std::int64_t in_n = std::count(order.links.of.begin(), order.links.of.end(), Class::n);
  const std::int64_t rows = strips::square_root(tightness.rows * tightness.rows * n) / 100 + 2;
  const std::int64_t cells = tightness.cells * std::max(n, 7 * in_n / 5) / 100 + 1;
  const std::int64_t columns = cells / rows + tightness.extra_columns;
  const std::int64_t beyond = 4 * tightness.reach * columns / 100 + 8 * tightness.extra_reach;
  return {static_cast<std::int32_t>(columns), static_cast<std::int32_t>(rows),
          static_cast<std::int32_t>(beyond)};
}

std::optional<Strip> fill_narrow_strip(const NarrowOrder& order, std::size_t num_edges,
                                       const Tightness& tightness, strips::NumbersAhead random,
                                       Census& census) {
  const auto n = static_cast<std::int64_t>(order.position.size());
  std::optional<Strip> strip(std::in_place, order.links, num_edges, narrow_size(order, tightness),
                             false);
  OrderedPlacer placer(*strip, order, random, census);
  if (!strips::place_with_ejections(placer, sources_and_sinks_last(order.links),
                                    strips::most_ejections(n, tightness), random, census)) {
    strip.reset();
  }
  return strip;
}

}  // namespace ar3d::compact_120
