"""Drawings on their way through the program: pages, formats of other programs, several files, levels, real types, threads."""
import html
import json
import os
import re
import resource
import xml.etree.ElementTree

import h5py

from program import IS_SANITISED, Program, main, read, run, write


class View(Program):
    """`ar3d view` and `ar3d draw --format html`; what the page does: tests/browser/viewer.test.mjs."""

    def test_writes_the_same_page_as_draw(self):
        write("d.jsonl-graphs", "D~{\nC~\n")
        draw = "ar3d draw d.jsonl-graphs --algorithm diamond"
        self.expect(f"{draw} -o d.jsonl && ar3d view d.jsonl && ar3d view d.jsonl && {draw} -o x.html && {draw} --format html > y.html")
        page = read("x.html")
        self.assertTrue(page == read("y.html"))
        self.assertAlmostEqual(os.path.getsize("d.html"), os.path.getsize("x.html"), delta=200)
        self.assertLess(os.path.getsize("x.html"), 1_000_000)
        for foreign in ("src=", 'href="http', "@import", "url("):
            self.assertNotIn(foreign, page.partition("var THREE")[0])

    def test_says_what_is_wrong(self):
        write("d.jsonl", '{"n":1,"error":"none"}\n')
        write("d.html", "<p>mine</p>")
        self.refused("ar3d view d.jsonl", "d.html exists and is no page of `ar3d view`")
        self.assertEqual(read("d.html"), "<p>mine</p>")
        self.refused("ar3d view - < d.jsonl", "a page of standard input needs a name")
        self.refused("ar3d view d.jsonl -o no/x.html", "no/x.html")
        self.refused("ar3d view d.jsonl -o d.jsonl", "would be overwritten")
        self.refused("ar3d view d.jsonl --algorithm hexagon -o x.html", "unknown algorithm 'hexagon'")
        write("b.jsonl", '{"n":1,"error":"none"}\n{"n":\n')
        self.refused("ar3d view b.jsonl -o x.html", "b.jsonl:2:")
        self.assertFalse(os.path.exists("x.html"), "nothing half-written")

    def test_shows_what_was_not_drawn(self):
        self.expect("printf 'E~~w\\nC~\\n' | ar3d draw - --algorithm diamond -o x.html", 2,
                    err="<stdin>:1: diamond draws graphs of maximum degree 4")
        self.assertIn('"error":"diamond draws graphs of maximum degree 4', read("x.html"))


class Export(Program):
    """The formats of other programs."""
    FORMATS = ("svg", "tikz", "vtp", "glb", "stl", "graphml")

    def test_help_says_what_each_format_keeps(self):
        text = run("ar3d draw --help").out
        for name in self.FORMATS:
            self.assertRegex(text, f"\n  {name} +\\.[a-z]+.*: ")

    def test_bad_input_is_one_line_and_writes_nothing(self):
        grid = " | ar3d draw - --algorithm grid"
        cases = [("ar3d generate random-cubic -n 60000" + grid + " -o x.svg", "svg holds at most these"),
                 ("ar3d generate random-cubic -n 60000" + grid + " -o x.tikz", "tikz holds at most these"),
                 ("ar3d generate random-cubic -n 60000" + grid + " -o x.stl", "stl holds at most 65536"),
                 ("ar3d generate random-cubic -n 9000 | ar3d draw - --algorithm two-bend -o x.glb", "glb holds at most 16777216")]
        for name in self.FORMATS:
            cases += [(f"printf 'C~\\nC~\\n'{grid} --format {name} -o x",
                       f"<stdin>:2: a second graph, but format {name} holds one drawing per file"),
                      (f"printf 'D~{{\\n'{grid} --format {name} -o x", "maximum degree 3"),
                      (f"printf 'C~\\n'{grid} --format {name} -o no/x", "no/x")]
        for command, message in cases:
            self.refused(command, message)
            self.assertEqual(os.listdir(), [], command)

    def test_vtp_is_read_by_a_parser_of_xml_as_vtk_describes_it(self):
        for algorithm in ("diamond", "grid", "two-bend"):
            draw = f"ar3d generate random-cubic -n 40 | ar3d draw - --force --algorithm {algorithm} -o d"
            self.expect(f"{draw}.vtp && {draw}.jsonl")
            piece = xml.etree.ElementTree.parse("d.vtp").getroot().find("PolyData/Piece")
            array = {(e.tag, a.get("Name")): [float(w) for w in a.text.split()] for e in piece for a in e}
            drawing = json.loads(read("d.jsonl"))
            n, m, points = drawing["n"], len(drawing["edges"]), int(piece.get("NumberOfPoints"))
            self.assertEqual([int(piece.get(k)) for k in ("NumberOfVerts", "NumberOfLines")], [n, m])
            lattice = [array["PointData", "lattice"][3 * i:3 * i + 3] for i in range(points)]
            self.assertEqual(lattice[:n], drawing["vertices"])
            self.assertEqual(array["PointData", "vertex"], [*range(n)] + [-1] * (points - n))
            self.assertEqual(array["CellData", "edge"], [-1] * n + [*range(m)])
            self.assertEqual(array["Verts", "offsets"], [*range(1, n + 1)])
            self.assertEqual(len(array["CellData", "colour"]), 3 * (n + m))
            self.assertEqual(len(array["Points", "Points"]), 3 * points)
            begin = 0
            for (u, v, bends), end in zip(drawing["edges"], map(int, array["Lines", "offsets"]), strict=True):
                first, *inner, last = (int(i) for i in array["Lines", "connectivity"][begin:end])
                self.assertEqual((first, [lattice[i] for i in inner], last), (u, bends, v))
                begin = end


