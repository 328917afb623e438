"""Every input is hostile: one line that names file, line and value; the documented exit code; bounded memory; nothing half-written."""
import gzip
import itertools
import lzma
import os
import shutil
import unittest

from program import IS_SANITISED, Program, main, run, with_fault, write

DRAW = "ar3d draw hostile --algorithm diamond"
EDGES = DRAW + " --from edgelist -o d.jsonl"
BAD_INPUT = {
    "missing file": ("ar3d draw hostile.missing --algorithm diamond -o d.jsonl", "", "hostile.missing", "No such file"),
    "unreadable directory": ("ar3d draw /tmp --algorithm diamond -o d.jsonl", "", "/tmp", "directory"),
    "empty file": (DRAW + " -o d.jsonl", "", "hostile", "empty"),
    "truncated graph6": (DRAW + " -o d.jsonl", "Dhc\nI?\n", "hostile:2:"),
    "non-ASCII graph6": (DRAW + " -o d.jsonl", "D\udcff\udcfe\n", "hostile:1"),
    "sparse6 with bad padding": (DRAW + " -o d.jsonl", ":Fa@x^@\n", "hostile:1:"),
    "id out of range": (EDGES, "# vertices 3\n0 1\n1 7\n", "hostile:3:", "7"),
    "loop": (EDGES, "0 1\n4 4\n", "hostile:2:", "loop"),
    "parallel edges": (EDGES, "0 1\n1 2\n1 0\n", "hostile:3:", "parallel"),
    "no number": (EDGES, "0 1\n1 -2\n", "hostile:2:", "-2"),
    "absurd n in graph6": (DRAW + " -o d.jsonl", "~~~~~~~~\n", "hostile:1:"),
    "absurd n in sparse6": (DRAW + " -o d.jsonl", ":~~~~~~~~\n", "hostile:1:"),
    "unknown family": ("ar3d generate no-such-family -n 10 -o d.out", "", "no-such-family"),
    "unknown algorithm": ("ar3d draw hostile --algorithm no-such-algorithm -o d.jsonl", "Dhc\n", "no-such-algorithm"),
    "unknown option": (DRAW + " --set colour=3 -o d.jsonl", "Dhc\n", "colour"),
    "option out of range": (DRAW + " --set effort=9 -o d.jsonl", "Dhc\n", "effort", "9"),
    "unknown flag": (DRAW + " --colour red -o d.jsonl", "Dhc\n", "--colour"),
    "unwritable output": (DRAW + " -o /no/such/dir/out", "Dhc\n", "/no/such/dir/out"),
    "unknown TOML key": ("ar3d study run hostile -o d.out",
                         "study = 'x'\nfamilys = 'path'\n[[sweep]]\nfamilies = 'path'\nsizes = 9\nalgorithms = 'diamond'\n",
                         "hostile:2", "familys"),
    "broken TOML": ("ar3d study run hostile -o d.out", "study = \n", "hostile:1"),
    "unknown study": ("ar3d study run no-such-study -o d.out", "", "no-such-study"),
    "results that are no HDF5": ("ar3d check hostile", "hello\n", "hostile"),
    "missing results": ("ar3d report hostile.missing", "", "hostile.missing"),
    "drawing that is no JSON": ("ar3d verify hostile", "hello\n", "hostile:1")}


class BadInput(Program):
    def test_is_told_in_one_line_and_writes_nothing(self):
        for name, (command, content, *parts) in BAD_INPUT.items():
            with self.subTest(name):
                write("hostile", content)
                self.refused(command, *parts)
                self.assertEqual(os.listdir(), ["hostile"])

    def test_a_full_disk_is_an_error_not_a_short_file(self):
        self.expect("ar3d generate path -n 100000 -o - > /dev/full", 2, err="No space left")

    @unittest.skipIf(IS_SANITISED, "needs all address space")
    def test_a_study_of_too_many_rows_is_refused_in_little_memory(self):
        # 27 million cells of a million rows each: refused at the first few, not when all are in memory.
        write("s.toml", f"study = 's'\n[[sweep]]\nfamilies = {{ family = 'generalised-petersen', k = {list(range(1, 3001))} }}\n"
                        "sizes = { from = 4, to = 4294967294, per_decade = 1000 }\nalgorithms = 'grid'\nrepetitions = 1000000\n")
        said = self.expect("ulimit -v 1000000; ar3d study plan s.toml", 2)
        self.assertEqual(said.err, "ar3d: study s has more than 10000000 rows\n")

    def test_a_degree_above_the_guarantee_names_the_vertex(self):
        write("star", "0 1\n0 2\n0 3\n0 4\n0 5\n")
        # Its line in the stream of drawings; the others go on.
        self.expect("ar3d draw star --from edgelist --algorithm diamond", 2, out='"error"', err="vertex 0 has degree 5")

    def test_the_graph_without_vertices_is_drawn(self):
        self.expect("printf '?\\n' | ar3d draw - --algorithm diamond | ar3d verify -")


