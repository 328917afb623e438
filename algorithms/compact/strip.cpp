// Places vertices and routes their edges while (a) to (e) and the cap rule hold, which by Lemmas
// C.3 to C.5 is more than a right drawing needs: the zones of the size bound's proof (Lemma C.7).
// O(1) expected per vertex tried: at most five contested lines.
#include "ar3d/algorithms/compact/strip.h"

#include <algorithm>

#include "ar3d/algorithms/diamond/fast/fast.h"
#include "ar3d/base/error.h"

namespace ar3d::compact {

Strip::Strip(const Decomposition& links, std::size_t num_edges, StripSize size, std::int32_t cap)
    : links_(&links),
      num_edges_(num_edges),
      size_(size),
      sites_(links.at.size(), Site{}),
      taken_(size),
      lines_(num_edges + links.num_green),
      caps_(cap, 8 * size.columns + 4 * size.rows + 16) {}

bool Strip::plan_line(std::uint64_t line, Plan& plan) const {
  const Piece whole = strips::whole_line(line);
  if (std::ranges::find(plan.lines, whole) != plan.lines.end()) return false;
  plan.lines.push_back(whole);
  return lines_.is_free(whole);
}

bool Strip::plan_edge(bool red, Site tail, Site head, Plan& plan) const {
  const Shape shape{red, tail.type, head.type, head.column > tail.column, 0};
  if (head.column == tail.column || (!red && shape.right != (tail.type == 0))) return false;
  const Word word = word_of(shape);
  const Letters from = letters_of(tail);
  const auto lengths = long_lengths(word, from, letters_of(head));
  if (*std::min_element(lengths.begin(), lengths.end()) < 1) return false;
  const Letters start = middle_start(word, from, lengths);
  plan.edges.emplace_back(shape, start);
  return plan_line(middle_piece(word, red, start, lengths[1]).line, plan) &&
         caps_.is_open(shape, start);
}

bool Strip::make_plan(Vertex v, Site site, Plan& plan) const {
  if (taken_.is_taken(forms_of(site))) return false;
  for (const ColourRole role : {kGreenOut, kGreenIn, kRedOut, kRedIn}) {
    const Vertex to = links_->at[v][role].to;
    if (to == kNobody || !sites_[to].is_set()) continue;
    const Site& other = sites_[to];
    const bool out = is_out(role);
    if (!plan_edge(is_red(role), out ? site : other, out ? other : site, plan)) return false;
  }
  return links_->at[v][kGreenIn].to == kNobody || plan_line(arrival_line(site).line, plan);
}

bool Strip::fits(Vertex v, Site site) const {
  Plan plan;
  return make_plan(v, site, plan);
}

bool Strip::try_place(Vertex v, Site site) {
  Plan plan;
  if (!make_plan(v, site, plan)) return false;
  sites_[v] = site;
  taken_.flip(forms_of(site));
  for (const Piece& line : plan.lines) lines_.insert(line);
  for (const auto& [shape, start] : plan.edges) caps_.add(shape, start);
  return true;
}

Placement Strip::placement() const {
  Placement placement{size_, {}, std::vector<std::uint8_t>(num_edges_, 0)};
  placement.places.reserve(sites_.size());
  for (const Site& site : sites_) placement.places.push_back(forms_of(site));
  return placement;
}

// The cap rule of Lemma C.7: it keeps any one plane from being crowded, so that few cells are
// closed to a vertex. One number for each family of lines and value of its third form: O(1) per
// question, O(sqrt n) memory. Used in the zones only.

std::size_t Caps::index(const Shape& shape, const Letters& on_line) const {
  const auto form = [&](Letter x, Letter y) { return on_line[x] - on_line[y]; };
  std::size_t family = 0;
  std::int32_t value = 0;
  if (shape.red) {
    family = shape.right ? 4 : 5;
    value = shape.right ? form(kA, kB) : form(kB, kD);
  } else {
    const bool by_a = shape.tail_type == 0;
    const bool q_is_b = shape.head_type == 0;
    family = (by_a ? 0u : 1u) + (q_is_b ? 0u : 2u);
    value = q_is_b ? (by_a ? form(kA, kC) : form(kC, kD)) : (by_a ? form(kA, kB) : form(kB, kD));
  }
  expect(value >= -widest_ && value <= widest_, "forms keep their width");
  return family * width() + static_cast<std::size_t>(value + widest_);
}

// Step 1.1 again: every edge directed and green or red. The four roles at a vertex are what gives
// every edge letters of its own at both ends (Lemma C.1). O(n + m).

Decomposition decompose(const Graph& graph) {
  constexpr Vertex kAhead = 16;  // heads are prefetched so many edges before they are written
  const diamond::TwoColouring colours = diamond::fast::colouring(graph);
  static_assert(diamond::kNone == kNobody);
  const HalfEdge nothing{kNobody, kNobody};
  Decomposition result;
  result.at.assign(graph.num_vertices(), {nothing, nothing, nothing, nothing});
  for (const auto colour : {diamond::kGreen, diamond::kRed}) {
    const ColourRole out = colour == diamond::kGreen ? kGreenOut : kRedOut;
    const auto& next = colours[colour];
    for (Vertex v = 0; v < graph.num_vertices(); ++v) {
      if (v + kAhead < next.size() && next[v + kAhead].to != kNobody) {
        __builtin_prefetch(&result.at[next[v + kAhead].to], 1);
      }
      const HalfEdge edge = next[v];
      if (edge.to == kNobody) continue;
      HalfEdge& in = result.at[edge.to][opposite(out)];
      expect(in.to == kNobody, "a vertex has one edge of each role");
      in = {v, edge.edge};
      result.at[v][out] = edge;
      if (out == kGreenOut) ++result.num_green;
    }
  }
  return result;
}

}  // namespace ar3d::compact
