#include "ar3d/analysis/report/sections.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "ar3d/analysis/replay.h"

namespace ar3d::report {
namespace {

/// The smallest slack over the axes; +infinity if there is none, so that it comes last.
double closeness(const SectionCurve& curve) {
  double least = std::numeric_limits<double>::infinity();
  for (const AxisBounds& axis : curve.bounds->axes) least = std::fmin(least, axis.worst_slack);
  return least;
}

/// The curves closest to their bound, in the order of the file.
void keep_closest(std::vector<SectionCurve>& curves) {
  if (curves.size() <= kMostFamilies) return;
  std::stable_sort(curves.begin(), curves.end(), [](const SectionCurve& a, const SectionCurve& b) {
    return closeness(a) < closeness(b);
  });
  curves.resize(kMostFamilies);
  std::sort(curves.begin(), curves.end(),
            [](const SectionCurve& a, const SectionCurve& b) { return a.place < b.place; });
}

void name_families(std::vector<SectionCurve>& curves) {
  std::map<std::string, std::size_t> times;
  for (const SectionCurve& curve : curves) ++times[curve.name];
  for (SectionCurve& curve : curves) {
    if (times.at(curve.bounds->key.family) > 1) curve.name = curve.family;
  }
}

}  // namespace

std::vector<Section> sections(const StudyAnalysis& analysis) {
  std::map<CurveKey, std::vector<const ScalingEntry*>> scaling_of;
  for (const ScalingEntry& entry : analysis.scaling) {
    auto& entries = scaling_of[entry.key];
    entries.resize(quantities().size());
    entries[static_cast<std::size_t>(entry.quantity)] = &entry;
  }
  const ShowCommand commands(analysis.rows);
  const std::vector<AlgorithmRecord> records = algorithm_records(*analysis.rows.identity);
  std::vector<Section> sections;
  std::map<std::string, std::size_t> index_of;
  for (std::size_t place = 0; place < analysis.bounds.size(); ++place) {
    const CurveKey& key = analysis.bounds[place].key;
    const auto [at, is_new] = index_of.try_emplace(algorithm_label(key), sections.size());
    if (at->second >= kMostSections) continue;
    if (is_new) {
      Section& section = sections.emplace_back();
      section.label = at->first;
      section.algorithm = key.algorithm;
      if (const auto* record = find_algorithm_record(records, key.algorithm, key.options)) {
        if (record->theorem.promises_box()) section.theorem = record->theorem;
        section.published = record->published;
      }
    }
    sections[at->second].has_own_unit |= analysis.tally.curves[place].has_own_unit;
    auto scaling = scaling_of[key];
    scaling.resize(quantities().size());
    const CurveTally& tally = analysis.tally.curves[place];
    sections[at->second].curves.push_back(
        {place, family_label(key), key.family, &tally, &analysis.bounds[place], std::move(scaling),
         commands.is_of_file(key.family) && tally.instances >= kFewestOfCollection});
  }
  for (Section& section : sections) {
    name_families(section.curves);
    section.shown = section.curves;
    keep_closest(section.shown);
  }
  return sections;
}

std::size_t count_families(const std::set<std::string>& family_labels) {
  std::set<std::string> names;
  for (const std::string& label : family_labels) names.insert(label.substr(0, label.find(" (")));
  return names.size();
}

}  // namespace ar3d::report