GRAPHS = {
    "file = 1": "file is not a string",
    "file = 'b.s6'": "cannot read ",
    "file = 'a.s6', name = 'a b'": "name 'a b' is not 1 to 47 letters",
    "file = 'a.s6', name = 3": "name is not a string",
    "file = 'a.s6', format = 's7'": "unknown graph format 's7'",
    "file = 'a.s6', format = 'dimacs'": "a.s6:1:1: ",
    "file = 'a.s6', base = 2": "base = 2 is outside 0..1",
    "file = 'a.s6', first_line = 'second'": "neither 'edge' nor 'header'",
    "file = 'a.s6', simple = 'yes'": "simple is neither true nor false",
    "file = 'a.s6', largest_component = 1": "largest_component is neither true nor false",
    "file = 'a.s6', sample = 0": "sample = 0 is outside",
    "file = 'a.s6', shuffle = [0.5]": "shuffle is not an integer",
    "file = 'a.s6', shuffel = 1": "unknown key 'shuffel'"}
GUARANTEE = "name = 'm'\ncommand = 'cat'\nguarantee = "
PROGRAM = {
    "command = 'cat'": "lacks 'name'",
    "name = 'm'": "lacks 'command'",
    "name = 'diamond'\ncommand = 'cat'": "is an algorithm of the catalogue",
    "name = 'm'\ncommand = 5": "command is not a string",
    "name = 'm'\ncommand = 'cat {steps}'": "names no option of it",
    "name = 'm'\ncommand = 'cat {steps}'\nsteps = 'many'": "steps is not an integer",
    "name = 'm'\ncommand = 'cat'\nsteps = 5": "unknown key 'steps'",
    "name = 'm'\ncommand = 'cat'\ninput = 'gml'": "input 'gml' is none of",
    "name = 'm'\ncommand = 'cat'\ntime_limit_s = 'long'": "time_limit_s is not a number",
    "name = 'm'\ncommand = 'cat'\ntime_limit_s_per_vertex = -1": "outside",
    "name = 'm'\ncommand = 'cat'\none_graph_per_process = 2": "neither true nor false",
    GUARANTEE + "{ max_bends = 3, cosine = [-1, 3] }": "lacks 'max_degree'",
    GUARANTEE + "{ max_degree = -1, max_bends = 3, cosine = [-1, 3] }": "max_degree = -1",
    GUARANTEE + "{ max_degree = 4, max_bends = 'x', cosine = [-1, 3] }": "max_bends is",
    GUARANTEE + "{ max_degree = 4, max_bends = 3, cosine = -0.3 }": "cosine is not",
    GUARANTEE + "{ max_degree = 4, max_bends = 3, cosine = [3, 1] }": "cosine is not",
    GUARANTEE + "{ max_degree = 4, max_bends = 3, cosine = [-1, 3], box = 5 }": "unknown key 'box'"}
FILES = {
    "a.g6": "D?\n",
    "a.s6": ":D\x01\n",
    "a.is6": ":B\n;\x01\n",
    "a.d6": "&B?\n",
    "a.edges": "0 1\n1 -2\n",
    "a.adj": "0 1\n1: two\n",
    "a.col": "p edge 3 1\ne 1 9\n",
    "a.graph": "3 5\n2\n1\n\n",
    "a.mtx": "%%MatrixMarket matrix coordinate pattern symmetric\n3 3 1\n7 1\n",
    "a.graphml": "<graphml><graph edgedefault='undirected'><edge source='a'/>"}


