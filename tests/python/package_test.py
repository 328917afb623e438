"""The Python package, as its users import it. Run by ctest (python.package) with PYTHONPATH=build/…/python."""
import contextlib
import os
import pathlib
import pickle
import re
import subprocess
import sys
import tempfile
import unittest

import networkx
import numpy
import pandas
import scipy.sparse

import ar3d


class OwnPoints(unittest.TestCase):
    SQUARE = [(0, 0, 0), (5, 0, 0), (5, 5, 0), (0, 5, 0)]

    def verdict(self, *drawing, graph=networkx.cycle_graph(4), **promise):
        """"valid", the kinds of violations, or the text of the ValueError."""
        try:
            certificate = ar3d.certify(graph, *drawing, **promise)
        except ValueError as error:
            return str(error)
        return "valid" if certificate else sorted({text.partition(":")[0] for text in certificate.violations})

    def test_are_held_to_what_is_promised(self):
        crossed = [self.SQUARE[i] for i in (0, 2, 1, 3)]
        detour = {(1, 0): [(3, 0, 1), (1, 0, 1)]}
        self.assertEqual(self.verdict(self.SQUARE), "valid")
        self.assertEqual(self.verdict(self.SQUARE, angle=90, exactly=True), "valid")
        self.assertEqual(self.verdict([point[:2] for point in self.SQUARE], angle=90), "valid")
        self.assertEqual(self.verdict(self.SQUARE, angle=109.47), ["vertex_angle"])
        self.assertEqual(self.verdict(crossed), ["crossing"])
        self.assertEqual(self.verdict([(0, 0, 0)] * 4), ["degenerate_segment", "same_point"])
        self.assertEqual(self.verdict(self.SQUARE, detour, max_bends=2), "valid")
        self.assertEqual(self.verdict(self.SQUARE, detour, max_bends=1), ["bends"])
        self.assertEqual(self.verdict(self.SQUARE, [[], [], [], []]), "valid")
        named = networkx.relabel_nodes(networkx.cycle_graph(4), "v{}".format)
        self.assertEqual(self.verdict({f"v{i}": p for i, p in enumerate(self.SQUARE)}, graph=named), "valid")
        drawn = ar3d.draw(networkx.petersen_graph())
        self.assertEqual(self.verdict(drawn, graph=networkx.petersen_graph(), angle=120, max_bends=3, exactly=True), "valid")

    def test_of_a_layout_get_their_verdict(self):
        petersen = networkx.petersen_graph()
        layout = networkx.spring_layout(petersen, dim=3, seed=1)
        rounded = {node: numpy.rint(1000 * point) for node, point in layout.items()}
        self.assertIn("positions are whole numbers below 2^62, not 0.0", self.verdict(layout, graph=petersen))
        self.assertEqual(self.verdict(rounded, graph=petersen), "valid")
        self.assertEqual(self.verdict(rounded, graph=petersen, angle=120), ["vertex_angle"])

    def test_that_make_no_drawing_are_refused(self):
        square = self.SQUARE
        for said, drawing, promise in (
                ("3 points for vertices are given, the graph has 4", [square[:3]], {}),
                ("positions are of 3 nodes, the graph has 4; 0 has none", [{1: square[1], 2: square[2], 3: square[3]}], {}),
                ("whole numbers below 2^62, not 4611686018427387904", [[*square[:3], (0, 2**62, 0)]], {}),
                ("whole numbers below 2^62, not nan", [[[float("nan")] * 3] * 4], {}),
                ("positions are points of 2 or 3 numbers each", [[1, 2, 3, 4]], {}),
                ("bends are of (2, 0), which is no edge", [square, {(2, 0): [(1, 1, 1)]}], {}),
                ("bends are of 3, which is no edge", [square, {3: [(1, 1, 1)]}], {}),
                ("bends are of 3 edges, the graph has 4", [square, [[]] * 3], {}),
                ("angle is 120, 109.47, 90 or None, not 100", [square], {"angle": 100}),
                ("the graph has a vertex of degree 2, max_degree is 1", [square], {"max_degree": 1}),
                ("max_bends = -1 is not from 0", [square], {"max_bends": -1}),
                ("bends are of points of one's own", [ar3d.draw(networkx.cycle_graph(4)), [[]] * 4], {}),
                ("an algorithm has its own angle", [square], {"algorithm": "grid", "angle": 90})):
            self.assertIn(said, self.verdict(*drawing, **promise))

    def test_a_drawing_is_a_layout(self):
        graph = networkx.relabel_nodes(networkx.petersen_graph(), "v{}".format)
        drawing = ar3d.draw(graph)
        layout = ar3d.layout(graph, drawing)
        self.assertEqual(list(layout), list(graph.nodes))
        self.assertTrue((layout["v3"] == drawing.in_space(drawing.vertices)[3]).all())
        self.assertEqual(ar3d.layout(ar3d.as_graph(graph), drawing).shape, (10, 3))


