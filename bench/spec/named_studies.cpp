#include "ar3d/bench/spec/named_studies.h"

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
compact = 25000   # and certifying the many segments of these

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
algorithms = ["diamond", "compact"]

[[sweep]]
families = "random-cubic"
sizes = 1000000
algorithms = ["grid", "two-bend"]
)toml";

constexpr std::string_view kVolume =
    R"toml(# How does the size of a drawing grow, and how close does it come to its bounds?
study = "volume"
description = "every algorithm and family at ten sizes to 10^5, eight seeds, and the effort dial"
seed = 1

[[sweep]]  # the exponents; diamond with effort 1 also computes the proof's bound for the very graph
families = { family = "all", shuffle = 1 }
sizes = { from = 100, to = 100000, per_decade = 3 }
algorithms = ["all", { algorithm = "diamond", effort = 1 }]
instances = 8

[[sweep]]  # what a smaller box costs in time
families = ["random-4-regular", "random-cubic", "random-tree"]
sizes = { from = 100, to = 100000, per_decade = 3 }
algorithms = [
  { algorithm = "diamond", effort = [0, 1, 2] },
  { algorithm = "grid", effort = [0, 1, 2] },
  { algorithm = "two-bend", effort = [0, 1, 2] },
]
instances = 8
)toml";

constexpr std::string_view kRegression =
    R"toml(# What `ar3d compare --base` runs with both builds, in turns: every kernel at two sizes.
study = "regression"
description = "what `compare --base` runs: every algorithm and family at two sizes"
seed = 1

[[sweep]]
families = "all"
sizes = [300, 3000]
algorithms = "all"
timed_repetitions = 5  # of one round; its smallest time counts
)toml";

constexpr std::array<NamedStudy, 5> kStudies = {{
    {"smoke", "every algorithm and family at small sizes, a few seconds", kSmoke},
    {"quick", "every algorithm over every family that fits it, up to a hundred thousand vertices",
     kQuick},
    {"volume", "every algorithm and family at ten sizes to 10^5, eight seeds, and the effort dial",
     kVolume},
    {"regression", "what `compare --base` runs: every algorithm and family at two sizes",
     kRegression},
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
