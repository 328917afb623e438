"""What pages print runs as printed, and what they say of committed results is so: pages.py SOURCE BUILD AR3D [UNITTEST'S ARGUMENTS].

`pages.py SOURCE BUILD AR3D --print` prints the sentences and tables of results/reference/precision.md and routed.md as
the committed rows have them."""
import csv
import functools
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy as np

SOURCE, BUILD, AR3D = sys.argv[1:4]
REFERENCE = pathlib.Path(SOURCE, "results/reference")


def page(name):
    return pathlib.Path(SOURCE, name).read_text()


def blocks(name):
    """Pairs of language and text of the code blocks of a page, in order."""
    return re.findall(r"^```(.*)\n([\s\S]*?)^```", page(name), re.M)


class Page(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        (self.folder / "bin").mkdir()
        (self.folder / "bin/ar3d").symlink_to(AR3D)

    def run_in_folder(self, command, shell="bash", exit_code=0):
        """Runs commands in a folder of their own, in which `ar3d` is the program that was built. @return what they print."""
        script = f"export PATH={self.folder}/bin:$PATH\nset -euo pipefail\n{command}" if shell == "bash" else command
        done = subprocess.run([shell, "-c", script], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(done.returncode, exit_code, f"{command}\n{done.stdout}{done.stderr}")
        return done.stdout if shell != "bash" else done.stdout + done.stderr

    def run_blocks(self, texts):
        said = ""
        for language, text in texts:
            if language == "python":
                (self.folder / "printed.py").write_text(text)
                text = "/usr/bin/python3 -W error::FutureWarning printed.py"
            said += self.run_in_folder(text.replace("./ar3d", "ar3d"))
        return said

    def expect(self, text, *parts):
        for part in parts:
            self.assertIn(part, text)

    def expect_made(self, *names):
        for name in names:
            self.assertTrue((self.folder / name).exists(), name)


class Printed(Page):
    def test_readme_runs(self):
        use = blocks("README.md")[-2:]
        self.assertEqual([language for language, _ in use], ["sh", "python"])
        self.expect(self.run_blocks(use), "diamond")
        self.expect_made("smoke.html", "k5.html", "six.h5")

    def test_tutorial_runs(self):
        texts = blocks("docs/tutorial.md")
        self.assertEqual(len(texts), 7)
        self.expect(self.run_blocks(texts), "1 certified, 0 violated, 0 not drawn", "0 certified, 1 violated, 0 not drawn",
                    "50 certified, 0 violated, 0 not drawn")
        self.expect_made("k5.html", "k5.svg", "broken.html", "trade.html", "k5.tikz")

    def test_gallery_is_what_its_script_makes(self):  # run tools/gallery if drawings have changed on purpose
        self.run_in_folder(f"{SOURCE}/tools/gallery {AR3D} made && diff -rq made {SOURCE}/docs/gallery")


class Installed(Page):
    """What is installed beside the program works: library, manual, completion."""

    def expect_completion(self, shell, prepare):
        """What the completion of a shell offers. `prepare` defines `say WORD...`: what is offered for the last word, a line each."""
        asked = ("ar3d ve", "ar3d study resu", "ar3d draw x --algorithm diam", "ar3d draw x --til", "ar3d draw x --format gr",
                 "ar3d generate cycl", "ar3d study run smo", "ar3d verify x --crossing-test hal", "ar3d list named-")
        (self.folder / f"ask.{shell}").write_text(prepare + "".join(f"say {words}\n" for words in asked))
        self.assertEqual(self.run_in_folder(f"{shell} ask.{shell}"),
                         "verify\nresume\ndiamond\n--tilt\ngraphml\ncycle\nsmoke\nhalving\nnamed-graphs\n", shell)

    def test_programs_of_the_library_page_compile_and_run(self):
        commands = "export PKG_CONFIG_PATH=$(dirname $(find $PWD/prefix -name ar3d.pc))\n"
        for language, text in blocks("docs/library.md"):
            if language == "sh":
                commands += text
            else:  # the first line names the file: "// draw_file.cpp: ..."
                (self.folder / re.match(r"(?://|#) ([a-zA-Z_]+\.(?:cpp|txt))", text)[1]).write_text(text)
        said = self.run_in_folder(f"cmake --install {BUILD} --prefix prefix >/dev/null\n"
                                  "cmake -S . -B build -DCMAKE_PREFIX_PATH=$PWD/prefix >/dev/null && cmake --build build >/dev/null\n" + commands)
        self.expect(said, "small.s6:3: certified, box ", "the angle at 0 is exactly 120 degrees", "4 components\n12 edges drawn")
        self.expect(said, "\ncertified\nvertex 0 at (0, 0, 0): edges 1 and 0 leave along")
        self.assertEqual(self.run_in_folder("./own_points").splitlines()[0], "certified")  # made with pkg-config
        self.expect_made("drawing.svg")
        self.expect((self.folder / "prefix/share/man/man1/ar3d.1").read_text(), "AR3D DRAW", "AR3D VIEW", "ar3d study run", "exact lattice coord")
        self.expect_completion("bash", "source prefix/share/bash-completion/completions/ar3d\nsay() { COMP_WORDS=(\"$@\"); "
                                       "COMP_CWORD=$(($# - 1)); _ar3d; printf '%s\\n' \"${COMPREPLY[@]}\"; }\n")
#The functions of zsh's completion system that are called, as far as they are needed here.
        self.expect_completion("zsh", "_describe() { print -rl -- ${${(P)2}%%:*} }; _files() { print files }\n"
                                      "fpath=($PWD/prefix/share/zsh/site-functions $fpath); autoload -U _ar3d\n"
                                      "say() { words=(\"$@\"); CURRENT=$#; _ar3d }\n")
        self.expect_completion("fish", "source prefix/share/fish/vendor_completions.d/ar3d.fish\n"
                                       "function say; complete -C (string join ' ' -- $argv) | cut -f1; end\n")

    def test_table_of_completions_holds_every_verb_and_its_words(self):
        table = self.run_in_folder(f"{SOURCE}/tools/completion {AR3D} table")
        self.expect("\n" + table, "\n\tdraw\tDraws every graph of files\t\n", "\nstudy\trun\tRuns a study and", "\nstudy run\t\t\t=studies\n",
                    "\nhelp\t\t\tlist generate draw ", "\nverify\t--crossing-test\t", "\tautomatic all-pairs halving\n",
                    "\nreport\t--reference\tresults file of")
        self.run_in_folder(f"{SOURCE}/tools/completion {AR3D} csh", exit_code=2)


class Included(Page):
    def test_sources_are_included_without_the_program_and_its_packages(self):
        """FetchContent, and so add_subdirectory: in a folder without HDF5, CLI11, toml++ and what `formats` reads."""
        for _, text in blocks("docs/library.md"):
            if name := re.match(r"(?://|#) (own_points\.cpp|fetched\.txt)", text):
                (self.folder / name[1].replace("fetched", "CMakeLists")).write_text(text)
        hidden = " ".join(f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON" for name in ("CLI11", "pugixml", "LibLZMA"))
        said = self.run_in_folder(f"cmake -S . -B build -DFETCHCONTENT_SOURCE_DIR_AR3D={SOURCE} {hidden}\n"
                                  "cmake --build build -j 2 >/dev/null && build/own_points")
        self.expect(said, "ar3d::formats needs nlohmann-json, zlib, liblzma and pugixml: it is not there", "\ncertified\n")
        self.assertNotIn("hdf5", said.lower())


def committed(file, options):
    """The rows of a committed table with these options."""
    with open(REFERENCE / file) as table:
        return [row for row in csv.DictReader(table) if row["options"] == options and
                (file.startswith("1.0.0-bounds") or row["algorithm"] in file)]


def largest_share(file, options):
    """"95 % (y": the largest share of the theorem's box, and on which axis."""
    share, axis = max((1 - float(row[f"worst_slack_{axis}"]), axis) for row in committed(file, options) for axis in "xyz")
    return f"{100 * share:.2g} % ({axis}"


def exponent(file, quantity, options="effort=1", family="random-cubic", parameters=""):
    """"0.495 [0.488, 0.502]"."""
    row = next(row for row in committed(file, options)
               if (row["family"], row["parameters"], row["quantity"]) == (family, parameters, quantity))
    low, high = float(row["exponent_low"]), float(row["exponent_high"])
    label = ", apparent" if row["growth"] == "apparent exponent" else ""
    return f"{float(row['exponent']):.3f} [{low:.3f}, {high:.3f}]{label}"


def cells(name, label):
    """The cells behind the label of the first row of a table whose label begins so."""
    return re.search(rf"^\| {re.escape(label)}(.*)\|$", page(name), re.M)[1].split("|")[1:]


def printed_bound(bound, is_order):
    """A bound of the report as the page prints it: superscripts, no additive constant; the paper's n^3 stands for its order."""
    if bound is None:
        return "–"
    if is_order and bound == "n^3":
        return "O(n³)"
    return bound.partition("+")[0].strip().replace("^2", "²").replace("^3", "³").replace("sqrt(n)", "√n")


class Told(Page):
    """What pages say of committed results."""

    def test_shares_and_exponents_are_those_of_the_committed_tables(self):
        for name, column in (("compact-120", 4), ("two-bend-109", 5)):
            self.assertIn(f"`{name}`", cells("results/reference/algorithms.md", "|")[column - 1])
            share = cells("results/reference/algorithms.md", "largest share of the proved box")[column]
            self.expect(share, largest_share(f"0.2.0-{name}-bounds.csv", "effort=1"),
                        largest_share(f"0.2.0-{name}-bounds.csv", "effort=0") + ", effort 0)")
        growth = "0.2.0-compact-120-growth.csv"
        self.assertIn(exponent(growth, "longest side"), cells("results/reference/algorithms.md", "exponent of the longest side")[4])
        self.assertIn(exponent(growth, "volume"), cells("results/reference/algorithms.md", "exponent of the volume")[4])

    def test_boxes_of_readme_are_medians_of_the_committed_rows(self):
        """Of random 4-regular or cubic graphs with default options, rounded to the digits that README prints."""
        compared = []
        for study, n, algorithms in (("0.2.0-volume", 10**5, "diamond grid two-bend compact"), ("0.2.0-compact-120", 10**5, "compact-120"),
                                     ("0.2.0-two-bend-109", 10**4, "two-bend-109"), ("1.0.0-routed", 1000, "routed routed-120")):
            rows = h5py.File(REFERENCE / f"{study}.h5")["runs"][:]
            for name in algorithms.split():
                cell = cells("README.md", f"[`{name}`]")
                self.assertEqual(len(cell), 4, "five columns")
                family = b"random-4-regular" if "≤ 4" in cell[0] else b"random-cubic"
                usual = [options for options in set(rows["options"]) if re.match(rb"effort=1(;bends=3|$)", options)]
                mine = rows[(rows["algorithm"] == name.encode()) & (rows["family"] == family) & np.isin(rows["options"], usual)]
                mine = mine[abs(mine["n"] / n - 1) < 0.01]  # a ladder to 1000 ends just before
                for axis, said in zip("xyz", cell[3].split("×"), strict=True):
                    digits, power = re.fullmatch(r" *([\d.]+)(n²|√n|n|) *", said).groups()
                    value = np.median(mine[f"extent_{axis}"] / mine["n"] ** {"n²": 2.0, "n": 1.0, "√n": 0.5, "": 0.0}[power])
                    self.assertLessEqual(abs(float(digits) - value), 0.5001 * 10.0 ** -len(digits.partition(".")[2]), f"{name} {axis}: {value}")
                    compared.append(name)
        self.assertEqual(len(compared), 24)

    def test_short_side_of_grid_is_that_of_the_committed_study(self):
        rows = h5py.File(REFERENCE / "0.2.0-volume.h5")["runs"][:]
        rows = rows[(rows["algorithm"] == b"grid") & (rows["family"] == b"random-cubic") & (rows["options"] == b"effort=1")]
        rows = rows[rows["requested_n"] >= 10000]
        sides = np.min([rows[f"extent_{axis}"] for axis in "xyz"], axis=0)
        self.expect(page("README.md"), f"from {sides.min()} to {sides.max():,} in {len(rows)} graphs with 10⁴ to 10⁵ vertices")

    def test_skewed_exponents_are_those_of_the_committed_table(self):
        """In the skewed coordinates of Theorem 3, random cubic graphs and those that grow fastest."""
        for family, parameters in (("random-cubic", "shuffle=1"), ("percolated-laves-graph", "keep=800000;shuffle=1")):
            found = [exponent("1.0.0-bounds-growth.csv", f"skewed {axis} extent", "spread=1;gap=0;cycle=0", family, parameters)
                     for axis in "xyz"]
            self.assertEqual([cell.strip() for cell in cells("results/reference/bounds.md", f"`{family}")[:3]],
                             [text.partition(", apparent")[0] for text in found])

    def report_of(self, name, option):
        made = self.folder / "made"
        self.run_in_folder(f"ar3d report {REFERENCE / name} -o page.html {option} {made}")
        return made.read_text()

    def test_promised_and_drawn_is_what_the_report_of_the_committed_study_says(self):
        """results/reference/bounds.md has a line a setting of what the report has a line an axis of."""
        tables = {
name: [dict(zip((column["name"] for column in table["columns"]), row)) for row in table["rows"]]
                  for name, table in json.loads(self.report_of("1.0.0-bounds.h5", "--json"))["tables"].items()}
        labels = {"diamond (effort=0)": "`diamond`, effort 0", "grid-paper (spread=0;gap=0;cycle=0)": "`grid-paper`, `spread=0`",
                  "grid-paper (spread=2;gap=1;cycle=0)": "`grid-paper`, `spread=2`, `gap=1`"}
        lines = {}
        for promise in tables["promises"]:
            numbers = [None if promise[key] is None else format(promise[key], form)
                       for key, form in (("exponent", ".3f"), ("constant", ".3g"))]
            setting = tables["settings"][promise["setting"]]["setting"]
            lines.setdefault(setting, []).append([printed_bound(promise["paper"], True), printed_bound(promise["proved"], False),
                                                  numbers[0] or "–", (numbers[1] or "–")])
        self.assertEqual(len(lines), 12)
        for setting, axes in lines.items():
            if not setting.startswith("lattice"):
                told = [of[0] if len(set(of)) == 1 and len(of) == 3 else ", ".join(of) for of in zip(*axes)]
                label = labels.get(setting, f"`{setting.partition(' (')[0]}`")
                self.assertIn(f"\n| {label} | {' | '.join(told)} |\n", page("results/reference/bounds.md"))

    def test_lower_bounds_are_those_of_the_committed_study(self):
        """What results/reference/bounds.md says of random 4-regular graphs by `compact`; the bound of every row."""
        seen = []
        rows = [row for row in csv.DictReader(self.report_of("1.0.0-bounds.h5", "--rows").splitlines()) if row["status"] == "ok"]
        self.assertGreater(len(rows), 1000)
        for row in rows:
            volume, bound, n = 2 ** float(row["log2_volume"]), float(row["volume_at_least"]), int(row["n"])
            self.assertTrue(1 <= bound <= volume * (1 + 1e-9), row)
            if row["algorithm"] == "compact" and row["family"] == "random-4-regular" and row["instance"] == "0" and 631 <= n <= 2512:
                seen.append((volume / n**1.5, bound / n**1.5, volume / bound / 100))
        least, most = zip(*((min(values), max(values)) for values in zip(*seen)))
        self.expect(re.sub(r"(\d),(\d)", r"\1\2", page("results/reference/bounds.md")), f"draws {least[0]:.0f} to {most[0]:.0f} n^1.5",
                    f"least {least[1]:.2f} to {most[1]:.2f} n^1.5", f"**{least[2]:.0f}00 to {most[2]:.0f}00 times")

    def test_compact_of_120_needed_no_zones_in_the_committed_file(self):
        """results/reference/compact-120.md says so of every drawing that it counts."""
        runs = h5py.File(REFERENCE / "0.2.0-compact-120.h5")["runs"][:]
        runs = runs[runs["algorithm"] == b"compact-120"]
        self.assertFalse(runs["violations"].any())
        wider = 0
        for options, n, text in zip(runs["options"], runs["n"], runs["counters"]):
            count = dict(re.findall(r"(\w+)=(\d+)", text.decode()))
            if options != b"effort=0":
                self.assertEqual((count["zones"], count["moved_components"]), ("0", "0"))
                if count["widenings"] != "0":
                    self.assertTrue(options == b"effort=2" and n <= 700 and count["widenings"] == "1")
                    wider += 1
        self.assertEqual((len(runs), wider), (559, 22))

    def test_times_the_optimum_are_those_of_the_study(self):
        """results/reference/optima.md: least, median and largest of each algorithm and effort."""
        self.run_in_folder(f"ar3d study run {REFERENCE}/optima.toml -q -o optima.h5\nar3d report optima.h5 --rows rows.csv")
        times = {}
        for row in csv.DictReader((self.folder / "rows.csv").read_text().splitlines()):
            if row["times_the_optimum"] not in ("", "nan"):
                effort = int(re.search(r"effort=(\d)", row["options"])[1])
                times.setdefault(row["algorithm"], {}).setdefault(effort, []).append(float(row["times_the_optimum"]))

        def printed(value):
            return f"{value:.0f}" if value >= 1000 and (value := float(f"{value:.3g}")) else f"{value:#.3g}".rstrip(".")
        self.assertEqual(len(times), 6)
        for algorithm, of_efforts in times.items():
            said = [", ".join(printed(f(of_efforts[effort])) for f in (min, np.median, max)) if effort in of_efforts else "–"
                    for effort in range(3)]
            self.assertEqual([cell.strip() for cell in cells("results/reference/optima.md", f"`{algorithm}`")], said)

    def test_routed_is_what_the_committed_rows_say(self):
        self.expect(page("results/reference/routed.md"), *("\n" + line + "\n" for line in routed_lines()))

    def test_precision_is_what_the_committed_rows_say(self):
        rows, real = precision_rows()[0], precision_rows()[0]["algorithm"] == b"two-bend-paper"
        measured = (rows["certificate"] == b"measured").sum()
        self.assertFalse(rows[real]["collapsed_segments"].any() or rows[real]["crossings"].any())
        self.expect(" ".join(page("results/reference/precision.md").split()), *precision_sentences())
        self.assertIn(f"{len(rows):,} rows", page("docs/precision.md"))
        self.assertIn(f"in none of the {measured:,} is a segment of length zero or a crossing", page("results/reference/precision.md"))


@functools.cache
def precision_rows():
    """All rows of the committed study, and those of the five random graphs with 1024 vertices."""
    rows = h5py.File(REFERENCE / "1.0.0-precision.h5")["runs"][:]
    is_usual = (rows["certificate"] == b"") | (rows["certificate"] == b"measured")
    return rows, rows[is_usual & (rows["requested_n"] == 1024) & (rows["instance_index"] < 5)]


def median(column, algorithm, options):
    """Of five random graphs with 1024 vertices; times in microseconds per vertex."""
    is_cubic = algorithm in ("grid", "two-bend", "two-bend-paper", "compact-120")
    family = b"random-cubic" if is_cubic else b"random-4-regular"
    rows = precision_rows()[1]
    rows = rows[(rows["algorithm"] == algorithm.encode()) & (rows["family"] == family) & np.char.startswith(rows["options"], options.encode())]
    assert len(rows) >= 5, (algorithm, options, len(rows))
    return float(np.median(rows[column] / rows["n"] * 1e6 if column.endswith("_s") else rows[column]))


def precision_sentences():
    def time(algorithm, effort=1):
        return median("cpu_s", algorithm, f"effort={effort}")

    def proof(algorithm):
        return median("certify_s", algorithm, "effort=1")

    def longer(algorithm, effort):
        return time(algorithm, effort) / time(algorithm)

    def log2_volume(algorithm, effort):
        return median("log2_volume", algorithm, f"effort={effort}") - median("log2_volume", algorithm, "effort=1")

    def saved(algorithm):
        return 100 * (1 - 2 ** log2_volume(algorithm, 2))

    def paper(kind, column):
        return median(column, "two-bend-paper", f"type={kind}")

    return [
        f"- **`diamond`** draws exactly in {time('diamond'):.2f} µs and is proved in {proof('diamond'):.2g} µs. Effort 2 takes "
        f"{longer('diamond', 2):.0f} times as long for {saved('diamond'):.0f} % less volume. Effort 0, the proof's own construction, saves no time "
        f"and needs {2 ** log2_volume('diamond', 0):.2g} times the volume.",
        f"- **`grid`**: {time('grid'):.2g} µs, proved in {proof('grid'):.2g} µs. Effort 0, the proof's core alone, takes {longer('grid', 0):.2g} times as long "
        f"and {2 ** log2_volume('grid', 0):.0f} times the volume.",
        f"- **`two-bend`**: {time('two-bend'):.2g} µs, proved in {proof('two-bend'):.2g} µs. The same theorem in real arithmetic (`two-bend-paper`) takes "
        f"{paper(1, 'cpu_s'):.2g} µs in double and {paper(4, 'cpu_s'):.2g} in 237 bits. In double it is off by {paper(1, 'angle_miss') * 1e10:.1f}·10⁻¹⁰ degrees: "
        f"exactness is the faster choice.",
        f"- **`compact`**: {time('compact'):.2g} µs, proved in {proof('compact'):.2g} µs. Effort 2 takes {longer('compact', 2):.2g} times as long for "
        f"{saved('compact'):.0f} % less volume. Effort 0 takes {longer('compact', 0):.2g} of the time and 2^{log2_volume('compact', 0):.0f} times the volume.",
        f"- **`compact-120`**: {time('compact-120'):.2g} µs, proved in {proof('compact-120'):.2g} µs. Effort 2 takes {longer('compact-120', 2):.2g} times as long for "
        f"{saved('compact-120'):.0f} % less volume.",
        f"- **`two-bend-109`**: {time('two-bend-109'):.2g} µs, proved in {proof('two-bend-109'):.2g} µs: the proof is the dearest. At effort 0 the drawing is "
        f"scaled as in the proof: {longer('two-bend-109', 0):.2g} times slower, and 2^{log2_volume('two-bend-109', 0):.1f} times the volume.",
    ]


def set_up(commands):
    done = subprocess.run(["bash", "-c", f"source {SOURCE}/tools/setup.sh; {commands}"], capture_output=True, text=True)
    return done.returncode, done.stdout, done.stderr


class Launcher(Page):
    """What ./ar3d and ./run-tests share: tools/setup.sh."""

    def packages(self, text):
        (self.folder / "packages").write_text(text)
        return self.folder / "packages"

    def fake_apt(self, busy):
        """A root user with an apt-get that notes its calls and whose first updates find the lists locked; no test waits."""
        calls = self.folder / "calls"
        (self.folder / "apt-get").write_text(
            f"#!/bin/bash\necho \"$@\" >> {calls}\n[[ \"$*\" != *update ]] || [ $(wc -l < {calls}) -gt {busy} ] || "
            "{ echo 'E: Could not get lock /var/lib/apt/lists/lock.' >&2; exit 100; }\necho much talk\n")
        (self.folder / "apt-get").chmod(0o755)
        return f"PATH={self.folder}:$PATH; id() {{ echo 0; }}; sleep() {{ :; }}; "

    def test_names_missing_packages_only(self):
        self.assertEqual(set_up(f"missing_packages {self.packages('# comment' + chr(10) + 'bash' + chr(10) + 'no-such-xyz  # why' + chr(10))}"),
                         (0, " no-such-xyz\n", ""))

    def test_is_silent_when_nothing_is_missing(self):
        self.assertEqual(set_up(f"install_packages {self.packages('bash')}"), (0, "", ""))

    def test_tells_a_user_without_sudo_what_to_type(self):
        user = "id() { echo 1000; }; command() { [ \"$2\" != sudo ] && builtin command \"$@\"; }; "
        code, _, said = set_up(user + f"install_packages {self.packages('no-such-xyz')}")
        self.assertEqual(code, 2)
        self.assertIn("Type: sudo apt-get install -y no-such-xyz\n", said)

    def test_says_what_it_installs_and_waits_for_a_busy_package_manager(self):
        listed = self.packages("no-such-xyz\nbash\nno-such-too\n")
        self.assertEqual(set_up(self.fake_apt(3) + f"install_packages {listed}"),
                         (0, "", "ar3d: installing with apt-get: no-such-xyz no-such-too\nar3d: waiting for another package manager\n"))
        calls = (self.folder / "calls").read_text()
        self.assertEqual(calls.count("\n"), 5, "four updates, one install")
        self.assertIn("DPkg::Lock::Timeout=600 install -y no-such-xyz no-such-too", calls)

    def test_shows_what_apt_said_when_it_fails(self):
        code, _, said = set_up(self.fake_apt(1000) + f"install_packages {self.packages('no-such-xyz')}")
        self.assertEqual(code, 2)
        self.expect(said, "E: Could not get lock /var/lib/apt/lists/lock.", "Type: sudo apt-get install -y no-such-xyz\n")

    def test_takes_any_npm(self):
        """Other packages of Node bring npm and exclude Debian's."""
        listed = f"missing_packages {self.packages('npm  # any')}"
        none = "dpkg-query() { echo unknown; }; "
        self.assertEqual(set_up(none + "npm() { :; }; " + listed)[1], "\n")
        self.assertEqual(set_up(none + "command() { [ \"$2\" != npm ] && builtin command \"$@\"; }; " + listed)[1], " npm\n")

    def test_says_how_far_a_long_build_is(self):
        log = self.folder / "log"
        log.touch()
        _, out, said = set_up(f"{{ sleep 2.5; echo '[3/10] a' >> {log}; sleep 1; echo '[10/10] b' >> {log}; sleep 1; }} & "
                              f"report_progress $! {log} release")
        self.assertEqual((out, said), ("", "ar3d: building (release), the first time takes minutes\nar3d: building (release), 30 %\n"
                                           "ar3d: building (release), 100 %\n"))
        self.assertEqual(set_up("sleep 0.1 & report_progress $! /dev/null release")[2], "", "a short one says nothing")

    def test_knows_every_package_of_the_lists(self):
        """They are what a fresh machine gets; a misspelt name would only show there."""
        self.assertEqual(set_up(f"cd {SOURCE}/tools && missing_packages packages.txt packages-tests.txt packages-lint.txt")[1], "\n",
                         "not installed here, although the build and the tests need it")


def routed_growth():
    """What the report says of the committed study; it takes a minute."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([AR3D, "report", "-q", REFERENCE / "1.0.0-routed.h5", "-o", f"{folder}/page.html", "--growth", f"{folder}/growth.csv"],
                       capture_output=True, check=True)
        return list(csv.DictReader(pathlib.Path(folder, "growth.csv").read_text().splitlines()))


def routed_lines(growth=()):
    """Lines of the tables of results/reference/routed.md: volume over n^1.5 and CPU seconds, medians; exponents; points."""
    runs, large = (h5py.File(REFERENCE / f"1.0.0-{name}.h5")["runs"][:] for name in ("routed", "routed-large"))
    for made in (runs, large):
        assert not made["violations"].any() and (made["status"] == b"ok").all()

    def of(family, algorithm, options, runs=runs):
        return runs[(runs["family"] == family.encode()) & (runs["algorithm"] == algorithm.encode())
                    & np.char.startswith(runs["options"], options.encode())]

    def cell(rows, n):
        rows = rows[abs(rows["requested_n"].astype(int) - n) <= 1]  # a ladder to 1000 ends there or one before
        volumes = 2 ** rows["log2_volume"] / rows["n"] ** 1.5
        return f"{float(f'{np.median(volumes):.3g}'):,g}, {np.median(rows['cpu_s']):.2g} s" if len(rows) else "–"

    def exponent(algorithm, options, family, quantity):
        row = next(row for row in growth if (row["algorithm"], row["family"], row["quantity"]) == (algorithm, family, quantity)
                   and row["options"].startswith(options))
        return f"{float(row['exponent']):.2f} [{float(row['exponent_low']):.2f}, {float(row['exponent_high']):.2f}], {row['growth']}"
    lines = []
    settings = {"random-4-regular": [("routed", f"effort=1;bends={b}") for b in (3, 4, 5)] + [("diamond", "effort=2"), ("compact", "effort=2")],
                "random-cubic": [("routed-120", f"effort=1;bends={b}") for b in (3, 4, 5)] + [("grid", "effort=1"), ("compact-120", "effort=2")]}
    for family, columns in settings.items():
        curves = [of(family, *column) for column in columns]
        lines += [f"| {n:,} | {' | '.join(cell(rows, n) for rows in curves)} |" for n in np.unique(curves[0]["requested_n"]).astype(int)]
        lines += [f"| {family}, {quantity} | {' | '.join(exponent(name, options, family, quantity) for name, options in columns)} |"
                  for quantity in ("longest side", "volume") if growth]
        algorithm = columns[0][0]
        lines += [f"| {family}, {b} | {' | '.join(cell(of(family, algorithm, f'effort=0;bends={b}'), n) for n in (10, 100, 1000, 3162, 10000))} |"
                  for b in (3, 5)]
        lines += [f"| {family}, {b} | {exponent(algorithm, f'effort=0;bends={b}', family, 'longest side')} | "
                  f"{exponent(algorithm, f'effort=0;bends={b}', family, 'volume')} |" for b in (3, 5) if growth]
        by_bends = [(b, effort, of(family, algorithm, f"effort={effort};bends={b}", large)) for b in (3, 5) for effort in (0, 1)]
        lines += [f"| {family}, {b}, {effort} | {cell(rows, 5000)} | {cell(rows, 10000)} |" for b, effort, rows in by_bends if len(rows)]
    for family in np.unique(runs["family"]):
        name = family.decode()
        if name not in settings and name != "named":
            kind = [(a, b) for a in ("routed", "routed-120") for b in (3, 5)]
            lines += [f"| {name} | " + " | ".join(cell(of(name, a, f"effort=1;bends={b}"), 100) for a, b in kind) + " | "
                      + " | ".join(cell(of(name, a, "effort=1;bends=3"), 1000) for a in ("routed", "routed-120")) + " |"]
    named = runs[runs["family"] == b"named"]
    names = {
  0 : "K4",
      1 : "K5",
          2 : "K3,3",
              3 : "octahedron",
                  7 : "Petersen",
                      15 : "Heawood",
                           17 : "tesseract",
                                23 : "dodecahedron"}
    for index, name in names.items():
        by_effort = named[named["parameters"] == f"index={index}".encode()]
        lines.append(f"| {name} | " + " | ".join(f"{2 ** row['log2_volume']:.0f}, {row['cpu_s']:.2g} s" for row in by_effort) + " |")
    return lines


if __name__ == "__main__":
    if "--print" in sys.argv:
        print("\n".join(precision_sentences() + routed_lines(routed_growth())))
    else:
        unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
