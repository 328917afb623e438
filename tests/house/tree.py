"""Rules that the files of the tree keep, each with a fault that is found: tree.py SOURCE BUILD AR3D [UNITTEST'S ARGUMENTS]."""
import collections
import functools
import pathlib
import re
import subprocess
import sys
import unittest

import references

SOURCE, BUILD, AR3D = sys.argv[1:4]
BINARY = (".h5", ".csv", ".gz", ".xz", ".png", ".pdf")
FOLDERS = ("algorithms", "analysis", "apps", "base", "bench", "formats", "generators", "model", "optimum", "python", "store", "verify")
OWN = rf"({'|'.join(FOLDERS)})/.*"


def printed(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def is_left_out(part):
    return part.startswith((".", "build")) or part in ("_skbuild", "node_modules")


@functools.cache
def tree():
    """The files below the root that people write, text by path: no build folders, no hidden ones, nothing binary."""
    root = pathlib.Path(SOURCE)
    found, folders = {}, [root]
    for folder in folders:
        for path in sorted(folder.iterdir()):
            if path.is_dir() and not path.is_symlink() and not is_left_out(path.name):
                folders.append(path)
            elif path.is_file():
                found[path.relative_to(root).as_posix()] = "" if path.suffix in BINARY else path.read_text(errors="replace")
    return found


def helps(verb=""):
    text = printed(AR3D, *verb.split(), "--help")
    found = {verb: text}
    listed = re.match(r".*\n((?:  .*\n?)*)", text.partition("Subcommands:")[2])
    for name in re.findall(r"^  (\S+)", listed[1], re.M) if listed else ():
        found |= helps(f"{verb} {name}".strip())
    return found


class Rule(unittest.TestCase):
    maxDiff = None

    def expect_of_sources(self, pattern, least, lacks):
        """`lacks` finds nothing in any file whose whole path matches, of which there are more than `least`."""
        sources = [path for path in tree() if re.fullmatch(pattern, path)]
        self.assertGreater(len(sources), least)
        self.assertEqual([f"{path}: {lack}" for path in sources if (lack := lacks(tree()[path]))], [])


SMALL = {
    "docs/theorem3.md": "# A page\n**Lemma 3.1 (sums).** All differ. **Step 3.2.** `place_all` in `core.cpp`.\n"
                        "By Lemma 3.1 and Steps 3.2, see [the code](../algorithms/core.cpp).\n\n"
                        "[above](#a-page), [here](theorem3.md#a-page), takes --algorithm.\n\n"
                        "| step | function | tests |\n|---|---|---|\n| order | `core.cpp`: `order` | `Core.*` |\n"
                        "`ar3d draw - --algorithm grid`, `Core.Places`, `More.test_it`, `Core::run()`, `std::vector`\n"
                        "```\nar3d study run quick | ar3d draw - --algorithm grid\n```\n",
    "algorithms/core.cpp": "/// Places by Lemma 3.1, tested in tests/core_test.cpp.\n"
                           "void place_all();\nvoid order();\nstruct Core { void run(); };\n",
    "tests/core_test.cpp": "TEST(Core, Places) {}\n",
    "tests/more_test.py": "class More(Case):\n    def test_it(self):\n        pass\n"}
SMALL_HELP = {"": "Subcommands:\n  draw  Draws\n  study  Runs\n", "draw": "--algorithm TEXT\n",
              "study": "Subcommands:\n  run  Runs\n", "study run": "--threads INT\n"}


def after_adding(text, path, files=SMALL):
    return references.dangling(files | {path: files.get(path, "") + text}, SMALL_HELP)


class References(Rule):
    """Every reference in a comment or a page leads somewhere, and a false one is noticed."""

    def see(self, path, *texts):
        for text in texts:
            self.assertNotEqual(after_adding(text, path), [], f"{path}: {text}")

    def test_of_the_tree_resolve(self):
        self.assertGreater(len(tree()), 300)
        self.assertGreater(len(known := helps()), 10)
        self.assertEqual(references.dangling(tree(), known), [])

    def test_of_a_small_tree_resolve(self):
        self.assertEqual(references.dangling(SMALL, SMALL_HELP), [])

    def test_see_numbers_without_a_definition(self):
        for text in ("Lemma 3.9", "Step 3.1", "Rule 3.1", "Lemmas 3.1 and 3.9", "Lemma\n// 3.9", "lemma 3.1", "Lemma 4",
                     "steps 1 and 3", "amendment A2", "section 5 of the proof", "finding 14", "(R2)", "(4.1, then 5)"):
            self.see("algorithms/core.cpp", f"// {text}\n")
        self.assertEqual(after_adding("// as in Lemma 3.1\n// by Lemma 3.9\n", "algorithms/x.h"),
                         ["algorithms/x.h:2: Lemma 3.9 is not defined in bold in any page"])

    def test_know_the_steps_of_history_and_the_repairs(self):
        files = SMALL | {"docs/history.md": "**Step H.1 (values).** Logarithms.\n",
                         "docs/theorem2-paper.md": "**Repair P.1 (choices).** Apart.\n"}
        self.assertEqual(after_adding("// Step H.1, Repair P.1\n", "algorithms/core.cpp", files), [])
        self.see("algorithms/core.cpp", "// Step H.1\n", "// Repair P.2\n")

    def test_see_comments_of_scripts_and_pages(self):
        self.see("tools/count.py", "n = 1  # as in Lemma 3.9\n", '"""By Step 3.9."""\n')
        self.see("tools/count.sh", "# `no_such()`\n")
        self.see("tools/count", "#!/bin/sh\n# see docs/gone.md\n")
        self.see("cmake/count.cmake", "# --no-such-option\n")
        self.see("tests/CMakeLists.txt", "# tools/gone.py\n")
        self.see("viewer/draw.js", "const a = '// '; // Rule 3.9\n")
        self.see("formats/drawings/viewer/page.css", "a { } /* viewer/gone.mjs */\n")
        self.assertEqual(after_adding("print('# Lemma 3.9')  # Lemma 3.1\n", "tools/count.py"), [])
        self.assertEqual(after_adding("const a = `// Lemma 3.9`;  // Lemma 3.1\n", "viewer/draw.js"), [])

    def test_see_numbers_defined_twice_or_in_the_wrong_page(self):
        self.assertEqual(after_adding("**Lemma 3.1.** Again.\n", "docs/theorem3.md"),
                         ["docs/theorem3.md: Lemma 3.1 is defined twice"])
        self.assertEqual(after_adding("**Lemma 3.2.** Here?\n", "docs/compact.md"),
                         ["docs/compact.md: Lemma 3.2 belongs into docs/theorem3.md"])

    def test_see_false_names_files_tests_links_and_commands(self):
        for text in ("`place_none`", "`no_such()`", "`Core::walk`", "`NoSuchType`", "`gone.cpp`", "`docs/gone.md`", "docs/gone.md",
                     "`algorithms/gone/`", "`Core.Gone`", "`Gone.*`", "`More.test_gone`", "[page](gone.md)", "[part](#gone)",
                     "[part](theorem3.md#gone)", "studies/gone.toml", "tools/gone.py", "takes --no-such-option",
                     "\n| function | test |\n|---|---|\n| `walk` | |", "`ar3d paint x`", "`./ar3d draw - --colour red`",
                     "`ar3d study walk`", "`ar3d study run quick | ar3d draw - --colour red`", "`--no-such-option`",
                     "```\n$ ./ar3d paint\n```", "`ar3d study\nwalk`"):
            self.see("docs/theorem3.md", f"\n{text}\n")

    def test_are_not_looked_for_in_code_or_strings(self):
        self.assertEqual(after_adding('const char* text = "Lemma 3.9 // Step 9";\nint lemma = R2;\n', "algorithms/core.cpp"), [])
        # A name that only comments mention does not exist.
        self.see("algorithms/core.cpp", "// only_here\n// `only_here`\n", "// --only-here\n")
        self.see("tools/count.py", "# only_here\n# `only_here`\n")


def lacks_in_head(source):
    """What the lines that a source begins with lack; "" if nothing."""
    head = re.match(r"(//.*\n)*", source)[0]
    if not 2 <= head.count("\n") <= 6:
        return "two to six lines of comment"
    if not re.search(r"\b(Step|Lemma|Rule|Theorem)s?\s+[0-9A-Z]", head):
        return "a step, lemma, rule or theorem"
    return "" if re.search(r"\bO\(|\bCost:", head) else "its cost"


class HeadComments(Rule):
    """Each source opens with what it does; each stage of an algorithm with its step of the proof and its cost (CONTRIBUTING.md)."""

    def test_of_every_stage_name_its_step_and_its_cost(self):
        self.expect_of_sources(r"algorithms/\w+/\w+\.cpp", 60, lacks_in_head)

    def test_open_every_source(self):
        self.expect_of_sources(OWN + r"\.cpp", 250, lambda source: not source.startswith("// "))

    def test_are_followed_by_one_anonymous_namespace_at_most(self):
        self.expect_of_sources(r".*\.(cpp|h)", 250, lambda source: source.count("\nnamespace {\n") > 1)

    def test_lack_what_is_not_there(self):
        for source, lack in {"// Step 3.1: orders.\n// Cost: O(n).\nint n;\n": "", "// Steps 3.1 and\n// 3.2. O(n).\nint n;\n": "",
                             "int n;\n": "two to six lines of comment", "// Step 3.1. O(n).\nint n;\n": "two to six lines of comment",
                             "// Orders.\n// O(n).\nint n;  // Step 3.1\n": "a step, lemma, rule or theorem",
                             "// Step 3.1:\n// orders.\nint n;  // O(n)\n": "its cost"}.items():
            self.assertEqual(lacks_in_head(source), lack)


def sub_folders():
    """Folders with sources, at any depth, below those that docs/architecture.md lists."""
    return {path.rpartition("/")[0] for path in tree() if path.endswith((".h", ".cpp")) and path.count("/") > 1
            and not re.match(r"(tests|examples|tools|python|bench/kernels)/", path)}


def allowed():
    """Who may include whom: items "- `apps/`, `bench/`: model, formats" of docs/architecture.md and lines "bench/plan: spec" of
    tests/house/includes.txt. "everything" frees from all rules. A sub-folder without a line includes no other one."""
    items = re.findall(r"^- ((?:`[a-z]+/`(?:, )?)+): ([a-z, ]+)$", tree()["docs/architecture.md"], re.M)
    rows = [(folder, others) for folders, others in items for folder in re.findall("`([a-z]+)/`", folders)]
    rows += re.findall(r"^([a-z_/0-9]+): ([a-z_0-9, ]+)$", tree()["tests/house/includes.txt"], re.M)
    return dict.fromkeys(sub_folders(), set()) | {
        folder: None if others == "everything" else set(re.findall("[a-z_0-9]+", others)) for folder, others in rows}


def includes(folder):
    """Pairs of a source below the folder and what it includes of the tree."""
    return [(path, target) for path in tree() if path.startswith(folder + "/") and path.endswith((".h", ".cpp"))
            for target in re.findall(r'^#include "ar3d/([^"]+)"', tree()[path], re.M)]


def folder_of(path, depth):
    return "/".join(path.split("/")[:-1][:depth])


def forbidden_includes(table):
    wrong = []
    for folder, others in table.items():
        depth = folder.count("/") + 1
        outer = folder.rpartition("/")[0]
        for path, target in includes(folder) if others is not None else ():
            to = folder_of(target, depth)
            is_free = table.get(folder_of(path, 2), set()) is None or folder_of(target, depth - 1) != outer or to in (folder, outer)
            if not is_free and to.rpartition("/")[2] not in others:
                wrong.append(f"{path}: {target}")
    return wrong


def rings(table):
    """What is left of a relation when whatever leads to nothing that is left, or is led to by nothing that is left, goes."""
    before = None
    while before != table:
        before = table
        table = {place: {to for to in others if to != place and to in table} for place, others in table.items()}
        used = set().union(*table.values())
        table = {place: others for place, others in table.items() if others and place in used}
    return table


def rings_of_folders(among):
    """Folders that lead back to themselves. In every folder a sub-folder with all below it is one place, and so is each of the
    folder's own units, a header with its source: units may lead to each other, no sub-folder is among those."""
    found = {}
    for path, target in among:
        for depth in range(path.count("/") + 1):
            outer = folder_of(path, depth)
            if folder_of(target, depth) == outer:
                places = [folder_of(name, depth + 1) + "/" if name.count("/") > depth else name.rpartition(".")[0]
                          for name in (path, target)]
                found.setdefault(outer, {}).setdefault(places[0], set()).add(places[1])
    return sorted(name for table in found.values() for name in rings(table) if name.endswith("/"))


class IncludeDirection(Rule):
    """The folders are the data flow: docs/architecture.md and includes.txt say who may include whom."""

    def test_follows_the_tables(self):
        self.assertEqual(forbidden_includes(allowed()), [])

    def test_has_no_rings(self):
        table = {folder: {folder[:folder.rfind("/") + 1] + other for other in others} for folder, others in allowed().items()
                 if others is not None}
        self.assertEqual(rings(table), {})
        self.assertEqual(len(rings(table | {"base": {"model"}})), 2)
        own = [pair for folder in allowed() if "/" not in folder for pair in includes(folder)]
        self.assertGreater(len(own), 1000)
        self.assertEqual(rings_of_folders(own), [])
        self.assertEqual(rings_of_folders([("a/b/c/x.h", "a/b/d/y.h"), ("a/b/d/z.h", "a/b/c/w.h")]), ["a/b/c/", "a/b/d/"])
        self.assertEqual(rings_of_folders([("a/face.h", "a/b/x.h"), ("a/b/y.h", "a/face.h")]), ["a/b/"])

    def test_has_a_rule_for_every_folder_with_sources(self):
        folders = {folder_of(path, 1) for path in tree() if re.fullmatch(r"\w+/CMakeLists\.txt", path)} - {"apps", "tests"}
        self.assertGreater(len(sub_folders()), 20)
        self.assertEqual(folders - allowed().keys(), set())

    def test_sees_forbidden_includes(self):
        self.assertEqual(allowed()["algorithms/grid"], set())  # which has no line
        for folder in ("verify", "bench/run"):  # verify does include model, and run makes what plan says
            self.assertNotEqual(forbidden_includes(allowed() | {folder: set()}), [])

    def test_only_store_includes_hdf5(self):
        self.expect_of_sources(OWN.replace("store|", "") + r"\.(h|cpp)", 300, lambda source: "#include <hdf5" in source)


HELPER = re.compile(r"^(?:template <[^{}]*?>\n)?(?:(?:struct|class|enum class|enum) (\w+)[^;]*?[{=]|(?:inline |static )?constexpr [^;(){}=]*?(\w+)"
                    r"(?:\[\w*\])?(?: =|\{)|(?!struct|class|enum|using|namespace|constexpr)[\w:][^;{}()=]*?[ &*](\w+)\(([^;{}]*)\)[^;{}()]*\{)", re.M)


def helpers_of(source):
    """What a file's anonymous namespaces define: namespace, name and, of a function, the types of its parameters."""
    found = set()
    for start in re.finditer(r"^namespace \{\n", source, re.M):
        outer = re.findall(r"^namespace (ar3d[\w:]*) \{", source[:start.start()], re.M)
        inner = source[start.end():].partition("\n}  // namespace\n")[0]
        for type_name, constant, function, parameters in HELPER.findall(inner):
            types = [re.sub(r"\s*=.*|\s*\b\w+$", "", part.strip()) for part in parameters.split(",")]
            found.add((outer[-1] if outer else "", type_name or constant or function, ", ".join(types) if function else ""))
    return found


def clashes(files):
    """Names of helpers that two sources of one folder define, which are compiled together."""
    owners = collections.defaultdict(list)
    for path in sorted(files):
        if path.endswith(".cpp"):
            for helper in helpers_of(files[path]):
                owners[path.rpartition("/")[0], helper].append(path)
    return sorted(f"{paths[0]} and {paths[1]}: {helper[1]}" for (_, helper), paths in owners.items() if len(paths) > 1)


class HelperNames(Rule):
    """Sources of a folder are compiled together: what their anonymous namespaces define has names of its own."""

    def test_stand_once_in_a_folder(self):
        production = {path: text for path, text in tree().items() if re.fullmatch(OWN, path)}
        self.assertGreater(sum(len(helpers_of(text)) for text in production.values()), 1500)
        self.assertEqual(clashes(production), [])

    def test_that_clash_are_named_with_their_files(self):
        one = "namespace ar3d {\nnamespace {\n\nint count(const Graph& a,\n          int b) {\n  return 1;\n}\n\n}  // namespace\n"
        self.assertEqual(clashes({"a/x.cpp": one, "a/y.cpp": one.replace("Graph& a", "Graph& graph")}), ["a/x.cpp and a/y.cpp: count"])
        for other in (one.replace("count", "sum"), one.replace("Graph", "Drawing"), one.replace("ar3d {", "ar3d::grid {")):
            self.assertEqual(clashes({"a/x.cpp": one, "a/y.cpp": other}), [])
        self.assertEqual(clashes({"a/x.cpp": one, "b/x.cpp": one}), [])


class TestNames(Rule):
    """A test's name is letters and digits; a parameter is named, not printed as bytes or counted: people read and type them."""

    @staticmethod
    def is_readable(name):
        return re.fullmatch(r"[A-Za-z0-9_./]+", name) and not re.fullmatch(r".*/[0-9]+", name)

    def test_of_ctest_are_readable(self):
        names = re.findall(r"^ *Test +#\d+: (.*)$", printed("ctest", "--test-dir", BUILD, "-N"), re.M)
        self.assertGreater(len(names), 10)
        self.assertEqual([name for name in names if not self.is_readable(name)], [])

    def test_that_are_bytes_or_counts_are_not(self):
        self.assertFalse(self.is_readable("Table/Family.Holds/40-byte object <08-00 00-00>"))
        self.assertFalse(self.is_readable("Tests/Violations.NoneInAValidDrawing/2"))
        self.assertTrue(self.is_readable("Sizes/TwoBendExhaustive.CertifiesEveryGraph/n5"))


class Commits(Rule):
    """What is said of a change stays readable where logs show it: "folder: do this", of at most 72 characters."""
    IMPERATIVES = ("pass", "address", "compress", "process", "focus", "need", "feed", "embed", "bring")

    def subjects(self, *which):
        if not (pathlib.Path(SOURCE) / ".git").exists():
            self.skipTest("no git repository")
        return printed("git", "-C", SOURCE, "log", *which, "--no-merges", "--format=%s").splitlines()

    def is_named_and_imperative(self, subject):
        topics, _, said = subject.partition(": ")
        verb = said.partition(" ")[0].lower()
        return all((pathlib.Path(SOURCE) / topic.partition("/")[0]).exists() for topic in topics.split(", ")) and bool(verb) and (
            verb in self.IMPERATIVES or not re.search(r"(ed|ing|s)$", verb))

    def test_have_short_subjects(self):
        self.assertEqual([subject for subject in self.subjects("-50") if len(subject) > 72], [])

    def test_name_a_folder_and_what_to_do(self):
        for wrong in ("Fix the reader", "formats: fixed the reader", "formats: reads tabs", "reader: read tabs", "formats: "):
            self.assertFalse(self.is_named_and_imperative(wrong), wrong)
        for right in ("formats/graphs: read tabs", "docs, README.md: name the page", "store: compress rows"):
            self.assertTrue(self.is_named_and_imperative(right), right)
        new = self.subjects("--since=2026-11-28", "-50")  # the day from which on it is a rule
        self.assertEqual([subject for subject in new if not self.is_named_and_imperative(subject)], [])


NO_FUNCTION = re.compile(r"\s*(inline )?(namespace|class|struct|enum|union|return|switch|for|if|while|do|else|try)\b.*|.*= ?\{|"
                         r".*R\"\w*\(.*")


def indent(line):
    return len(line) - len(line.lstrip(" ")) if line else -1


def closing(lines, begin, column):
    """The line that closes the block opened on line `begin`: the next one that starts with "}" and is indented by `column` at most."""
    return next((at for at in range(begin + 1, len(lines)) if 0 <= indent(lines[at]) <= column and lines[at].lstrip()[0] == "}"),
                len(lines))


def counted(lines, begin, end):
    """Lines of a block without the tables in it (between "return {" or "= {" and its end) and texts of several lines."""
    count, raw, at = 0, False, begin
    while at <= end and at < len(lines):
        count += not raw
        raw = (raw or 'R"' in lines[at]) and ')"' not in lines[at]
        if not raw and at > begin and re.fullmatch(r".*(return|=) \{", lines[at]):
            at = closing(lines, at, indent(lines[at]))
        at += 1
    return count


def long_functions(lines):
    """The functions of a formatted source with more than 60 lines. They stand at column 0, in a class at column 2; their first
    line may go on for several lines until the one that ends in "{"."""
    found = []
    for column in (0, 2):
        head, at = None, 0
        while at < len(lines):
            line = lines[at]
            if indent(line) == column and line[column].isalpha():
                head = line
            if line.endswith("{") and head and (indent(line) == column or indent(line) >= column + 4) and not NO_FUNCTION.fullmatch(head):
                end = closing(lines, at, column)
                if counted(lines, at, end) > 60:
                    found.append(head)
                at, head = end, None
            at += 1
    return found


class Sizes(Rule):
    """Functions have at most 60 lines and files at most 400 (CONTRIBUTING.md)."""

    def test_of_functions_and_files_keep_the_limits(self):
        self.expect_of_sources(rf"({OWN}|tests/.*)\.(h|cpp)", 400, lambda source: len(source.splitlines()) > 400 or
                               ", ".join(long_functions(source.splitlines())))

    def test_see_a_long_function_but_not_a_long_table(self):
        def function(length, body):
            return ["int f(int a,", "      int b) {", *[body] * (length - 2), "}"]
        self.assertEqual(len(long_functions(function(60, "  f(1, 2);"))), 0)
        self.assertEqual(len(long_functions(function(63, "  f(1, 2);"))), 1)
        table = function(100, "      {1, 2},")
        table[2] = "  return {"
        self.assertEqual(long_functions([*table[:-1], "  };", "}"]), [])


class Terminal(Rule):
    """One function writes what people read, so that no name or message of others can steer a terminal."""
    DIRECT = re.compile(r"\bfmt::print\(|std::(?:cout|cerr|clog|puts)\b|\bv?f?printf\([^;]*%s|fputs\((?!\")")

    def test_every_verb_writes_through_say(self):
        self.expect_of_sources(r"(apps|analysis|bench/(compare|keep|plan|replay|search|spec))/.*\.(cpp|h)", 100, self.DIRECT.search)

    def test_direct_output_is_found(self):
        self.assertFalse(self.DIRECT.search('say(stderr, "{}", x); std::fputs("\\r", stdout);'))
        for text in ('fmt::print("{}", x);', 'std::printf("%s", x);', "std::cerr << x;"):
            self.assertTrue(self.DIRECT.search(text), text)


class Variables(Rule):
    """Every variable of the environment that anything in the tree reads is explained on one page."""

    def test_are_explained(self):
        read = re.compile(r'getenv\("([A-Z_0-9]+)"|process\.env\.([A-Z_0-9]+)|environ\["([A-Z_0-9]+)"|\$\{([A-Z][A-Z_0-9]+):?[-+=]')
        names = {"".join(name) for path, text in tree().items() if not path.endswith(".md") for name in read.findall(text)}
        self.assertGreaterEqual(len(names), 18)
        self.assertEqual({name for name in names if f"`{name}`" not in tree()["docs/contracts.md"]}, set())


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
