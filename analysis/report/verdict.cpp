// The head of the page: is everything certified, how close does anything come to a bound, and what
// changed since the reference (the comparison of `ar3d compare`, by setting)?
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

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
  std::string html = table_head({"Setting", "#Violated", "#Regressed", "#Inconclusive", "#Unjudged",
                                 "#Improved", "#Pass", "#Largest change of time", "#of volume"});
  for (const auto& [label, setting] : changes_of(comparison)) {
    html += row_head(label);
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
  const auto& changes = comparison.environment;
  const bool is_unlike = std::any_of(changes.begin(), changes.end(),
                                     [](const auto& change) { return change.differs(); });
  std::string html = fmt::format(
      "<p class=incomplete>{}, so times are {}:</p><ul>",
      is_unlike ? "The environments differ" : "The machine was busy with other work",
      comparison.time_judged ? "judged only because that was asked for" : "shown and not judged");
  for (const EnvironmentChange& change : comparison.environment) {
    html += fmt::format("<li>{}: {}{}</li>", escape(change.name), escape(change.base),
                        change.differs() ? " → " + escape(change.now) : " in both");
  }
  return html + "</ul>\n";
}

std::string where(const CellComparison& cell) {
  return family_label(cell.key) + (cell.n >= 0 ? fmt::format(", n = {}", cell.n) : ", all n");
}