class Draw(unittest.TestCase):
    def test_every_kind_of_graph_gives_the_same_proved_drawing(self):
        petersen = networkx.petersen_graph()
        edges = numpy.array(petersen.edges)
        dense = networkx.to_numpy_array(petersen)
        graphs = [petersen, edges, edges[::-1, ::-1], edges.tolist(), edges.astype(numpy.uint32),
                  scipy.sparse.csr_matrix(dense), scipy.sparse.coo_matrix(numpy.triu(dense)), ar3d.as_graph(petersen)]
        for algorithm in ("diamond", "grid", "two-bend", "compact"):
            first = ar3d.draw(petersen, algorithm)
            for graph in graphs:
                drawing = ar3d.draw(graph, algorithm)
                self.assertTrue((drawing.vertices == first.vertices).all())
                self.assertTrue((drawing.bends == first.bends).all())
                certificate = ar3d.certify(graph, drawing)
                self.assertTrue(certificate and certificate.valid and certificate.complete)
                self.assertEqual(certificate.violations, [])

    def test_arrays_have_the_stated_shapes_and_are_views(self):
        graph = ar3d.generate("random-cubic", 50, 7)
        drawing = ar3d.draw(graph, "grid", effort=0)
        m = graph.num_edges
        self.assertEqual(drawing.vertices.shape, (50, 3))
        self.assertEqual(drawing.edges.shape, (m, 2))
        self.assertEqual(drawing.bend_offsets.shape, (m + 1,))
        self.assertEqual(drawing.bends.shape, (drawing.bend_offsets[-1], 3))
        self.assertEqual(drawing.vertices.dtype, numpy.int64)
        self.assertTrue((drawing.edges == graph.edges).all())
        points = numpy.vstack([drawing.vertices, drawing.bends])
        self.assertTrue((drawing.box == [points.min(axis=0), points.max(axis=0)]).all())
        address = lambda array: array.__array_interface__["data"][0]
        for name in ("vertices", "bends", "edges"):
            a, b = getattr(drawing, name), getattr(drawing, name)
            self.assertEqual(address(a), address(b), name)  # the drawing's own memory
            self.assertFalse(a.flags.writeable)
            self.assertFalse(a.flags.owndata)
        self.assertEqual(address(drawing.edges), address(graph.edges))

    def test_travels_with_its_names(self):
        graph = networkx.relabel_nodes(networkx.petersen_graph(), "node {}".format)
        drawing = ar3d.draw(graph)
        self.assertEqual((drawing.algorithm, drawing.names), ("grid", [f"node {v}" for v in range(10)]))
        self.assertEqual(ar3d.draw(networkx.complete_graph(5)).algorithm, "diamond")
        self.assertEqual(ar3d.draw(networkx.complete_graph(5)).names, [], "numbers say nothing")
        with tempfile.TemporaryDirectory() as folder:
            drawing.save(folder + "/d.jsonl")
            loaded = ar3d.load(pathlib.Path(folder, "d.jsonl"))
        for other in [pickle.loads(pickle.dumps(drawing)), *loaded]:
            self.assertTrue((other.vertices == drawing.vertices).all() and (other.bends == drawing.bends).all())
            self.assertEqual(other.names, drawing.names)
            self.assertTrue(ar3d.certify(graph, other))
        self.assertIn("node 7", drawing._repr_html_())
        self.assertTrue(drawing._repr_html_().startswith("<iframe "))
        self.assertEqual(dir(ar3d), sorted([*ar3d.__all__, "__version__"]))

    def test_drawings_of_a_notebook_share_the_viewer_of_the_first(self):
        with tempfile.TemporaryDirectory() as folder:
            script = ("import ar3d, sys; frames = [ar3d.draw('D~{', name)._repr_html_() for name in ('diamond', 'compact', 'diamond')]\n"
                      "print(*map(len, frames)); open('page.html', 'w').write(sys.argv[1] + ''.join(frames) + '</body></html>')")
            count = ("<html><body><script>setInterval(() => document.body.dataset.ready = Array.from(frames).filter("
                     "frame => frame.ar3d).length, 100)</script>")
            done = subprocess.run([sys.executable, "-c", script, count], check=True, cwd=folder, capture_output=True, text=True)
            first, *others = map(int, done.stdout.split())
            self.assertGreater(first, 400_000)
            self.assertLess(max(others), 60_000)
            browse = ["chromium", "--headless", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
                      f"--user-data-dir={folder}/profile", "--virtual-time-budget=60000", "--dump-dom", f"file://{folder}/page.html"]
            shown = [subprocess.run(browse, capture_output=True, text=True).stdout[:200] for _ in range(2)]  # time is virtual: some load, two looks
            self.assertTrue(any('data-ready="3"' in text for text in shown), shown)

    def test_takes_texts_and_igraph_and_warns(self):
        import igraph
        for graph in ("D~{", igraph.Graph.Full(5)):
            self.assertEqual(ar3d.as_graph(graph).num_edges, 10)
        named = igraph.Graph([(0, 1)])
        named.vs["name"] = ["a", "b"]
        self.assertEqual(ar3d.draw(named).names, ["a", "b"])
        with self.assertRaisesRegex(ValueError, "directed"):
            ar3d.as_graph(igraph.Graph([(0, 1)], directed=True))
        with self.assertWarnsRegex(UserWarning, "no graph with 7 vertices: this has 6"):
            ar3d.generate("random-cubic", 7)

    def test_takes_a_data_frame_and_a_file(self):
        frame = pandas.DataFrame({"weight": [1.5, 2], "Target": ["a, b", "c"], "Source": ["c", "d"]})
        self.assertEqual(ar3d.draw(frame).names, ["c", "a, b", "d"])
        self.assertEqual(ar3d.as_graph(frame).edges.tolist(), [[0, 1], [0, 2]])
        with self.assertWarnsRegex(UserWarning, "^the DataFrame: ids are from 1 to 3$"):
            self.assertEqual(ar3d.as_graph(pandas.DataFrame({"u": [1, 2], "v": [2, 3]})).num_vertices, 3)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "names.csv")
            path.write_text("source,target\na,b\nb,c\n")
            with self.assertWarnsRegex(UserWarning, "names.csv:1: 'source target' is a heading, no edge"):
                self.assertEqual(ar3d.draw(path).names, ["a", "b", "c"])

    def test_runs_a_study(self):
        os.environ["AR3D"] = str(pathlib.Path(sys.argv[1]).resolve())
        rows = ar3d.run_study({"study": "t", "sweep": [{"families": "cycle", "sizes": [5, 9], "algorithms": "diamond"}]})
        self.assertEqual(list(rows.n), [5, 9])
        with self.assertRaisesRegex(ValueError, "unknown family 'circle'"):
            ar3d.run_study({"study": "t", "sweep": [{"families": "circle", "sizes": 5, "algorithms": "diamond"}]})
        with self.assertRaisesRegex(ValueError, "key 'seed = 1.*study'"):
            ar3d.run_study({"study": "t", "seed = 1\nstudy": "u"})

    def test_is_saved_as_the_program_writes_it_and_replaced_if_asked(self):
        drawing = ar3d.draw(networkx.petersen_graph(), "grid")
        self.assertEqual(repr(drawing), "<ar3d.Drawing of 10 vertices, 15 edges and %d bends by grid>" % len(drawing.bends))
        self.assertEqual(repr(ar3d.certify(networkx.petersen_graph(), drawing)), "<ar3d.Certificate: valid>")
        self.assertRegex(repr(ar3d.certify(networkx.cycle_graph(10), drawing)), r"<ar3d.Certificate: \d+ violations>")
        program = pathlib.Path(sys.argv[1]).resolve()
        told = subprocess.run([program, "--version"], check=True, capture_output=True, text=True).stdout
        self.assertEqual(told.split()[:2], ["ar3d", ar3d.__version__])
        with tempfile.TemporaryDirectory() as folder:
            graph = "\n".join(f"{u} {v}" for u, v in networkx.petersen_graph().edges)
            pathlib.Path(folder, "petersen.txt").write_text(graph + "\n")
            for ending in ("jsonl", "svg", "tikz", "vtp", "glb", "stl", "graphml", "html"):
                drawing.save(f"{folder}/mine.{ending}")
                subprocess.run([program, "draw", "petersen.txt", "--from", "edgelist", "--algorithm", "grid", "-o",
                                f"its.{ending}"], cwd=folder, check=True)
                mine, its = (pathlib.Path(folder, f"{whose}.{ending}").read_bytes() for whose in ("mine", "its"))
                self.assertEqual(mine, its.replace(b"petersen.txt:15", b"the drawing"))  # a page names its input
            with self.assertRaisesRegex(FileExistsError, "mine.svg exists; force=True"):
                drawing.save(folder + "/mine.svg")
            drawing.save(folder + "/mine.svg", "vtp", force=True)
            self.assertTrue(pathlib.Path(folder, "mine.svg").read_text().startswith("<?xml"))
            for path, wrong in (("x.png", "png"), ("no/such/x.svg", "no/such")):
                self.assertRaisesRegex(ValueError, wrong, drawing.save, f"{folder}/{path}")

    def test_a_forked_child_certifies_although_its_parents_threads_are_not_there(self):
        script = ("import os, ar3d\n"
                  "graph = ar3d.generate('random-cubic', 90000, 1)\n"
                  "drawing = ar3d.draw(graph, 'grid')\n"
                  "assert ar3d.certify(graph, drawing)\n"
                  "child = os.fork()\n"
                  "if child == 0: os._exit(0 if ar3d.certify(graph, drawing) else 1)\n"
                  "assert os.waitpid(child, 0)[1] == 0\n")
        subprocess.run([sys.executable, "-c", script], check=True, timeout=200, env={**os.environ, "OMP_NUM_THREADS": "2"})
        shown = subprocess.run([sys.executable, "-c", "import ar3d"], check=True, capture_output=True, text=True,
                               env={**os.environ, "OMP_DISPLAY_ENV": "true"}).stderr
        self.assertIn("OMP_WAIT_POLICY = 'PASSIVE'", shown)

    def test_arrays_outlive_their_drawing(self):
        vertices = ar3d.draw(networkx.cycle_graph(10)).vertices
        copy = vertices.copy()
        for i in range(100):
            ar3d.draw(networkx.cycle_graph(10 + i))
        self.assertTrue((vertices == copy).all())

    def test_in_space_angles_are_the_guaranteed_ones(self):
        for algorithm, cosine in (("two-bend", -1 / 2), ("diamond", -1 / 3)):
            for line in ar3d.polylines(ar3d.draw(networkx.complete_graph(4), algorithm)):
                steps = numpy.diff(line, axis=0)
                for a, b in zip(steps[:-1], steps[1:]):
                    seen = -(a @ b) / (numpy.linalg.norm(a) * numpy.linalg.norm(b))
                    self.assertLess(seen, cosine + 1e-9)  # at least that angle

    def test_the_program_draws_the_same(self):
        program = sys.argv[1]
        text = subprocess.run([program, "generate", "random-cubic", "-n", "30", "--seed", "3", "--format", "edgelist"],
                              check=True, capture_output=True, text=True).stdout
        lines = [line for line in text.splitlines() if line and not line.startswith("#")]
        rows = [tuple(map(int, line.split())) for line in lines]
        mine = ar3d.generate("random-cubic", 30, 3)
        self.assertTrue({tuple(sorted(row)) for row in rows} >= {tuple(map(int, edge)) for edge in mine.edges})

    def test_graphs_without_edges_or_vertices(self):
        for graph in (networkx.empty_graph(3), networkx.Graph()):
            drawing = ar3d.draw(graph)
            self.assertEqual(drawing.vertices.shape, (len(graph), 3))
            self.assertEqual(drawing.bends.shape, (0, 3))
            self.assertEqual(drawing.edges.shape, (0, 2))
            self.assertTrue(ar3d.certify(graph, drawing))
        self.assertEqual(ar3d.as_graph([], 5).num_vertices, 5)

    def test_another_graph_is_a_violation(self):
        drawing = ar3d.draw(networkx.cycle_graph(6))
        certificate = ar3d.certify(networkx.path_graph(6), drawing)
        self.assertFalse(certificate)
        self.assertIn("edge_set", certificate.violations[0])


