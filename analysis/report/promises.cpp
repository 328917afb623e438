// What was promised, and what is drawn: by setting and axis the paper's bound, the proved one, and
// the exponent and the constant that were measured.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ar3d/analysis/report/html.h"
#include "ar3d/analysis/report/sections.h"

namespace ar3d::report {
namespace {

/// The family whose extent grows fastest among those with an interval; null if there is none.
const SectionCurve* fastest_family(const Section& section, Quantity extent) {
  const SectionCurve* fastest = nullptr;
  const auto exponent = [&](const SectionCurve& curve) {
    const ScalingEntry* entry = curve.scaling[static_cast<std::size_t>(extent)];
    return entry != nullptr && entry->decided ? entry->power.exponent : kMissing;
  };
  for (const SectionCurve& curve : section.curves) {
    if (std::isnan(exponent(curve))) continue;
    if (fastest == nullptr || exponent(curve) > exponent(*fastest)) fastest = &curve;
  }
  return fastest;
}

/// The mean extent of a family's largest graphs over the bound's power of n; missing without any.
double drawn_constant(const SectionCurve& curve, Quantity extent, const AxisBound& bound) {
  const ScalingEntry* entry = curve.scaling[static_cast<std::size_t>(extent)];
  if (entry == nullptr || !entry->decided) return kMissing;
  const SizeSample& last = entry->all.back();
  return std::exp(last.mean_log() - bound.half_power / 2.0 * std::log(last.n));
}

std::string axis_row(const Section& section, std::size_t axis) {
  const auto extent = static_cast<Quantity>(static_cast<std::size_t>(Quantity::extent_x) + axis);
  const AxisBound& bound = section.theorem->axes[axis];
  const SectionCurve* fastest = fastest_family(section, extent);
  const SectionCurve* largest = nullptr;
  double constant = kMissing, share = kMissing;
  for (const SectionCurve& curve : section.curves) {
    const double one = drawn_constant(curve, extent, bound);
    share = std::fmax(share, 1 - curve.bounds->axes[axis].worst_slack);
    if (std::isnan(one) || one <= constant) continue;
    constant = one;
    largest = &curve;
  }
  std::string html = row_head(section.label) + cell(std::string(1, "xyz"[axis])) +
                     cell(section.published ? section.published->axes[axis].formula() : "–", true) +
                     cell(bound.formula(), true);
  if (fastest == nullptr) {
    html += cell("–", true) + cell("–");
  } else {
    const CurveFit& fit = fastest->scaling[static_cast<std::size_t>(extent)]->power;
    html += cell(fmt::format("{:.3f} <small>[{:.3f}, {:.3f}]</small>", fit.exponent,
                             fit.exponent_interval.low, fit.exponent_interval.high),
                 true) +
            cell(escape(fastest->name));
  }
  return html + cell(number(constant), true) +
         cell(largest == nullptr ? "–" : escape(largest->name)) + cell(percent(share), true) +
         "</tr>\n";
}

}  // namespace

std::string promises_section(const std::vector<Section>& sections) {
  std::string rows;
  for (const Section& section : sections) {
    if (!section.theorem || std::ranges::all_of(section.theorem->axes, [](const AxisBound& bound) {
          return bound.numerator == 0;
        })) {
      continue;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) rows += axis_row(section, axis);
  }
  if (rows.empty()) return "";
  return "<section id=promises><h2>What was promised, and what is drawn?</h2>" +
         table_head({"Setting", "Axis", "#Paper", "#Proved", "#Measured exponent", "Of family",
                     "#Measured constant", "Of family", "#Largest share"}) +
         rows +
         "</tbody></table></div><p class=muted>Bounds of the extents. Measured exponent: of the "
         "family whose extent grows fastest, with its 95 % interval. Measured constant: the "
         "largest mean extent of a family at its largest n, divided by the proved bound's power "
         "of n.</p></section>\n";
}

}  // namespace ar3d::report
