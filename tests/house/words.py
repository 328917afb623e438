#!/usr/bin/python3
"""Pages, --help, messages and comments of specifications have no sentence of more than 30 words, pages no line of prose of more than 120
characters; house words stay away from them and from sources: words.py SOURCES AR3D. With --measure: words, sentences and mean of each page.

Code, tables and targets of links are left out, so are numbered lemmas, rules, repairs, steps and theorems; what is in backticks is one
word. A colon before a capital letter or a number ends a sentence."""
import pathlib
import re
import subprocess
import sys

MOST_WORDS, MOST_CHARACTERS = 30, 120
HOUSE_WORDS = re.compile(r"\b(whoever|nobody|somebody|but for|for who|ask_ahead|ask_for|asks? (?:the |for )?memory|orphanage|manner|hopeless)\b", re.I)
NUMBERED = re.compile(r"\*\*(Lemma|Rule|Repair|Step|Theorem)[ .]|\*Proof")
FOLDERS = ("algorithms", "analysis", "apps", "base", "bench", "formats", "generators", "model", "optimum", "python", "store", "verify")
OTHER = re.compile(r"\||<|!\[|#|\$\$|\[[^]]*\]: ")  # tables, pictures, headings


def paragraphs(text):
    """Pairs of line number and text; an item of a list is a paragraph of its own."""
    found, fenced = [], False
    for number, line in enumerate(text.splitlines(), 1):
        bare = line.strip()
        fence = bare.startswith("```")
        fenced ^= fence
        if fenced or fence or OTHER.match(bare):
            found.append((number, ""))
        elif not bare or re.match(r"([-*]|\d+\.) ", bare) or not found or not found[-1][1]:
            found.append((number, re.sub(r"^([-*]|\d+\.) +", "", bare)))
        else:
            found[-1] = (found[-1][0], f"{found[-1][1]} {bare}")
    return [(number, text) for number, text in found if text and not NUMBERED.match(text)]


def sentences(text):
    text = re.sub(r"`[^`]*`", "X", text)
    text = re.sub(r"!?\[([^]]*)\]\([^)]*\)", lambda m: m[1][:1].upper() + m[1][1:], text).replace("*", "")
    return [s for s in re.split(r"(?<=[.!?:])[)\"”]*\s+(?=[^a-z])", text) if s.strip()]


def words(sentence):
    return len([w for w in sentence.split() if re.search(r"\w", w)])


def too_long(name, text):
    return [f"{name}:{number}: {words(s)} words: {s}" for number, paragraph in paragraphs(text) for s in sentences(paragraph)
            if words(s) > MOST_WORDS]


def wide_lines(name, text):
    prose = re.sub(r"```.*?```", lambda m: "\n" * m[0].count("\n"), text, flags=re.S)
    return [f"{name}:{number}: {len(line)} characters" for number, line in enumerate(prose.splitlines(), 1)
            if len(line) > MOST_CHARACTERS and not OTHER.match(line.strip())]


def house_words(name, text):
    """Words of this house that the field does not use; they do not come back."""
    return [f"{name}:{number}: '{found[0]}'" for number, line in enumerate(text.splitlines(), 1) if (found := HOUSE_WORDS.search(line))]


def helps(program, verbs=()):
    """The help of a verb and of the verbs below it, each text of an option a paragraph."""
    text = subprocess.run([program, *verbs, "--help"], check=True, capture_output=True, text=True).stdout
    plain = re.sub(r"\n +", "\n\n", re.sub(r"\n {20,}", " ", text))
    yield f"ar3d {' '.join(verbs)} --help", re.sub(r" {2,}|\{[^}]*\}", "\n\n", plain)
    for verb in re.findall(r"^  ([a-z]+) {2,}", text.partition("Subcommands:")[2], re.M):
        yield from helps(program, (*verbs, verb))


def messages(source):
    """Pairs of line number and text of the literals of C++ that hold two words."""
    for m in re.finditer(r'"(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*', source):
        text = "".join(re.findall(r'"((?:[^"\\\n]|\\.)*)"', m[0])).replace("\\n", "\n\n")
        if re.search("[a-z] [a-z]", text) and not text.startswith("<"):
            yield source.count("\n", 0, m.start()) + 1, text


root, program = pathlib.Path(sys.argv[1]), sys.argv[-1]
folders = [folder for folder in root.glob("*/") if folder.name not in ("build", "results")]
pages = [page for folder in (root, *folders) for page in sorted([*folder.glob("*.md"), *folder.glob("*/README.md")])
         if folder == page.parent or folder.name in ("docs", "examples") if "gallery" not in page.parts]
texts = [(str(page.relative_to(root)), page.read_text()) for page in [*pages, root / "results/SCHEMA.md", root / "results/JOURNAL.md"]]
if "--measure" in sys.argv:
    for name, text in texts:
        counts = [words(s) for _, paragraph in paragraphs(text) for s in sentences(paragraph)]
        print(f"{name}: {len(text.split())} words, {len(counts)} sentences, mean {sum(counts) / len(counts):.1f}")
    raise SystemExit
if not too_long("", "Word " * 31 + "end.") or too_long("", "Word " * 29 + "end."):
    raise SystemExit("a sentence of 32 words is not found, or one of 30 is")
wrong = [line for name, text in texts for line in too_long(name, text)] + [
    line for name, text in texts if not name.startswith("results") for line in wide_lines(name, text)]
sources = [path for folder in (*FOLDERS, "tools", "tests") for path in sorted((root / folder).rglob("*"))
           if path.suffix in (".h", ".cpp", ".js", ".mjs", ".py", ".cmake", ".txt", ".sh", ".toml")
           and not {"three", "node_modules", "words.py"} & set(path.parts)]
if len(sources) < 500 or not house_words("", "but for one") or house_words("", "everybody"):
    raise SystemExit("a house word is not found, or one that is none is")
wrong += [line for path in sources for line in house_words(str(path.relative_to(root)), path.read_text())]
wrong += [line for name, text in texts for line in house_words(name, text)]
for specification in sorted([*root.glob("bench/**/*.toml"), *root.glob("examples/**/*.toml")]):
    comments = re.sub(r"^[^#\n].*$", "", specification.read_text(), flags=re.M)
    wrong += too_long(str(specification.relative_to(root)), re.sub(r"^#+ ?", "", comments, flags=re.M))
told = [(f"{path.relative_to(root)}:{number}", text) for folder in FOLDERS for path in sorted((root / folder).rglob("*.cpp"))
        for number, text in messages(path.read_text())]
if len(told) < 1000:
    raise SystemExit(f"only {len(told)} messages are found")
wrong += [line for name, text in told for line in too_long(name, text)]
helped = list(helps(program))
if len(helped) < 20:
    raise SystemExit(f"only {len(helped)} verbs have a help")
wrong += [line for name, text in helped for line in too_long(name, text)]
print("\n".join(wrong))
sys.exit(bool(wrong))