class BadKeys(Program):
    """Every key of `graphs` and `[[algorithm]]`, and every format of graphs, with a bad value."""

    def test_of_graphs_are_refused(self):
        self.expect("ar3d generate cycle -n 5 -o a.s6")
        for entry, message in GRAPHS.items():
            write("s.toml", f"study = 's'\n[[sweep]]\ngraphs = {{ {entry} }}\nalgorithms = 'grid'\n")
            self.refused("ar3d study plan s.toml", message)
            self.assertIn(message, run("ar3d study run s.toml -o s.h5").err)
            self.assertFalse(os.path.exists("s.h5"), entry)

    def test_of_a_program_are_refused(self):
        for keys, message in PROGRAM.items():
            write("s.toml", f"study = 's'\n[[algorithm]]\n{keys}\n[[sweep]]\nfamilies = 'cycle'\nsizes = 5\nalgorithms = 'm'\n")
            self.refused("ar3d study plan s.toml", message, "s.toml:")

    def test_files_of_every_format_are_refused_by_their_line(self):
        for name, text in FILES.items():
            write(name, text)
            self.refused(f"ar3d study run --graphs {name} --algorithm grid -o s.h5", name)
            self.assertFalse(os.path.exists("s.h5"), name)


# A sanitised program needs all address space.
IN_ONE_GIGABYTE = ("" if IS_SANITISED else "ulimit -v 1000000; ") + "export OMP_NUM_THREADS=1; timeout 100 "
N = "16777216"
CLAIMS = (  # what is 2^24 vertices, or nearly so, in every format
    ("graph6", "~~????~???\n"), ("sparse6", ":~~???}???" + 40000 * "?" + "\n"), ("isparse6", ":~~???}???\n;~~???}???\n"),
    ("edgelist", f"# vertices {N}\n0 1\n"), ("adjlist", f"# vertices {N}\n0: 1\n"),
    ("adjlist", "0: 16777215\n"), ("matrixmarket", f"%%MatrixMarket matrix coordinate pattern symmetric\n{N} {N} 1\n2 1\n"),
    ("metis", f"{N} 0\n" + 40000 * "\n"), ("dimacs", f"p edge {N} 1\ne 1 2\n"))


class HostileSizes(Program):
    """Files of a few kilobytes that claim millions of vertices, in bounded memory."""

    def refused_in_one_gigabyte(self, command, *parts):
        self.assertEqual(self.refused(IN_ONE_GIGABYTE + command, *parts).out, "", command)

    def test_are_refused_in_every_format_by_every_verb(self):
        self.expect("ar3d generate k4 | ar3d draw - --algorithm grid -o d.jsonl")
        for form, text in CLAIMS:
            write("claim", text)
            for algorithm in ("diamond", "two-bend"):
                self.refused_in_one_gigabyte(f"ar3d draw claim --from {form} --algorithm {algorithm} -o out.jsonl")
            self.refused_in_one_gigabyte(f"ar3d verify d.jsonl --graphs claim --from {form}")
            self.refused_in_one_gigabyte(f"ar3d shrink claim --from {form} --algorithm grid --ratio 1 -o s")

    def test_what_is_just_believed_fits_the_memory_too(self):
        write("many", "# vertices 1048576\n0 1\n")
        for algorithm in ("diamond", "grid", "compact"):
            self.expect(f"{IN_ONE_GIGABYTE} ar3d draw many --algorithm {algorithm} -o /dev/null")

    def test_are_believed_on_demand(self):
        write("many", "# vertices 1200000\n0 1\n")
        self.assertIn("1200000 vertices claimed by a graph of 4 bytes, which accounts for at most 1048640; --trust-sizes believes it",
                      run("ar3d draw many --algorithm grid -o /dev/null").err)
        self.expect("ar3d draw many --algorithm grid --trust-sizes -o /dev/null")

    def test_a_packed_file_does_not_unpack_without_end(self):
        text = b'<graphml><graph edgedefault="undirected">' + b"<a/>" * 50_000_000
        for ending, packed in ((".gz", gzip.compress(text)), (".xz", lzma.compress(text, preset=1)),
                               (".el.gz", gzip.compress(b"# a comment that goes on\n" * 8_000_000))):
            with open("bomb" + ending, "wb") as file:
                file.write(packed)
            self.refused_in_one_gigabyte(f"ar3d draw bomb{ending} --algorithm grid -o /dev/null", "unpack it first if that is meant")
        for text in ('{"n":16777216,"error":"x"}\n',
                     '{"n":4294967294,"algorithm":"grid","gram":[[1,0,0],[0,1,0],[0,0,1]],"gram_denominator":1,"vertices":[],"edges":[]}\n'):
            write("d.jsonl", text)
            self.assertIn(run(IN_ONE_GIGABYTE + "ar3d verify d.jsonl").code, (2, 5), text)


