// What changed since the reference? The comparison of `ar3d compare`, by setting.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/report/sections.h"

namespace ar3d::report {
namespace {

constexpr std::size_t kShownCells = 60, kShownLines = 20;
constexpr std::array kVerdicts = {Verdict::violated, Verdict::regressed, Verdict::inconclusive,
                                  Verdict::unjudged, Verdict::improved,  Verdict::pass};

/// "+12.3 %" of a ratio, "× 25.4" from ten-fold on; "–" if it is missing.
std::string change(double ratio) {
  if (!std::isfinite(ratio)) return "–";
  return ratio >= 10 ? fmt::format("× {:.3g}", ratio) : fmt::format("{:+.1f} %", 100 * (ratio - 1));
}

double time_ratio(const CellComparison& cell) {
  return cell.time.test.pairs == 0 ? kMissing : std::exp(cell.time.test.estimate);
}

/// The one of two ratios that is farther from 1.
double farther(double a, double b) {
  if (!std::isfinite(a)) return b;
  return std::isfinite(b) && std::abs(std::log(b)) > std::abs(std::log(a)) ? b : a;
}

/// What all cells of one setting came to.
struct SettingChange {
  std::array<std::size_t, kVerdicts.size()> cells{};  // indexed by Verdict
  double time = kMissing, volume = kMissing;          // ratios, the one farthest from 1
};

std::map<std::string, SettingChange> changes_of(const Comparison& comparison) {
  std::map<std::string, SettingChange> settings;
  for (const CellComparison& cell : comparison.cells) {
    SettingChange& setting = settings[algorithm_label(cell.key)];
    ++setting.cells[static_cast<std::size_t>(cell.verdict)];
    setting.time = farther(setting.time, time_ratio(cell));
    setting.volume = farther(setting.volume, std::exp2(cell.log2_volume_change));
  }
  return settings;
}

std::string settings_table(const Comparison& comparison) {
  std::string html =
      "<div class=scroll><table class=sortable><thead><tr><th>Setting<th class=num>Violated"
      "<th class=num>Regressed<th class=num>Inconclusive<th class=num>Unjudged<th "
      "class=num>Improved"
      "<th class=num>Pass<th class=num>Largest change of time<th class=num>of volume</tr></thead>"
      "<tbody>\n";
  for (const auto& [label, setting] : changes_of(comparison)) {
    html += "<tr><th scope=row>" + escape(label) + "</th>";
    for (const Verdict verdict : kVerdicts) {
      const std::size_t count = setting.cells[static_cast<std::size_t>(verdict)];
      const bool is_bad = verdict == Verdict::violated || verdict == Verdict::regressed;
      html += cell(is_bad && count > 0 ? fmt::format("<b class=violated>{}</b>", count)
                                       : fmt::format("{}", count),
                   true);
    }
    html += cell(change(setting.time), true) + cell(change(setting.volume), true) + "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string environment_list(const Comparison& comparison) {
  if (comparison.environment.empty()) return "";
  std::string html = fmt::format(
      "<p class=incomplete>The environments differ, so times are {}:</p><ul>",
      comparison.time_judged ? "judged only because that was asked for" : "shown and not judged");
  for (const EnvironmentChange& change : comparison.environment) {
    html += fmt::format("<li>{}: {} → {}</li>", escape(change.name), escape(change.base),
                        escape(change.now));
  }
  return html + "</ul>\n";
}

std::string where(const CellComparison& cell) {
  return family_label(cell.key) + (cell.n >= 0 ? fmt::format(", n = {}", cell.n) : ", all n");
}

/// The cells that are neither a plain pass nor merely unjudged, the heaviest verdicts first.
std::string cell_list(const Comparison& comparison) {
  std::string rows;
  std::size_t found = 0;
  for (const Verdict verdict : kVerdicts) {
    for (const CellComparison& cell : comparison.cells) {
      const bool is_plain = verdict == Verdict::pass || verdict == Verdict::unjudged;
      if (cell.verdict != verdict || (is_plain && cell.reason.empty())) continue;
      if (++found > kShownCells) continue;
      rows += fmt::format("<tr><td>{}</td><th scope=row>{}</th><td>{}</td>", to_string(verdict),
                          escape(algorithm_label(cell.key)), escape(where(cell))) +
              report::cell(change(time_ratio(cell)), true) +
              report::cell(change(std::exp2(cell.log2_volume_change)), true) +
              note(escape(cell.reason)) + "</tr>\n";
    }
  }
  if (found == 0) return "";
  const std::string rest =
      found > kShownCells
          ? fmt::format("<p>… and {} more; <code>ar3d compare</code> says them all.</p>",
                        found - kShownCells)
          : "";
  return fmt::format(
             "<details><summary>Where something changed ({})</summary><div class=scroll>"
             "<table class=sortable><thead><tr><th>Verdict<th>Setting<th>Graphs<th class=num>Time"
             "<th class=num>Volume<th>Why</tr></thead><tbody>\n",
             grouped(static_cast<std::int64_t>(found))) +
         rows + "</tbody></table></div>" + rest + "</details>\n";
}

std::string lines(const std::vector<std::string>& all, const char* css) {
  std::string html;
  for (std::size_t i = 0; i < std::min(kShownLines, all.size()); ++i) {
    html += fmt::format("<li class={}>{}</li>", css, escape(all[i]));
  }
  if (all.size() > kShownLines) {
    html += fmt::format("<li class={}>… and {} more</li>", css, all.size() - kShownLines);
  }
  return html.empty() ? "" : "<ul>" + html + "</ul>\n";
}

}  // namespace

std::string reference_section(const SinceReference& since) {
  std::string html = "<section id=reference><h2>What changed since the reference?</h2>";
  if (!since.comparison) {
    return html + "<p class=incomplete>Not compared: " + escape(since.why_none) +
           "</p><p class=muted><code>ar3d report RESULTS --reference FILE</code> compares with "
           "another results file of the same study.</p></section>\n";
  }
  const Comparison& comparison = *since.comparison;
  html += fmt::format(
      "<p><b>{}</b> against {} of {}: {} measurements that both hold, in {} cells.{} Judged: "
      "{}.</p>\n",
      comparison.word(), escape(since.file), escape(since.created),
      grouped(static_cast<std::int64_t>(comparison.rows)),
      grouped(static_cast<std::int64_t>(comparison.cells.size())),
      comparison.is_copy ? " The two hold the same measurements." : "",
      escape(comparison.judged()));
  return html + environment_list(comparison) + lines(comparison.incomplete, "incomplete") +
         lines(comparison.remarks, "muted") + settings_table(comparison) + cell_list(comparison) +
         "<p class=muted>NEW is this study, BASE the reference. A cell is a setting on one family "
         "at one size, or at all sizes where a "
         "size "
         "has too few pairs. The rule is that of <code>ar3d compare</code>: any change for the "
         "worse "
         "of status, certificate, bends or volume, and a slow-down that is significant. The "
         "largest "
         "change is the one farthest from none, judged or not.</p></section>\n";
}

}  // namespace ar3d::report