/// The cells that are neither a plain pass nor merely unjudged or inconclusive, the heaviest
/// verdicts first.
std::string cell_list(const Comparison& comparison) {
  std::string rows;
  std::size_t found = 0;
  for (const Verdict verdict : kVerdicts) {
    for (const CellComparison& cell : comparison.cells) {
      const bool is_plain = verdict == Verdict::pass || verdict == Verdict::unjudged;
      if (verdict == Verdict::inconclusive || cell.verdict != verdict) continue;
      if (is_plain && cell.reason.empty()) continue;
      if (++found > kShownCells) continue;
      rows += fmt::format("<tr><td>{}</td><th scope=row>{}</th><td>{}</td>", to_string(verdict),
                          escape(algorithm_label(cell.key)), escape(where(cell))) +
              report::cell(change(time_ratio(cell)), true) +
              report::cell(change(std::exp(cell.counts.instructions)), true) +
              report::cell(change(std::exp(cell.counts.cycles)), true) +
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
  return fmt::format("<details><summary>Where something changed ({})</summary>",
                     grouped(static_cast<std::int64_t>(found))) +
         table_head({"Verdict", "Setting", "Graphs", "#Time", "#Instructions", "#Cycles", "#Volume",
                     "Why"}) +
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

constexpr const char* kAxisNames[] = {"x", "y", "z"};

std::string count_text(std::size_t count) { return grouped(static_cast<std::int64_t>(count)); }

std::string verdict_sentence(const StudyAnalysis& analysis) {
  const CheckVerdict& verdict = analysis.verdict;
  std::string css = verdict.word();
  std::transform(css.begin(), css.end(), css.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  std::string html = fmt::format(
      "<p><span class='verdict {}'>{}</span></p><p>{} rows: {} proved right and inside their "
      "bounds, {} violated, {} incomplete, {} refused (the graph lies outside the theorem)",
      css, verdict.word(), count_text(verdict.rows), count_text(verdict.proved),
      count_text(verdict.violated_rows), count_text(verdict.incomplete_rows),
      count_text(verdict.refused));
  if (verdict.unproved > 0) {
    html += fmt::format(", {} <b>not proved</b> (their certificate proves nothing{})",
                        count_text(verdict.unproved),
                        verdict.accepts_unproved ? "; the study accepts that" : "");
  }
  if (verdict.measured > 0) {
    html += fmt::format(", {} measured without a guarantee", count_text(verdict.measured));
  }
  html += ".</p>\n";
  if (verdict.rows == 0) html += "<p>Nothing was measured, so nothing is shown.</p>\n";
  return html;
}

/// Says what of very many rows the page does not show; empty if it shows all.
std::string sampling_note(const StudyTally& tally) {
  std::string html;
  if (tally.kept_graphs > 0) {
    html += fmt::format(
        "<p class=incomplete>There are sizes with more than {0} graphs: medians, bands and points "
        "of these are of {0} graphs drawn at random. Counts, verdict, extreme values and the means "
        "that are fitted are of all.</p>\n",
        grouped(static_cast<std::int64_t>(tally.kept_graphs)));
  }
  if (tally.left_out_rows > 0) {
    html += fmt::format(
        "<p class=incomplete>{} rows of further families and sizes are in the verdict, but in no "
        "table or plot.</p>\n",
        grouped(static_cast<std::int64_t>(tally.left_out_rows)));
  }
  return html;
}

std::string findings_list(Page& page) {
  const StudyAnalysis& analysis = page.analysis;
  const auto& findings = analysis.verdict.findings;
  if (findings.empty()) return "";
  std::string html = "<h3>Findings</h3><ol>";
  for (std::size_t i = 0; i < std::min(kShownFindings, findings.size()); ++i) {
    const Finding& finding = findings[i];
    html += fmt::format(
        "<li><b class={}>{}</b>: ", is_violation(finding.kind) ? "violated" : "incomplete",
        to_string(finding.kind));
    if (finding.row) {
      const std::string name = fmt::format("row {}, {}", *finding.row, escape(finding.subject));
      html += (page.point_at(*finding.row) ? row_button(*finding.row, name) : name) + ": ";
    }
    html += escape(finding.message);
    if (finding.row) html += "<br><code>" + escape(finding.command) + "</code>";
    html += "</li>\n";
  }
  html += "</ol>";
  if (analysis.verdict.all_findings > kShownFindings) {
    html += fmt::format("<p>… and {} more; <code>ar3d check</code> counts them all.</p>",
                        analysis.verdict.all_findings - kShownFindings);
  }
  return html;
}

/// "0.98–1.02" over the families' decided exponents of one quantity.
std::string exponent_range(const Section& section, Quantity quantity) {
  double low = kMissing, high = kMissing;
  std::string undecided = "–";
  for (const SectionCurve& curve : section.curves) {
    const ScalingEntry* entry = curve.scaling[static_cast<std::size_t>(quantity)];
    if (entry == nullptr) continue;
    undecided = entry->reason == kUntimed ? "not timed" : "undecided";
    if (!entry->decided) continue;
    low = std::fmin(low, entry->power.exponent);
    high = std::fmax(high, entry->power.exponent);
  }
  if (std::isnan(low)) return undecided;
  const std::string first = fmt::format("{:.2f}", low), last = fmt::format("{:.2f}", high);
  return first == last ? first : first + " – " + last;
}

/// The curve and axis of smallest slack; no curve if nothing has a bound.
struct Closest {
  const SectionCurve* curve = nullptr;
  std::size_t axis = 0;

  const AxisBounds& bounds() const { return curve->bounds->axes[axis]; }
};

Closest closest_of(const Section& section) {
  Closest closest;
  for (const SectionCurve& curve : section.curves) {
    const auto axis = worst_axis(*curve.bounds);
    if (!axis) continue;
    if (closest.curve == nullptr ||
        curve.bounds->axes[*axis].worst_slack < closest.bounds().worst_slack) {
      closest = {&curve, *axis};
    }
  }
  return closest;
}

std::string setting_row(Page& page, const Section& section, std::size_t index) {
  std::size_t instances = 0, violations = 0, unproved = 0, ok_rows = 0, measured_rows = 0;
  std::int64_t largest = 0;
  std::set<std::string> families;
  for (const SectionCurve& curve : section.curves) {
    families.insert(curve.family);
    instances += curve.bounds->instances;
    violations += curve.bounds->violations;
    unproved += curve.bounds->unproved;
    ok_rows += curve.bounds->count(RunStatus::ok);
    measured_rows += curve.bounds->count(RunStatus::measured);
    largest = std::max(largest, curve.bounds->largest_n);
  }
  const Closest closest = closest_of(section);
  std::string html =
      fmt::format("<tr><th scope=row><a href='#a{}'>{}</a></th>", index, escape(section.label));
  html += closest.curve == nullptr
              ? cell("–", true) + cell("–")
              : cell(percent(1 - closest.bounds().worst_slack), true) +
                    cell(graph_button(page, closest.curve->place, closest.bounds().worst,
                                      escape(closest.curve->name) +
                                          ", n = " + grouped(closest.bounds().worst.n)));
  return html + cell(count_text(count_families(families)), true) +
         cell(count_text(instances), true) + cell(grouped(largest), true) +
         cell(violations_text(violations, unproved, ok_rows, measured_rows), true) +
         cell(exponent_range(section, Quantity::longest_side), true) +
         cell(exponent_range(section, Quantity::volume), true) +
         cell(exponent_range(section, Quantity::wall_s), true) + "</tr>\n";
}

std::string closest_sentence(Page& page, const std::vector<Section>& sections) {
  const Section* best = nullptr;
  Closest closest;
  for (const Section& section : sections) {
    const Closest one = closest_of(section);
    if (one.curve == nullptr) continue;
    if (best == nullptr || one.bounds().worst_slack < closest.bounds().worst_slack) {
      best = &section;
      closest = one;
    }
  }
  if (best == nullptr) return "<p>No row has a bound to compare with.</p>\n";
  const DrawnGraph& graph = closest.bounds().worst;
  const std::string text = fmt::format("{} on {}, n = {}", escape(best->label),
                                       escape(closest.curve->family), grouped(graph.n));
  return fmt::format(
      "<p id=closest>The closest to a bound is {}: its {} extent is {} of {:.6g}, <b>{}</b> of "
      "what the theorem allows.</p>\n",
      graph_button(page, closest.curve->place, graph, text), kAxisNames[closest.axis],
      grouped(graph.extents[closest.axis]), graph.theorem_bound[closest.axis],
      percent(1 - closest.bounds().worst_slack));
}

std::string since_sentence(const SinceReference& since) {
  if (!since.comparison) return "";
  const Comparison& comparison = *since.comparison;
  return fmt::format(
      "<p id=since>Since the reference <a href='#reference'>{}</a>: <b>{}</b>; judged: {}.</p>\n",
      escape(since.file), comparison.word(), escape(comparison.judged()));
}

}  // namespace

std::string verdict_section(Page& page, const std::vector<Section>& sections,
                            const SinceReference& since) {
  const StudyAnalysis& analysis = page.analysis;
  const StudyIdentity& study = *analysis.rows.identity;
  return fmt::format("<h1>3D drawings: {}</h1>\n<p class=\"muted wrap\">{} · program {}{}</p>\n",
                     escape(study.study_id), escape(study.created), escape(study.source_hash),
                     study.dirty ? " <b class=incomplete>with uncommitted changes</b>" : "") +
         verdict_sentence(analysis) + (sections.empty() ? "" : closest_sentence(page, sections)) +
         since_sentence(since) + sampling_note(analysis.tally) + findings_list(page);
}

std::string closeness_section(Page& page, const std::vector<Section>& sections) {
  if (sections.empty()) return "";
  std::string html =
      "<section id=closeness><h2>How close does anything come to a bound?</h2>" +
      table_head({"Setting", "#Share", "Closest graph", "#Families", "#Graphs", "#Largest n",
                  "#Violations", "#Side ~ n^a", "#Volume ~ n^a", "#Time ~ n^a"});
  for (std::size_t i = 0; i < sections.size(); ++i) html += setting_row(page, sections[i], i);
  return html +
         "</tbody></table></div><p class=muted>Share of the theorem's bound: the largest over "
         "axes, families and sizes; 100 % would touch the theorem's. Exponents: the range over the "
         "families.</p></section>\n";
}

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
         "at one size, or at all sizes where a size has too few pairs. The rule is that of "
         "<code>ar3d compare</code>: any change for the worse of status, certificate, bends or "
         "volume, and a slow-down that is significant. The largest change is the one farthest from "
         "none, judged or not.</p></section>\n";
}

}  // namespace ar3d::report
