"""References in comments (of C++, JavaScript, style sheets, Python, CMake and shell) and in pages that lead nowhere.

dangling(files, helps) returns them as "file:line: what". `files` is text by path, `helps` the help of the program by verb and sub-verb.
What is looked at:
 - Lemma, Rule, Step and Repair with a number, which a page defines in bold (CONTRIBUTING.md, "How to cite"); bare numbers, and numbers
   of notes that are not in the tree;
 - in backticks: functions, types and columns (a word of the code), files, tests (Suite.Name), commands of the program with options;
 - options, in backticks or not;
 - links between pages and to headings, and paths that begin with a folder of the tree."""
import os
import re

PAGES = {"1": "theorem1", "2": "theorem2", "3": "theorem3", "C": "compact", "D": "compact-120", "E": "two-bend-109", "F": "two-bend-120",
         "G": "theorem3-paper", "H": "history", "L": "lower-bounds", "O": "optimum", "P": "theorem2-paper", "R": "routed", "V": "verify"}
NUMBER = r"(?:[0-9CDEFGHLOPRV]\.[0-9]+|[0-9]+)"
DEFINITION = re.compile(r"(?:^|[^`])\*\*(Lemma|Rule|Step|Repair) ([0-9CDEFGHLOPRV])\.([0-9]+)")
CITATION = re.compile(rf"\b([Ll]emma|[Rr]ule|[Ss]tep|[Ss]tage|[Rr]epair)s?\s+{NUMBER}(?:(?:,|\s+and|\s+to|\s+or|–)\s*{NUMBER})*(?!\w)")
PRIVATE = re.compile(r"\bamendments?\s+[A-Z]?[0-9]|\bfinding\s+[0-9]|\bsections?\s+[0-9]+(?!\.)")
PRIVATE_IN_CODE = re.compile(r"\([^()\n]*\b[RA][0-9]{1,2}\b[^()]*\)|\([0-9]\.[0-9](?:\.[0-9])?[,;)]")
LINK = re.compile(r"\]\(([^)#\s]*)(?:#([^)\s]*))?\)")
HEADING = re.compile(r"(?:^|\n)#+ +([^\n]*)")
PATH = re.compile(r"(?:^|[\s(`\"])((?:algorithms|analysis|apps|base|bench|cmake|docs|examples|formats|generators|model|python|records|"
                  r"results|store|studies|tests|tools|verify|viewer)/[\w./-]*\w\.(?:h|cpp|md|toml|txt|cmake|svg|csv|h5|py|mjs|js|css|sh))"
                  r"(?![\w*<{])")
PLACEHOLDER = re.compile(r".*[A-Z]{3}.*\.(csv|h5)")
CALL = re.compile(r"(?:^ *|[|;&$] *|[A-Z_]+=\S+ +|mpirun -n \S+ +)(?:\./)?ar3d +((?:[^|;&>#\n]|\\\|)+)", re.M)
OPTION_IN_PROSE = re.compile(r"(?:^|[\s(\"])(--[a-z][a-z_-]*[a-z])")
OUTSIDE = re.compile(r"OMP_NUM_THREADS|FIELD_i_NAME|member_|kConstant|perf_event_open|hdf5\.h|--sshlogin|--return|--array|--mem|--time|fuzz_.*|"
                     r"ar3d_.*_tests|--(gtest|benchmark)_.*|.*_(bound|slack)_[xyz]|slack_[xyz]|(theorem|published)_[a-z_]+|std::.*")
# What a span in backticks is.
FILE = re.compile(r"[\w.-]+(/[\w.-]+)*\.(h|cpp|md|cmake|svg)|(\w+/)+")
TEST = re.compile(r"[A-Z][A-Za-z0-9]*\.(\*|[A-Z]\w*|test_\w+)")
OPTION = re.compile(r"--[a-z][a-z-]+")
NAME = re.compile(r"[A-Za-z_]\w*(::[A-Za-z_]\w*)*(\(.*\))?")
MARKED = re.compile(r".*[a-z]_.*|.*::.*|.*\)|[A-Z]?[a-z0-9]+[A-Z].*")

SLASHES = r"(?P<comment>//[^\n]*|/\*[\s\S]*?(?:\*/|$))|R\"(\w*)\([\s\S]*?\)\2\"|\"(?:\\[\s\S]|[^\"\\])*\"?|(?<![A-Za-z0-9])'(?:\\[\s\S]|[^'\\])*'?"
HASHES = r"(?P<comment>(?<!\S)#[^\n]*)|\\[\s\S]|\"(?:\\[\s\S]|[^\"\\\n])*[\"\n]?|'(?:\\[\s\S]|[^'\\\n])*['\n]?"
LANGUAGES = {"c": re.compile(SLASHES), "js": re.compile(SLASHES + r"|`(?:\\[\s\S]|[^`\\])*`?"), "sh": re.compile(HASHES),
             "py": re.compile(r"(?P<text>\"\"\"[\s\S]*?(?:\"\"\"|$))|" + HASHES)}


