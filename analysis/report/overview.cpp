#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

#include "ar3d/analysis/replay.h"
#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/report/sections.h"

namespace ar3d::report {
namespace {

constexpr std::size_t kShownFindings = 20;

std::string verdict_sentence(const StudyAnalysis& analysis) {
  const CheckVerdict& verdict = analysis.verdict;
  std::string css = verdict.word();
  std::transform(css.begin(), css.end(), css.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  std::string html = fmt::format(
      "<p><span class='verdict {}'>{}</span></p><p>{} rows: {} proved right and inside their "
      "bounds, {} violated, {} incomplete, {} refused (the graph lies outside the theorem).</p>\n",
      css, verdict.word(), grouped(static_cast<std::int64_t>(verdict.rows)),
      grouped(static_cast<std::int64_t>(verdict.proved)),
      grouped(static_cast<std::int64_t>(verdict.violated_rows)),
      grouped(static_cast<std::int64_t>(verdict.incomplete_rows)),
      grouped(static_cast<std::int64_t>(verdict.refused)));
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
  for (const ScalingEntry* entry : section.scaling) {
    if (entry->quantity != quantity || !entry->decided) continue;
    low = std::fmin(low, entry->power.exponent);
    high = std::fmax(high, entry->power.exponent);
  }
  if (std::isnan(low)) return "undecided";
  const std::string first = fmt::format("{:.2f}", low), last = fmt::format("{:.2f}", high);
  return first == last ? first : first + " – " + last;
}

std::string algorithm_row(const Section& section, std::size_t index) {
  std::size_t instances = 0, violations = 0;
  std::int64_t largest = 0;
  double worst = kMissing;
  for (const BoundsEntry* entry : section.bounds) {
    instances += entry->instances;
    violations += entry->violations;
    largest = std::max(largest, entry->largest_n);
    for (const AxisBounds& axis : entry->axes) worst = std::fmin(worst, axis.worst_slack);
  }
  return fmt::format("<tr><th scope=row><a href='#a{}'>{}</a></th>", index, escape(section.label)) +
         cell(std::to_string(section.bounds.size()), true) +
         cell(grouped(static_cast<std::int64_t>(instances)), true) + cell(grouped(largest), true) +
         cell(violations == 0 ? "<span class=pass>none</span>"
                              : fmt::format("<b class=violated>{}</b>", violations),
              true) +
         cell(percent(1 - worst), true) +
         cell(exponent_range(section, Quantity::longest_side), true) +
         cell(exponent_range(section, Quantity::volume), true) +
         cell(exponent_range(section, Quantity::wall_s), true) + "</tr>\n";
}

}  // namespace

std::vector<Section> sections(const StudyAnalysis& analysis) {
  std::vector<Section> sections;
  std::map<std::string, std::size_t> index_of;
  for (const BoundsEntry& entry : analysis.bounds) {
    const std::string label = algorithm_label(entry.key);
    const auto [place, is_new] = index_of.try_emplace(label, sections.size());
    if (is_new) sections.push_back({label, {}, {}});
    sections[place->second].bounds.push_back(&entry);
  }
  for (const ScalingEntry& entry : analysis.scaling) {
    sections[index_of.at(algorithm_label(entry.key))].scaling.push_back(&entry);
  }
  return sections;
}

std::string overview(const StudyAnalysis& analysis, const std::vector<Section>& sections) {
  const StudyIdentity& study = *analysis.rows.identity;
  std::string html = "<h1>3D drawings: bounds and scaling</h1>\n";
  html += fmt::format("<p class=\"muted wrap\">Study {} · {} · program {}{}</p>\n",
                      escape(study.study_id), escape(study.created), escape(study.source_hash),
                      study.dirty ? " <b class=incomplete>with uncommitted changes</b>" : "");
  html += verdict_sentence(analysis) + sampling_note(analysis.tally) + findings_list(analysis);
  if (sections.empty()) return html;
  html +=
      "<p class=muted>Fill is the largest measured share of a theorem's bound "
      "over all axes, families and sizes; 100 % would touch it. Exponents are of n, the range over "
      "the families.</p><div class=scroll><table><thead><tr><th>Algorithm<th class=num>Families<th "
      "class=num>Graphs"
      "<th class=num>Largest n<th class=num>Violations<th class=num>Fill<th class=num>Longest side"
      "<th class=num>Volume<th class=num>Time</tr></thead><tbody>\n";
  for (std::size_t i = 0; i < sections.size(); ++i) html += algorithm_row(sections[i], i);
  return html + "</tbody></table></div>\n";
}

}  // namespace ar3d::report
