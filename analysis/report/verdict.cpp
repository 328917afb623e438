// The head of the page: is everything certified, and how close does anything come to a bound?
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/report/sections.h"

namespace ar3d::report {
namespace {

constexpr std::size_t kShownFindings = 20;
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
        "of "
        "these are of {0} graphs drawn at random. Counts, verdict, extreme values and the means "
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

std::string findings_list(const StudyAnalysis& analysis) {
  const auto& findings = analysis.verdict.findings;
  if (findings.empty()) return "";
  std::string html = "<h3>Findings</h3><ol>";
  for (std::size_t i = 0; i < std::min(kShownFindings, findings.size()); ++i) {
    const Finding& finding = findings[i];
    html += fmt::format("<li><b class={}>{}</b>: {}",
                        is_violation(finding.kind) ? "violated" : "incomplete",
                        to_string(finding.kind), escape(finding.message));
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
  for (const SectionCurve& curve : section.curves) {
    const ScalingEntry* entry = curve.scaling[static_cast<std::size_t>(quantity)];
    if (entry == nullptr || !entry->decided) continue;
    low = std::fmin(low, entry->power.exponent);
    high = std::fmax(high, entry->power.exponent);
  }
  if (std::isnan(low)) return "undecided";
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
  for (const SectionCurve& curve : section.curves) {
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
  return html + cell(count_text(section.all_curves), true) + cell(count_text(instances), true) +
         cell(grouped(largest), true) +
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
         since_sentence(since) + sampling_note(analysis.tally) + findings_list(analysis);
}

std::string closeness_section(Page& page, const std::vector<Section>& sections) {
  if (sections.empty()) return "";
  std::string html =
      "<section id=closeness><h2>How close does anything come to a bound?</h2>"
      "<div class=scroll><table class=sortable><thead><tr><th>Setting<th class=num>Share"
      "<th>Closest graph<th class=num>Families<th class=num>Graphs<th class=num>Largest n"
      "<th class=num>Violations<th class=num>Side ~ n^a<th class=num>Volume ~ n^a"
      "<th class=num>Time ~ n^a</tr></thead><tbody>\n";
  for (std::size_t i = 0; i < sections.size(); ++i) html += setting_row(page, sections[i], i);
  return html +
         "</tbody></table></div><p class=muted>Share of the theorem's bound: the largest over "
         "axes, families and "
         "sizes; 100 % would touch the theorem's. Exponents: the range over the "
         "families.</p></section>\n";
}

}  // namespace ar3d::report
