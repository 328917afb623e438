"""Runs the code blocks of the pages as they are printed; every block of every page is run here or by a test that is named.

blocks.py SOURCE PROGRAM. `sh` blocks are run line by line, `python` blocks as they are, `toml` blocks are planned as (parts of) a study;
`text` is no code; directly below commands it is what they
print (… stands for anything). What the pages take for granted (`smoke.h5`, `my-study.toml`, `nets/*.s6`, …) is made first, small. A study that
takes minutes is replaced by a small one of the same name.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

# Pages whose blocks another test runs, and the part of the tree that says so.
ELSEWHERE = {
    "README.md": "tests/house/pages.py",
    "CONTRIBUTING.md": "tests/house/walkthrough.py",
    "docs/tutorial.md": "tests/house/pages.py",
    "docs/library.md": "tests/house/pages.py",
    "docs/cluster.md": "tests/apps/cluster_recipes.h",
    "docs/python.md": "tests/python/package_test.py",
    "examples/own_algorithm/README.md": "tests/house/own_algorithm.cmake",
}
# Lines that are not run, and why.
NOT_RUN = {
    "ar3d compare --base HEAD~1": "builds another commit, which takes minutes: tests/apps/compare_test.cpp",
    "git bisect ": "builds other commits, which takes minutes: tests/apps/bisect_test.cpp",
    "build/release/bench/kernels/ar3d_precision": "takes more than a minute: tests/kernels/limits_test.py",
    "tools/precision-report": "takes three minutes: tests/kernels/limits_test.py",
    "./ar3d study run extremes-large": "takes ten minutes: tests/apps/extremes_test.cpp",
    "./ar3d study run routed-large": "takes an hour; its rows: tests/house/pages.py",
    "./ar3d study run extremes-huge": "takes 17 minutes and 19 GB: tests/apps/extremes_test.cpp",
    "sudo apt-get install graphviz python3-igraph python3-pandas python3-tables": "installs packages",
}
# Exit codes other than 0, and lines as they run on the small files that are made here.
EXIT = {"ar3d hunt --algorithm grid -n 60 --seeded-fault wrong-bend": 4, "ar3d study run bad.toml": 4, "ar3d study run late.toml": 5,
        "ar3d check late.h5": 5, "ar3d compare --drawings-only helix.h5": 3, "ar3d compare one.h5 two.h5": 6, "ar3d compare one.h5 bound.h5": 7,
        "ar3d compare --turns 'grid": 3, "ar3d compare --turns one.toml": 3, "ar3d compare ar3d-two-turns.h5": 3,
        "sh gate.sh judge ||": 0, "sh gate.sh judge": 3, "ar3d draw twice.edges": 2}
IN_PLACE_OF = {
    "study run quick": "study run quick.toml", " ROW": " 0", "study run peers": "study run peers.toml",
    "study run precision": "study run precision.toml", "study run figures.toml": "study run --force-timing figures.toml",
    "study run regression": "study run smoke.toml", "study run routed": "study run quick.toml", "study run short.toml": "study run --force-timing short.toml",
    "compare one.h5 two.h5": "compare --time-always one.h5 two.h5",
    "compare --turns 'python3": "compare --drawings-only --turns 'python3", "compare --turns HEAD .": "compare --drawings-only --turns HEAD .",
    "build/release/bench/kernels/ar3d_limits --benchmark_out": "ar3d_limits --benchmark_filter='^draw/(search|grid)/.*n:1000/' --benchmark_out",
    "'^draw/(search|grid)/'": "'^draw/(search|grid)/.*n:1000/'", "'/n:10000000/'": "'^machine/.*mib:1/'",
    "'^(draw/grid|search)/'": "'^(draw/grid|search)/cycle/1000/'", "build/release/bench/kernels/": "",
    "./ar3d": "ar3d", "python3 -c": "/usr/bin/python3 -c", "python3 /usr/share": "/usr/bin/python3 /usr/share",
}

TINY = """study = "{name}"
seed = 1
[[sweep]]
families = ["cycle", "prism"]
sizes = [8, 16]
algorithms = ["diamond", "grid"]
instances = 1
"""


def blocks(text):
    """(line, language, text) of each code block; `printed` in place of `text` if it stands directly below commands."""
    end, before = 0, ""
    for match in re.finditer(r"^```(\w*)\n(.*?)^```", text, re.S | re.M):
        is_printed = before == "sh" and match[1] == "text" and not text[end:match.start()].strip()
        yield text[:match.start()].count("\n") + 1, "printed" if is_printed else match[1], match[2]
        end, before = match.end(), match[1]


def commands(block):
    """The lines of a block without comments, continued ones joined."""
    joined = re.sub(r"\\\n\s*", "", block)
    return [re.sub(r"\s+# .*", "", line).strip() for line in joined.splitlines() if line.strip() and not line.startswith("#")]


class Folder:
    """Where the blocks of one page run."""

    def __init__(self, path, program):
        self.path, self.printed = path, ""
        (path / "bin").mkdir()
        (path / "bin" / "ar3d").symlink_to(program)
        self.kernels = program.parents[1] / "bench" / "kernels"
        for name in ("ar3d_limits", "ar3d_kernels"):
            (path / "bin" / name).symlink_to(self.kernels / name)
        for proved in ("ar3d_proved", "ar3d_unsatisfiable"):
            (path / "bin" / proved).symlink_to(program.parents[1] / "proof" / proved)
        self.package = program.parents[1] / "python"
        self.environment = dict(os.environ, PATH=f"{path}/bin:" + os.environ["PATH"], PYTHONPATH=str(self.package))

    def run(self, command):
        return subprocess.run(["bash", "-c", command], cwd=self.path, env=self.environment, stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, timeout=300)

    def must(self, command, code=0):
        done = self.run(command)
        assert done.returncode == code, f"{command}\nended with {done.returncode}, not {code}\n{done.stdout[-2000:]}{done.stderr}"
        self.printed += done.stdout + done.stderr

    def expect_printed(self, text):
        """The lines of a `text` block stand in this order in what the commands above it printed; blanks count as one."""
        rest = [" ".join(line.split()) for line in self.printed.splitlines()]
        for line in text.splitlines():
            like = ".*".join(re.escape(part.strip()) for part in " ".join(line.split()).split("…"))
            at = next((i for i, printed in enumerate(rest) if re.fullmatch(like, printed)), None)
            assert at is not None, f"not printed in this place:\n{line}\nbut\n" + "\n".join(rest)
            rest = rest[at + 1:]

    def prepare(self):
        for name, file in (("smoke", "smoke"), ("quick", "quick"), ("mine", "my-study")):
            (self.path / f"{file}.toml").write_text(TINY.format(name=name))
        peers = pathlib.Path(sys.argv[1]).resolve().joinpath("bench", "studies", "peers.toml").read_text()
        (self.path / "precision.toml").write_text('study = "precision"\naccept_unproved = true\n[[sweep]]\nfamilies = "prism"\nsizes = [8, 16]\n'
                                                  'algorithms = { algorithm = "two-bend-paper", type = [0, 1] }\n')
        (self.path / "peers.toml").write_text(peers.replace("[60, 240, 960]", "[60]").replace("instances = 3", "instances = 1"))
        for folder in ("bench", "docs", "examples"):
            (self.path / folder).symlink_to(pathlib.Path(sys.argv[1]).resolve().joinpath(folder))
        (self.path / "strong.toml").write_text(TINY.format(name="r") + "strong = { threads = [1, 2], drawings = 2, repetitions = 1 }\n")
        self.must("ar3d study run smoke.toml -q -o smoke.h5 && cp smoke.h5 before.h5 && cp smoke.h5 after.h5")
        self.must("ar3d study run strong.toml -q -o r.h5")
        self.must("mkdir nets && ar3d generate prism -n 8 -o nets/a.s6 && ar3d generate cycle -n 9 -o nets/b.s6 && cat nets/*.s6 | gzip >census.s6.gz")
        self.must("ar3d generate torus -n 16 --format matrixmarket -o roads.mtx")
        self.must(f"python3 {pathlib.Path(sys.argv[1]).resolve()}/tests/apps/rome_like.py rome 4")
        self.must("ls rome/*/* | sed 's|.*/||; s|$|,all|' >rome.csv")
        self.must("printf '#!/bin/sh\\ncat\\n' >my-drawer && chmod +x my-drawer")
        # What docs/analysis.md draws in turns.
        for name, efforts in (("two", "[0, 1]"), ("one", "1"), ("zero", "0")):
            (self.path / f"{name}.toml").write_text('study = "two"\n[[sweep]]\nfamilies = "random-cubic"\nsizes = [100, 200]\n'
                                                    f'algorithms = {{ algorithm = "grid", effort = {efforts} }}\n')
        self.must("""git init -q repo && cp examples/own_program/* repo && sed 's/, "grid"//; s/, "cycle"//' repo/own.toml >repo/helix.toml
                  git -C repo add -A && git -C repo -c user.name=me -c user.email=me@here commit -qm first""")
        # A checkout with a reference of the study.
        self.must("git init -q . && mkdir -p apps results/reference && touch apps/study.cpp && cp smoke.h5 results/reference/0.1.0-smoke.h5")
        self.must(f"cp {pathlib.Path(sys.argv[1]).resolve()}/results/reference/optima* results/reference")

    def run_sh(self, block):
        self.printed = ""
        if "/ar3d_limits" in block and not (self.kernels / "ar3d_limits").exists():
            return print("not run, since this build has no benchmarks: bench/kernels/ar3d_limits")
        for left in self.path.glob("ar3d-*"):  # by blocks before, unless this one begins with it
            if left.name not in commands(block)[0]:
                shutil.rmtree(left) if left.is_dir() else left.unlink()
        for line in commands(block):
            if any(line.startswith(start) for start in NOT_RUN):
                continue
            code = next((c for start, c in EXIT.items() if line.startswith(start)), 0)
            for printed, small in IN_PLACE_OF.items():
                line = line.replace(printed, small)
            every = [line.replace("1/3", f"{i}/3") for i in (1, 2, 3)] if "--shard 1/3" in line else [line]
            for command in every:
                self.must(command, code)

    def keep(self, block):
        """A block whose first line is a comment that names a file is that file from there on. Gives the rest of it."""
        named = re.match(r"# ([\w-]+\.(?:py|toml))\n", block)
        if named:
            (self.path / named[1]).write_text(block)
        return block[named.end():] if named else block

    def run_python(self, block):
        if "from ar3d" in block and not (self.package / "ar3d").exists():
            return print("not run, since this build has no Python package: from ar3d")
        self.keep(block)
        (self.path / "printed.py").write_text(("" if "import" in block else "import pandas\n") + block)
        self.must("/usr/bin/python3 printed.py")

    def plan_toml(self, block):
        """A block is a whole study, or keys of its head, or of a sweep, or a table."""
        block = self.keep(block)
        whole = block.startswith("study")
        if not whole:
            head, sweep = TINY.format(name="part").split("[[sweep]]")
            if "graphs =" in block:
                block = head + block
            elif block.startswith("[["):
                block = head + block + "[[sweep]]" + sweep.replace('"diamond"', '"mine"')
            elif block.startswith("budget"):
                block = head + block + "[[sweep]]" + sweep
            else:
                block = head + "[[sweep]]" + sweep + block
        (self.path / "printed.toml").write_text(block)
        self.must("ar3d study plan printed.toml")
        if whole:
            (self.path / "printed.toml").write_text(block.replace("from = 100, to = 10000", "from = 20, to = 40"))
            self.must("ar3d study run -q --force-timing printed.toml -o printed.h5 --force")


def run_page(page, text, program):
    with tempfile.TemporaryDirectory(prefix="ar3d-blocks-") as scratch:
        folder = Folder(pathlib.Path(scratch), program)
        folder.prepare()
        for line, language, block in blocks(text):
            run = {"sh": folder.run_sh, "printed": folder.expect_printed, "python": folder.run_python, "toml": folder.plan_toml}
            try:
                if language != "text":
                    run[language](block)
            except (AssertionError, KeyError) as error:
                raise SystemExit(f"{page}:{line}: {error!r}" if isinstance(error, KeyError) else f"{page}:{line}: {error}") from None


def expect_covered(pages, tests):
    """The tests of ELSEWHERE pick blocks by heading, mark or place: no block lies where none of them looks."""
    applied = [re.match(r"git apply tests/house/added/(\w+)\.patch\n", block) for _, _, block in blocks(pages["CONTRIBUTING.md"])]
    assert all(applied) and sorted(m[1] for m in applied) == sorted(re.findall(r"^ar3d_walkthrough\((\w+)", tests, re.M)), applied
    unmarked = re.findall(r"(?<!-->)\n```sh\n.*", pages["docs/cluster.md"])
    assert not unmarked, f"docs/cluster.md: blocks without a recipe's name: {unmarked}"
    for page, kinds in {"README.md": ["sh", "sh", "sh", "python"], "examples/own_algorithm/README.md": ["sh"]}.items():
        found = [language for _, language, _ in blocks(pages[page])]
        assert found == kinds, f"{page}: blocks are {found}: is each of them run by a test?"


def main():
    source, program = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    listed = subprocess.run(["git", "ls-files", "*.md"], cwd=source, capture_output=True, text=True, check=True).stdout.split()
    pages = {name: (source / name).read_text() for name in listed if (source / name).exists()}
    everything = "\n".join(pages.values())
    for start in [*NOT_RUN, *EXIT]:
        assert start in everything, f"no page says: {start}"
    for page, by in ELSEWHERE.items():
        assert page in pages and (source / by).exists(), f"{page}, {by}"
    expect_covered(pages, (source / "tests" / "CMakeLists.txt").read_text())
    count = 0
    for page, text in pages.items():
        found = list(blocks(text))
        for line, language, block in found:
            assert language, f"{page}:{line}: a code block without its language; `text` for what is no code"
            assert language not in ("text", "printed") or not re.search(r"^(\./)?ar3d ", block, re.M), f"{page}:{line}: commands are `sh`"
        if found and page not in ELSEWHERE and any(language not in ("text", "printed") for _, language, _ in found):
            run_page(page, text, program)
            count += len(found)
    print(f"{count} blocks of pages are run here, those of {len(ELSEWHERE)} pages by other tests")


main()
