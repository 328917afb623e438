// What settings trade: volume against n, where one algorithm begins to need less than another, and
// volume against drawing time at one n.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/report/plot.h"
#include "ar3d/analysis/report/settings.h"

namespace ar3d::report {
namespace {

constexpr std::size_t kMostCrossings = 8;  // told in words
constexpr std::size_t kFewestGraphs = 8;   // on either side of a crossing

struct VolumeLine {
  const ComparedSetting* setting = nullptr;
  std::vector<std::pair<double, double>> points;  // log n, log volume - order * log n
};

/// At each n over the families that all settings with this n drew there.
std::vector<VolumeLine> volume_lines(const SettingGroup& group, double order) {
  std::vector<VolumeLine> lines;
  for (const ComparedSetting* setting : group.settings) lines.push_back({setting, {}});
  for (const std::int64_t n : group.sizes()) {
    const SettingGroup there = group.at(n);
    if (there.families.empty()) continue;
    for (VolumeLine& line : lines) {
      if (!line.setting->sizes.contains(n)) continue;
      const double volume = over(*line.setting, n, there).volume;
      if (std::isnan(volume)) continue;
      line.points.emplace_back(log10_of(n), volume - order * log10_of(n));
    }
  }
  std::erase_if(lines, [](const VolumeLine& line) { return line.points.empty(); });
  return lines;
}

/// Where line `a` falls below line `b` for good within their common sizes.
struct Crossing {
  const VolumeLine* below = nullptr;
  const VolumeLine* above = nullptr;
  double log_n = 0, value = 0;
  std::size_t graphs = 0, smaller = 0;  // beyond it, that both drew; of them with less volume
};

/// Counts the graphs on either side. True if they bear the crossing out: enough of them, most of
/// those beyond it with less volume, and most of the others without.
bool is_borne_out(const SettingGroup& group, Crossing& crossing) {
  std::size_t before = 0, smaller_before = 0;
  for (const PairedGraph& graph :
       paired_graphs(*crossing.below->setting, *crossing.above->setting, group)) {
    const bool is_beyond = graph.log_n > crossing.log_n;
    ++(is_beyond ? crossing.graphs : before);
    (is_beyond ? crossing.smaller : smaller_before) += graph.log_ratio < 0;
  }
  return std::min(before, crossing.graphs) >= kFewestGraphs &&
         10 * crossing.smaller >= 9 * crossing.graphs && 2 * smaller_before < before;
}

void add_crossing(const VolumeLine& a, const VolumeLine& b, std::vector<Crossing>& crossings) {
  std::map<double, double> other(b.points.begin(), b.points.end());
  double last_n = kMissing, last_gap = kMissing, last_value = kMissing;
  Crossing found;
  for (const auto& [log_n, value] : a.points) {
    const auto at = other.find(log_n);
    if (at == other.end()) continue;
    const double gap = value - at->second;
    if (!std::isnan(last_gap) && (gap < 0) != (last_gap < 0) && gap != last_gap) {
      const double part = last_gap / (last_gap - gap);
      found = {gap < 0 ? &a : &b, gap < 0 ? &b : &a, last_n + part * (log_n - last_n),
               last_value + part * (value - last_value)};
    }
    last_n = log_n, last_gap = gap, last_value = value;
  }
  if (found.below != nullptr) crossings.push_back(found);
}

/// The last crossing of every two lines of different algorithms that the graphs bear out.
std::vector<Crossing> crossings_of(const SettingGroup& group,
                                   const std::vector<VolumeLine>& lines) {
  std::vector<Crossing> crossings;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (lines[i].setting->algorithm == lines[j].setting->algorithm) continue;
      add_crossing(lines[i], lines[j], crossings);
    }
  }
  std::erase_if(crossings, [&](Crossing& crossing) { return !is_borne_out(group, crossing); });
  std::sort(crossings.begin(), crossings.end(),
            [](const Crossing& a, const Crossing& b) { return a.log_n < b.log_n; });
  return crossings;
}

std::string crossing_sentences(const std::vector<Crossing>& crossings) {
  if (crossings.empty()) return "";
  std::string html = "<ul class=crossings>";
  for (std::size_t i = 0; i < std::min(kMostCrossings, crossings.size()); ++i) {
    const Crossing& crossing = crossings[i];
    html += fmt::format(
        "<li>{} needs less volume than {} from about n = {} on (there {} of {} graphs "
        "that both drew)</li>",
        escape(crossing.below->setting->label), escape(crossing.above->setting->label),
        grouped(std::llround(std::pow(10, crossing.log_n))), crossing.smaller, crossing.graphs);
  }
  return html + "</ul>";
}

std::string unit_of(const SettingGroup& group) {
  return group.is_relative ? "cubes of the smallest vertex distance" : "lattice points";
}

