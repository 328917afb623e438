// Speed against accuracy: time against the largest miss by type and n, and against volume by
// effort; levels of detail.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/report/plot.h"
#include "ar3d/analysis/report/precision.h"
#include "ar3d/analysis/report/settings.h"
#include "ar3d/analysis/statistics.h"

namespace ar3d::report {
namespace {

constexpr std::size_t kMostSizes = 4;  // in one figure

/// Medians of one type at one n: decimal logarithms.
struct Accuracy {
  std::size_t setting = 0;
  double log_time = kMissing;  ///< CPU time per vertex in seconds
  double log_miss = kMissing;
};

std::vector<Accuracy> accuracies(const RealRows& real, const std::string& family, std::int64_t n) {
  std::vector<Accuracy> all;
  for (std::size_t setting = 0; setting < real.settings.size(); ++setting) {
    std::vector<double> times;
    for (const RealRow& row : real.rows) {
      if (row.setting != setting || row.family != family || row.requested_n != n) continue;
      times.push_back(std::log10(row.cpu_s / static_cast<double>(row.n)));
    }
    const auto misses = median_misses(real, setting, family);
    const auto miss = misses.find(n);
    if (miss == misses.end() || !std::isfinite(miss->second)) continue;
    const Accuracy one{setting, median(std::move(times)), miss->second};
    if (std::isfinite(one.log_time)) all.push_back(one);
  }
  return all;
}

/// At most kMostSizes of the sizes, evenly, the least and the largest among them.
std::vector<std::int64_t> shown_sizes(const RealRows& real, const std::string& family) {
  std::set<std::int64_t> sizes;
  for (const RealRow& row : real.rows) {
    if (row.family == family) sizes.insert(row.requested_n);
  }
  return evenly(std::vector<std::int64_t>(sizes.begin(), sizes.end()), kMostSizes);
}

/// One algorithm's efforts at an n: time and volume over those of its first effort, logarithms.
struct EffortLine {
  std::string label;
  std::int64_t n = 0;
  std::vector<std::pair<std::string, Median>> points;  // option, ratios
};

/// Efforts of one algorithm, and all families that any of them drew.
SettingGroup group_of(const std::vector<const ComparedSetting*>& efforts) {
  SettingGroup group{efforts, {}};
  for (const ComparedSetting* setting : efforts) {
    for (const auto& [n, families] : setting->sizes) {
      for (const auto& [family, medians] : families) group.families.insert(family);
    }
  }
  return group;
}

/// At the largest n that two efforts drew; no points if there is none.
EffortLine effort_line(const std::string& algorithm, const SettingGroup& group) {
  EffortLine line{algorithm, 0, {}};
  const std::vector<std::int64_t> sizes = group.sizes();
  for (auto n = sizes.rbegin(); n != sizes.rend() && line.points.empty(); ++n) {
    const SettingGroup there = group.at(*n);
    if (there.settings.size() < 2 || there.families.empty()) continue;
    line.n = *n;
    const Median first = over(*there.settings.front(), *n, there);
    for (const ComparedSetting* setting : there.settings) {
      const Median own = over(*setting, *n, there);
      line.points.emplace_back(setting->label,
                               Median{own.volume - first.volume, kMissing, own.time - first.time});
    }
  }
  return line;
}

std::vector<EffortLine> effort_lines(const std::vector<ComparedSetting>& settings) {
  std::map<std::string, std::vector<const ComparedSetting*>> of_algorithm;
  for (const ComparedSetting& setting : settings) {
    const bool is_level = setting.label.find("level=") != std::string::npos;
    if (!is_level && setting.label.find("effort=") != std::string::npos) {
      of_algorithm[setting.algorithm].push_back(&setting);
    }
  }
  std::vector<EffortLine> lines;
  for (const auto& [algorithm, efforts] : of_algorithm) {
    EffortLine line = effort_line(algorithm, group_of(efforts));
    if (!line.points.empty()) lines.push_back(std::move(line));
  }
  return lines;
}

NamedPlot accuracy_plot(const RealRows& real) {
  const std::string family = sample_family(real);
  NamedPlot plot{
      "accuracy-against-time", "What accuracy costs",
      family +
          ": medians, a line of types for each n; dashed: nothing is faster and more accurate"};
  plot.x = "CPU time per vertex in s";
  plot.y = "largest miss in degrees";
  const std::vector<std::int64_t> sizes = shown_sizes(real, family);
  LogRange x, y;
  std::vector<std::vector<Accuracy>> all;
  for (const std::int64_t n : sizes) {
    all.push_back(accuracies(real, family, n));
    for (const Accuracy& point : all.back()) {
      x.include(point.log_time);
      y.include(point.log_miss);
    }
  }
  if (x.empty()) return plot;
  PlotFrame frame = frame_of(x, y, TickStyle::power, plot.y);
  frame.x_ticks = TickStyle::seconds;
  frame.x_title = "CPU time per vertex";
  std::string svg = axes_svg(frame), marks;
  std::vector<Label> labels;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    std::vector<std::pair<double, double>> points;
    for (const Accuracy& one : all[i]) points.emplace_back(one.log_time, one.log_miss);
    const auto front = front_of(std::move(points));
    svg += front_svg(front, frame);
    for (const auto& [x, y] : front) {
      plot.csv += csv_line(fmt::format("front at n = {}", sizes[i]), "line", x, y);
    }
    for (const Accuracy& point : all[i]) {
      const double px = frame.x.pixel(point.log_time), py = frame.y.pixel(point.log_miss);
      marks += bend_mark(2, px, py, fill_class(point.setting));
      plot.csv += csv_line(fmt::format("{} at n = {}", real.settings[point.setting].name, sizes[i]),
                           "point", point.log_time, point.log_miss);
      if (i + 1 == sizes.size()) {
        labels.push_back(
            {kRight + 5, py + 4, real.settings[point.setting].name, fill_class(point.setting)});
      }
    }
    if (all[i].empty()) continue;
    labels.push_back({frame.x.pixel(all[i].front().log_time) + 7,
                      frame.y.pixel(all[i].front().log_miss) - 7, "n = " + grouped(sizes[i]),
                      "of-n"});
  }
  plot.svg = labelled_svg(plot.title, svg + marks, std::move(labels), kTop + 26);
  return plot;
}

NamedPlot effort_plot(const std::vector<Section>& sections) {
  const std::vector<ComparedSetting> settings = settings_of(sections);
  const std::vector<EffortLine> lines = effort_lines(settings);
  NamedPlot plot{"effort", "What effort buys",
                 "time and volume over those of the algorithm's first effort, at its largest n"};
  plot.x = "times the drawing time";
  plot.y = "times the volume";
  LogRange x, y;
  for (const EffortLine& line : lines) {
    for (const auto& [label, ratios] : line.points) {
      x.include(ratios.time);
      y.include(ratios.volume);
    }
  }
  if (x.empty() || y.empty()) return plot;
  PlotFrame frame = frame_of(x, y, TickStyle::power, plot.y);
  frame.x_ticks = frame.y_ticks = TickStyle::count;
  frame.x_title = plot.x;
  std::string svg = axes_svg(frame);
  std::vector<Label> labels;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::string points, marks;
    for (const auto& [label, ratios] : lines[i].points) {
      if (std::isnan(ratios.time)) continue;
      points += frame.point(ratios.time, ratios.volume);
      const double px = frame.x.pixel(ratios.time), py = frame.y.pixel(ratios.volume);
      marks += bend_mark(2, px, py, fill_class(i));
      labels.push_back({px + 7, py - 4, label.substr(label.find('=') + 1, 1), fill_class(i)});
      plot.csv += csv_line(label, "point", ratios.time, ratios.volume);
    }
    svg +=
        fmt::format("<polyline class='median {}' points='{}'/>", stroke_class(i), points) + marks;
    labels.push_back({kRight + 5, kTop + 12 + 14 * static_cast<double>(i),
                      fmt::format("{}, n = {}", lines[i].label, grouped(lines[i].n)),
                      fill_class(i)});
  }
  plot.svg = labelled_svg(plot.title, svg, std::move(labels));
  return plot;
}

