// What docs/tutorial.md and docs/library.md print runs as it is printed; what is installed beside
// the program works.
#include <regex>

#include "support/program.h"

namespace ar3d::testing {
namespace {

struct Block {
  std::string language;
  std::string text;
};

/// All code blocks of a page, in order.
std::vector<Block> blocks(const std::string& page) {
  const std::string text = read_file(AR3D_SOURCE_DIR "/docs/" + page);
  std::vector<Block> found;
  const std::string fence = "\n```";
  for (std::size_t at = text.find(fence); at != std::string::npos; at = text.find(fence, at + 4)) {
    const std::size_t line = text.find('\n', at + 4);
    const std::size_t end = text.find(fence, line - 1);
    found.push_back(
        {text.substr(at + 4, line - at - 4), text.substr(line + 1, end + 1 - line - 1)});
    at = end;
  }
  return found;
}

/// A folder in which `ar3d` is the program that was built.
std::string enter(const ScratchDirectory& folder) {
  if (!fs::exists(folder.path("bin"))) {
    fs::create_directory(folder.path("bin"));
    fs::create_symlink(AR3D_PROGRAM, folder.path("bin/ar3d"));
  }
  return "cd " + folder.path("") + " && export PATH=" + folder.path("bin") +
         ":$PATH && set -eo pipefail\n";
}

TEST(Tutorial, RunsAsPrinted) {
  const ScratchDirectory folder;
  std::string all;
  std::size_t count = 0;
  for (const Block& block : blocks("tutorial.md")) {
    ++count;
    if (block.language == "python") folder.write("printed.py", block.text);
    const std::string command =
        block.language == "python" ? "/usr/bin/python3 printed.py" : block.text;
    const Outcome outcome = expect_exit(0, run(enter(folder) + command));
    all += outcome.out;
  }
  EXPECT_EQ(count, 7u);
  EXPECT_THAT(all, HasSubstr("1 certified, 0 violated, 0 not drawn"));
  EXPECT_THAT(all, HasSubstr("0 certified, 1 violated, 0 not drawn"));
  EXPECT_THAT(all, HasSubstr("50 certified, 0 violated, 0 not drawn"));
  for (const char* made : {"k5.html", "k5.svg", "broken.html", "trade.html", "k5.tikz"}) {
    EXPECT_TRUE(fs::exists(folder.path(made))) << made;
  }
}

/// The name that the first line of a program gives: "// draw_file.cpp: …".
std::string file_of(const std::string& text) {
  std::smatch found;
  std::regex_search(text, found, std::regex("^(?://|#) ([a-zA-Z_]+\\.(?:cpp|txt))"));
  return found.empty() ? "" : found[1].str();
}

/// What the installed completion of a shell offers. @param prepare  defines `say WORD…`, which
/// prints what is offered for the last word, a line each.
void expect_completion(const ScratchDirectory& folder, const std::string& shell,
                       const std::string& prepare) {
  folder.write("ask." + shell,
               prepare +
                   "say ar3d ve\nsay ar3d study resu\nsay ar3d draw x --algorithm diam\n"
                   "say ar3d draw x --til\nsay ar3d draw x --format gr\n"
                   "say ar3d generate cycl\nsay ar3d study run smo\n"
                   "say ar3d verify x --crossing-test sl\nsay ar3d list named-\n");
  const Outcome offered = expect_exit(0, run(enter(folder) + shell + " ask." + shell));
  EXPECT_EQ(offered.out,
            "verify\nresume\ndiamond\n--tilt\ngraphml\ncycle\nsmoke\nslabs\nnamed-graphs\n")
      << shell << offered.err;
}

/// The table behind it names every verb with its meaning, and whatever has words for values.
TEST(Completion, TableHoldsEveryVerbAndItsWords) {
  const Outcome table =
      expect_exit(0, run(AR3D_SOURCE_DIR "/tools/completion " AR3D_PROGRAM " table"));
  for (const char* line :
       {"\n\tdraw\tDraws every graph of files\t\n", "\nstudy\trun\tRuns a study and",
        "\nstudy run\t\t\t=studies\n", "\nhelp\t\t\tlist generate draw ",
        "\nverify\t--crossing-test\t", "\tautomatic all-pairs slabs\n",
        "\nreport\t--reference\tresults file of"}) {
    EXPECT_THAT("\n" + table.out, HasSubstr(line));
  }
  expect_exit(2, run(AR3D_SOURCE_DIR "/tools/completion " AR3D_PROGRAM " csh"));
}

TEST(LibraryPage, ProgramsCompileAndRun) {
  const ScratchDirectory folder;
  std::string commands;
  for (const Block& block : blocks("library.md")) {
    if (block.language == "sh") {
      commands += block.text;
    } else {
      folder.write(file_of(block.text), block.text);
    }
  }
  const std::string build =
      "cmake --install " AR3D_BINARY_DIR " --prefix " + folder.path("prefix") +
      " >/dev/null && cmake -S . -B build -DCMAKE_PREFIX_PATH=" + folder.path("prefix") +
      " >/dev/null && cmake --build build >/dev/null\n";
  expect_output(run(enter(folder) + build + commands),
                {"small.s6:3: certified, box ", "the angle at 0 is exactly 120 degrees",
                 "4 components\n12 edges drawn"});
  EXPECT_TRUE(fs::exists(folder.path("drawing.svg")));

  const std::string man = read_file(folder.path("prefix/share/man/man1/ar3d.1"));
  for (const char* verb : {"AR3D DRAW", "AR3D VIEW", "ar3d study run", "exact lattice coord"}) {
    EXPECT_THAT(man, HasSubstr(verb));
  }
  expect_completion(folder, "bash",
                    "source prefix/share/bash-completion/completions/ar3d\n"
                    "say() { COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1)); _ar3d; "
                    "printf '%s\\n' \"${COMPREPLY[@]}\"; }\n");
  // The functions of zsh's completion system that are called, as far as they are needed here.
  expect_completion(folder, "zsh",
                    "_describe() { print -rl -- ${${(P)2}%%:*} }; _files() { print files }\n"
                    "fpath=($PWD/prefix/share/zsh/site-functions $fpath); autoload -U _ar3d\n"
                    "say() { words=(\"$@\"); CURRENT=$#; _ar3d }\n");
  expect_completion(folder, "fish",
                    "source prefix/share/fish/vendor_completions.d/ar3d.fish\n"
                    "function say; complete -C (string join ' ' -- $argv) | cut -f1; end\n");
}

TEST(Gallery, IsWhatItsScriptMakes) {
  const ScratchDirectory folder;
  const Outcome outcome = expect_exit(
      0, run(AR3D_SOURCE_DIR "/tools/gallery " AR3D_PROGRAM " " + folder.path("made") +
             " && diff -rq " + folder.path("made") +
             " " AR3D_SOURCE_DIR
             "/docs/gallery"));  // run tools/gallery if drawings have changed on purpose
}

}  // namespace
}  // namespace ar3d::testing
