#include "ar3d/bench/search/trial.h"

#include <fmt/format.h>

#include <algorithm>

#include "ar3d/base/error.h"
#include "ar3d/verify/certificate.h"

namespace ar3d {
namespace {

std::array<double, 3> bound_of(const Subject& subject, const RatioRule& rule, const Graph& graph,
                               const Drawing& drawing) {
  std::array<double, 3> bound{};
  if (graph.num_vertices() == 0) return bound;
  const Algorithm& algorithm = *subject.choice.algorithm;
  if (algorithm.guarantee.claim == Claim::measured) {
    throw InputError(fmt::format("{} promises no box to search against", algorithm.name));
  }
  if (rule.against == Against::instance && !drawing.instance_bound) {
    throw InputError(fmt::format("{} states no bound for the instance", algorithm.name));
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    bound[axis] = rule.against == Against::theorem
                      ? algorithm.guarantee.bound.axes[axis].value(graph.num_vertices())
                      : static_cast<double>((*drawing.instance_bound)[axis]);
  }
  return bound;
}

double ratio_of(const Trial& trial, Measure measure) {
  std::array<double, 3> share{};
  double volume = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto extent = static_cast<double>(trial.extents[axis]);
    if (trial.bound[axis] > 0) share[axis] = extent / trial.bound[axis];
    volume *= (extent + 1) / (trial.bound[axis] + 1);
  }
  switch (measure) {
    case Measure::side:
      return *std::max_element(share.begin(), share.end());
    case Measure::volume:
      return volume;
    default:
      return share[static_cast<std::size_t>(measure) - static_cast<std::size_t>(Measure::x)];
  }
}

}  // namespace

Drawing draw_subject(const Subject& subject, const Graph& graph) {
  const Algorithm& algorithm = *subject.choice.algorithm;
  Drawing drawing = draw(algorithm, graph, subject.choice.options);
  return subject.fault == nullptr ? drawing
                                  : subject.fault->plant(graph, drawing, algorithm.guarantee);
}

Trial try_graph(const Subject& subject, const RatioRule& rule, Graph graph) {
  Trial trial;
  trial.graph = std::move(graph);
  try {
    const Drawing drawing = draw_subject(subject, trial.graph);
    trial.extents = bounding_box(drawing).extents();
    trial.bound = bound_of(subject, rule, trial.graph, drawing);
    trial.ratio = ratio_of(trial, rule.measure);
    const Certificate certificate =
        certify(trial.graph, drawing, subject.choice.algorithm->guarantee);
    if (certificate.violated()) {
      const Violation& first = certificate.violations.front();
      trial.failure = to_string(first.kind);
      trial.message = first.message;
    }
  } catch (const InternalError& error) {
    trial.failure = "internal_error";
    trial.message = error.what();
  }
  return trial;
}

}  // namespace ar3d