def blank(text):
    return re.sub(r"[^\n]", " ", text)


def language_of(path, text):
    ending = os.path.splitext(path)[1]
    if ending in (".h", ".cpp", ".css"):
        return "c"
    if ending in (".js", ".mjs"):
        return "js"
    if ending == ".py" or (not ending and text.startswith("#!/usr/bin/env p")):
        return "py"
    if ending in (".cmake", ".sh") or path.endswith("CMakeLists.txt") or (not ending and text.startswith("#!")):
        return "sh"
    return None


def parts(path, text):
    """The comments and the code of a text, the other's characters blanked. A page is all comment; what is no source is all code."""
    if path.endswith(".md"):
        return text, blank(text)
    language = language_of(path, text)
    if language is None:
        return blank(text), text
    comments, code, at = [], [], 0
    for m in LANGUAGES[language].finditer(text):
        if m.lastgroup not in ("comment", "text"):
            continue
        code += [text[at:m.start()], blank(m[0])]
        marks = 3 if m.lastgroup == "text" else len(m[0]) - len(m[0].lstrip("/#"))
        comments += [blank(text[at:m.start()]), " " * marks, m[0][marks:]]
        at = m.end()
    return "".join([*comments, blank(text[at:])]), "".join([*code, text[at:]])


def anchor(heading):
    """The anchor of a heading or of a link, as GitHub makes it; what is not ASCII is left out."""
    return re.sub(r"[^a-z0-9_-]", "", heading.lower().replace(" ", "-"))


def strip(word):
    return word.rstrip("],.:`")


