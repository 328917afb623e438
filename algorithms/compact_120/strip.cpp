// Places vertices and routes their edges while (a) to (e) hold, which by Lemma D.6 is all that a
// right drawing needs; (a) follows from (b). O(1) expected per cell tried: at most three pieces of
// contested lines, which never overlap each other (Lemma D.7).
#include "ar3d/algorithms/compact_120/strip.h"

#include <bit>

#include "ar3d/base/error.h"

namespace ar3d::compact_120 {

namespace {

Route route_of(const ArmLink& link, unsigned variant, const Quad& own, const Quad& other) {
  const Shape shape{link.runs_right(), link.arrival(), variant};
  return link.is_out != 0 ? Route(shape, own, other) : Route(shape, other, own);
}

}  // namespace

Strip::Strip(const Links& links, std::size_t num_edges, StripSize size, bool whole_lines)
    : links_(&links),
      size_(size),
      whole_lines_(whole_lines),
      sites_(links.at.size()),
      variant_(num_edges, 0),
      free_(size.columns, size.rows),
      lines_(num_edges),
      top_right_(size.beyond),
      top_left_(size.beyond + 6 * (size.columns - 1) + 3) {}

bool Strip::plan_edge(const ArmLink& link, const Quad& own, Plan& plan) const {
  const Quad other = quad_of(sites_[link.to]);
  const unsigned tried = whole_lines_ ? 1 : variants(link.arrival());
  for (unsigned variant = 0; variant < tried; ++variant) {
    const Route route = route_of(link, variant, own, other);
    if (!route.fits() || route.top() > (link.runs_right() ? top_right_ : top_left_)) continue;
    Piece piece = route.middle();
    if (whole_lines_) piece = strips::whole_line(piece.line);
    if (!lines_.is_free(piece)) continue;
    plan.edges[plan.count] = link.edge;
    plan.variants[plan.count] = static_cast<std::uint8_t>(variant);
    plan.pieces[plan.count++] = piece;
    return true;
  }
  return false;
}

/// Prefetches the line of variant 0, which is mostly the one that is taken.
void Strip::prefetch_line(const ArmLink& link, const Quad& own) const {
  lines_.prefetch(route_of(link, 0, own, quad_of(sites_[link.to])).middle().line);
}

bool Strip::make_plan(Vertex v, Site site, Plan& plan) const {
  if (!free_.is_free(site)) return false;
  const std::array<ArmLink, 3>& links = links_->at[v];
  const Quad own = quad_of(site);
  for (const ArmLink& link : links) {
    if (link.is_set() && is_placed(link.to)) prefetch_line(link, own);
  }
  for (const ArmLink& link : links) {
    if (link.is_set() && is_placed(link.to) && !plan_edge(link, own, plan)) return false;
  }
  return true;
}

bool Strip::fits(Vertex v, Site site) {
  erase_leaving();
  Plan plan;
  return make_plan(v, site, plan);
}

bool Strip::try_place(Vertex v, Site site) {
  Plan plan;
  erase_leaving();
  if (!make_plan(v, site, plan)) return false;
  sites_[v] = site;
  free_.flip(site);
  for (std::size_t i = 0; i < plan.count; ++i) {
    lines_.insert(plan.pieces[i]);
    variant_[plan.edges[i]] = plan.variants[i];
  }
  return true;
}

void Strip::erase_leaving() {
  for (const Piece& piece : leaving_) lines_.erase(piece);
  leaving_.clear();
}

void Strip::remove(Vertex v) {
  expect(!whole_lines_, "vertices are removed only where edges take pieces");
  erase_leaving();
  const Quad own = quad_of(sites_[v]);
  for (const ArmLink& link : links_->at[v]) {
    if (!link.is_set() || !is_placed(link.to)) continue;
    const Route route = route_of(link, variant_[link.edge], own, quad_of(sites_[link.to]));
    leaving_.push_back(route.middle());
    lines_.prefetch(leaving_.back().line);
  }
  free_.flip(sites_[v]);
  sites_[v] = {};
}

void Strip::prefetch_neighbours(Vertex v) const {
  for (const ArmLink& link : links_->at[v]) {
    if (link.is_set()) __builtin_prefetch(&sites_[link.to]);
  }
}

void Strip::prefetch_edges_of_neighbours(Vertex v) const {
  for (const ArmLink& link : links_->at[v]) {
    if (link.is_set()) __builtin_prefetch(&links_->at[link.to]);
  }
}

void Strip::prefetch_removal_of_neighbours(Vertex v) const {
  for (const ArmLink& link : links_->at[v]) {
    if (!link.is_set()) continue;
    for (const ArmLink& next : links_->at[link.to]) {
      if (!next.is_set()) continue;
      __builtin_prefetch(&sites_[next.to]);
      __builtin_prefetch(&variant_[next.edge]);
    }
  }
}

// The occupied cells of a strip: rule (d) of Lemma D.6. A random row is often taken; the next free
// one costs a look at a word or two, where another random one would cost all that comes before it.
// Cost: O(1 + rows / 64) per question.

FreePlaces::FreePlaces(std::int32_t columns, std::int32_t rows)
    : columns_(static_cast<std::size_t>(columns)),
      rows_(static_cast<std::size_t>(rows)),
      words_(3 * columns_ * rows_ / 64 + 1, ~std::uint64_t{0}) {}

std::int32_t FreePlaces::next_row(Site site, std::int32_t last) const {
  const std::size_t first = bit_of(site);
  const std::size_t end = first + static_cast<std::size_t>(last - site.row) + 1;
  for (std::size_t bit = first; bit < end; bit = (bit / 64 + 1) * 64) {
    const std::uint64_t rest = words_[bit / 64] >> (bit % 64);
    if (rest == 0) continue;
    const std::size_t found = bit + static_cast<std::size_t>(std::countr_zero(rest));
    if (found >= end) break;
    return site.row + static_cast<std::int32_t>(found - first);
  }
  return last + 1;
}

}  // namespace ar3d::compact_120
