// The tables that answer first: is everything certified, how close does anything come to a bound,
// how does it grow, and what was promised?
#include <algorithm>
#include <array>
#include <cmath>

#include "ar3d/analysis/report/sections.h"
#include "ar3d/analysis/scaling/samples.h"

namespace ar3d::report {
namespace {

using enum CellType;

constexpr std::array kFrontQuantities = {Quantity::longest_side, Quantity::volume,
                                         Quantity::wall_s};

void add_study(TableMaker& make) {
  const StudyIdentity& study = *make.analysis.rows.identity;
  const StudyTally& tally = make.analysis.tally;
  const FileCounts files = file_counts(study);
  make.start("study", "the study",
             {{"study", "", "its name"},
              {"created", "", "when its results were begun"},
              {"program", "", "commit of the program"},
              {"dirty", "", "the program had uncommitted changes", flag},
              {"file", "", "the results file"},
              {"spec_hash", "", "XXH3-128 of the specification"},
              {"spec", "", "the specification"},
              {"kept_graphs", "", "graphs of a size that medians, bands and points are of; 0: all",
               integer},
              {"left_out_rows", "", "rows in the verdict, but in no other table", integer},
              {"files_read", "", "files of collections that graphs were read from", integer},
              {"files_given", "", "files of collections", integer}})
      .add({study.study_id, study.created, study.source_hash, study.dirty, make.analysis.rows.file,
            study.spec_hash, study.spec, tally.kept_graphs, tally.left_out_rows, files.read,
            files.given});
  Table& skipped = make.start("skipped_files", "a file of a collection that was left out",
                              {{"collection", "", "its name"},
                               {"file", "", "path within it"},
                               {"reason", "", "why it could not be read"}});
  for (const SkippedFile& file : skipped_file_records(study)) {
    skipped.add({file.name, file.file, file.reason});
  }
}

void add_findings(TableMaker& make) {
  const CheckVerdict& verdict = make.analysis.verdict;
  make.start("verdict", "the verdict of `ar3d check`",
             {{"word", "", "PASS, VIOLATED, INCOMPLETE or MEASURED"},
              {"exit_code", "", "of `ar3d check`", integer},
              {"rows", "", "all rows", integer},
              {"proved", "", "ok rows whose certificate and bounds hold", integer},
              {"violated", "", "rows that break a bound or a certificate", integer},
              {"incomplete", "", "rows that something is missing of", integer},
              {"refused", "", "rows whose graph lies outside the theorem", integer},
              {"unproved", "", "rows whose certificate proves nothing", integer},
              {"accepts_unproved", "", "the study accepts unproved rows", flag},
              {"measured", "", "rows of programs without a guarantee", integer},
              {"findings", "", "all findings, listed or not", integer}})
      .add({verdict.word(), verdict.exit_code(), verdict.rows, verdict.proved,
            verdict.violated_rows, verdict.incomplete_rows, verdict.refused, verdict.unproved,
            verdict.accepts_unproved, verdict.measured, verdict.all_findings});
  Table& findings = make.start("findings", "a finding, violations first",
                               {{"kind", "", "what was found"},
                                {"is_violation", "", "something is proved wrong", flag},
                                {"row", "", "its row in /runs", integer},
                                {"subject", "", "what drew which graph"},
                                {"message", "", "one line"},
                                {"command", "", "draws the row again"}});
  for (const Finding& finding : verdict.findings) {
    if (!make.all && findings.size() == kShownFindings) break;
    if (finding.row) make.graphs.add_row(*finding.row);
    findings.add({to_string(finding.kind), is_violation(finding.kind),
                  finding.row ? TableCell(*finding.row) : TableCell(), finding.subject,
                  finding.message, finding.command});
  }
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

std::vector<TableColumn> setting_columns() {
  return {{"setting", "", "its name"},
          {"algorithm", "", "the algorithm"},
          {"theorem", "", "the theorem's box"},
          {"published", "", "the published box"},
          {"own_unit", "", "no theorem promises a box: the unit is the drawings' own", flag},
          {"families", "", "families; one with several parameters counts once", integer},
          {"shown", "", "curves that the page shows: those closest to the bound", integer},
          {"curves", "", "families with their parameters", integer},
          {"graphs", "", "graphs, drawn or not", integer},
          {"drawn", "", "graphs that were drawn", integer},
          {"largest_n", "vertices", "largest n", integer},
          {"violations", "", "rows that break a bound or a certificate", integer},
          {"unproved", "", "ok rows that no exact certificate judged", integer},
          {"ok", "", "ok rows", integer},
          {"measured", "", "rows that were measured, not judged", integer},
          {"share", "", "largest share of the theorem's bound over axes, families and sizes",
           number, 0},
          {"closest_family", "", "family of the graph with that share"},
          {"closest_n", "vertices", "its vertices", integer},
          {"closest_row", "", "its row in /runs", integer},
          {"closest_axis", "", "x, y or z"},
          {"closest_extent", "lattice units", "its extent there", integer},
          {"closest_bound", "lattice units", "the theorem's bound there", number}};
}

void add_settings(TableMaker& make) {
  Table& table = make.start("settings", "an algorithm with its options", setting_columns());
  for (const Section& section : make.sections) {
    std::size_t graphs = 0, drawn = 0, violations = 0, unproved = 0, ok = 0, measured = 0;
    std::int64_t largest = -1;
    std::set<std::string> families;
    std::string theorem, published;
    for (const SectionCurve& curve : section.curves) {
      families.insert(curve.family);
      graphs += curve.bounds->instances;
      for (const auto& [n, size] : curve.tally->sizes) drawn += size.drawn;
      violations += curve.bounds->violations;
      unproved += curve.bounds->unproved;
      ok += curve.bounds->count(RunStatus::ok);
      measured += curve.bounds->count(RunStatus::measured);
      largest = std::max(largest, curve.bounds->largest_n);
      if (theorem.empty()) theorem = curve.bounds->theorem_formula;
      if (published.empty()) published = curve.bounds->published_formula;
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
                                  measured};
    row.resize(table.columns.size());
    if (const Closest closest = closest_of(section); closest.curve != nullptr) {
      const DrawnGraph& graph = closest.bounds().worst;
      std::size_t at = 15;
      row[at++] = 1 - closest.bounds().worst_slack;
      row[at++] = closest.curve->name;
      row[at++] = graph.n;
      row[at++] = make.graphs.add(closest.curve->place, graph);
      row[at++] = std::string(1, "xyz"[closest.axis]);
      row[at++] = graph.extents[closest.axis];
      row[at++] = graph.theorem_bound[closest.axis];
    }
    table.add(std::move(row));
  }
}

/// How the families of one setting grow in one quantity.
struct ExponentRange {
  double least = kMissing, largest = kMissing, low = kMissing, high = kMissing;
  std::array<std::size_t, 4> labels{};  // by Growth
  bool is_untimed = false;

  void include(const ScalingEntry& entry) {
    is_untimed |= entry.reason == kUntimed;
    ++labels[static_cast<std::size_t>(entry.growth)];
    if (!entry.decided) return;
    const Interval told = told_interval(entry);
    least = std::fmin(least, entry.power.exponent),
    largest = std::fmax(largest, entry.power.exponent);
    low = std::fmin(low, told.low), high = std::fmax(high, told.high);
  }
};

void add_exponents(TableMaker& make) {
  Table& table = make.start(
      "exponents", "a setting and a quantity: the exponents a of n^a over its families",
      {{"setting", "", "its row in settings", integer},
       {"quantity", "", "what grows"},
       {"unit", "", "its unit"},
       {"order", "", "the power of n that figures divide by: the theorem's", number},
       {"least", "", "least exponent of a family", number},
       {"largest", "", "largest exponent of a family", number},
       {"low", "", "least end of their intervals: of a power law the one for larger n, too",
        number},
       {"high", "", "largest end of their intervals", number},
       {"power", "", "families with a power law", integer},
       {"logarithm", "", "families with a power law with logarithm", integer},
       {"apparent", "", "families with an apparent exponent", integer},
       {"undecided", "", "families that are undecided", integer},
       {"untimed", "", "no rows of the timing phase: nothing is ranked or drawn", flag}});
  for (std::size_t i = 0; i < make.sections.size(); ++i) {
    const Section& section = make.sections[i];
    for (const Quantity quantity : kFrontQuantities) {
      ExponentRange range;
      bool has_any = false;
      for (const SectionCurve& curve : section.curves) {
        const ScalingEntry* entry = curve.growth(quantity);
        if (entry == nullptr) continue;
        has_any = true;
        range.include(*entry);
      }
      if (!has_any) continue;
      const bool is_own = quantity == Quantity::volume && section.has_own_unit;
      const auto count = [&](Growth growth) {
        return range.labels[static_cast<std::size_t>(growth)];
      };
      table.add({i, name_of(quantity), is_own ? "vertex distances³" : unit_of(quantity),
                 order_of(section, quantity), range.least, range.largest, range.low, range.high,
                 count(Growth::power), count(Growth::power_and_log), count(Growth::apparent),
                 count(Growth::undecided), range.is_untimed});
    }
  }
}

/// The family whose extent grows fastest among those with an interval; null if there is none.
const SectionCurve* fastest_family(const Section& section, Quantity extent) {
  const SectionCurve* fastest = nullptr;
  for (const SectionCurve& curve : section.curves) {
    const ScalingEntry* entry = curve.growth(extent);
    if (entry == nullptr || !entry->decided || std::isnan(entry->power.exponent)) continue;
    if (fastest == nullptr || entry->power.exponent > fastest->growth(extent)->power.exponent) {
      fastest = &curve;
    }
  }
  return fastest;
}

/// The geometric mean extent of a family's largest graphs over the bound's power of n.
double drawn_constant(const SectionCurve& curve, Quantity extent, const AxisBound& bound) {
  const ScalingEntry* entry = curve.growth(extent);
  if (entry == nullptr || !entry->decided) return kMissing;
  const SizeSample& last = entry->all.back();
  return std::exp(last.mean_log() - bound.half_power / 2.0 * std::log(last.n));
}

void add_promise(const Section& section, std::size_t setting, std::size_t axis, Table& table) {
  const auto extent = static_cast<Quantity>(static_cast<std::size_t>(Quantity::extent_x) + axis);
  const AxisBound& bound = section.theorem->axes[axis];
  const SectionCurve *fastest = fastest_family(section, extent), *largest = nullptr;
  double constant = kMissing, share = kMissing;
  for (const SectionCurve& curve : section.curves) {
    const double one = drawn_constant(curve, extent, bound);
    share = std::fmax(share, 1 - curve.bounds->axes[axis].worst_slack);
    if (std::isnan(one) || one <= constant) continue;
    constant = one;
    largest = &curve;
  }
  const ScalingEntry* growth = fastest == nullptr ? nullptr : fastest->growth(extent);
  const Interval told = growth == nullptr ? Interval{kMissing, kMissing} : told_interval(*growth);
  table.add({setting, std::string(1, "xyz"[axis]),
             section.published ? TableCell(section.published->axes[axis].formula()) : TableCell(),
             bound.formula(), growth == nullptr ? kMissing : growth->power.exponent, told.low,
             told.high, growth == nullptr ? TableCell() : TableCell(to_string(growth->growth)),
             fastest == nullptr ? TableCell() : TableCell(fastest->name), constant,
             largest == nullptr ? TableCell() : TableCell(largest->name), share});
}

void add_promises(TableMaker& make) {
  Table& table = make.start(
      "promises", "a setting and an axis: what was promised, and what is drawn",
      {{"setting", "", "its row in settings", integer},
       {"axis", "", "x, y or z"},
       {"paper", "", "the published bound of the extent"},
       {"proved", "", "the theorem's bound of the extent"},
       {"exponent", "", "of the family whose extent grows fastest", number},
       {"low", "", "its interval: of a power law the one for larger n, too", number},
       {"high", "", "upper end", number},
       {"growth", "", "its label"},
       {"family", "", "that family"},
       {"constant", "",
        "largest geometric mean extent of a family at its largest n, over the bound's power of n",
        number},
       {"constant_family", "", "that family"},
       {"share", "", "largest share of the theorem's bound", number}});
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
