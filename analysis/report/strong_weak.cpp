// Batches of equal drawings shared by threads or ranks: how many more drawings they make at a
// time.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/report/plot.h"
#include "ar3d/analysis/report/sections.h"
#include "ar3d/analysis/statistics.h"

namespace ar3d::report {
namespace {

constexpr std::size_t kMostNamed = 8;  // at the ends of their lines

/// One graph size of a family, drawn in batches.
struct Curve {
  std::string family;
  std::int64_t n = 0;
  std::map<std::int64_t, const BatchTally*> scales;  ///< by threads or ranks
};

struct BatchCurves {
  RunPhase phase = RunPhase::strong;
  std::string algorithm;
  std::vector<Curve> curves;
};

std::vector<BatchCurves> batches_of(const StudyTally& tally) {
  std::vector<BatchCurves> all;
  for (const auto& [key, batch] : tally.batches) {  // sorted by phase, algorithm, family, n
    if (all.empty() || all.back().phase != key.phase || all.back().algorithm != key.algorithm) {
      all.push_back({key.phase, key.algorithm, {}});
    }
    std::vector<Curve>& curves = all.back().curves;
    if (curves.empty() || curves.back().family != key.family || curves.back().n != key.n) {
      curves.push_back({key.family, key.n, {}});
    }
    curves.back().scales[key.sharers] = &batch;
  }
  return all;
}

/// How many share and their gain over one alone, as decimal logarithms.
double log_sharers(std::int64_t sharers) { return std::log10(static_cast<double>(sharers)); }
double log_gain(std::int64_t sharers, const BatchTally& scale) {
  return log_sharers(sharers) + std::log10(median(scale.efficiency));
}

const char* sharers_of(RunPhase phase) { return is_over_ranks(phase) ? "ranks" : "threads"; }
std::string counted(std::int64_t sharers, RunPhase phase) {
  if (sharers == 1) return is_over_ranks(phase) ? "1 rank" : "1 thread";
  return fmt::format("{} {}", grouped(sharers), sharers_of(phase));
}
const char* kind_of(RunPhase phase) { return is_strong(phase) ? "strong" : "weak"; }

PlotFrame frame_of(const BatchCurves& batches) {
  LogRange x, y;
  x.include(0);
  y.include(0);
  for (const Curve& curve : batches.curves) {
    for (const auto& [sharers, scale] : curve.scales) {
      x.include(log_sharers(sharers));
      y.include(log_sharers(sharers));
      y.include(log_gain(sharers, *scale));
    }
  }
  return {LogAxis(x.low, x.high, kLeft, kRight),
          LogAxis(y.low, y.high, kBottom, kTop + 12),
          TickStyle::count,
          TickStyle::count,
          sharers_of(batches.phase),
          "drawings at a time"};
}

std::string ideal_line(const BatchCurves& batches, const PlotFrame& frame) {
  std::int64_t most = 1;
  for (const Curve& curve : batches.curves) {
    most = std::max(most, curve.scales.rbegin()->first);
  }
  const double end = log_sharers(most);
  return fmt::format(
      "<polyline class='bound' points='{}{}'><title>ideal</title></polyline><g "
      "class='labels'><text x='{:.1f}' y='{:.1f}' text-anchor='end'>ideal</text></g>",
      frame.point(0, 0), frame.point(end, end), frame.x.pixel(end) - 8, frame.y.pixel(end) + 2);
}

std::string curve_svg(const Curve& curve, std::size_t colour, const PlotFrame& frame) {
  std::string line, dots;
  for (const auto& [sharers, scale] : curve.scales) {
    const double x = log_sharers(sharers), y = log_gain(sharers, *scale);
    line += frame.point(x, y);
    dots += fmt::format("M{:.1f} {:.1f}h0", frame.x.pixel(x), frame.y.pixel(y));
  }
  return fmt::format(
      "<polyline class='median {0}' points='{1}'/><path class='dots big {0}' d='{2}'/>",
      stroke_class(colour), line, dots);
}

NamedPlot plot_of(const BatchCurves& batches) {
  const std::string kind = kind_of(batches.phase);
  const std::string sharers = sharers_of(batches.phase);
  NamedPlot plot;
  plot.title = fmt::format("{}: {} scaling{}", batches.algorithm, kind,
                           is_over_ranks(batches.phase) ? " over ranks" : "");
  plot.file = plot.title;
  plot.note = is_strong(batches.phase)
                  ? fmt::format("the same drawings shared by more {}", sharers)
                  : fmt::format("as many drawings for each of the {}", sharers);
  plot.x = sharers;
  plot.y = "drawings at a time";
  const PlotFrame frame = frame_of(batches);
  std::string content = axes_svg(frame) + ideal_line(batches, frame);
  std::vector<Label> labels;
  for (std::size_t i = 0; i < batches.curves.size(); ++i) {
    const Curve& curve = batches.curves[i];
    content += curve_svg(curve, i, frame);
    const auto& [sharers_at_end, last] = *curve.scales.rbegin();
    if (i < kMostNamed) {
      labels.push_back({kRight + 5, frame.y.pixel(log_gain(sharers_at_end, *last)) + 4,
                        fmt::format("{}, n = {}", curve.family, grouped(curve.n)), fill_class(i)});
    }
    for (const auto& [number, scale] : curve.scales) {
      plot.csv += csv_line(fmt::format("{}, n = {}", curve.family, curve.n), "line",
                           log_sharers(number), log_gain(number, *scale));
    }
  }
  plot.svg = labelled_svg(plot.title + ": drawings at a time against " + sharers, content,
                          std::move(labels));
  return plot;
}

std::string table_rows(const BatchCurves& batches) {
  std::string html;
  for (const Curve& curve : batches.curves) {
    for (const auto& [sharers, scale] : curve.scales) {
      html += "<tr>" + cell(escape(batches.algorithm)) + cell(kind_of(batches.phase)) +
              cell(escape(curve.family)) + cell(grouped(curve.n), true) +
              cell(counted(sharers, batches.phase), true) +
              cell(duration(median(scale->batch_s)), true) +
              cell(duration(median(scale->ideal_s)), true) +
              cell(percent(median(scale->efficiency)), true) + "</tr>\n";
    }
  }
  return html;
}

}  // namespace

std::string strong_weak_section(Page& page) {
  const std::vector<BatchCurves> all = batches_of(page.analysis.tally);
  if (all.empty()) return "";
  std::string html =
      "<section id=strong-weak><h2>Strong and weak scaling</h2><p>Batches of equal drawings shared "
      "by threads or ranks, medians over batches. Drawings at a time: how many drawings they make "
      "in the time in which one alone makes one; ideal is their number. Efficiency is the ideal "
      "time of a batch divided by its time.</p><div class=figures>\n";
  for (const BatchCurves& batches : all) html += page.figure(plot_of(batches));
  html += "</div>" + table_head({"Algorithm", "Kind", "Family", "#n", "#Shared by", "#Batch",
                                 "#Ideal", "#Efficiency"});
  for (const BatchCurves& batches : all) html += table_rows(batches);
  return html + "</tbody></table></div></section>\n";
}

}  // namespace ar3d::report