NamedPlot plot_of(const SettingGroup& group, const std::vector<VolumeLine>& lines, double order) {
  const std::string divisor = fmt::format("n^{:.3g}", order);
  NamedPlot plot{
      "volume", "Volume against n",
      fmt::format("in {}, divided by {}; medians over {}", unit_of(group), divisor, group.text())};
  plot.x = "vertices n";
  plot.y = "volume / " + divisor;
  LogRange x, y;
  for (const VolumeLine& line : lines) {
    for (const auto& [log_n, value] : line.points) {
      x.include(log_n);
      y.include(value);
    }
  }
  const PlotFrame frame = frame_of(x, y, TickStyle::power, plot.y);
  std::string svg = axes_svg(frame);
  std::vector<Label> labels;
  for (const VolumeLine& line : lines) {
    std::string points;
    for (const auto& [log_n, value] : line.points) {
      points += frame.point(log_n, value);
      plot.csv += csv_line(line.setting->label, "line", log_n, value);
    }
    svg += fmt::format("<polyline class='median {}' points='{}'/>",
                       stroke_class(line.setting->colour), points);
    labels.push_back({kRight + 5, frame.y.pixel(line.points.back().second) + 4, line.setting->label,
                      fill_class(line.setting->colour)});
  }
  const std::vector<Crossing> crossings = crossings_of(group, lines);
  for (const Crossing& crossing : crossings) {
    svg += fmt::format("<circle class='crossing' cx='{:.1f}' cy='{:.1f}' r='4'/>",
                       frame.x.pixel(crossing.log_n), frame.y.pixel(crossing.value));
    plot.csv +=
        csv_line(crossing.below->setting->label + " below " + crossing.above->setting->label,
                 "point", crossing.log_n, crossing.value);
  }
  plot.svg = labelled_svg(plot.title, svg, std::move(labels));
  plot.legend = crossing_sentences(crossings);
  return plot;
}

/// The setting's volumes against n as lines, divided by n^order, with the last crossing of every
/// two algorithms; no svg if fewer than two settings have a size in common.
NamedPlot volume_plot(const SettingGroup& group, double order) {
  const std::vector<VolumeLine> lines = volume_lines(group, order);
  return lines.size() < 2 ? NamedPlot{} : plot_of(group, lines, order);
}

constexpr std::size_t kMostChoices = 16;  // of n

std::string bend_legend(const std::vector<const ComparedSetting*>& settings) {
  std::set<std::size_t> kinds;
  for (const ComparedSetting* setting : settings) {
    kinds.insert(setting->bends == 0 ? 0 : std::clamp<std::size_t>(setting->bends, 2, 6));
  }
  std::string html = "<div class=legend>";
  for (const std::size_t bends : kinds) {
    html +=
        fmt::format("<span><svg viewBox='0 0 12 12' class=key aria-hidden=true>{}</svg>{}</span>",
                    bend_mark(bends, 6, 6, "mark"),
                    bends == 0 ? "straight edges"
                               : fmt::format("{}{} bends per edge", bends < 6 ? "at most " : "",
                                             bends < 6 ? std::to_string(bends) : "more"));
  }
  return html + "<span>line: nothing is smaller and faster</span></div>";
}

/// Volume against time at one requested n; no svg if fewer than two settings can be compared.
NamedPlot trade_plot(const SettingGroup& group, std::int64_t n) {
  const SettingGroup there = group.at(n);
  NamedPlot plot{fmt::format("trade-n-{}", n),
                 fmt::format("Volume against drawing time, n = {}", grouped(n)),
                 "medians over " + there.text()};
  LogRange x, y;
  std::vector<Median> points;
  if (there.families.empty() || there.settings.size() < 2) return plot;
  for (const ComparedSetting* setting : there.settings) {
    points.push_back(over(*setting, n, there));
    if (std::isnan(points.back().volume)) points.back().time = kMissing;  // no point
    x.include(points.back().time);
    y.include(points.back().volume);
  }
  if (x.empty()) return plot;
  plot.x = "drawing time in s";
  plot.y = "volume in " + unit_of(group);
  PlotFrame frame = frame_of(x, y, TickStyle::power, plot.y);
  frame.x_ticks = TickStyle::seconds;
  frame.x_title = "drawing time";
  std::string svg = axes_svg(frame);
  std::vector<std::pair<double, double>> timed;
  for (const Median& point : points) {
    if (!std::isnan(point.time)) timed.emplace_back(point.time, point.volume);
  }
  const auto front = front_of(std::move(timed));
  svg += front_svg(front, frame);
  for (const auto& [time, volume] : front) {
    plot.csv += csv_line("Pareto front", "line", time, volume);
  }
  std::vector<Label> labels;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::isnan(points[i].time)) continue;
    const ComparedSetting& setting = *there.settings[i];
    const double px = frame.x.pixel(points[i].time), py = frame.y.pixel(points[i].volume);
    svg += bend_mark(setting.bends, px, py, fill_class(setting.colour));
    labels.push_back({px + 8, py + 4, setting.label, fill_class(setting.colour)});
    plot.csv += csv_line(setting.label, "point", points[i].time, points[i].volume);
  }
  plot.svg = labelled_svg(plot.title, svg, std::move(labels), kTop + 26);
  plot.legend = bend_legend(there.settings);
  return plot;
}