class Environment(Program):
    def test_openmp_gets_no_threads_and_stacks_that_end_the_process(self):
        write("g.g6", "D~{\n" * 9)
        draw = "ar3d draw g.g6 --algorithm diamond --threads 2 -o d.jsonl --force"
        for threads in ("1025", "4294967296", "9223372036854775807", "99999999999999999999", "2,4294967297"):
            self.expect(f"OMP_NUM_THREADS={threads} {draw}", 2, err="ar3d: OMP_NUM_THREADS asks for")
        for stack in ("16k", "32k", "63K", "1B", "65535b", "0", "2G", "100G", "1048577", "' 16 k'", "9999999999999999999999G"):
            self.expect(f"OMP_STACKSIZE={stack} {draw}", 2, err=("ar3d: OMP_STACKSIZE is", "64k to 1G are possible"))
        for good in ("OMP_NUM_THREADS=2", "OMP_NUM_THREADS=2,1", "OMP_NUM_THREADS=", "OMP_STACKSIZE=64k", "OMP_STACKSIZE=65536B", "OMP_STACKSIZE=1M",
                     "OMP_STACKSIZE=512", "OMP_STACKSIZE=1G"):
            self.expect(f"{good} {draw}")


class LargeNumbers(Program):
    def test_what_no_double_is_equal_to_is_a_number_all_the_same(self):
        write("s.toml", 'study = "s"\n[budget]\nrow_memory_bytes = 9223372036854775807\n[[sweep]]\nfamilies = "cycle"\nsizes = 5\nalgorithms = "grid"\n')
        self.refused("ar3d study plan -q s.toml", "s.toml:3: row_memory_bytes = 9.223372036854776e+18 is outside 0..1e+18")
        write("w.edges", "1 2 1e400\n2 3 1e-400\n")
        self.expect("ar3d draw w.edges --algorithm grid -q", 0, '"n":3,')


class Leftovers(Program):
    def test_a_kill_at_any_call_leaves_nothing_that_resume_does_not_take_away(self):
        """Also between a journal's second name and the end of its first one."""
        write("s.toml", 'study = "s"\n[[sweep]]\nfamilies = "cycle"\nsizes = [5, 6]\nalgorithms = "grid"\n')
        self.expect("ar3d study run -q s.toml -o whole.h5")
        for verb, kind, call in itertools.product(("run", "resume"), ("before", "after"), range(1, 16)):
            for name in os.listdir("."):
                if name.startswith("r."):
                    os.remove(name)
            if verb == "resume":
                shutil.copy("whole.h5", "r.h5")
            begin = "resume -q --again refused r.h5" if verb == "resume" else "run -q s.toml -o r.h5"
            killed = run(with_fault(f"{kind}:{call}") + "ar3d study " + begin)
            begun = os.path.exists("r.h5") or os.path.exists("r.h5.journal")
            self.expect("ar3d study " + ("resume -q r.h5" if begun else "run -q s.toml -o r.h5"))
            self.assertEqual([name for name in os.listdir(".") if "partial" in name or "journal" in name], [], (killed, kind, call))


class Elsewhere(Program):
    """What a call cannot do, and what can."""
    def test_an_option_in_front_of_its_verb(self):
        said = self.refused("ar3d --json list", "not expected: '--json' here; write 'ar3d list --json'")
        self.assertNotIn("did you mean", said.err)
        self.expect("ar3d list --json", out="{")
        self.refused("ar3d --quiet study run smoke", "write 'ar3d study run --quiet'")
        self.refused("ar3d --nothing list", "not expected: '--nothing'")

    def test_results_are_no_drawings(self):
        self.expect("ar3d study run smoke -q -o smoke.h5 && mv smoke.h5 r.h5")
        for call in ("view r.h5", "verify r.h5", "draw r.h5", "verify r.h5 --graphs r.h5", "verify - < r.h5"):
            self.refused(f"ar3d {call}", "results (HDF5), no graph and no drawing", "ar3d replay")
        command = run("ar3d verify r.h5").err.split("`")[1]
        self.assertEqual(command, "ar3d replay r.h5 --keep all -o drawings.jsonl")
        self.expect(command)
        self.expect("ar3d verify drawings.jsonl", out="0 violated")


if __name__ == "__main__":
    main()