class Checker:
    def __init__(self, files, helps):
        self.files, self.helps, self.findings = files, helps, []
        self.parts = {path: parts(path, text) for path, text in files.items()
                      if not path.startswith("formats/drawings/viewer/three/")}
        code = "\n".join(code for _, code in self.parts.values())
        self.words = set(re.findall(r"[A-Za-z_]\w*", code))
        self.options = set(re.findall(r"--[\w-]+", "\n".join([code, *helps.values()])))
        self.folders = {path[:at.end()] for path in files for at in re.finditer("/", path)}
        tests = re.findall(r"TEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)\)",
                           "\n".join(code for path, (_, code) in self.parts.items() if path.startswith("tests/")))
        self.tests = {f"{suite}.{name}" for suite, name in tests} | {f"{suite}.*" for suite, _ in tests}
        for path, (_, code) in self.parts.items():
            for suite, body in re.findall(r"^class (\w+)(\(.*\n(?: .*\n|\n)*)", code, re.M) if path.startswith("tests/") else ():
                self.tests |= {f"{suite}.{name}" for name in ["*", *re.findall(r"    def (test_\w+)", body)]}
        self.defined = set()
        for path, text in files.items():
            if path.endswith(".md"):
                self.collect_definitions(path, text)

    def run(self):
        for self.path, (self.prose, _) in sorted(self.parts.items()):
            if self.path == "CHANGELOG.md":  # the past may name what is gone
                continue
            self.is_page = self.path.endswith(".md")
            for check in (self.check_numbers, self.check_links, self.check_paths, self.check_fences, self.check_spans,
                          self.check_options, self.check_function_tables):
                check()
        return self.findings

    def report(self, offset, what):
        self.findings.append(f"{self.path}:{1 + self.prose.count(chr(10), 0, offset)}: {what}")

    def collect_definitions(self, path, text):
        for kind, page, number in DEFINITION.findall(text):
            name = f"{kind} {page}.{number}"
            if name in self.defined:
                self.findings.append(f"{path}: {name} is defined twice")
            self.defined.add(name)
            if path != f"docs/{PAGES.get(page)}.md":
                self.findings.append(f"{path}: {name} belongs into docs/{PAGES.get(page)}.md")

    def check_numbers(self):
        for m in CITATION.finditer(self.prose):
            for number in re.findall(NUMBER, m[0]):
                name = f"{m[1]} {number}"
                if "." not in number or m[1].lower() == "stage":
                    self.report(m.start(), f"{name} has no page: write Lemma, Rule or Step and X.N")
                elif name not in self.defined:
                    self.report(m.start(), f"{name} is not defined in bold in any page")
        for pattern in (PRIVATE,) if self.is_page else (PRIVATE, PRIVATE_IN_CODE):
            for m in pattern.finditer(self.prose):
                self.report(m.start(), f"{m[0]} is nothing of this tree")

    def check_links(self):
        for m in LINK.finditer(self.prose) if self.is_page else ():
            if "://" in m[1]:
                continue
            path = os.path.normpath(os.path.join(os.path.dirname(self.path), m[1])) if m[1] else self.path
            if not self.exists(path):
                self.report(m.start(), f"the link to {m[1]} leads nowhere")
            elif m[2] and path.endswith(".md") and anchor(m[2]) not in map(anchor, HEADING.findall(self.files[path])):
                self.report(m.start(), f"{path} has no heading #{m[2]}")

    def check_paths(self):
        """Paths from the root, in backticks or not, but the file that a page shows how to write."""
        for m in PATH.finditer(self.prose):
            shown = self.prose.endswith("```cpp\n// ", 0, m.start(1))
            if not shown and not PLACEHOLDER.fullmatch(m[1]) and not self.exists(m[1]):
                self.report(m.start(), f"{m[1]} does not exist")

    def exists(self, path):
        return path in self.files or path.rstrip("/") + "/" in self.folders or path == "."

    def check_fences(self):
        """Fenced blocks hold commands; they are blanked for the checks of spans."""
        if not self.is_page:
            return
        fence = re.compile(r"(?:^|(?<=\n))```[^\n]*\n([\s\S]*?)```")
        for m in fence.finditer(self.prose):
            self.check_commands(m[1], m.start())
        self.prose = fence.sub(lambda m: blank(m[0]), self.prose)

    def check_spans(self):
        for m in re.finditer(r"`([^`]+)`", self.prose):
            span = re.sub(r"\s+", " ", m[1])
            if len(span) < 200 and not OUTSIDE.fullmatch(span) and not span.startswith("build/"):
                self.check_span(span, m.start())

    def check_span(self, span, at):
        if FILE.fullmatch(span):
            known = self.folders if span.endswith("/") else self.files
            if span not in known and not any(name.endswith("/" + span) for name in known):
                self.report(at, f"{span} does not exist")
        elif TEST.fullmatch(span):
            if span not in self.tests:
                self.report(at, f"no test {span}")
        elif OPTION.fullmatch(span):
            self.check_option(span, at)
        elif NAME.fullmatch(span) and MARKED.fullmatch(span):
            self.check_name(span, at)
        else:
            self.check_commands(span, at)

    def check_name(self, span, at):
        for part in re.findall(r"\w+", span.partition("(")[0]):
            if part not in self.words:
                self.report(at, f"the code has no {part} ({span})")

    def check_option(self, option, at):
        if option not in self.options:
            self.report(at, f"no program has an option {option}")

    def check_options(self):
        """Options without backticks. What fences and commands hold is looked at there."""
        for m in OPTION_IN_PROSE.finditer(self.prose):
            if not OUTSIDE.fullmatch(m[1]):
                self.check_option(m[1], m.start(1))

    def check_function_tables(self):
        """What stands in a column headed "function" of a table."""
        offset, column = 0, None
        for line in self.prose.splitlines(keepends=True) if self.is_page else ():
            cells = line.split("|") if line.startswith("|") else []
            column = cells.index(" function ") if " function " in cells else column if cells else None
            for name in re.findall(r"`([A-Za-z_:]+)`", cells[column]) if column and column < len(cells) else ():
                self.check_name(name, offset)
            offset += len(line)

    def check_commands(self, text, at):
        """Every call of the program: verb, sub-verb and options."""
        for m in CALL.finditer(text):
            self.check_call(m[1].split(), at)

    def check_call(self, words, at):
        if not words or not words[0][0].islower():  # VERB, --version, ...
            return
        verbs = [strip(words[0])]
        if verbs[0] in self.helps and "Subcommands:" in self.helps[verbs[0]] and words[1:] and words[1][0].islower():
            verbs = [f"{verbs[0]} {name}" for name in re.findall(r"[\w-]+", strip(words[1]))]
        for verb in verbs:
            if self.is_hidden(verb):
                continue
            if verb not in self.helps:
                self.report(at, f"the program has no verb {verb}")
                continue
            for option in re.findall(r"(?:^|\s)\[?(--[a-z][a-z-]*)(?:=\S*|[\],.…]\S*)?(?=\s|$)", " ".join(words)):
                if option != "--help" and not re.search(option + "(?![a-z-])", self.helps[verb]):
                    self.report(at, f"ar3d {verb} has no option {option}")

    def is_hidden(self, verb):
        """Verbs that programs use, not people, are in no help."""
        literal = f'"{verb.split()[-1]}"'
        return "-" in verb and any(path.startswith("bench/") and literal in text for path, text in self.files.items())


def dangling(files, helps):
    return Checker(files, helps).run()
