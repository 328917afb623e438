// Every reference in a comment or a page leads somewhere, and a false one is noticed.
#include "support/references.h"

#include "support/test.h"

namespace ar3d::testing {
namespace {

/// A tree in which everything resolves.
Tree small_tree() {
  Tree tree;
  tree.files["docs/theorem3.md"] =
      "# A page\n**Lemma 3.1 (sums).** All differ. **Step 3.2.** `place_all` in `core.cpp`.\n"
      "By Lemma 3.1 and Steps 3.2, see [the code](../algorithms/core.cpp).\n\n"
      "[above](#a-page), [here](theorem3.md#a-page), takes --algorithm.\n\n"
      "| step | function | tests |\n|---|---|---|\n| order | `core.cpp`: `order` | `Core.*` |\n"
      "`ar3d draw - --algorithm grid`, `Core.Places`, `Core::run()`, `std::vector`\n"
      "```\nar3d study run quick | ar3d draw - --algorithm grid\n```\n";
  tree.files["algorithms/core.cpp"] =
      "/// Places by Lemma 3.1, tested in tests/core_test.cpp.\n"
      "void place_all();\nvoid order();\nstruct Core { void run(); };\n";
  tree.files["tests/core_test.cpp"] = "TEST(Core, Places) {}\n";
  tree.help = {{"", "Subcommands:\n  draw  Draws\n  study  Runs\n"},
               {"draw", "--algorithm TEXT\n"},
               {"study", "Subcommands:\n  run  Runs\n"},
               {"study run", "--threads INT\n"}};
  return tree;
}

std::vector<std::string> after_adding(const std::string& text, const std::string& path) {
  Tree tree = small_tree();
  tree.files[path] += text;
  return dangling_references(tree);
}

TEST(References, OfTheTreeResolve) {
  Tree tree = read_tree(AR3D_SOURCE_DIR);
  tree.help = read_help();
  ASSERT_GT(tree.files.size(), 300u);
  ASSERT_GT(tree.help.size(), 10u);
  for (const std::string& finding : dangling_references(tree)) ADD_FAILURE() << finding;
}

TEST(References, OfASmallTreeResolve) { EXPECT_THAT(dangling_references(small_tree()), IsEmpty()); }

TEST(References, SeeNumbersWithoutADefinition) {
  for (const std::string text :
       {"Lemma 3.9", "Step 3.1", "Rule 3.1", "Lemmas 3.1 and 3.9", "Lemma\n// 3.9", "lemma 3.1",
        "Lemma 4", "steps 1 and 3", "amendment A2", "section 5 of the proof", "finding 14", "(R2)",
        "(4.1, then 5)"}) {
    EXPECT_FALSE(after_adding("// " + text + "\n", "algorithms/core.cpp").empty()) << text;
  }
  EXPECT_THAT(after_adding("// as in Lemma 3.1\n// by Lemma 3.9\n", "algorithms/x.h"),
              ElementsAre("algorithms/x.h:2: Lemma 3.9 is not defined in bold in any page"));
}

TEST(References, KnowTheStepsOfHistoryAndTheRepairs) {
  Tree tree = small_tree();
  tree.files["docs/history.md"] = "**Step H.1 (values).** Logarithms.\n";
  tree.files["docs/theorem2-paper.md"] = "**Repair P.1 (choices).** Apart.\n";
  tree.files["algorithms/core.cpp"] += "// Step H.1, Repair P.1\n";
  EXPECT_THAT(dangling_references(tree), IsEmpty());
  EXPECT_FALSE(after_adding("// Step H.1\n", "algorithms/core.cpp").empty());
  EXPECT_FALSE(after_adding("// Repair P.2\n", "algorithms/core.cpp").empty());
}

TEST(References, SeeCommentsOfScriptsAndPages) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"tools/count.py", "n = 1  # as in Lemma 3.9\n"},
      {"tools/count.py", "\"\"\"By Step 3.9.\"\"\"\n"},
      {"tools/count.sh", "# `no_such()`\n"},
      {"tools/count", "#!/bin/sh\n# see docs/gone.md\n"},
      {"cmake/count.cmake", "# --no-such-option\n"},
      {"tests/CMakeLists.txt", "# tools/gone.py\n"},
      {"viewer/draw.js", "const a = '// '; // Rule 3.9\n"},
      {"formats/drawings/viewer/page.css", "a { } /* viewer/gone.mjs */\n"}};
  for (const auto& [path, text] : cases) {
    EXPECT_FALSE(after_adding(text, path).empty()) << path << ": " << text;
  }
  EXPECT_THAT(after_adding("print('# Lemma 3.9')  # Lemma 3.1\n", "tools/count.py"), IsEmpty());
  EXPECT_THAT(after_adding("const a = `// Lemma 3.9`;  // Lemma 3.1\n", "viewer/draw.js"),
              IsEmpty());
}

TEST(References, SeeNumbersDefinedTwiceOrInTheWrongPage) {
  EXPECT_THAT(after_adding("**Lemma 3.1.** Again.\n", "docs/theorem3.md"),
              ElementsAre(HasSubstr("Lemma 3.1 is defined twice")));
  EXPECT_THAT(after_adding("**Lemma 3.2.** Here?\n", "docs/compact.md"),
              ElementsAre(HasSubstr("Lemma 3.2 belongs into docs/theorem3.md")));
}

TEST(References, SeeFalseNamesFilesTestsAndLinks) {
  for (const std::string text :
       {"`place_none`", "`no_such()`", "`Core::walk`", "`NoSuchType`", "`gone.cpp`",
        "`docs/gone.md`", "docs/gone.md", "`algorithms/gone/`", "`Core.Gone`", "`Gone.*`",
        "[page](gone.md)", "[part](#gone)", "[part](theorem3.md#gone)", "studies/gone.toml",
        "tools/gone.py", "takes --no-such-option",
        "\n| function | test |\n|---|---|\n| `walk` | |"}) {
    EXPECT_FALSE(after_adding("\n" + text + "\n", "docs/theorem3.md").empty()) << text;
  }
}

TEST(References, SeeFalseCommands) {
  for (const std::string text :
       {"`ar3d paint x`", "`./ar3d draw - --colour red`", "`ar3d study walk`",
        "`ar3d study run quick | ar3d draw - --colour red`", "`--no-such-option`",
        "```\n$ ./ar3d paint\n```", "`ar3d study\nwalk`"}) {
    EXPECT_FALSE(after_adding("\n" + text + "\n", "docs/theorem3.md").empty()) << text;
  }
}

TEST(References, AreNotLookedForInCodeOrStrings) {
  EXPECT_THAT(after_adding("const char* text = \"Lemma 3.9 // Step 9\";\nint lemma = R2;\n",
                           "algorithms/core.cpp"),
              IsEmpty());
  // A name that only comments mention does not exist.
  EXPECT_FALSE(after_adding("// only_here\n// `only_here`\n", "algorithms/core.cpp").empty());
  EXPECT_FALSE(after_adding("// --only-here\n", "algorithms/core.cpp").empty());
  EXPECT_FALSE(after_adding("# only_here\n# `only_here`\n", "tools/count.py").empty());
}

}  // namespace
}  // namespace ar3d::testing
