// Where misses pass limits: predicted by the condition, and seen.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/report/plot.h"
#include "ar3d/analysis/report/precision.h"

namespace ar3d::report {
namespace {

constexpr std::size_t kMostSentences = 40;

std::string limit_text(double log_limit) {
  return log_limit == 0 ? "1" : fmt::format("10<sup>{}</sup>", static_cast<int>(log_limit));
}

/// "n = 120", "n beyond 1,024", "the least n, 16".
std::string place(double log_n, const Onset& onset) {
  const auto whole = [](double log) { return grouped(std::llround(std::pow(10, log))); };
  if (std::isfinite(log_n)) return "n = " + whole(log_n);
  return log_n > 0 ? "n beyond " + whole(onset.log_last) : "the least n, " + whole(onset.log_first);
}

const char* word(OnsetVerdict verdict) {
  switch (verdict) {
    case OnsetVerdict::confirmed:
      return "<span class=pass>confirmed</span>";
    case OnsetVerdict::refuted:
      return "<b class=violated>refuted</b>";
    case OnsetVerdict::open:
      break;
  }
  return "<span class=incomplete>open</span>";
}

std::string kappa_text(double log_kappa) {
  return std::isnan(log_kappa) ? "–" : fmt::format("{:.2g}", std::pow(10, log_kappa));
}

/// "double passes 10⁻⁹ degrees on cycle at n = 200; predicted at n = 180: confirmed." Why one is
/// refuted is what its κ says.
std::string sentence(const RealRows& real, const Onset& onset) {
  const std::string why =
      onset.verdict == OnsetVerdict::refuted
          ? fmt::format(" κ is {} there, and {} in the family's drawings in the widest type.",
                        kappa_text(onset.log_kappa_seen), kappa_text(onset.log_kappa))
          : "";
  return fmt::format("<li>{} passes {} degrees on {} at {}; predicted at {}: {}.{}</li>\n",
                     escape(real.settings[onset.setting].name), limit_text(onset.log_limit),
                     escape(onset.family), place(onset.log_seen, onset),
                     place(onset.log_predicted, onset), word(onset.verdict), why);
}

/// The diagonal, and a line a factor of 2 above and below it.
std::string diagonal_svg(const PlotFrame& frame, double low, double high, NamedPlot& plot) {
  std::string svg;
  for (const int step : {-1, 0, 1}) {
    const double shift = step * std::log10(2.0);
    const double from = std::max(low, low - shift), to = std::min(high, high - shift);
    svg += fmt::format("<polyline class='{}' points='{}{}'/>", step == 0 ? "bound" : "front",
                       frame.point(from, from + shift), frame.point(to, to + shift));
    const char* name = step == 0 ? "as predicted" : step > 0 ? "twice" : "half";
    for (const double x : {from, to}) {
      plot.csv += csv_line(name, "dashed", x, x + shift);
    }
  }
  return svg;
}

NamedPlot onset_plot(const RealRows& real, const std::vector<Onset>& all) {
  NamedPlot plot{"onsets", "Where misses pass a limit: predicted and seen",
                 "one point per family, type and limit; dashed: equal, twice and half"};
  plot.x = "predicted n";
  plot.y = "seen n";
  LogRange range;
  const auto is_inside = [](const Onset& onset) {
    return std::isfinite(onset.log_predicted) && std::isfinite(onset.log_seen);
  };
  for (const Onset& onset : all) {
    if (!is_inside(onset)) continue;
    range.include(onset.log_predicted);
    range.include(onset.log_seen);
  }
  if (range.empty()) return plot;
  PlotFrame frame = frame_of(range, range, TickStyle::count, plot.y);
  frame.x_title = plot.x;
  std::string svg = axes_svg(frame) + diagonal_svg(frame, range.low, range.high, plot);
  std::vector<Label> labels;
  for (std::size_t setting = 0; setting < real.settings.size(); ++setting) {
    std::string dots;
    for (const Onset& onset : all) {
      if (onset.setting != setting || !is_inside(onset)) continue;
      dots += fmt::format("M{:.1f} {:.1f}h0", frame.x.pixel(onset.log_predicted),
                          frame.y.pixel(onset.log_seen));
      plot.csv +=
          csv_line(real.settings[setting].name, "point", onset.log_predicted, onset.log_seen);
    }
    if (dots.empty()) continue;
    svg += fmt::format("<path class='points {}' d='{}'/>", stroke_class(setting), dots);
    labels.push_back({kRight + 5, kTop + 8 + 14 * static_cast<double>(labels.size()),
                      real.settings[setting].name, fill_class(setting)});
  }
  plot.svg = labelled_svg(plot.title, svg, std::move(labels));
  return plot;
}

std::array<std::size_t, 3> counts_of(const std::vector<Onset>& all) {
  std::array<std::size_t, 3> counts{};
  for (const Onset& onset : all) ++counts[static_cast<std::size_t>(onset.verdict)];
  return counts;
}

/// Those of the sample family, then all that are refuted.
std::string sentences(const RealRows& real, const std::vector<Onset>& all) {
  const std::string family = sample_family(real);
  std::string html = "<ul class=crossings>\n";
  std::size_t told = 0, left = 0;
  for (const bool is_sample : {true, false}) {
    for (const Onset& onset : all) {
      if ((onset.family == family) != is_sample) continue;
      if (!is_sample && onset.verdict != OnsetVerdict::refuted) continue;
      if (told == kMostSentences) {
        ++left;
        continue;
      }
      ++told;
      html += sentence(real, onset);
    }
  }
  if (left > 0) html += fmt::format("<li>… and {} more refuted ones</li>\n", left);
  return html + "</ul>";
}

std::string onset_table(const RealRows& real, const std::vector<Onset>& all) {
  std::string html =
      "<details><summary>All predictions</summary>" +
      table_head({"Family", "Type", "#Degrees", "Predicted", "Seen", "Verdict", "#κ", "#κ seen"});
  for (const Onset& onset : all) {
    html += row_head(onset.family) + cell(escape(real.settings[onset.setting].name)) +
            cell(limit_text(onset.log_limit), true) + cell(place(onset.log_predicted, onset)) +
            cell(place(onset.log_seen, onset)) + cell(word(onset.verdict)) +
            cell(kappa_text(onset.log_kappa), true) + cell(kappa_text(onset.log_kappa_seen), true) +
            "</tr>\n";
  }
  return html + "</tbody></table></div></details>\n";
}

}  // namespace

std::string onset_part(Page& page, const RealRows& real, const MissModel& model) {
  const std::vector<Onset> all = onsets(real, model);
  if (all.empty()) return "";
  const auto [confirmed, refuted, open] = counts_of(all);
  std::string html = fmt::format(
      "<h3>Where misses pass a limit</h3><p>Predicted from κ and C of the family's drawings in {} "
      "alone; seen where the median miss passes the limit, both by interpolation. Within a factor "
      "of 2 in n: {} of {} predictions; {} are refuted; {} are open, since one of the two lies "
      "beyond the sizes that were drawn.</p>\n",
      escape(real.settings[model.setting].name), confirmed, all.size(), refuted, open);
  NamedPlot plot = onset_plot(real, all);
  if (!plot.svg.empty()) html += "<div class=figures>" + page.figure(std::move(plot)) + "</div>\n";
  return html + sentences(real, all) + onset_table(real, all);
}

}  // namespace ar3d::report
