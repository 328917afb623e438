// A collection of graphs from files: who drew how many, how good the drawings are beside the best
// one of the same graph, distributions by group.
#include "ar3d/analysis/report/collection.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "ar3d/analysis/report/html.h"

namespace ar3d::report {
namespace {

constexpr std::size_t kMostCompared = 6;  // settings of the scatters
constexpr std::size_t kMostGroupRows = 24;

/// The value of one metric of the table; missing if the row has none.
double metric_of(const DrawnGraph& graph, const char* name) {
  const auto at = std::ranges::find(metrics(), name, &Metric::name);
  const auto place = static_cast<std::size_t>(at - metrics().begin());
  return place < graph.metrics.size() ? graph.metrics[place] : kMissing;
}

double log10_metric(const DrawnGraph& graph, const char* name) {
  return decimal(log_positive(metric_of(graph, name)));
}

const std::vector<CollectionMeasure>& measures() {
  static const std::vector<CollectionMeasure> all = {
      {"volume", "Volume", TickStyle::power,
       [](const Collection& of) {
         return std::string(of.is_relative ? "cubes of the smallest vertex distance"
                                           : "lattice points");
       },
       [](const Collection& of, const DrawnGraph& graph) {
         return (of.is_relative ? graph.log2_relative_volume : graph.log2_volume) * std::log10(2);
       }},
      {"time", "Drawing time", TickStyle::seconds,
       [](const Collection& of) { return std::string(of.is_timed ? "s" : "s, beside other rows"); },
       [](const Collection& of, const DrawnGraph& graph) {
         return decimal(log_value(graph, Quantity::wall_s, of.is_timed));
       }},
      {"edge-length", "Total edge length", TickStyle::power,
       [](const Collection&) { return std::string("smallest vertex distances"); },
       [](const Collection&, const DrawnGraph& graph) {
         return log10_metric(graph, "total_edge_length") -
                log10_metric(graph, "smallest_vertex_distance");
       }},
      {"angle", "Smallest angle at a vertex", TickStyle::count,
       [](const Collection&) { return std::string("degrees"); },
       [](const Collection&, const DrawnGraph& graph) {
         return log10_metric(graph, "smallest_vertex_angle");
       },
       true}};
  return all;
}
constexpr std::size_t kScattered = 2;  // of the measures

/// The collections of the page, in the order of the file.
std::vector<Collection> collections_of(const std::vector<Section>& sections) {
  std::vector<Collection> all;
  std::map<std::string, std::size_t> index_of;
  for (const Section& section : sections) {
    for (const SectionCurve& curve : section.curves) {
      if (!curve.is_collection) continue;
      const auto [at, is_new] = index_of.try_emplace(curve.family, all.size());
      if (is_new) all.emplace_back().family = curve.family;
      Collection& collection = all[at->second];
      const std::size_t setting = collection.settings.size();
      collection.settings.push_back({section.label, &curve});
      collection.is_relative |= section.has_own_unit;
      collection.is_timed &= curve.tally->has_timing_rows;
      for (const auto& [n, size] : curve.tally->sizes) {
        for (const DrawnGraph& graph : size.graphs) {
          CollectionGraph& known = collection.graphs[{graph.seed, graph.instance}];
          known.n = std::max<std::int64_t>(1, graph.n);
          known.drawn.emplace_back(setting, &graph);
        }
      }
    }
  }
  return all;
}

/// A table of the settings: how many graphs each drew, and what became of the rows.
std::string drawn_table(const Collection& collection) {
  std::string html = table_head({"Setting", "#Graphs", "#Drawn", "#Share", "#Refused rows",
                                 "#Violated rows", "#Unfinished rows"});
  for (const CollectionSetting& setting : collection.settings) {
    const CurveTally& tally = *setting.curve->tally;
    std::size_t drawn = 0;
    for (const auto& [n, size] : tally.sizes) drawn += size.drawn;
    const std::size_t unfinished = tally.count(RunStatus::timeout) +
                                   tally.count(RunStatus::out_of_memory) +
                                   tally.count(RunStatus::crashed);
    html += row_head(setting.label);
    html += cell(grouped(static_cast<std::int64_t>(tally.instances)), true);
    html += cell(grouped(static_cast<std::int64_t>(drawn)), true);
    html += cell(percent(static_cast<double>(drawn) / static_cast<double>(tally.instances)), true);
    for (const std::size_t count :
         {tally.count(RunStatus::refused), tally.violations, unfinished}) {
      html += cell(grouped(static_cast<std::int64_t>(count)), true);
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

/// Median, and (grey) the tenths at either end.
std::string distribution_cell(std::vector<double> values) {
  if (values.empty()) return cell("–", true);
  std::ranges::sort(values);
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
  };
  return cell(fmt::format("{} <small>{} – {}</small>", number_text(at(0.5)), number_text(at(0.1)),
                          number_text(at(0.9))),
              true);
}

/// By name; empty if the collection has none.
std::map<std::string, std::vector<const CollectionGraph*>> groups_in(const Collection& collection) {
  std::map<std::string, std::vector<const CollectionGraph*>> groups;
  for (const auto& [key, one] : collection.graphs) {
    const std::string& group = one.drawn.front().second->group;
    if (!group.empty()) groups[group].push_back(&one);
  }
  return groups;
}

std::string group_table(const Collection& collection, const CollectionMeasure& measure) {
  const auto groups = groups_in(collection);
  if (groups.empty()) return "";
  std::vector<std::string> columns = {"Group", "#Graphs"};
  for (const CollectionSetting& setting : collection.settings) {
    columns.push_back("#" + escape(setting.label));
  }
  std::string html =
      fmt::format(
          "<details{}><summary>{} by group</summary><p class=muted>In {}: "
          "median and (grey) the tenths at either end, over the graphs that "
          "the setting drew.</p>",
          &measure == measures().data() ? " open" : "", measure.title, measure.unit(collection)) +
      table_head(columns);
  std::size_t shown = 0;
  for (const auto& [name, graphs] : groups) {
    if (++shown > kMostGroupRows) break;
    std::vector<std::vector<double>> values(collection.settings.size());
    for (const CollectionGraph* one : graphs) {
      for (const auto& [setting, graph] : one->drawn) {
        const double value = measure.log10_value(collection, *graph);
        if (!std::isnan(value)) values[setting].push_back(value);
      }
    }
    html += row_head(name) + cell(grouped(static_cast<std::int64_t>(graphs.size())), true);
    for (auto& of_setting : values) html += distribution_cell(std::move(of_setting));
    html += "</tr>\n";
  }
  html += "</tbody></table></div>";
  if (groups.size() > kMostGroupRows) {
    html += fmt::format("<p>The first {} of {} groups.</p>", kMostGroupRows, groups.size());
  }
  return html + "</details>\n";
}

/// The choice of two settings of a scatter and its figures; one at a time is seen.
std::string scatters(Page& page, const Collection& collection, const std::string& id) {
  std::string figures, options;
  std::size_t pick = 0;
  const std::size_t settings = std::min(kMostCompared, collection.settings.size());
  for (std::size_t m = 0; m < kScattered; ++m) {
    for (std::size_t a = 0; a < settings; ++a) {
      for (std::size_t b = a + 1; b < settings; ++b) {
        NamedPlot plot = scatter_plot(page, collection, measures()[m], a, b);
        if (plot.svg.empty()) continue;
        options += fmt::format("<option value={}>{}</option>", pick, escape(plot.title));
        figures += page.figure(std::move(plot), fmt::format(" data-pick={} data-value={}{}", id,
                                                            pick, pick == 0 ? "" : " hidden"));
        ++pick;
      }
    }
  }
  if (pick == 0) return "";
  return "<div><label class=choice>One graph, two settings <select class=pick name=" + id + ">" +
         options + "</select></label>" + figures + "</div>";
}

}  // namespace

const DrawnGraph* drawn_by(const CollectionGraph& one, std::size_t setting) {
  for (const auto& [by, graph] : one.drawn) {
    if (by == setting) return graph;
  }
  return nullptr;
}

std::string number_text(double log10) {
  return std::isnan(log10) ? "–" : fmt::format("{:.3g}", std::pow(10, log10));
}

std::string collection_sections(Page& page, const std::vector<Section>& sections) {
  std::string html;
  std::size_t index = 0;
  for (const Collection& collection : collections_of(sections)) {
    const std::string id = fmt::format("c{}", index++);
    html += fmt::format(
        "<section id={}><h2>Collection {}</h2><p>Who drew how many of its graphs, and how good "
        "the drawings are beside the best one of the same graph.</p>",
        id, escape(collection.family));
    html += drawn_table(collection) + "<div class=figures>\n";
    for (const CollectionMeasure& measure : measures()) {
      NamedPlot plot = profile_plot(collection, measure);
      if (!plot.svg.empty()) html += page.figure(std::move(plot));
    }
    html += scatters(page, collection, id);
    for (std::size_t m = 0; m < kScattered; ++m) {
      NamedPlot plot = sizes_plot(collection, measures()[m]);
      if (!plot.svg.empty()) html += page.figure(std::move(plot));
    }
    html += "</div>\n";
    for (const CollectionMeasure& measure : measures()) html += group_table(collection, measure);
    html += "</section>\n";
  }
  return html;
}

std::vector<std::size_t> collection_outliers(const std::vector<Section>& sections) {
  std::vector<std::size_t> rows;
  for (const Collection& collection : collections_of(sections)) {
    const std::size_t settings = std::min(kMostCompared, collection.settings.size());
    for (std::size_t a = 0; a < settings; ++a) {
      for (std::size_t b = a + 1; b < settings; ++b) {
        for (const CollectionPair& pair :
             outliers(pairs_of(collection, measures().front(), a, b))) {
          rows.push_back(pair.one->row);
          rows.push_back(pair.other->row);
        }
      }
    }
  }
  return rows;
}

}  // namespace ar3d::report
