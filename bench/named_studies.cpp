#include "ar3d/bench/named_studies.h"

#include <algorithm>
#include <array>

namespace ar3d {
namespace {

constexpr std::string_view kSmoke =
    R"toml(# Every algorithm over every family that fits it, at small sizes: does the whole way work?
study = "smoke"
description = "every algorithm and family at small sizes, a few seconds"
seed = 1

[[sweep]]
families = "all"
sizes = [4, 20, 100]
algorithms = "all"
instances = 2
)toml";

constexpr std::string_view kQuick =
    R"toml(# The first study to run: how do size, bends and time grow?
study = "quick"
description = "every algorithm over every family that fits it, up to a hundred thousand vertices"
seed = 1

[max_n]
two-bend = 25000  # certifying its tall drawings is what takes longest

[[sweep]]
families = "all"
sizes = { from = 10, to = 100000, per_decade = 3 }
algorithms = "all"
instances = 5
)toml";

constexpr std::string_view kMillion =
    R"toml(# One graph of a million vertices for every algorithm. For times to be quoted: --threads 1.
study = "million"
description = "one random regular graph of a million vertices for every algorithm"
seed = 1

[[sweep]]
families = "random-4-regular"
sizes = 1000000
algorithms = "diamond"

[[sweep]]
families = "random-cubic"
sizes = 1000000
algorithms = ["grid", "two-bend"]
)toml";

constexpr std::array<NamedStudy, 3> kStudies = {{
    {"smoke", "every algorithm and family at small sizes, a few seconds", kSmoke},
    {"quick", "every algorithm over every family that fits it, up to a hundred thousand vertices",
     kQuick},
    {"million", "one random regular graph of a million vertices for every algorithm", kMillion},
}};

}  // namespace

std::span<const NamedStudy> named_studies() { return kStudies; }

const NamedStudy* find_named_study(std::string_view name) {
  const auto at = std::find_if(kStudies.begin(), kStudies.end(),
                               [&](const NamedStudy& study) { return study.name == name; });
  return at == kStudies.end() ? nullptr : &*at;
}

}  // namespace ar3d
