#include "ar3d/bench/spec/batch_rules.h"

#include <algorithm>

#include "ar3d/bench/spec/toml_table.h"

namespace ar3d {
namespace {

bool has_batches(const Sweep& sweep) {
  const auto has = [](const Batches& batches) { return !batches.scales.empty(); };
  return has(sweep.strong) || has(sweep.weak) || has(sweep.strong_ranks) || has(sweep.weak_ranks);
}

template <class Is>
bool any(const Sweep& sweep, Is is) {
  return std::any_of(sweep.algorithms.begin(), sweep.algorithms.end(), is);
}

}  // namespace

void refuse_bad_batches(const std::string& file, const toml::node& node, const Sweep& sweep) {
  if (!has_batches(sweep)) return;
  if (any(sweep, [](const AlgorithmChoice& c) { return c.program != nullptr; })) {
    refuse_toml(file, node, "strong and weak batches are of the catalogue's algorithms only");
  }
  if (any(sweep, [](const AlgorithmChoice& c) { return c.level != Level::extents; })) {
    refuse_toml(file, node, "strong and weak batches are of level extents only");
  }
  const CertificateMode first = sweep.algorithms.front().certificate;
  if (any(sweep, [&](const AlgorithmChoice& c) { return c.certificate != first; })) {
    refuse_toml(file, node, "strong and weak batches are judged by one certificate");
  }
}

}  // namespace ar3d
