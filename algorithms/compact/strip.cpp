// Places vertices and routes their edges while (a) to (e) hold, which by Lemmas C.3 to C.5 is all
// that a right drawing needs. Cheap refusals (reach, sides, lengths) come before lines are looked
// up. O(1) expected per vertex tried: at most five pieces of contested lines.
#include "ar3d/algorithms/compact/strip.h"

#include <algorithm>
#include <cstdlib>

#include "ar3d/base/error.h"

namespace ar3d::compact {

Strip::Strip(const Decomposition& links, std::size_t num_edges, StripSize size, std::int32_t cap)
    : links_(&links),
      size_(size),
      sites_(links.at.size(), Site{}),
      variant_(num_edges, 0),
      taken_(size),
      lines_(num_edges + links.num_green) {
  if (cap > 0) caps_.emplace(cap, 8 * size.columns + 4 * size.rows + 16);
}

bool Strip::is_free(const Piece& piece, const Plan& plan) const {
  for (std::size_t i = 0; i < plan.count; ++i) {
    if (plan.pieces[i].overlaps(piece)) return false;
  }
  return lines_.is_free(piece);
}

bool Strip::plan_arrival(Vertex v, Site site, Plan& plan) const {
  if (!has_arrival(v)) return true;
  const Piece piece = arrival_line(site);
  if (!is_free(piece, plan)) return false;
  plan.edges[plan.count] = kNobody;
  plan.pieces[plan.count++] = piece;
  return true;
}

/// False for what no variant mends: reach, the side of the head, and |dV| > |dU| + 2, which leaves a
/// length below 1. (A length is (|dU| +- dV)/2 plus at most 2.) Cheap, so that few lines are looked
/// up in vain.
bool Strip::may_join(ColourRole role, Site own, Site other) const {
  const std::int32_t across = std::abs(other.column - own.column);
  if (across == 0 || across > size_.reach) return false;
  if (!is_red(role)) {
    const Site tail = is_out(role) ? own : other;
    const Site head = is_out(role) ? other : own;
    if ((head.column > tail.column) != (tail.type == 0)) return false;
  }
  const std::int32_t types = other.type - own.type;
  const std::int32_t du = std::abs(4 * (other.column - own.column) + 2 * types);
  const std::int32_t dv = std::abs(4 * (other.row - own.row) - 2 * types);
  return dv <= du + 2;
}

bool Strip::plan_edge(ColourRole role, Site own, Site other, EdgeId edge, Plan& plan) const {
  const Site tail = is_out(role) ? own : other;
  const Site head = is_out(role) ? other : own;
  Shape shape{is_red(role), tail.type, head.type, head.column > tail.column, 0};
  const Letters from = letters_of(tail);
  const Letters to = letters_of(head);
  const unsigned tried = caps_ ? 1 : variants(shape.red);
  for (; shape.variant < tried; ++shape.variant) {
    const Word word = word_of(shape);
    const auto lengths = long_lengths(word, from, to);
    if (*std::min_element(lengths.begin(), lengths.end()) < 1) continue;
    const Letters start = middle_start(word, from, lengths);
    Piece piece = middle_piece(word, shape.red, start, lengths[1]);
    if (caps_) piece = strips::whole_line(piece.line);
    if (!is_free(piece, plan)) continue;
    if (caps_ && !caps_->is_open(shape, start)) continue;
    plan.edges[plan.count] = edge;
    plan.shapes[plan.count] = shape;
    plan.starts[plan.count] = start;
    plan.pieces[plan.count++] = piece;
    return true;
  }
  return false;
}

Piece Strip::piece_of(const Shape& shape, Site tail, Site head) const {
  const Word word = word_of(shape);
  const Letters from = letters_of(tail);
  const auto lengths = long_lengths(word, from, letters_of(head));
  return middle_piece(word, shape.red, middle_start(word, from, lengths), lengths[1]);
}

void Strip::commit(Vertex v, Site site, const Plan& plan) {
  sites_[v] = site;
  taken_.flip(place_of(site));
  for (std::size_t i = 0; i < plan.count; ++i) {
    lines_.insert(plan.pieces[i]);
    if (plan.edges[i] == kNobody) continue;
    variant_[plan.edges[i]] = static_cast<std::uint8_t>(plan.shapes[i].variant);
    if (caps_) caps_->add(plan.shapes[i], plan.starts[i]);
  }
}

Joined Strip::joined(Vertex v) const {
  Joined joined;
  for (const ColourRole role : {kGreenOut, kGreenIn, kRedOut, kRedIn}) {
    const HalfEdge edge = links_->at[v][role];
    if (edge.to == kNobody || !is_placed(edge.to)) continue;
    joined.push_back({role, edge.edge, sites_[edge.to]});
  }
  return joined;
}

bool Strip::may_hold(Site site, const Joined& joined) const {
  return !taken_.is_taken(place_of(site)) &&
         std::all_of(joined.begin(), joined.end(), [&](const PlacedNeighbour& edge) {
           return may_join(edge.role, site, edge.other);
         });
}

bool Strip::make_plan(Vertex v, Site site, const Joined& joined, Plan& plan) const {
  for (const auto& [role, edge, other] : joined) {
    if (!plan_edge(role, site, other, edge, plan)) return false;
  }
  return plan_arrival(v, site, plan);
}

bool Strip::fits(Vertex v, Site site) const {
  Plan plan;
  const Joined joined = this->joined(v);
  return may_hold(site, joined) && make_plan(v, site, joined, plan);
}

bool Strip::try_place(Vertex v, Site site) {
  const Joined joined = this->joined(v);
  if (!may_hold(site, joined)) return false;
  Plan plan;
  if (!make_plan(v, site, joined, plan)) return false;
  commit(v, site, plan);
  return true;
}

void Strip::remove(Vertex v) {
  expect(!caps_, "vertices are removed only where edges take pieces");
  const Site site = sites_[v];
  if (has_arrival(v)) lines_.erase(arrival_line(site));
  for (const auto& [role, edge, other] : joined(v)) {
    const Site tail = is_out(role) ? site : other;
    const Site head = is_out(role) ? other : site;
    lines_.erase(
        piece_of({is_red(role), tail.type, head.type, head.column > tail.column, variant_[edge]},
                 tail, head));
  }
  taken_.flip(place_of(site));
  sites_[v] = {};
}

Placement Strip::placement() const {
  Placement placement{size_, {}, variant_};
  placement.places.reserve(sites_.size());
  for (const Site& site : sites_) placement.places.push_back(place_of(site));
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

}  // namespace ar3d::compact
