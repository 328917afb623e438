// The tables that answer first: is everything certified, how close does anything come to a bound,
// how does it grow, and what was promised?
#include <algorithm>
#include <array>
#include <cmath>

#include "ar3d/analysis/report/sections.h"
#include "ar3d/analysis/scaling/scaling.h"

namespace ar3d::report {
namespace {

constexpr std::array kFrontQuantities = {Quantity::longest_side, Quantity::volume,
                                         Quantity::wall_s};

void add_study(TableMaker& make) {
  const StudyIdentity& study = make.analysis.rows.identity();
  const StudyTally& tally = make.analysis.tally;
  const auto [read, given] = file_counts(study);
  make.table("study").add({study.study_id, study.created, study.source_hash, study.dirty,
                           make.analysis.rows.file, study.spec_hash, study.spec, tally.kept_graphs,
                           tally.left_out_rows, read, given});
  Table& skipped = make.table("skipped_files");
  for (const SkippedFile& file : side_records<SkippedFile>(study)) {
    skipped.add({file.name, file.file, file.reason});
  }
}

void add_findings(TableMaker& make) {
  const CheckVerdict& verdict = make.analysis.verdict;
  make.table("verdict").add({verdict.word(), verdict.exit_code(), verdict.rows, verdict.proved,
                             verdict.violated_rows, verdict.incomplete_rows, verdict.refused,
                             verdict.unproved, verdict.accepts_unproved, verdict.measured,
                             verdict.all_findings});
  Table& findings = make.table("findings");
  for (const Finding& finding : verdict.findings) {
    if (!make.all && findings.size() == kShownFindings) break;
    if (finding.row) make.add_row(*finding.row);
    findings.add({to_string(finding.kind), is_violation(finding.kind), finding.row, finding.subject,
                  finding.message, finding.command});
  }
}

double least_angle(const Section& section) {
  double least = kMissing;
  for (const SectionCurve& curve : section.curves) {
    for (const auto& [n, size] : curve.tally->sizes) {
      for (const DrawnGraph& graph : size.graphs) {
        for (const char* angle : {"smallest_vertex_angle", "smallest_bend_angle"}) {
          least = std::fmin(least, metric_of(graph, angle));
        }
      }
    }
  }
  return least;
}

void add_settings(TableMaker& make) {
  Table& table = make.table("settings");
  for (const Section& section : make.sections) {
    std::size_t graphs = 0, drawn = 0, violations = 0, unproved = 0, ok = 0, measured = 0,
                bends = 0;
    std::int64_t largest = -1;
    std::set<std::string> families;
    std::string theorem, published;
    for (const SectionCurve& curve : section.curves) {
      families.insert(curve.family);
      graphs += curve.tally->instances;
      for (const auto& [n, size] : curve.tally->sizes) drawn += size.drawn;
      violations += curve.tally->violations;
      unproved += curve.tally->unproved;
      ok += curve.tally->count(RunStatus::ok);
      measured += curve.tally->count(RunStatus::measured);
      largest = std::max(largest, curve.tally->largest_n);
      bends = std::max(bends, most_bends(curve.tally->bends));
      if (theorem.empty()) theorem = curve.tally->theorem_formula;
      if (published.empty()) published = curve.tally->published_formula;
    }
    std::vector<TableCell> row = {section.label,
                                  section.algorithm,
                                  theorem,
                                  published,
                                  section.has_own_unit,
                                  count_families(families),
                                  section.shown.size(),
                                  section.curves.size(),
                                  graphs,
                                  drawn,
                                  count_or_none(largest),
                                  violations,
                                  unproved,
                                  ok,
                                  measured,
                                  least_angle(section),
                                  bends,
                                  count_or_none(section.max_bends)};
    row.resize(table.columns.size());
    const SectionCurve& closest = *std::ranges::min_element(
        section.curves, {}, [](const SectionCurve& curve) { return curve.least_slack(); });
    if (const auto axis = worst_axis(*closest.tally)) {
      const DrawnGraph& graph = closest.tally->axes[*axis].worst;
      std::ranges::copy(
          std::initializer_list<TableCell>{1 - closest.least_slack(), closest.name, graph.n,
                                           make.add_graph(closest.index, graph),
                                           std::string(1, "xyz"[*axis]), graph.extents[*axis],
                                           graph.theorem_bound[*axis]},
          row.end() - 7);
    }
    table.add(std::move(row));
  }
}

void add_exponents(TableMaker& make) {
  Table& table = make.table("exponents");
  for (std::size_t i = 0; i < make.sections.size(); ++i) {
    const Section& section = make.sections[i];
    for (const Quantity quantity : kFrontQuantities) {
      double least = kMissing, largest = kMissing, low = kMissing, high = kMissing;
      std::array<std::size_t, 4> labels{};  // by Growth
      bool is_untimed = false;
      for (const SectionCurve& curve : section.curves) {
        const ScalingEntry* entry = curve.growth(quantity);
        if (entry == nullptr) continue;
        if (entry->reason == kUntimed) {
          is_untimed = true;
          continue;
        }
        ++labels[static_cast<std::size_t>(entry->growth)];
        if (!entry->decided) continue;
        const double exponent = entry->power.exponent;
        const Interval shown = shown_interval(*entry);
        least = std::fmin(least, exponent), largest = std::fmax(largest, exponent);
        low = std::fmin(low, shown.low), high = std::fmax(high, shown.high);
      }
      const bool is_fitted = std::ranges::count(labels, 0U) < 4;
      if (!is_fitted && !is_untimed) continue;
      table.add({i, name_of(quantity), unit_of(section, quantity), order_of(section, quantity),
                 least, largest, low, high, labels[0], labels[1], labels[2], labels[3],
                 !is_fitted});
    }
  }
}

void add_promise(const Section& section, std::size_t setting, std::size_t axis, Table& table) {
  const auto extent = static_cast<Quantity>(static_cast<std::size_t>(Quantity::extent_x) + axis);
  const AxisBound& bound = section.theorem->axes[axis];
  const ScalingEntry* growth = nullptr;  // of the family whose extent grows fastest
  TableCell fastest, largest;
  double constant = kMissing, share = kMissing;
  for (const SectionCurve& curve : section.curves) {
    share = std::fmax(share, 1 - curve.tally->axes[axis].worst_slack);
    const ScalingEntry* entry = curve.growth(extent);
    if (entry == nullptr || !entry->decided) continue;
    if (growth == nullptr || entry->power.exponent > growth->power.exponent) {
      growth = entry, fastest = curve.name;
    }
    // The geometric mean extent of the family's largest graphs over the bound's power of n.
    const SizeSample& last = entry->all.back();
    const double one = std::exp(last.mean_log() - bound.half_power / 2.0 * std::log(last.n));
    if (std::isnan(one) || one <= constant) continue;
    constant = one, largest = curve.name;
  }
  const Interval shown = growth == nullptr ? Interval{kMissing, kMissing} : shown_interval(*growth);
  table.add({setting, std::string(1, "xyz"[axis]),
             section.published ? TableCell(section.published->axes[axis].formula()) : TableCell(),
             bound.formula(), growth == nullptr ? kMissing : growth->power.exponent, shown.low,
             shown.high, growth == nullptr ? TableCell() : TableCell(to_string(growth->growth)),
             fastest, constant, largest, share});
}

void add_promises(TableMaker& make) {
  Table& table = make.table("promises");
  for (std::size_t i = 0; i < make.sections.size(); ++i) {
    const Section& section = make.sections[i];
    if (!section.theorem || std::ranges::all_of(section.theorem->axes, [](const AxisBound& bound) {
          return bound.numerator == 0;
        })) {
      continue;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) add_promise(section, i, axis, table);
  }
}

}  // namespace

void add_verdict(TableMaker& make) {
  add_study(make);
  add_findings(make);
  add_settings(make);
  add_exponents(make);
  add_promises(make);
}

}  // namespace ar3d::report
