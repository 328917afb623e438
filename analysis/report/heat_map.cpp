// Families x n: the largest share of the theorem's bound that any graph uses.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "ar3d/analysis/report/axis.h"
#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/report/sections.h"

namespace ar3d::report {
namespace {

constexpr std::size_t kMostColumns = 16;

using Shares = std::map<std::int64_t, const DrawnGraph*>;

double largest(const Shares& shares) {
  double share = 0;
  for (const auto& [n, graph] : shares) share = std::max(share, graph->share());
  return share;
}

/// At most kMostColumns sizes, evenly, the first and the last among them.
std::vector<std::int64_t> columns_of(const std::vector<Shares>& rows) {
  std::set<std::int64_t> all;
  for (const Shares& shares : rows) {
    for (const auto& [n, graph] : shares) all.insert(n);
  }
  std::vector<std::int64_t> sizes(all.begin(), all.end());
  if (sizes.size() <= kMostColumns) return sizes;
  std::vector<std::int64_t> columns;
  for (std::size_t i = 0; i < kMostColumns; ++i) {
    columns.push_back(sizes[i * (sizes.size() - 1) / (kMostColumns - 1)]);
  }
  return columns;
}

std::string share_cell(Page& page, std::size_t curve, const DrawnGraph& graph) {
  const double share = graph.share();
  const int shade = std::clamp(static_cast<int>(std::floor(share * 10)), 0, 9);
  return fmt::format("<td class='h{}{}{}' data-r={} tabindex=0>{:.0f}</td>", shade,
                     share > 1 ? " violated" : "", page.is_shown(graph.row) ? " shown" : "",
                     page.point_at(curve, graph), 100 * share);
}

}  // namespace

std::map<std::int64_t, const DrawnGraph*> worst_by_size(const CurveTally& curve) {
  Shares shares;
  for (const auto& [n, size] : curve.sizes) {
    if (size.drawn == 0 || std::isnan(size.closest.share())) continue;
    const DrawnGraph*& at = shares[size.requested_n];
    if (at == nullptr || size.closest.share() > at->share()) at = &size.closest;
  }
  return shares;
}

std::string heat_map(Page& page, const Section& section) {
  std::vector<Shares> shares;
  for (const SectionCurve& curve : section.curves) shares.push_back(worst_by_size(*curve.tally));
  const std::vector<std::int64_t> columns = columns_of(shares);
  if (columns.empty()) return "";
  std::vector<std::size_t> order(shares.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return largest(shares[a]) > largest(shares[b]);
  });
  std::string html =
      "<details open><summary>Share of the theorem's bound by family and n</summary><p class=muted>"
      "Per cent, the worst graph and axis; the family that comes closest stands first. A click on "
      "an underlined number opens its drawing in 3D; on another one it shows the lines that draw "
      "it.</p><div class=scroll><table class='heat sortable'><thead><tr>"
      "<th>Family";
  for (const std::int64_t n : columns) {
    html += fmt::format("<th class=num title='n = {}'>{}", grouped(n), short_count(n));
  }
  html += "</tr></thead><tbody>\n";
  for (const std::size_t i : order) {
    const SectionCurve& curve = section.curves[i];
    html += fmt::format("<tr data-f={}><th scope=row>{}</th>", i, escape(curve.name));
    for (const std::int64_t n : columns) {
      const auto at = shares[i].find(n);
      html += at == shares[i].end() ? "<td></td>" : share_cell(page, curve.place, *at->second);
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div></details>\n";
}

}  // namespace ar3d::report
