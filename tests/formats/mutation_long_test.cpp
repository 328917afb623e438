#include <sys/resource.h>

#include <array>
#include <cstdio>
#include <string_view>

#include "ar3d/base/random.h"
#include "fuzz/checks.h"
#include "support/program.h"

// The checks of the fuzz targets without a fuzzer: the corpus, and mutations of it that are the
// same in every run. Needs no clang; what libFuzzer adds is the search guided by coverage.

namespace ar3d::testing {
namespace {

constexpr int kExecutions = 200000;
constexpr std::size_t kLongest = 1024;
constexpr long kMostMemoryKib = 512 * 1024;

std::vector<std::string> corpus_of(const std::string& target) {
  const fs::path corpus = AR3D_SOURCE_DIR "/tests/formats/corpus";
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(corpus)) {
    const bool wanted = target == "detected" || entry.path().parent_path().filename() == target;
    if (entry.is_regular_file() && wanted) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<std::string> texts;
  for (const auto& file : files) texts.push_back(read_file(file.string()));
  return texts;
}

/// Mutates texts of a corpus: bytes changed, pieces cut, doubled or taken from another text, and
/// words in their place that parsers have had trouble with.
class Mutator {
  template <class Items>
  const auto& any(const Items& items) {
    return items[random_.below(static_cast<std::uint32_t>(items.size()))];
  }

 public:
  Mutator(std::vector<std::string> corpus, std::uint64_t seed)
      : corpus_(std::move(corpus)), random_(seed) {}

  std::string next() {
    std::string text = any(corpus_);
    for (std::uint32_t steps = 1 + random_.below(6); steps > 0; --steps) mutate(text);
    text.resize(std::min(text.size(), kLongest));
    return text;
  }

 private:
  static constexpr std::array<std::string_view, 16> kWords = {
      "0", "1", "-1", "2147483648", "4294967295", "18446744073709551616", "\n", "\r\n",
      " ", "~", ":",  ";",          "%",          "# vertices 3\n",       "e ", "}"};

  std::size_t place(const std::string& text) {
    return random_.below(static_cast<std::uint32_t>(text.size()) + 1);
  }
  void mutate(std::string& text) {
    const std::size_t at = place(text);
    const std::size_t length = std::min<std::size_t>(text.size() - at, 1 + random_.below(12));
    switch (random_.below(6)) {
      case 0:
        if (at < text.size()) text[at] = static_cast<char>(random_.below(256));
        break;
      case 1:
        text.insert(at, 1, static_cast<char>(random_.below(256)));
        break;
      case 2:
        text.erase(at, length);
        break;
      case 3:
        text.insert(place(text), text.substr(at, length));
        break;
      case 4:
        text.replace(at, random_.chance(1, 2) ? length : 0, any(kWords));
        break;
      default: {
        const std::string& other = any(corpus_);
        text = text.substr(0, at) + other.substr(place(other));
      }
    }
  }

  std::vector<std::string> corpus_;
  RandomStream random_;
};

class Mutations : public ::testing::TestWithParam<const char*> {};

TEST_P(Mutations, AreRefusedWithOneLineOrComeBackFromTheWriter) {
  const std::string target = GetParam();
  const std::vector<std::string> corpus = corpus_of(target);
  ASSERT_FALSE(corpus.empty());
  const auto check = [&](const std::string& text) {
    if (target == "drawing") return fuzz::check_drawings(text);
    fuzz::check_graphs(target == "detected" ? "" : target, text);
  };
  for (const std::string& text : corpus) EXPECT_NO_THROW(check(text));
  Mutator mutator(corpus, 1);
  for (int i = 0; i < kExecutions; ++i) {
    const std::string text = mutator.next();
    ASSERT_NO_THROW(check(text)) << "execution " << i << ": " << shown(text);
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  EXPECT_LT(usage.ru_maxrss, kMostMemoryKib);
  std::printf("%s: %d executions, peak resident %ld KiB\n", target.c_str(), kExecutions,
              usage.ru_maxrss);
}

INSTANTIATE_TEST_SUITE_P(Targets, Mutations,
                         ::testing::Values("graph6", "sparse6", "isparse6", "edgelist", "adjlist",
                                           "matrixmarket", "metis", "dimacs", "graphml", "gml",
                                           "dot", "detected", "drawing"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace ar3d::testing