class SeveralFiles(Program):
    """Verbs that take several files, and the names of vertices on their way to drawings and pages."""

    def setUp(self):
        super().setUp()
        write("a.edges", "alice bob\nbob carol\n")
        write("b.gml", 'graph [ node [ id 1 label "<x> & y" ] node [ id 2 ] edge [ source 1 target 2 ] ]\n')
        self.expect("ar3d generate petersen -n 10 -o c.g6")

    def test_are_drawn_verified_shown_and_hunted_in_one_go(self):
        draw = "ar3d draw --algorithm grid "
        self.expect(f"{draw} a.edges b.gml c.g6 -o all.jsonl && {draw} a.edges -o a.jsonl && {draw} c.g6 -o c.jsonl")
        self.expect("ar3d verify all.jsonl --graphs a.edges --graphs b.gml --graphs c.g6", out="3 certified, 0 violated")
        self.expect("ar3d verify a.jsonl c.jsonl", out="2 certified, 0 violated")
        self.expect("ar3d verify a.jsonl c.jsonl --graphs a.edges", 2,
                    err="a.edges has 1 graphs, but a.jsonl c.jsonl has more drawings")
        self.expect("ar3d view a.jsonl c.jsonl -o page.html")
        self.assertHas(read("page.html"), ("about-0", "about-1"))
        self.refused("ar3d view a.jsonl c.jsonl", "a page of several files needs a name")
        self.refused(draw + "a.edges c.g6 -o x.svg", "one drawing")
        self.refused(draw + "a.edges none.g6", "cannot read none.g6")
        self.refused(draw + "a.edges c.g6 -o c.g6 --format jsonl", "c.g6")
        said = self.expect("ar3d hunt --algorithm grid --graphs c.g6 --graphs a.edges --evaluations 20", out="comes from 2 files (")
        share = re.search(r"side is (\S+) of the theorem's bound", said.out)
        self.assertGreater(float(share[1]), 0, share)

    def test_what_is_assumed_of_a_file_is_said_on_the_terminal_in_the_results_and_on_the_page(self):
        for text, note in (("source,target\n0,1\n1,2\n", "lists.csv:1: 'source target' is a heading, no edge"),
                           ("0,1\n1,3\n", "lists.csv: 1 of 4 vertices are in no line"),
                           ("1,2\n2,3\n", "lists.csv: ids are from 1 to 3"),
                           ("0,1000000\n", "lists.csv: ids up to 1000000 are names: as numbers they would leave most vertices without an edge")):
            write("lists.csv", text)
            self.expect("ar3d draw lists.csv --algorithm grid -o /dev/null", err="ar3d: note: " + note)
            self.expect("ar3d study run --force --graphs lists.csv --algorithm grid -o lists.h5", err=note)
            self.assertIn(note, html.unescape(read("lists.html")))
            with h5py.File("lists.h5", "r") as file:
                values = {row["name"]: row["value"] for row in file["environments"][:]}
            self.assertTrue(values[b"reading_notes"].decode().endswith(note), values)

    def test_names_travel_to_drawings_pages_and_exports(self):
        write("one.edges", "# Nodes: 3 Edges: 2\n1 2\n2 3\n")
        said = self.expect("ar3d draw one.edges --algorithm grid -o /dev/null", err="ar3d: note: one.edges:1: ids are from 1 to 3\n")
        self.assertEqual(said.err.count("\n"), 1)
        self.expect("ar3d study run --graphs one.edges --algorithm grid -o one.h5 && grep -q 'ids are from 1 to 3' one.html", err="ids are from 1")
        self.expect("ar3d draw a.edges b.gml --algorithm grid -o d.jsonl")
        self.assertHas(read("d.jsonl"), (',"names":["alice","bob","carol"]}\n', '"names":["<x> & y","2"]}'))
        self.expect("ar3d verify d.jsonl && ar3d view d.jsonl")
        self.assertIn('"names":["alice","bob","carol"]', read("d.html"))
        self.expect("ar3d draw a.edges --algorithm grid -o d.svg && ar3d draw a.edges --algorithm grid -o d.graphml")
        self.assertIn("<title>bob</title></circle>", read("d.svg"))
        self.assertIn('<node id="n1"><data key="name">bob</data>', read("d.graphml"))
        self.expect("ar3d draw d.graphml --algorithm grid", out='"names":["alice","bob","carol"]')

    def test_names_in_a_line_are_as_many_as_vertices(self):
        self.expect("ar3d draw a.edges --algorithm grid -o d.jsonl")
        line, old = read("d.jsonl"), '["alice","bob","carol"]'
        self.assertIn(old, line)
        for names, message in {'["a"]': "n is 3, but there are 1 names", "[1]": "unexpected number 1", '[["a"]]': "unexpected array",
                               '"a"': "unexpected text 'a'", "{}": "unexpected object"}.items():
            write("bad.jsonl", line.replace(old, names))
            self.expect("ar3d verify bad.jsonl", 2, err=message)


