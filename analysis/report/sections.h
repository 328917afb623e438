#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "ar3d/analysis/study_analysis.h"

namespace ar3d::report {

/// One algorithm with one set of options: the entries of the bounds table and curves of its
/// families, in the order of the file.
struct Section {
  std::string label;
  std::vector<const BoundsEntry*> bounds;
  std::vector<const ScalingEntry*> scaling;
};
std::vector<Section> sections(const StudyAnalysis& analysis);

/// The head of the page: title, verdict, counts, findings, table of the algorithms with links.
std::string overview(const StudyAnalysis& analysis, const std::vector<Section>& sections);
/// One algorithm: sentence, plots, bounds table, growth table, bends, small multiples. `id` is its
/// anchor.
std::string algorithm_section(const Section& section, const std::string& id);
/// Parts of it.
std::string bound_sentences(const Section& section);
std::string bounds_table_html(const Section& section);
std::string growth_table(const Section& section);
std::string bend_histogram(const Section& section);
/// Edges with 0, 1, … bends over all families of the section.
std::array<std::uint64_t, 8> bends_of(const Section& section);
/// Volume against drawing time by setting; empty if no algorithm was measured with two settings.
std::string effort_section(const StudyAnalysis& analysis);
/// Batches of strong and weak scaling against the ideal; empty if there are none.
std::string strong_weak_section(const StudyAnalysis& analysis);
/// Every metric of verify/metrics.h: unit, definition, and its median and range by setting.
std::string metrics_section(const StudyAnalysis& analysis, const std::vector<Section>& sections);
/// Environment, spec and methods.
std::string background(const RowView& rows);

/// The rows that plots point at as JSON for a script element: {"cells": [[label, command before n,
/// command behind the seed], …], "rows": {"row": [cell, n, m, seed, status, extents, …], …}}.
std::string plotted_rows_json(const StudyAnalysis& analysis);

}  // namespace ar3d::report