/// Median with the range of 10 to 90 %, in grey, as a table's cell.
std::string time_cell(const std::vector<double>& seconds) {
  const double middle = median(seconds);
  if (std::isnan(middle)) return cell("–", true);
  return cell(fmt::format("{} <small>{} – {}</small>", duration(middle),
                          duration(quantile(seconds, 0.1)), duration(quantile(seconds, 0.9))),
              true);
}

std::string bytes_cell(const std::vector<double>& bytes) {
  const double middle = median(bytes);
  return cell(std::isnan(middle) ? "–" : fmt::format("{:.0f}", middle), true);
}

std::string model_sentence(const RealRows& real, const MissModel& model) {
  if (model.drawings == 0) return "";
  const auto kappa = [&](std::size_t i) { return std::pow(10, model.log_kappa.at(i)); };
  return fmt::format(
      "<p>A coordinate rounded to p bits turns an angle by about κ 2<sup>−p</sup> C radians, C "
      "being the drawing's condition. From {} drawings in {}: κ has the median {:.2g}, and eight "
      "in ten lie between {:.2g} and {:.2g}. What the other types miss is predicted with "
      "these.</p>\n",
      model.drawings, escape(real.settings[model.setting].name), kappa(1), kappa(0), kappa(2));
}

std::string real_part(Page& page, const RealRows& real) {
  if (real.rows.empty()) return "";
  const MissModel model = miss_model(real);
  const auto broken = std::count_if(real.rows.begin(), real.rows.end(),
                                    [](const RealRow& row) { return row.is_broken; });
  std::string html = fmt::format(
      "<p>{} drawings in real types, judged without tolerance: their coordinates are dyadic "
      "rationals, every inner product and every decision is exact. {} of them are broken, by a "
      "crossing or a segment of length zero.{}</p>\n",
      grouped(static_cast<std::int64_t>(real.rows.size())), broken,
      real.left_out == 0 ? "" : fmt::format(" {} more rows were left out.", real.left_out));
  html += model_sentence(real, model);
  html += "<div class=figures>" + miss_figures(page, real, model);
  NamedPlot accuracy = accuracy_plot(real);
  if (!accuracy.svg.empty()) html += page.figure(std::move(accuracy));
  return html + "</div>\n" + onset_part(page, real, model) + share_table(real) +
         miss_table(real, model);
}