class DrawLevels(Program):
    """How much of a drawing the program writes."""

    def drawn_at(self, level, algorithm):
        said = run(f"ar3d generate random-cubic -n 20 | ar3d draw - --algorithm {algorithm} --level {level}")
        self.assertIn(said.code, (0, 5), said)
        return json.loads(said.out)

    def test_extents_tell_of_the_drawing_instead_of_writing_it(self):
        metrics = {row["name"] for row in json.loads(run("ar3d list metrics --json").out)["metrics"]}
        self.assertGreater(len(metrics), 20)
        for algorithm in ("diamond", "grid", "two-bend", "compact", "compact-120", "two-bend-109", "grid-paper"):
            line = self.drawn_at("extents", algorithm)
            self.assertEqual([line[key] for key in ("level", "verdict", "violations")], ["extents", "proved", 0])
            self.assertFalse({"vertices", "edges"} & line.keys())
            self.assertEqual(metrics - line.keys(), set())
            self.assertEqual(sum(line[f"bends_{bends}"] for bends in range(8)), 30)
            for low, high, axis in zip(*line["box"], "xyz", strict=True):
                self.assertEqual(high - low, line[f"extent_{axis}"])

    def test_positions_are_those_of_the_drawing(self):
        for algorithm in ("diamond", "two-bend", "two-bend-paper"):
            line, extents, full = (self.drawn_at(level, algorithm) for level in ("positions", "extents", "full"))
            self.assertEqual(line["vertices"], full["vertices"])
            self.assertNotIn("edges", line)
            self.assertEqual("unit_exponent" in line, "unit_exponent" in full)
            self.assertEqual({key: line.get(key) for key in extents}, {**extents, "level": "positions"})

    def test_what_is_not_proved_is_no_pass(self):
        self.expect("ar3d generate cycle -n 5 | ar3d draw - --algorithm two-bend-paper --level extents", 5, out='"verdict":"measured"')
        self.expect("ar3d generate random-4-regular -n 10 | ar3d draw - --algorithm grid --level extents", 2, out='"error"')

    def test_other_formats_are_of_whole_drawings(self):
        said = self.expect("ar3d generate cycle -n 5 | ar3d draw - --algorithm diamond --level extents -o c.svg", 2)
        self.assertEqual(said.err, "ar3d: --level extents is written as jsonl, not as svg\n")
        self.expect("ar3d draw - --algorithm diamond --level half </dev/null", 2)

    def test_long_lines_are_never_held_as_a_whole(self):
        # The line of 200,000 vertices has 30 MB; the program with the drawing takes less than that text would take beside it.
        self.expect("ar3d generate random-4-regular -n 200000 -o g.s6 && OMP_NUM_THREADS=1 ar3d draw g.s6 --algorithm diamond -o d.jsonl")
        self.assertGreater(os.path.getsize("d.jsonl"), 25 << 20)
        if not IS_SANITISED:  # which keeps what is freed
            self.assertLess(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss, 70 << 10)


