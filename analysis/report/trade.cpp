// What settings trade: volume against drawing time at one n.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/report/labels.h"
#include "ar3d/analysis/report/plot.h"
#include "ar3d/analysis/report/settings.h"

namespace ar3d::report {
namespace {

constexpr std::size_t kMostChoices = 16;  // of n

/// The front of the points that no other one beats in both volume and time, as steps.
std::string front_svg(std::vector<Median> points, const Frame& frame, std::string& csv) {
  std::erase_if(points, [](const Median& point) { return std::isnan(point.time); });
  std::sort(points.begin(), points.end(), [](const Median& a, const Median& b) {
    return std::pair(a.time, a.volume) < std::pair(b.time, b.volume);
  });
  std::string path;
  double least = std::numeric_limits<double>::infinity();
  for (const Median& point : points) {
    if (point.volume >= least) continue;
    if (!path.empty()) path += frame.point(point.time, least);
    path += frame.point(point.time, point.volume);
    least = point.volume;
    csv += csv_line("Pareto front", "line", point.time, point.volume, kMissing, kMissing);
  }
  return "<polyline class='front' points='" + path + "'/>";
}

std::string bend_legend(const std::vector<const Setting*>& settings) {
  std::set<std::size_t> kinds;
  for (const Setting* setting : settings) {
    kinds.insert(std::clamp<std::size_t>(setting->bends, 2, 6));
  }
  std::string html = "<div class=legend>";
  for (const std::size_t bends : kinds) {
    html +=
        fmt::format("<span><svg viewBox='0 0 12 12' class=key aria-hidden=true>{}</svg>{}</span>",
                    bend_mark(bends, 6, 6, "mark"),
                    bends == 2 ? "at most 2 bends per edge"
                               : fmt::format("{}{} bends per edge", bends < 6 ? "at most " : "",
                                             bends < 6 ? std::to_string(bends) : "more"));
  }
  return html + "<span>line: nothing is smaller and faster</span></div>";
}

/// Volume against time at one requested n; no svg if fewer than two settings can be compared.
NamedPlot trade_plot(const Group& group, std::int64_t n) {
  const Group there = group.at(n);
  NamedPlot plot{fmt::format("trade-n-{}", n),
                 fmt::format("Volume against drawing time, n = {}", grouped(n)),
                 "medians over " + there.text()};
  Range x, y;
  std::vector<Median> points;
  if (there.families.empty() || there.settings.size() < 2) return plot;
  for (const Setting* setting : there.settings) {
    points.push_back(over(*setting, n, there.families));
    x.include(points.back().time);
    y.include(points.back().volume);
  }
  if (x.empty()) return plot;
  plot.x = "drawing time in s";
  plot.y = "volume in lattice points";
  Frame frame = frame_of(x, y, TickStyle::power, "volume");
  frame.x_ticks = TickStyle::seconds;
  frame.x_title = "drawing time";
  std::string svg = axes_svg(frame);
  svg += front_svg(points, frame, plot.csv);
  std::vector<Label> labels;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::isnan(points[i].time)) continue;
    const Setting& setting = *there.settings[i];
    const double px = frame.x.pixel(points[i].time), py = frame.y.pixel(points[i].volume);
    svg += bend_mark(setting.bends, px, py, fill_class(setting.colour));
    labels.push_back({px + 8, py + 4, setting.label, fill_class(setting.colour)});
    plot.csv +=
        csv_line(setting.label, "point", points[i].time, points[i].volume, kMissing, kMissing);
  }
  svg += "<g class='ends'>" + labels_svg(std::move(labels), kTop + 26, kBottom) + "</g>";
  plot.svg = svg_element(plot.title, kLabelledWidth, kHeight, svg);
  plot.legend = bend_legend(there.settings);
  return plot;
}

/// The plots of one group by n: at most kMostChoices, evenly, the largest n among them.
std::vector<std::pair<std::int64_t, NamedPlot>> trade_plots(const Group& group) {
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
std::int64_t first_shown(const Group& group,
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

/// Said where drawings in decimals stand beside drawings on a lattice.
std::string unit_note(const std::vector<Section>& sections) {
  const auto is_measured = [](const SectionCurve& curve) {
    return curve.bounds->count(RunStatus::measured) > 0;
  };
  const bool is_mixed = std::any_of(sections.begin(), sections.end(), [&](const Section& section) {
    return std::any_of(section.curves.begin(), section.curves.end(), is_measured);
  });
  if (!is_mixed) return "";
  return " Volumes of programs without a guarantee are in units of the smallest vertex distance, "
         "the others in lattice points: log2_relative_volume, under All metrics, compares them.";
}

}  // namespace

std::string trade_section(Page& page, const std::vector<Section>& sections) {
  const std::vector<Setting> settings = settings_of(sections);
  const std::vector<Group> groups = groups_of(settings);
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
         unit_note(sections) + "</p><p>" + choices + "</p><div class=figures>\n<div>" + trades +
         "</div><div>" + volumes + "</div></div></section>\n";
}

}  // namespace ar3d::report