class BadInput(unittest.TestCase):
    def test_is_a_value_error_that_names_the_value(self):
        cases = [
            (lambda: ar3d.draw(networkx.star_graph(5)), "degree"),
            (lambda: ar3d.draw(networkx.DiGraph([(0, 1)])), "directed"),
            (lambda: ar3d.draw([(0, 0)]), "0"),
            (lambda: ar3d.draw([(0, 1), (1, 0)]), "0"),
            (lambda: ar3d.draw([(0, -1)]), "-1"),
            (lambda: ar3d.draw([(0, 5)], "diamondd"), "diamond"),
            (lambda: ar3d.draw([(0, 1)], "diamond", speed=1), "speed"),
            (lambda: ar3d.draw([(0, 1)], "diamond", effort=99), "99"),
            (lambda: ar3d.draw([(0, 1)], "two-bend-paper"), "real type"),
            (lambda: ar3d.draw([(0.5, 1)]), "integers"),
            (lambda: ar3d.draw([1, 2, 3]), "shape"),
            (lambda: ar3d.draw(numpy.array([[0, 2**63]], dtype=numpy.uint64)), "64 bits"),
            (lambda: ar3d.as_graph([(0, 9)], 5), "vertices are 0 to 4"),
            (lambda: ar3d.as_graph([(0, 9)], 0), "there are no vertices"),
            (lambda: ar3d.generate("x\x1b[31m", 10), "x\\x1b[31m"),
            (lambda: ar3d.generate("x\0y", 10), "x\\x00y"),
            (lambda: ar3d.as_graph([], -1), "-1"),
            (lambda: ar3d.draw(scipy.sparse.csr_matrix((2, 3))), "square"),
            (lambda: ar3d.draw(scipy.sparse.identity(3)), "0"),
            (lambda: ar3d.generate("cyclee", 5), "cycle"),
            (lambda: ar3d.generate("cycle", -1), "n is"),
            (lambda: ar3d.draw([(0, 1)]).in_space(numpy.zeros((2, 2), dtype=int)), "shape"),
            (lambda: ar3d.draw([(0, 1)]).in_space([[0.5, 1, 2]]), "integers"),
            (lambda: ar3d.draw([(0, 1)], effort=1.5), "effort is an integer, not 1.5"),
            (lambda: ar3d.draw([(0, 1)], effort="x"), "effort is an integer, not 'x'"),
            (lambda: ar3d.draw([(0, 1)], effort=2**70), "beyond 64 bits"),
            (lambda: ar3d.draw([(0, 1)], 3), "algorithm is a name, not 3"),
            (lambda: ar3d.generate("cycle", 5.5), "n is an integer, not 5.5"),
            (lambda: ar3d.generate(3, 5), "family is a name, not 3"),
            (lambda: ar3d.as_graph(ar3d.generate("cycle", 5), 7), "its own"),
            (lambda: ar3d.as_graph([(0, 1)], 2.5), "num_vertices is an integer, not 2.5"),
            (lambda: ar3d.draw(networkx.Graph([("a\udcff", "b")])), r"'\udcff' is no UTF-8, in "),
            (lambda: ar3d.as_graph("a\udcff,b\n"), r"'\udcff' is no UTF-8, in "),
            (lambda: ar3d.as_graph(pandas.DataFrame({"source": ["a\udcff"], "target": ["b"]})), r"'\udcff' is no UTF-8, in "),
            (lambda: ar3d.as_graph(pandas.DataFrame({"name": ["a"], "age": [7]})), "columns such as source and target, or from and to; these are ['name', 'age']"),
            (lambda: ar3d.as_graph(pandas.DataFrame({"source": ["a", None], "target": ["b", "c"]})), "the DataFrame:3:1: an end of an edge is missing"),
            (lambda: ar3d.as_graph(pandas.DataFrame({"source": [0.0, 1.5], "target": [1, 2]})), "the DataFrame:2:1: expected a vertex id, found '0.0'"),
            (lambda: ar3d.as_graph(pathlib.Path("/no/such.g6")), "/no/such.g6: No such file or directory"),
            (lambda: ar3d.as_graph(scipy.sparse.coo_matrix(([1, numpy.nan], ([0, 1], [1, 0])))), "an entry that is nan"),
            (lambda: ar3d.as_graph(scipy.sparse.coo_matrix(([1, -1], ([0, 0], [1, 1])), (2, 2))), "at one place cancel"),
        ]
        for call, word in cases:
            with self.assertRaises(ValueError) as caught:
                call()
            self.assertIn(word, str(caught.exception))
            self.assertTrue(str(caught.exception).isprintable())

    def test_what_was_not_made_by_ar3d_is_no_object_of_its_classes(self):
        for made in (ar3d.Drawing, ar3d.Certificate, ar3d.Graph):
            for call in (made, lambda made=made: made.__new__(made), lambda made=made: object.__new__(made)):
                self.assertRaises(TypeError, call)
        drawing = ar3d.draw([(0, 1), (1, 2)])
        for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
            text = pickle.dumps(drawing, protocol)
            self.assertEqual(repr(pickle.loads(text)), repr(drawing))
            for end in range(len(text)):  # a pickle that is cut, and ended
                with contextlib.suppress(Exception):
                    self.assertNotIsInstance(pickle.loads(text[:end] + b"."), ar3d.Drawing)

    def test_a_byte_0_cuts_no_file_name(self):
        drawing = ar3d.draw([(0, 1)])
        with tempfile.TemporaryDirectory() as folder:
            for call in (lambda: drawing.save(f"{folder}/a\0b.jsonl"), lambda: drawing.save(f"{folder}/a\0b.jsonl", force=True),
                         lambda: ar3d.load(f"{folder}/a\0b.jsonl")):
                with self.assertRaisesRegex(ValueError, "byte 0"):
                    call()
            self.assertEqual(os.listdir(folder), [])
            drawing.save(f"{folder}/\x1b[31m.jsonl")
            with self.assertRaises(FileExistsError) as caught:
                drawing.save(f"{folder}/\x1b[31m.jsonl")
            self.assertTrue(str(caught.exception).isprintable())