class RealTypes(Program):
    """two-bend-paper through the program: draw, verify, study, replay, check, report."""

    def test_are_drawn_exactly_and_judged_without_tolerance(self):
        for number, name in enumerate(("float", "double", "binary80", "binary128", "reference")):
            self.expect("ar3d generate random-cubic -n 20 | "
                        f"ar3d draw - --algorithm two-bend-paper --set type={number} --force -o d.jsonl")
            self.assertIn(f'"real_type":"{name}"', read("d.jsonl"))
            said = self.expect("ar3d verify d.jsonl", 5, out=("0 certified, 0 violated, 0 not drawn, 1 measured",
                                                              "0 crossings, 0 collapsed segments"))
        self.assertIn("in reference: ", said.out)

    def test_a_damaged_line_is_measured_or_violated(self):
        verify = ("""printf '%s\\n' '{"n":2,"algorithm":"two-bend-paper","real_type":"float","unit_exponent":-1,"""
                  """"vertices":[["0","0","0"],["-6","0","0"]],"edges":[[0,1,[BENDS]]]}' | ar3d verify -""")
        for bends, code, text in (("", 5, "in float: angles miss by at most 0 degrees"),
                                   ('["0","3","0"]', 5, "angles miss by at most 56.5651 degrees"),
                                   ('["0","0","0"]', 5, "1 collapsed segments"),
                                   ('["0","3","0"],["0","9","9"],["7","9","9"]', 4, "bends: edge 0 has 3 bends, at most 2 are promised")):
            self.expect(verify.replace("BENDS", bends), code, out=text)
        self.expect(verify.replace("BENDS", "") + " --algorithm two-bend", 4)

    def test_hostile_lines_are_refused_by_name(self):
        def line(exponent, point, real_type="float"):
            return (f'{{"n":1,"algorithm":"two-bend-paper","real_type":"{real_type}","unit_exponent":{exponent},'
                    f'"vertices":[[{point}]],"edges":[]}}')
        zero = '"0","0","0"'
        for text, message in {
                line(5000, zero): "5000 is not in -4000..4000",
                line(0, '"0","0x1","0"'): "is no decimal integer",
                line(0, '"0","nan","0"'): "is no decimal integer",
                line(0, '"0","-","0"'): "is no decimal integer",
                line(0, '"0","16777217","0"'): "vertex 0 has a coordinate of 25 significant bits, float holds 24",
                **{line(0, zero, name): "is none of float, double, binary80," for name in ("", "NaN", "half", "Double")},
                line(0, "0,0,0"): "are texts of decimal integers",
                line(0, '"0","0"'): "2 numbers instead of 3",
                line(0, f'"{1001 * "7"}","0","0"'): "more than 1000 characters",
                line(0, zero).replace('"unit_exponent":0,', ""): "key 'unit_exponent' is missing",
                '{"n":1,"algorithm":"grid","gram":[[1,0,0],[0,1,0],[0,0,1]],"gram_denominator":1,"vertices":[["0","0","0"]],"edges":[]}':
                "coordinates are integers"}.items():
            self.expect(f"printf '%s\\n' '{text}' | ar3d verify -", 2, err=message)

    def test_rows_say_that_they_are_measured_and_check_does_not_pass_them_unasked(self):
        spec = ('[[sweep]]\nfamilies = ["random-cubic", "union-k4"]\nsizes = [12, 40]\n'
                'algorithms = ["two-bend", { algorithm = "two-bend-paper", type = [0, 1, 4] }]\n')
        write("s.toml", 'study = "real"\n' + spec)
        write("a.toml", 'study = "real"\naccept_unproved = true\n' + spec)
        self.expect("ar3d study run s.toml -q -o r.h5", 5)  # twelve rows are not proved
        self.expect("ar3d check r.h5", 5, out=("12 not proved",
                                               "16 rows, 4 proved, 0 violated, 0 incomplete, 0 refused, 12 not proved"))
        self.expect("ar3d check --accept-unproved r.h5", out="12 not proved (accepted)")
        self.expect("ar3d study run a.toml -q -o a.h5", out="12 not proved (accepted)")
        self.expect("ar3d check a.h5")
        for which in ("0", "1", "2", "3", "--all"):
            self.expect("ar3d replay r.h5 " + which)
        self.expect("ar3d report a.h5 -o a.html")

    def test_outputs_that_would_round_are_refused_or_pictures(self):
        self.expect("ar3d generate union-k4 -n 8 | ar3d draw - --algorithm two-bend-paper -o d.svg")
        self.expect("ar3d hunt --algorithm two-bend-paper -n 20 --evaluations 1", 2)

    def test_the_list_says_what_is_promised(self):
        self.expect("ar3d list algorithms", out=("two-bend-paper: ", "what rounding makes of it is measured; no box",
                                                 "option type = 0..4 (default 1)"))


