#include <fmt/format.h>

#include <algorithm>

#include "ar3d/analysis/replay.h"
#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/report/plot.h"
#include "ar3d/analysis/report/sections.h"
#include "ar3d/analysis/text.h"

namespace ar3d::report {
namespace {

constexpr std::size_t kOpenPanels = 12;  // more panels than this start folded
constexpr const char* kAxisNames[] = {"x", "y", "z"};

TickStyle tick_style(Quantity quantity) {
  if (quantity == Quantity::wall_s) return TickStyle::seconds;
  return quantity == Quantity::volume ? TickStyle::power : TickStyle::count;
}

std::vector<const ScalingEntry*> of_quantity(const Section& section, Quantity quantity) {
  std::vector<const ScalingEntry*> entries;
  std::copy_if(section.scaling.begin(), section.scaling.end(), std::back_inserter(entries),
               [&](const ScalingEntry* entry) { return entry->quantity == quantity; });
  return entries;
}

/// The colour of a family is its place in the ledger, so that it is the same in every plot of the
/// section.
std::size_t colour_of(const Section& section, const CellKey& key) {
  const auto place = std::find_if(section.ledger.begin(), section.ledger.end(),
                                  [&](const LedgerEntry* entry) { return entry->key == key; });
  return static_cast<std::size_t>(place - section.ledger.begin());
}

std::string legend(const Section& section) {
  std::string html = "<div class=legend>";
  for (std::size_t i = 0; i < section.ledger.size(); ++i) {
    html += fmt::format(
        "<span><svg viewBox='0 0 26 10' aria-hidden=true><path class='median s{} d{}' "
        "d='M0 5H26'/></svg>{}</span>",
        i % 8, i / 8 % 3, escape(family_label(section.ledger[i]->key)));
  }
  return html +
         "<span><svg viewBox='0 0 26 10' aria-hidden=true><path class=bound d='M0 5H26'/></svg>"
         "theorem's bound</span></div>\n";
}

std::string exponent_text(const ScalingEntry& entry) {
  if (!entry.power.fitted) return "no slope";
  if (!entry.decided) return fmt::format("n^{:.2f}, undecided", entry.power.exponent);
  return fmt::format("n^{:.2f} [{:.2f}, {:.2f}]", entry.power.exponent,
                     entry.power.exponent_interval.low, entry.power.exponent_interval.high);
}

std::string family_panel(const Section& section, const ScalingEntry& entry) {
  const std::string family = family_label(entry.key);
  const std::string title =
      fmt::format("{} of {} on {} against n", name_of(entry.quantity), section.label, family);
  const std::string svg = scaling_svg({{family, &entry, colour_of(section, entry.key)}}, title,
                                      {true, tick_style(entry.quantity)});
  return fmt::format(
      "<figure><figcaption><b>{}</b> <span>{}, {}; {}</span></figcaption>{}</figure>",
      escape(family), name_of(entry.quantity), unit_of(entry.quantity), exponent_text(entry), svg);
}

std::string row_text(const Run& run) {
  return fmt::format("{}\n{} vertices, {} edges, seed {}\nbox {} × {} × {}\n{}",
                     family_label({"", "", run.family, run.parameters}), run.n, run.m, run.seed,
                     run.extents[0], run.extents[1], run.extents[2], duration(run.wall_s));
}

/// A JSON string that may stand in a script element: no byte of it can end the element.
std::string json_string(std::string_view text) {
  std::string json = "\"";
  for (const char c : valid_utf8(text)) {
    const auto code = static_cast<unsigned char>(c);
    const bool is_special =
        code < 0x20 || std::string_view("\"\\<>&").find(c) != std::string_view::npos;
    json += is_special ? fmt::format("\\u{:04x}", code) : std::string(1, c);
  }
  return json + "\"";
}

}  // namespace

std::string overview_plots(const Section& section) {
  std::string html = "<div class=figures>\n";
  for (const Quantity quantity : {Quantity::longest_side, Quantity::volume, Quantity::wall_s}) {
    std::vector<Series> series;
    for (const ScalingEntry* entry : of_quantity(section, quantity)) {
      series.push_back({family_label(entry->key), entry, colour_of(section, entry->key)});
    }
    const std::string title =
        fmt::format("{} of {} against n, medians by family", name_of(quantity), section.label);
    std::string name = name_of(quantity);
    name[0] = static_cast<char>(name[0] - 'a' + 'A');
    html += fmt::format(
        "<figure><figcaption><b>{}</b> <span>{}, medians by family</span>"
        "</figcaption>{}</figure>\n",
        name, unit_of(quantity), scaling_svg(series, title, {false, tick_style(quantity)}));
  }
  return html + "</div>\n" + legend(section);
}

std::string family_plots(const Section& section) {
  std::string html;
  for (const Quantity quantity : {Quantity::longest_side, Quantity::wall_s}) {
    const auto entries = of_quantity(section, quantity);
    const bool is_open = quantity == Quantity::longest_side && entries.size() <= kOpenPanels;
    html +=
        fmt::format("<details{}><summary>By family: {} ({} plots)</summary><div class=figures>\n",
                    is_open ? " open" : "", name_of(quantity), entries.size());
    for (const ScalingEntry* entry : entries) html += family_panel(section, *entry);
    html += "</div></details>\n";
  }
  return html;
}

std::string algorithm_section(const Analysis& analysis, const Section& section,
                              const std::string& id) {
  const LedgerEntry* closest = nullptr;
  std::size_t axis = 0;
  for (const LedgerEntry* entry : section.ledger) {
    const auto worst = worst_axis(*entry);
    if (worst &&
        (closest == nullptr || entry->axes[*worst].worst_slack < closest->axes[axis].worst_slack)) {
      closest = entry;
      axis = *worst;
    }
  }
  std::string html = fmt::format("<section id={}><h2>{}</h2>\n", id, escape(section.label));
  if (closest != nullptr) {
    const Run& run = analysis.results.runs[*closest->axes[axis].worst_row];
    html += fmt::format(
        "<p>The closest to a bound: the {} extent on {} with n = {} is {} of {:.6g}, {} of what "
        "the "
        "theorem allows.</p>\n",
        kAxisNames[axis], escape(family_label(closest->key)), grouped(run.n),
        grouped(run.extents[axis]), run.theorem_bound[axis],
        percent(1 - closest->axes[axis].worst_slack));
  }
  html += section.scaling.empty() ? "" : overview_plots(section);
  html += ledger_table(analysis, section) + growth_table(section) + bend_histogram(section);
  html += section.scaling.empty() ? "" : family_plots(section);
  return html + "</section>\n";
}

std::string plotted_rows_json(const Analysis& analysis) {
  std::set<std::size_t> rows;
  for (const ScalingEntry& entry : analysis.scaling) {
    if (entry.quantity != Quantity::longest_side && entry.quantity != Quantity::wall_s) continue;
    for (const SizeSample& size : entry.all) {
      for (const InstanceValue& instance : shown_points(size)) rows.insert(instance.row);
    }
  }
  std::string json = "{";
  for (const std::size_t row : rows) {
    const Run& run = analysis.results.runs[row];
    json += fmt::format("{}\"{}\":[{},{}]", json.size() > 1 ? ",\n" : "", row,
                        json_string(row_text(run)), json_string(draw_command(run)));
  }
  return json + "}";
}

}  // namespace ar3d::report
