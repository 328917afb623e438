// Speed against accuracy: real types, certificate modes, levels, efforts.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/report/precision.h"
#include "ar3d/analysis/statistics.h"

namespace ar3d::report {
namespace {

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
      "in "
      "ten lie between {:.2g} and {:.2g}. What the other types miss is predicted with these.</p>\n",
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

}  // namespace

std::string certificate_table(const PrecisionRows& rows) {
  std::set<std::string> modes;
  for (const auto& [key, judged] : rows.judgements) modes.insert(key.certificate);
  modes.erase("measured");
  if (modes.empty() || (modes.size() == 1 && modes.contains("exact"))) return "";
  std::string html =
      "<h3>Certificate modes</h3><p>Only <code>exact</code> proves. Wall time of judging and "
      "measuring a drawing; median, and (grey) from 10 to 90 %.</p><div class=scroll><table "
      "class=sortable><thead><tr><th>Algorithm<th class=num>n<th>Certificate<th class=num>Rows"
      "<th class=num>Violated<th class=num>Time per vertex</tr></thead><tbody>\n";
  for (const auto& [key, judged] : rows.judgements) {
    if (key.certificate == "measured") continue;
    html += fmt::format("<tr><th scope=row>{}</th>", escape(key.algorithm)) +
            cell(grouped(key.n), true) + cell(escape(key.certificate)) +
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
    body += fmt::format("<tr><th scope=row>{}</th>", escape(key.algorithm)) +
            cell(grouped(key.n), true) + cell(escape(key.level)) +
            cell(fmt::format("{}", judged.rows), true) + time_cell(judged.draw_s) +
            time_cell(judged.store_s) + time_cell(judged.certify_s) +
            bytes_cell(judged.peak_bytes) + "</tr>\n";
  }
  if (body.empty()) return "";
  return "<h3>Levels of detail</h3><p>What a row stores of its drawing: nothing, positions, all "
         "bends. Times per vertex (drawing in CPU time), medians and (grey) from 10 to 90 %; "
         "memory "
         "is the peak beyond what was resident when the row began, where the row had a process or "
         "a measurement of its own.</p><div class=scroll><table class=sortable><thead><tr>"
         "<th>Algorithm<th class=num>n<th>Level<th class=num>Rows<th class=num>Drawing"
         "<th class=num>Storing<th class=num>Certifying<th class=num>Bytes per vertex</tr></thead>"
         "<tbody>\n" +
         body + "</tbody></table></div>\n";
}

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