std::string certificate_table(const PrecisionRows& rows) {
  std::set<std::string> modes;
  for (const auto& [key, judged] : rows.judgements) modes.insert(key.certificate);
  modes.erase("measured");
  if (modes.empty() || (modes.size() == 1 && modes.contains("exact"))) return "";
  std::string html =
      "<h3>Certificate modes</h3><p>Only <code>exact</code> proves. Wall time of judging and "
      "measuring a drawing; median, and (grey) from 10 to 90 %.</p>" +
      table_head({"Algorithm", "#n", "Certificate", "#Rows", "#Violated", "#Time per vertex"});
  for (const auto& [key, judged] : rows.judgements) {
    if (key.certificate == "measured") continue;
    html += row_head(key.algorithm) + cell(grouped(key.n), true) + cell(escape(key.certificate)) +
            cell(fmt::format("{}", judged.rows), true) +
            cell(fmt::format("{}", judged.violated), true) + time_cell(judged.certify_s) +
            "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string level_table(const PrecisionRows& rows) {
  std::map<std::pair<std::string, std::int64_t>, std::set<std::string>> levels;
  for (const auto& [key, judged] : rows.judgements) {
    levels[{key.algorithm, key.n}].insert(key.level);
  }
  std::string body;
  for (const auto& [key, judged] : rows.judgements) {
    if (levels[{key.algorithm, key.n}].size() < 2) continue;
    body += row_head(key.algorithm) + cell(grouped(key.n), true) + cell(escape(key.level)) +
            cell(fmt::format("{}", judged.rows), true) + time_cell(judged.draw_s) +
            time_cell(judged.store_s) + time_cell(judged.certify_s) +
            bytes_cell(judged.peak_bytes) + "</tr>\n";
  }
  if (body.empty()) return "";
  return "<h3>Levels of detail</h3><p>What a row stores of its drawing: nothing, positions, all "
         "bends. Times per vertex (drawing in CPU time), medians and (grey) from 10 to 90 %; "
         "memory is the peak beyond what was resident when the row began, where the row had a "
         "process or a measurement of its own.</p>" +
         table_head({"Algorithm", "#n", "Level", "#Rows", "#Drawing", "#Storing", "#Certifying",
                     "#Bytes per vertex"}) +
         body + "</tbody></table></div>\n";
}

}  // namespace

std::string precision_section(Page& page, const std::vector<Section>& sections) {
  const PrecisionRows rows = precision_rows(page.analysis);
  std::string html = real_part(page, rows.real) + certificate_table(rows) + level_table(rows);
  if (html.empty()) return "";
  NamedPlot effort = effort_plot(sections);
  if (!effort.svg.empty()) {
    html += "<h3>Effort</h3><div class=figures>" + page.figure(std::move(effort)) + "</div>\n";
  }
  return "<section id=precision><h2>What does accuracy cost?</h2>\n" + html + "</section>\n";
}

}  // namespace ar3d::report
