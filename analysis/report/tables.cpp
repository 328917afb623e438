#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ar3d/analysis/replay.h"
#include "ar3d/analysis/report/figures.h"
#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/report/plot.h"
#include "ar3d/analysis/report/sections.h"

namespace ar3d::report {
namespace {

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

template <class Values>
std::string box(const Values& values) {
  if (!(values[0] >= 0)) return "–";
  return fmt::format("{:.6g} × {:.6g} × {:.6g}", static_cast<double>(values[0]),
                     static_cast<double>(values[1]), static_cast<double>(values[2]));
}

/// The boxes of the row that comes closest to the theorem's: measured, its own bound, the
/// theorem's, the published one; and the lines that show it again.
std::string worst_instance(const BoundsEntry& entry) {
  const auto axis = worst_axis(entry);
  if (!axis) return "–";
  const DrawnGraph& graph = entry.axes[*axis].worst;
  return fmt::format(
      "<details><summary>n = {}, seed {}</summary>measured {}<br>own bound {}<br>theorem {}<br>"
      "published {}<br><code>{}</code><br><code>{}</code></details>",
      grouped(graph.n), graph.seed, box(graph.extents), box(graph.instance_bound),
      box(graph.theorem_bound), box(graph.published_bound), escape(draw_command(entry.key, graph)),
      escape(replay_command(graph.row)));
}

std::string bounds_row(const BoundsEntry& entry) {
  std::string html = fmt::format("<tr><th scope=row>{}</th>", escape(family_label(entry.key)));
  html += cell(grouped(entry.smallest_n) + " – " + grouped(entry.largest_n), true);
  html += cell(statuses(entry));
  html += cell(entry.violations == 0 ? "<span class=pass>none</span>"
                                     : fmt::format("<b class=violated>{}</b>", entry.violations),
               true);
  for (const AxisBounds& axis : entry.axes) {
    html += cell(fill(axis.worst_slack, axis.median_slack), true);
  }
  html += cell(percent(1 - worst_of(entry, &AxisBounds::worst_instance_slack)), true);
  html += cell(percent(1 - worst_of(entry, &AxisBounds::worst_published_slack)), true);
  return html + cell(worst_instance(entry)) + "</tr>\n";
}

std::string exponent(const ScalingEntry* entry) {
  if (entry == nullptr || !entry->power.fitted) return "–";
  if (!entry->decided) return fmt::format("{:.2f} <small>undecided</small>", entry->power.exponent);
  const Interval interval = entry->power.exponent_interval;
  return fmt::format("{:.3f} <small>[{:.3f}, {:.3f}]</small>", entry->power.exponent, interval.low,
                     interval.high);
}

const ScalingEntry* find_entry(const Section& section, const CurveKey& key, Quantity quantity) {
  for (const ScalingEntry* entry : section.scaling) {
    if (entry->key == key && entry->quantity == quantity) return entry;
  }
  return nullptr;
}

/// "8 of 10 sizes, n = 64 – 8,192"; why sizes were left out stands in the methods.
std::string fit_notes(const ScalingEntry& entry) {
  const auto& used = entry.sizes.used;
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
  std::string html = fmt::format("{} <small>{}", growth_label(*entry), escape(entry->reason));
  if (!entry->next.empty()) html += "; would decide: " + escape(entry->next);
  return html + "</small>";
}

}  // namespace

std::string bound_sentences(const Section& section) {
  for (const BoundsEntry* entry : section.bounds) {
    if (entry->theorem_formula.empty()) continue;
    return fmt::format(
        "<p>Theorem's box: {}.<br>Published box: {}.</p>\n", escape(entry->theorem_formula),
        entry->published_formula.empty() ? "none" : escape(entry->published_formula));
  }
  return "";
}

std::string bounds_table_html(const Section& section) {
  std::string html =
      "<h3>Bounds table</h3><p class=muted>Share of the theorem's bound that "
      "the "
      "worst and (grey) the median graph use, by axis; then the worst share over the axes of the "
      "proof's own bound for the very graph and of the published bound. 100 % touches the "
      "bound.</p><div class=scroll><table><thead><tr><th>Family<th "
      "class=num>n<th>Rows"
      "<th class=num>Violations<th class=num>x<th class=num>y<th class=num>z"
      "<th class=num>Own bound<th class=num>Published<th>Worst graph</tr></thead><tbody>\n";
  for (const BoundsEntry* entry : section.bounds) html += bounds_row(*entry);
  return html + "</tbody></table></div>\n";
}

std::string growth_table(const Section& section) {
  if (section.scaling.empty()) return "";
  std::string html =
      "<h3>Growth</h3><p class=muted>Exponent a of n^a over the fitted sizes, with its 95 % "
      "interval. Volume is the number of lattice points of the box, here also at the largest n "
      "as its share of the theorem's own box.</p><div class=scroll><table><thead><tr><th>Family"
      "<th class=num>Longest side<th class=num>Volume<th class=num>Share of the theorem's<th "
      "class=num>Drawing time<th>Growth of the time<th>Fit of the "
      "time</tr></thead><tbody>\n";
  for (const BoundsEntry* entry : section.bounds) {
    const auto find = [&](Quantity quantity) { return find_entry(section, entry->key, quantity); };
    const ScalingEntry* time = find(Quantity::wall_s);
    html += fmt::format("<tr><th scope=row>{}</th>", escape(family_label(entry->key))) +
            cell(exponent(find(Quantity::longest_side)), true) +
            cell(exponent(find(Quantity::volume)), true);
    html += cell(percent(entry->volume.share), true) + cell(exponent(time), true) +
            note(time_label(time)) +
            note(time == nullptr ? "–" : "<small>" + escape(fit_notes(*time)) + "</small>") +
            "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::array<std::uint64_t, 8> bends_of(const Section& section) {
  std::array<std::uint64_t, 8> bends{};
  for (const BoundsEntry* entry : section.bounds) {
    for (std::size_t b = 0; b < bends.size(); ++b) bends[b] += entry->bends[b];
  }
  return bends;
}

std::string bend_histogram(const Section& section) {
  const std::array<std::uint64_t, 8> bends = bends_of(section);
  const std::string svg = bend_svg(bends);
  if (svg.empty()) return "";
  return fmt::format(
      "<h3>Bends</h3><figure><figcaption><span>Share of all {} edges</span></figcaption>"
      "{}</figure>\n",
      grouped(
          static_cast<std::int64_t>(std::accumulate(bends.begin(), bends.end(), std::uint64_t{0}))),
      svg);
}

std::string effort_section(const StudyAnalysis& analysis) {
  const std::vector<NamedPlot> dials = effort_dials(analysis);
  if (dials.empty()) return "";
  std::string html =
      "<section id=effort><h2>What a smaller box costs</h2><p>Volume against drawing time, medians "
      "over graphs, one line a family; the numbers are the setting that varies.</p><div "
      "class=figures>\n";
  for (NamedPlot dial : dials) {
    dial.svg += legend_html(dial.legend, false);
    html += figure_html(dial);
  }
  return html + "</div></section>\n";
}

}  // namespace ar3d::report
