// One setting: its bounds by family, the share of the theorem's bound by family and n, its growth.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/report/plot.h"
#include "ar3d/analysis/report/sections.h"

namespace ar3d::report {
namespace {

/// Tables of more rows than this are folded.
constexpr std::size_t kMostOpenRows = 80;
const char* details(const std::vector<SectionCurve>& rows) {
  return rows.size() <= kMostOpenRows ? "<details open>" : "<details>";
}

/// "93.1 % · 88.0 %": the worst and the median share of the bound.
std::string fill(double worst_slack, double median_slack) {
  if (std::isnan(worst_slack)) return "–";
  const std::string worst = percent(1 - worst_slack);
  return fmt::format("{} <small>· {}</small>",
                     worst_slack < 0 ? "<b class=violated>" + worst + "</b>" : worst,
                     percent(1 - median_slack));
}

/// The smallest slack over the axes.
double worst_of(const BoundsEntry& entry, double AxisBounds::*slack) {
  double worst = kMissing;
  for (const AxisBounds& axis : entry.axes) worst = std::fmin(worst, axis.*slack);
  return worst;
}

/// "120 ok, 3 timeout": every status that occurs.
std::string statuses(const BoundsEntry& entry) {
  std::string text;
  for (std::size_t i = 0; i < entry.rows_of_status.size(); ++i) {
    if (entry.rows_of_status[i] == 0) continue;
    std::string name = to_string(static_cast<RunStatus>(i));
    std::replace(name.begin(), name.end(), '_', ' ');
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", entry.rows_of_status[i], name);
  }
  return text;
}

std::string bounds_row(Page& page, const SectionCurve& curve, std::size_t index) {
  const BoundsEntry& entry = *curve.bounds;
  std::string html =
      fmt::format("<tr data-f={}><th scope=row>{}</th>", index, escape(curve.family));
  html += cell(grouped(entry.smallest_n) + " – " + grouped(entry.largest_n), true);
  html += cell(statuses(entry));
  html += cell(violations_text(entry.violations, entry.unproved, entry.count(RunStatus::ok),
                               entry.count(RunStatus::measured)),
               true);
  for (const AxisBounds& axis : entry.axes) {
    html += cell(fill(axis.worst_slack, axis.median_slack), true);
  }
  html += cell(percent(1 - worst_of(entry, &AxisBounds::worst_instance_slack)), true);
  html += cell(percent(1 - worst_of(entry, &AxisBounds::worst_published_slack)), true);
  const auto axis = worst_axis(entry);
  return html +
         cell(axis ? graph_button(page, curve.place, entry.axes[*axis].worst,
                                  "n = " + grouped(entry.axes[*axis].worst.n))
                   : "–") +
         "</tr>\n";
}

std::string exponent(const ScalingEntry* entry) {
  if (entry == nullptr || !entry->power.fitted) return "–";
  if (!entry->decided) return fmt::format("{:.2f} <small>undecided</small>", entry->power.exponent);
  const Interval interval = entry->power.exponent_interval;
  return fmt::format("{:.3f} <small>[{:.3f}, {:.3f}]</small>", entry->power.exponent, interval.low,
                     interval.high);
}

/// "8 of 10 sizes, n = 64 – 8,192"; why sizes were left out stands in the methods.
std::string fit_notes(const ScalingEntry& entry) {
  const auto& used = entry.sizes.used;
  if (used.empty() && entry.reason == kUntimed) return "";
  if (used.empty()) return "no finished size";
  std::string notes = fmt::format("{} of {} sizes, n = {} – {}", used.size(), entry.all.size(),
                                  grouped(used.front().n), grouped(used.back().n));
  const bool is_censored = std::any_of(entry.all.begin(), entry.all.end(),
                                       [](const SizeSample& size) { return size.censored; });
  if (is_censored) notes += "; sizes with unfinished graphs left out";
  return notes;
}

/// The label of the drawing time.
std::string time_label(const ScalingEntry* entry) {
  if (entry == nullptr) return "–";
  if (entry->reason == kUntimed) {
    return "not timed <small><code>timed_repetitions</code> in the sweep of the study times "
           "drawings</small>";
  }
  std::string html = growth_label(*entry);
  if (const Interval a = entry->law_interval; entry->growth == Growth::power) {
    html += fmt::format(", a in [{:.2f}, {:.2f}]", a.low, a.high);
  }
  html += " <small>" + escape(entry->reason);
  if (!entry->next.empty()) html += "; would decide: " + escape(entry->next);
  return html + "</small>";
}

std::string bound_sentences(const Section& section) {
  for (const SectionCurve& curve : section.curves) {
    const BoundsEntry& entry = *curve.bounds;
    if (entry.theorem_formula.empty()) continue;
    return fmt::format("<p>Theorem's box: {}.<br>Published box: {}.</p>\n",
                       escape(entry.theorem_formula),
                       entry.published_formula.empty() ? "none" : escape(entry.published_formula));
  }
  return "";
}

std::string bounds_table_html(Page& page, const Section& section) {
  std::string html =
      details(section.shown) +
      std::string(
          "<summary>Bounds table</summary><p class=muted>Share of the theorem's bound "
          "that the worst and (grey) the median graph use, by axis; then the worst share over the "
          "axes "
          "of the proof's own bound for the very graph and of the published bound. 100 % touches "
          "the "
          "bound.</p>") +
      table_head({"Family", "#n", "Rows", "#Violations", "#x", "#y", "#z", "#Own bound",
                  "#Published", "Worst graph"});
  for (std::size_t i = 0; i < section.shown.size(); ++i) {
    html += bounds_row(page, section.shown[i], i);
  }
  return html + "</tbody></table></div></details>\n";
}

std::string growth_table(const Section& section) {
  std::string html =
      details(section.shown) +
      std::string(
          "<summary>Growth, and how sure it is</summary><p class=muted>Exponent a of n^a over the "
          "fitted sizes, with its 95 % interval. Volume is the number of lattice points of the "
          "box, here also at the largest n as its share of the theorem's own box, and over what "
          "any drawing with this guarantee needs.</p>") +
      table_head({"Family", "#Longest side", "#Volume", "#Share of the theorem's",
                  "#Over the least", "#Drawing time", "Growth of the time", "Fit of the time"});
  std::size_t rows = 0;
  for (std::size_t i = 0; i < section.shown.size(); ++i) {
    const SectionCurve& curve = section.shown[i];
    const auto find = [&](Quantity quantity) {
      return curve.scaling[static_cast<std::size_t>(quantity)];
    };
    const ScalingEntry* time = find(Quantity::wall_s);
    if (find(Quantity::longest_side) == nullptr && time == nullptr) continue;
    ++rows;
    html += fmt::format("<tr data-f={}><th scope=row>{}</th>", i, escape(curve.family)) +
            cell(exponent(find(Quantity::longest_side)), true) +
            cell(exponent(find(Quantity::volume)), true) +
            cell(percent(curve.bounds->volume_share), true) +
            cell(number(curve.bounds->volume_over_least), true) + cell(exponent(time), true) +
            note(time_label(time)) +
            note(time == nullptr ? "–" : "<small>" + escape(fit_notes(*time)) + "</small>") +
            "</tr>\n";
  }
  return rows == 0 ? "" : html + "</tbody></table></div></details>\n";
}

std::string bend_figure(Page& page, const Section& section) {
  std::array<std::uint64_t, 8> bends{};
  for (const SectionCurve& curve : section.curves) {
    for (std::size_t b = 0; b < bends.size(); ++b) bends[b] += curve.bounds->bends[b];
  }
  const std::uint64_t edges = std::accumulate(bends.begin(), bends.end(), std::uint64_t{0});
  NamedPlot plot{section.label + "-bends", section.label + ": edges by bends",
                 fmt::format("share of all {} edges", grouped(static_cast<std::int64_t>(edges)))};
  plot.svg = bend_svg(bends);
  if (plot.svg.empty()) return "";
  plot.x = "bends";
  plot.y = "edges";
  for (std::size_t b = 0; b < bends.size(); ++b) {
    plot.csv += fmt::format("edges,bar,{},{},,\r\n", b, bends[b]);
  }
  return "<details><summary>Bends</summary>" + page.figure(std::move(plot)) + "</details>\n";
}

constexpr std::size_t kMostColumns = 16;

using Shares = std::map<std::int64_t, const DrawnGraph*>;

double largest(const Shares& shares) {
  double share = 0;
  for (const auto& [n, graph] : shares) share = std::max(share, graph->share());
  return share;
}

std::vector<SizeBin> columns_of(const std::vector<Shares>& rows) {
  std::set<std::int64_t> all;
  for (const Shares& shares : rows) {
    for (const auto& [n, graph] : shares) all.insert(n);
  }
  return size_bins(all, kMostColumns);
}

/// The graph with the largest share among those of the bin; null if there is none.
const DrawnGraph* closest_in(const Shares& shares, const SizeBin& bin) {
  const DrawnGraph* closest = nullptr;
  for (auto at = shares.lower_bound(bin.first); at != shares.end() && at->first <= bin.last; ++at) {
    if (closest == nullptr || at->second->share() > closest->share()) closest = at->second;
  }
  return closest;
}

std::string share_cell(Page& page, std::size_t curve, const DrawnGraph& graph) {
  const double share = graph.share();
  const int shade = std::clamp(static_cast<int>(std::floor(share * 10)), 0, 9);
  return fmt::format("<td class='h{}{}{}' data-r={} tabindex=0>{:.0f}</td>", shade,
                     share > 1 ? " violated" : "", page.is_shown(graph.row) ? " shown" : "",
                     page.point_at(curve, graph), 100 * share);
}

std::string heat_map(Page& page, const Section& section) {
  std::vector<Shares> shares;
  for (const SectionCurve& curve : section.shown) shares.push_back(worst_by_size(*curve.tally));
  const std::vector<SizeBin> columns = columns_of(shares);
  if (columns.empty()) return "";
  std::vector<std::size_t> order(shares.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return largest(shares[a]) > largest(shares[b]);
  });
  std::string html =
      details(section.shown) +
      std::string(
          "<summary>Share of the theorem's bound by family and n</summary><p "
          "class=muted>Per cent, the worst graph and axis; the family that comes closest stands "
          "first. "
          "A click on an underlined number opens its drawing in 3D; on another one it shows the "
          "lines "
          "that draw it.</p><div class=scroll><table class='heat sortable'><thead><tr><th>Family");
  for (const SizeBin& bin : columns) {
    html += fmt::format("<th class=num title='n = {}'>{}", bin.text(), short_count(bin.first));
    if (bin.first != bin.last) html += "–";
  }
  html += "</tr></thead><tbody>\n";
  for (const std::size_t i : order) {
    const SectionCurve& curve = section.shown[i];
    html += fmt::format("<tr data-f={}><th scope=row>{}</th>", i, escape(curve.name));
    for (const SizeBin& bin : columns) {
      const DrawnGraph* closest = closest_in(shares[i], bin);
      html += closest == nullptr ? "<td></td>" : share_cell(page, curve.place, *closest);
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div></details>\n";
}

}  // namespace

std::string violations_text(std::size_t violations, std::size_t unproved, std::size_t ok_rows,
                            std::size_t measured_rows) {
  const std::string rest =
      unproved == 0 ? "" : fmt::format("{} of {} not proved", unproved, ok_rows);
  if (violations > 0) {
    return fmt::format("<b class=violated>{}</b>{}{}", violations, rest.empty() ? "" : "; ", rest);
  }
  if (ok_rows == 0) return measured_rows > 0 ? "measured, not judged" : "–";
  return rest.empty() ? "<span class=pass>none</span>" : "none found, " + rest;
}

std::string row_button(std::size_t row, const std::string& text) {
  return fmt::format("<button type=button class=graph data-r={}>{}</button>", row, text);
}

std::string graph_button(Page& page, std::size_t curve, const DrawnGraph& graph,
                         const std::string& text) {
  return row_button(page.point_at(curve, graph), text);
}

std::map<std::int64_t, const DrawnGraph*> worst_by_size(const CurveTally& curve) {
  Shares shares;
  for (const auto& [n, size] : curve.sizes) {
    if (size.drawn == 0 || std::isnan(size.closest.share())) continue;
    const DrawnGraph*& at = shares[size.requested_n];
    if (at == nullptr || size.closest.share() > at->share()) at = &size.closest;
  }
  return shares;
}

std::string algorithm_section(Page& page, const Section& section, const std::string& id) {
  std::string html =
      fmt::format("<section id={} class=setting><h2>{}</h2>\n", id, escape(section.label));
  html += bound_sentences(section);
  if (section.shown.size() < section.curves.size()) {
    html += fmt::format(
        "<p class=incomplete>The {} of {} families that come closest to the bound; <code>ar3d "
        "report --csv</code> lists all.</p>\n",
        section.shown.size(), section.curves.size());
  }
  html += fmt::format(
      "<p><label class=choice>Highlight families <input type=search class=filter placeholder='part "
      "of a name' list='{}-families'></label><datalist id='{}-families'>",
      id, id);
  for (const SectionCurve& curve : section.shown) {
    html += fmt::format("<option value='{}'>", escape(curve.family));
  }
  html += "</datalist></p>\n";
  const std::string growth = growth_figures(page, section);
  const bool is_of_collections = std::all_of(section.curves.begin(), section.curves.end(),
                                             [](const auto& curve) { return curve.is_collection; });
  html +=
      is_of_collections ? "<details><summary>Growth</summary>" + growth + "</details>\n" : growth;
  html += heat_map(page, section);
  html += bounds_table_html(page, section) + growth_table(section) + bend_figure(page, section);
  return html + "</section>\n";
}

}  // namespace ar3d::report