/// The plots of one group by n: at most kMostChoices, evenly, the largest n among them.
std::vector<std::pair<std::int64_t, NamedPlot>> trade_plots(const SettingGroup& group) {
  std::vector<std::pair<std::int64_t, NamedPlot>> plots;
  for (const std::int64_t n : group.sizes()) {
    NamedPlot plot = trade_plot(group, n);
    if (!plot.svg.empty()) plots.emplace_back(n, std::move(plot));
  }
  while (plots.size() > kMostChoices) {
    std::size_t i = plots.size();
    std::erase_if(plots, [&](const auto&) { return --i % 2 == 1; });
  }
  return plots;
}

/// The largest n at which most settings are compared.
std::int64_t first_shown(const SettingGroup& group,
                         const std::vector<std::pair<std::int64_t, NamedPlot>>& plots) {
  std::int64_t shown = -1;
  std::size_t most = 0;
  for (const auto& [n, plot] : plots) {
    const std::size_t compared = group.at(n).settings.size();
    if (compared >= most) shown = n;
    most = std::max(most, compared);
  }
  return shown;
}

std::string options_html(const char* id, const char* label,
                         const std::vector<std::pair<std::string, std::string>>& options,
                         const std::string& selected) {
  std::string html = fmt::format("<label class=choice>{} <select id={}>", label, id);
  for (const auto& [value, text] : options) {
    html += fmt::format("<option value={}{}>{}</option>", value,
                        value == selected ? " selected" : "", escape(text));
  }
  return html + "</select></label> ";
}

double least_order(const std::vector<Section>& sections) {
  double least = 3;
  for (const Section& section : sections) {
    if (!section.theorem) continue;
    double order = 0;
    for (const AxisBound& axis : section.theorem->axes) {
      order += axis.numerator == 0 ? 0 : axis.half_power / 2.0;
    }
    least = std::min(least, order);
  }
  return least;
}

/// Said where a program that chooses its own unit stands beside drawings on a lattice.
std::string unit_note(const std::vector<SettingGroup>& groups) {
  if (std::none_of(groups.begin(), groups.end(),
                   [](const SettingGroup& group) { return group.is_relative; })) {
    return "";
  }
  return " A program without a theorem chooses its own unit: where one is compared, all volumes "
         "are in cubes of the drawing's smallest vertex distance (log2_relative_volume).";
}

}  // namespace

std::string trade_section(Page& page, const std::vector<Section>& sections) {
  const std::vector<ComparedSetting> settings = settings_of(sections);
  const std::vector<SettingGroup> groups = groups_of(settings);
  std::vector<std::pair<std::string, std::string>> group_options, n_options;
  std::string trades, volumes;
  std::int64_t shown_n = -1;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const std::string attributes = fmt::format(" data-group={}", g);
    auto plots = trade_plots(groups[g]);
    const std::int64_t shown = first_shown(groups[g], plots);
    if (g == 0) shown_n = shown;
    group_options.emplace_back(std::to_string(g), groups[g].text());
    for (auto& [n, plot] : plots) {
      if (g == 0) n_options.emplace_back(std::to_string(n), grouped(n));
      const bool is_shown = g == 0 && n == shown;
      trades += page.figure(std::move(plot),
                            attributes + fmt::format(" data-n={}{}", n, is_shown ? "" : " hidden"));
    }
    NamedPlot volume = volume_plot(groups[g], least_order(sections));
    if (!volume.svg.empty()) {
      volumes += page.figure(std::move(volume), attributes + (g == 0 ? "" : " hidden"));
    }
  }
  if (trades.empty() && volumes.empty()) return "";
  std::string choices = options_html("trade-group", "of the", group_options, "0");
  choices += options_html("trade-n", "at n =", n_options, std::to_string(shown_n));
  return "<section id=trade><h2>What does each algorithm trade?</h2><p>Less volume costs time or "
         "bends. Medians over graphs, then over families; sizes with unfinished graphs are left "
         "out." +
         unit_note(groups) + "</p><p>" + choices + "</p><div class=figures>\n<div>" + trades +
         "</div><div>" + volumes + "</div></div></section>\n";
}

}  // namespace ar3d::report