class Results(unittest.TestCase):
    def test_a_results_file_is_a_frame_with_units(self):
        with tempfile.TemporaryDirectory() as folder:
            spec, path = folder + "/tiny.toml", folder + "/tiny.h5"
            with open(spec, "w") as file:
                file.write("study = 'tiny'\n[[sweep]]\nfamilies = 'cycle'\nsizes = [8, 9]\nalgorithms = 'grid'\n")
            subprocess.run([sys.argv[1], "study", "run", spec, "--threads", "1", "--quiet", "-o", path], check=True,
                           capture_output=True)
            runs = ar3d.read_results(path)
            self.assertEqual(list(runs.n), [8, 9])
            self.assertEqual(runs.attrs["units"]["wall_s"], "s")
            self.assertEqual(runs.attrs["units"]["peak_bytes"], "bytes")
            self.assertIn("drawing", runs.attrs["meaning"]["wall_s"])
            self.assertEqual(len(ar3d.read_results(path, "instances")), 2)
            with self.assertRaises(KeyError):
                ar3d.read_results(path, "no such table")
        with self.assertRaises(OSError):
            ar3d.read_results("no-such-file.h5")


class Page(unittest.TestCase):
    def test_docs_python_md_runs_as_printed(self):
        page = pathlib.Path(__file__).resolve().parents[2] / "docs" / "python.md"
        blocks = re.findall(r"^```python\n(.*?)^```", page.read_text(), re.S | re.M)
        self.assertEqual(len(blocks), 2)
        with tempfile.TemporaryDirectory() as folder:
            spec = folder + "/quick.toml"
            pathlib.Path(spec).write_text("study = 'quick'\n[[sweep]]\nfamilies = 'cycle'\nsizes = 8\nalgorithms = 'grid'\n")
            subprocess.run([pathlib.Path(sys.argv[1]).resolve(), "study", "run", spec, "--quiet"], check=True,
                           capture_output=True, cwd=folder)
            for block in blocks:
                subprocess.run([sys.executable, "-c", block], check=True, cwd=folder, env={**os.environ, "MPLBACKEND": "Agg"})


    def test_its_shell_commands_build_and_install_the_package(self):
        root = pathlib.Path(__file__).resolve().parents[2]
        build = pathlib.Path(sys.argv[1]).resolve().parents[1]
        blocks = re.findall(r"^```sh\n(.*?)^```", (root / "docs" / "python.md").read_text(), re.S | re.M)
        lines = [re.sub(r"\s+#.*", "", line) for line in "".join(blocks).splitlines()]
        venv, pip, make, use, install = lines
        self.assertEqual([venv, pip], re.findall(r"^(?:python3|build/env/bin/pip) .*", (root / "tests/python/wheel.sh").read_text(), re.M))
        environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
        with tempfile.TemporaryDirectory() as folder:
            def shell(line):
                for printed, here in (("build/release", str(build)), ("DIR", folder)):
                    line = line.replace(printed, here)
                line = re.sub(r"(?<= )python3(?= )", sys.executable, line)
                return subprocess.run(["bash", "-c", line], check=True, capture_output=True, text=True, cwd=root,
                                      env=environment).stdout
            configure, ninja = make.split(" && ")
            self.assertEqual(configure, "cmake --preset release -DAR3D_PYTHON=ON")
            self.assertIn("AR3D_PYTHON:BOOL=ON", (build / "CMakeCache.txt").read_text())
            self.assertIn('"release"', shell("cmake --list-presets"))
            self.assertIn("ninja", shell(ninja.replace("ninja", "ninja -n")))  # would build it, or has nothing to do
            self.assertEqual(shell(use + " -c 'import ar3d; print(ar3d.__file__)'").strip(),
                             str(build / "python" / "ar3d" / "__init__.py"))
            shell(install)
            packages = folder + "/lib/python3/dist-packages"
            self.assertEqual(shell(f"PYTHONPATH={packages} python3 -c 'import ar3d; print(ar3d.draw([(0, 1)]).vertices.shape)'").strip(),
                             "(2, 3)")


class Plot(unittest.TestCase):
    def test_edges_and_vertices_are_on_the_axes(self):
        import matplotlib
        matplotlib.use("Agg")
        axes = ar3d.plot(ar3d.draw(networkx.petersen_graph(), "grid"), linewidths=2)
        self.assertEqual(len(axes.collections), 2)
        axes.figure.canvas.draw()


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
