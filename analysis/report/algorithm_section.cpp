#include <fmt/format.h>

#include <algorithm>

#include "ar3d/analysis/report/figures.h"
#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/report/plot.h"
#include "ar3d/analysis/report/sections.h"

namespace ar3d::report {
namespace {

constexpr std::size_t kOpenPanels = 12;  // more panels than this start folded
constexpr const char* kAxisNames[] = {"x", "y", "z"};

TickStyle tick_style(Quantity quantity) {
  if (quantity == Quantity::wall_s) return TickStyle::seconds;
  return quantity == Quantity::volume ? TickStyle::power : TickStyle::count;
}

/// The curves of one quantity. The colour of a family is its place in the bounds table, so that it
/// is the same in every plot of the section.
std::vector<Series> curves(const Section& section, Quantity quantity) {
  std::vector<Series> series;
  for (const ScalingEntry* entry : section.scaling) {
    if (entry->quantity != quantity) continue;
    const auto place = std::find_if(section.bounds.begin(), section.bounds.end(),
                                    [&](const BoundsEntry* row) { return row->key == entry->key; });
    series.push_back({family_label(entry->key), entry,
                      static_cast<std::size_t>(place - section.bounds.begin())});
  }
  return series;
}

/// The families by name; with their parameters only where two would be called the same.
std::vector<LegendEntry> legend_of(const Section& section) {
  std::vector<LegendEntry> legend;
  for (const BoundsEntry* entry : section.bounds) {
    const auto same = std::count_if(
        section.bounds.begin(), section.bounds.end(),
        [&](const BoundsEntry* other) { return other->key.family == entry->key.family; });
    legend.push_back({same == 1 ? entry->key.family : family_label(entry->key), legend.size()});
  }
  return legend;
}

std::string exponent_text(const ScalingEntry& entry) {
  if (!entry.power.fitted) return "no slope";
  if (!entry.decided) return fmt::format("n^{:.2f}, undecided", entry.power.exponent);
  return fmt::format("n^{:.2f} [{:.2f}, {:.2f}]", entry.power.exponent,
                     entry.power.exponent_interval.low, entry.power.exponent_interval.high);
}

std::string family_panel(const Section& section, const Series& one, const Frame& frame,
                         const std::string& axes) {
  const ScalingEntry& entry = *one.entry;
  const std::string title =
      fmt::format("{} of {} on {} against n", name_of(entry.quantity), section.label, one.label);
  return fmt::format(
      "<figure><figcaption><b>{}</b> <span>{}, {}; {}</span></figcaption>{}{}</figure>",
      escape(one.label), name_of(entry.quantity), unit_of(entry.quantity), exponent_text(entry),
      scaling_svg({one}, title, frame, {true, axes}),
      residual_svg(one, "residuals of the " + title, frame));
}

/// All families in one frame, so that they can be compared; its axes stand in the page once.
std::string quantity_panels(const Section& section, const std::string& id, Quantity quantity) {
  const std::vector<Series> series = curves(section, quantity);
  if (series.empty()) return "";
  const Frame frame = frame_of(series, tick_style(quantity));
  const std::string axes_id = fmt::format("{}q{}", id, static_cast<int>(quantity));
  const bool is_open = quantity == Quantity::longest_side && series.size() <= kOpenPanels;
  std::string html = fmt::format(
      "<svg class=defs aria-hidden=true><defs><g id='{}'>{}</g></defs></svg><details{}><summary>By "
      "family: {} ({} plots with residuals)</summary><div class=figures>\n",
      axes_id, axes_svg(frame), is_open ? " open" : "", name_of(quantity), series.size());
  const std::string axes = "<use href='#" + axes_id + "'/>";
  for (const Series& one : series) html += family_panel(section, one, frame, axes);
  return html + "</div></details>\n";
}

std::string closest_sentence(const Section& section) {
  const BoundsEntry* closest = nullptr;
  std::size_t axis = 0;
  for (const BoundsEntry* entry : section.bounds) {
    const auto worst = worst_axis(*entry);
    if (worst &&
        (closest == nullptr || entry->axes[*worst].worst_slack < closest->axes[axis].worst_slack)) {
      closest = entry;
      axis = *worst;
    }
  }
  if (closest == nullptr) return "";
  const DrawnGraph& graph = closest->axes[axis].worst;
  return fmt::format(
      "<p>The closest to a bound: the {} extent on {} with n = {} is {} of {:.6g}, {} of what "
      "the theorem allows.</p>\n",
      kAxisNames[axis], escape(family_label(closest->key)), grouped(graph.n),
      grouped(graph.extents[axis]), graph.theorem_bound[axis],
      percent(1 - closest->axes[axis].worst_slack));
}

std::string overview_plots(const Section& section) {
  std::string html = "<div class=figures>\n";
  for (const NamedPlot& plot : section_plots(section)) html += figure_html(plot);
  return html + "</div>\n" + legend_html(legend_of(section), true);
}

}  // namespace

std::vector<NamedPlot> section_plots(const Section& section) {
  std::vector<NamedPlot> plots;
  for (const Quantity quantity : {Quantity::longest_side, Quantity::volume, Quantity::wall_s}) {
    const std::vector<Series> series = curves(section, quantity);
    if (series.empty()) continue;
    std::string name = name_of(quantity);
    const std::string title =
        fmt::format("{} of {} against n, medians by family", name, section.label);
    const std::string note = fmt::format("{}, medians by family", unit_of(quantity));
    std::string file = name;
    std::replace(file.begin(), file.end(), ' ', '-');
    name[0] = static_cast<char>(name[0] - 'a' + 'A');
    plots.push_back({file, name, note,
                     scaling_svg(series, title, frame_of(series, tick_style(quantity)), {}),
                     legend_of(section)});
  }
  return plots;
}

std::string algorithm_section(const Section& section, const std::string& id) {
  std::string html = fmt::format("<section id={}><h2>{}</h2>\n", id, escape(section.label));
  html += closest_sentence(section) + bound_sentences(section);
  html += section.scaling.empty() ? "" : overview_plots(section);
  html += bounds_table_html(section) + growth_table(section) + bend_histogram(section);
  for (const Quantity quantity : {Quantity::longest_side, Quantity::volume, Quantity::wall_s}) {
    html += quantity_panels(section, id, quantity);
  }
  return html + "</section>\n";
}

}  // namespace ar3d::report