class Coordinates(Program):
    def test_that_the_bound_does_not_cover_or_that_do_not_fit_are_refused(self):
        for n, coordinates, code, err in ((20, "auto", 0, ""), (20, "checked=int16", 0, ""), (1000, "proved=int32", 0, ""),
                                          (20, "proved=int16", 2, "20 vertices: the bound proves int16 for at most "),
                                          (1000, "checked=int16", 2, "above the least one, int16 holds 32767"), (20, "int16", 2, "")):
            said = self.expect(f"ar3d generate random-cubic -n {n} | ar3d draw - --algorithm two-bend --coordinates {coordinates}",
                               code, err=err)
            self.assertEqual('"error":' in said.out, bool(err))


class Threads(Program):
    """What comes out of the program is the same on any number of threads."""

    def test_one_large_drawing_and_many_small_ones(self):
        self.expect("ar3d generate random-4-regular -n 66000 -o large.s6 && ar3d generate random-cubic -n 20 --count 30 -o small.s6")
        for file in ("large.s6", "small.s6"):
            draw = f"ar3d draw {file} --algorithm diamond --level extents"
            alone = self.expect(draw + " --threads 1", out='"proved"').out
            for threads in (" --threads 2", " --threads 3", ""):
                self.assertEqual(run(draw + threads).out, alone, threads)

    def test_verify_and_usage(self):
        self.expect("ar3d generate random-cubic -n 20 --count 5 | ar3d draw - --algorithm diamond -o d.jsonl")
        for threads in (1, 2, 3):
            self.assertEqual(self.expect(f"ar3d verify d.jsonl --threads {threads}").out, "5 certified, 0 violated, 0 not drawn\n")
        for threads in ("0", "-1", "two", "100000"):
            self.expect(f"ar3d verify d.jsonl --threads {threads}", 2)


class OnePlane(Program):
    VERIFY = "ar3d verify f.jsonl --bends 0 --cosine=-1/3 --at-least "

    def fan(self, size, wrong=()):
        """Segments side by side in one plane, whose boxes all meet. @param wrong  places whose upper ends are exchanged with the next one's."""
        high = 10 ** 6
        tops = [40 * i + i + high for i in range(size)]
        for i in wrong:
            tops[i], tops[i + 1] = tops[i + 1], tops[i]
        points = [point for i in range(size) for point in ([40 * i, 0, 7], [tops[i], high, 7])]
        edges = [[2 * i, 2 * i + 1, []] for i in range(size)]
        write("f.jsonl", json.dumps({"n": 2 * size, "algorithm": "mine", "gram": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "gram_denominator": 1,
                                     "vertices": points, "edges": edges}) + "\n")

    def test_segments_side_by_side_are_proved_and_a_crossing_is_named(self):
        self.fan(5000)
        self.expect(self.VERIFY, 0, "1 certified")
        self.fan(5000, wrong=[17, 3000])
        said = self.expect(self.VERIFY, 4, ["crossing: edge 17 (34-35)", "crossing: edge 3000 (6000-6001)"])
        self.assertEqual(said.out.count("crossing"), 2)
        for test in ("all-pairs", "halving"):
            self.assertEqual(run(self.VERIFY + "--crossing-test " + test).out, said.out)


class OnePlaneLong(OnePlane):
    def test_100000_are_proved(self):
        self.fan(100000)
        self.expect(self.VERIFY, 0, "1 certified")


if __name__ == "__main__":
    main()
