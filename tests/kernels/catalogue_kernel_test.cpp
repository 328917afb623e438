// The kernels are the catalogues' rows: nothing has to be registered by hand, nothing is left out.
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/formats/catalog.h"
#include "ar3d/generators/catalog.h"
#include "support/program.h"

namespace ar3d::testing {
namespace {

const std::string kKernels = AR3D_KERNELS;
const std::set<std::string> kKinds = {"draw", "certify", "generate", "parse"};

// "draw/diamond/cycle" of "draw/diamond/cycle/1000/process_time/real_time", for the kernels of the
// catalogues; others stand beside them.
std::set<std::string> subjects(const std::string& arguments) {
  std::istringstream lines(run(kKernels + " --benchmark_list_tests " + arguments).out);
  std::set<std::string> subjects;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t place = line.find("/process_time");
    const std::string kind = line.substr(0, line.find('/'));
    if (place == std::string::npos || !kKinds.contains(kind)) continue;
    subjects.insert(line.substr(0, line.rfind('/', place - 1)));
  }
  return subjects;
}

TEST(Kernels, EveryRowOfTheCataloguesHasItsKernels) {
  std::set<std::string> expected;
  for (const Family& family : families()) {
    expected.insert("generate/" + family.name);
    for (const GraphFormat& format : graph_formats()) {
      expected.insert("parse/" + format.name + "/" + family.name);
    }
    for (const Algorithm& algorithm : algorithms()) {
      if (family.max_degree > algorithm.guarantee.max_degree) continue;
      if (algorithm.by_name_only) continue;
      expected.insert("draw/" + algorithm.name + "/" + family.name);
      expected.insert("certify/" + algorithm.name + "/" + family.name);
    }
  }
  EXPECT_EQ(subjects("--benchmark_filter=."), expected);
}

TEST(Kernels, WithoutFilterAFewOfEveryKindRun) {
  const std::set<std::string> few = subjects("");
  EXPECT_LT(few.size(), 50u);
  for (const char* name :
       {"draw/diamond/random-4-regular", "draw/grid/random-cubic", "certify/two-bend/random-cubic",
        "generate/random-cubic", "parse/sparse6/random-cubic"}) {
    EXPECT_TRUE(few.contains(name)) << name;
  }
}

TEST(Kernels, ReportTimesAndRatesAndNoComplexity) {
  const ScratchDirectory scratch;
  const std::string file = scratch.path("out.json");
  const Outcome outcome =
      expect_exit(0, run(kKernels +
                         " --benchmark_filter='^(draw|certify|generate|parse)/.*/?cycle/1000/"
                         "' --benchmark_min_time=0 --benchmark_out=" +
                         file));
  const auto report = nlohmann::json::parse(read_file(file));
  std::set<std::string> kinds;
  for (const auto& row : report.at("benchmarks")) {
    const std::string name = row.at("name");
    kinds.insert(name.substr(0, name.find('/')));
    EXPECT_FALSE(row.contains("error_message")) << row;
    EXPECT_EQ(row.at("run_type"), "iteration") << "complexity would be an aggregate";
    for (const char* value : {"real_time", "cpu_time", "items_per_second", "bytes_per_second"}) {
      EXPECT_GT(row.at(value).get<double>(), 0) << row;
    }
  }
  EXPECT_EQ(kinds, kKinds);
}

TEST(Kernels, UnknownArgumentsAreErrors) { expect_exit(2, run(kKernels + " --colour")); }

}  // namespace
}  // namespace ar3d::testing
