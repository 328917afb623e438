// Steps O.4 and O.5 of the formula: how an edge goes on inside, and how many bends it has.
#include "ar3d/optimum/encoding.h"

namespace ar3d::optimum {

// Inside an edge one step reaches a point and one leaves it, straight on or with a right bend.
void Encoding::add_turns() {
  for (int p = 0; p < num_points(); ++p) add_turns_at(p);
}

void Encoding::add_turns_at(int at) {
  const auto p = static_cast<std::size_t>(at);
  const int inside = -is_inside_[p];
  Row out = {inside};
  Row in = {inside};
  for (std::size_t d = 0; d < num_steps(); ++d) {
    if (step_[p][d] != 0) out.push_back(step_[p][d]);
    if (into_[p][d] != 0) in.push_back(into_[p][d]);
  }
  formula_.add(out);
  formula_.add(in);
  for (const Row& some : {out, in}) {
    for (std::size_t i = 1; i < some.size(); ++i) {
      for (std::size_t j = 1; j < i; ++j) formula_.add({inside, -some[i], -some[j]});
    }
  }
  for (std::size_t d = 0; d < num_steps(); ++d) {
    Row next = {inside, -into_[p][d]};
    Row former = {inside, -step_[p][d]};
    for (std::size_t f = 0; f < num_steps(); ++f) {
      if (step_[p][f] != 0 && may_follow(d, f)) next.push_back(step_[p][f]);
      if (into_[p][f] != 0 && may_follow(f, d)) former.push_back(into_[p][f]);
      if (into_[p][d] == 0 || step_[p][f] == 0) continue;
      if (!may_follow(d, f)) formula_.add({inside, -into_[p][d], -step_[p][f]});
      const int bend = d == f ? -is_bend_[p] : is_bend_[p];
      if (may_follow(d, f)) formula_.add({inside, -into_[p][d], -step_[p][f], bend});
    }
    if (into_[p][d] != 0) formula_.add(next);
    if (step_[p][d] != 0) formula_.add(former);
  }
}

// A bend raises the counter along the edge by one, and it is at most max_bends behind the last one.
void Encoding::add_bends() {
  const std::size_t most = question_.max_bends;
  for (std::size_t p = 0; p < points_.points.size(); ++p) {
    const Row& before = bends_before_[p];
    formula_.add({-is_bend_[p], is_inside_[p]});
    for (std::size_t k = 1; k < most; ++k) formula_.add({-before[k + 1], before[k]});
    if (most > 0) formula_.add({-before[most], -is_bend_[p]});
    if (most == 0) formula_.add({-is_bend_[p]});
    for (std::size_t k = 1; k <= most; ++k) formula_.add({-before[k], is_inside_[p]});
    for (std::size_t d = 0; d < num_steps(); ++d) {
      if (step_[p][d] == 0) continue;
      add_bends_along(static_cast<int>(p), points_.neighbours[p][d], step_[p][d]);
    }
  }
}

void Encoding::add_bends_along(int from, int to, int step) {
  const std::size_t most = question_.max_bends;
  const auto p = static_cast<std::size_t>(from);
  const auto q = static_cast<std::size_t>(to);
  const Row& before = bends_before_[p];
  const Row& behind = bends_before_[q];
  const Row both = {-step, -is_inside_[p], -is_inside_[q]};
  const auto add = [&](std::initializer_list<int> rest) {
    Row clause = both;
    clause.insert(clause.end(), rest);
    formula_.add(clause);
  };
  for (std::size_t k = 1; k <= most; ++k) {
    add({-before[k], behind[k]});
    add({before[k], is_bend_[p], -behind[k]});
  }
  for (std::size_t k = 0; k < most; ++k) {
    if (k == 0) add({-is_bend_[p], behind[1]});
    if (k > 0) add({-is_bend_[p], behind[k + 1], -before[k]});
    if (k + 2 <= most) add({before[k + 1], -behind[k + 2]});
  }
  if (most > 0) formula_.add({-step, -is_vertex_[p], -is_inside_[q], -behind[1]});
}

}  // namespace ar3d::optimum
