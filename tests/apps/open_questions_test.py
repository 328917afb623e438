"""What docs/open-questions.md says that computations say."""
import itertools
import json

from program import SOURCE, Program, main, read, run

FOLDER = f"{SOURCE}/docs/open-questions"
K5, OCTAHEDRON = "D~{", "E]~o"
DRAWABLE = "FFzvO"  # the other one with 7 vertices


def answer(graph6, options="", script="lattice_orders.py", solver="z3"):
    """What the solver says, "sat" or "unsat": has the graph a drawing on the lattice?"""
    return run(f"/usr/bin/python3 {FOLDER}/{script} '{graph6}' {options} > formula.smt2 && {solver} formula.smt2").out.rstrip("\n")


def box(drawing):
    """On the cube grid, where p = (x, y, z) is (x + y - 2z, x - y, 2(x + y + z)) in the file, as docs/open-questions.md names it."""
    points = drawing["vertices"] + [bend for _, _, bends in drawing["edges"] for bend in bends]
    on_grid = [((x + 3 * y + z) // 6, (x - 3 * y + z) // 6, (z - 2 * x) // 6) for x, y, z in points]
    return " x ".join(str(max(axis) - min(axis)) for axis in zip(*on_grid, strict=True))


def between(a, b):
    return [to - of for of, to in zip(a, b, strict=True)]


def dot(u, v):
    return 2 * u[0] * v[0] + 6 * u[1] * v[1] + u[2] * v[2]


class OpenQuestions(Program):
    def test_k5_has_no_lattice_drawing_with_two_bends(self):
        self.assertEqual(answer(K5), "unsat")

    def test_k5_has_no_lattice_drawing_with_two_bends_by_the_second_formula(self):
        self.assertEqual(answer(K5, script="lattice_lengths.py"), "unsat")

    def test_k5_has_no_lattice_drawing_with_one_bend_by_both_formulas(self):
        self.assertEqual(answer(K5, "--bends 1"), "unsat")
        self.assertEqual(answer(K5, "--bends 1", "lattice_lengths.py"), "unsat")

    def test_the_octahedron_has_no_lattice_drawing_with_two_bends(self):
        self.assertEqual(answer(OCTAHEDRON), "unsat")

    def test_one_graph_of_seven_vertices_has_a_lattice_drawing(self):
        self.assertEqual(answer(DRAWABLE), "sat")

    def test_the_model_refuses_what_is_not_four_regular(self):
        for script in ("lattice_orders.py", "lattice_lengths.py"):
            made = run(f"/usr/bin/python3 {FOLDER}/{script} 'C~'")
            self.assertNotEqual(made.code, 0)
            self.assertIn("vertex 0 has not degree 4", made.err)


class SmallDrawings(Program):
    def is_optimal(self, a, b, where):
        """The cosine is exactly -1/3, for squared length 2x^2 + 6y^2 + z^2."""
        self.assertTrue(dot(a, b) < 0 and 9 * dot(a, b) ** 2 == dot(a, a) * dot(b, b), where)

    def test_k4_has_a_drawing_with_one_bend(self):
        run(f"/usr/bin/python3 {FOLDER}/k4_one_bend.py > k4.jsonl")
        self.expect("ar3d verify k4.jsonl --algorithm two-bend-109", out="4 certified, 0 violated")
        for drawing in map(json.loads, read("k4.jsonl").splitlines()):
            self.assertEqual((box(drawing), len(drawing["edges"])), ("4 x 4 x 4", 6))
            leaving = [[], [], [], []]
            for u, v, (bend,) in drawing["edges"]:  # one bend
                back = [between(bend, drawing["vertices"][end]) for end in (u, v)]
                self.is_optimal(*back, "at the bend")
                for end, direction in zip((u, v), back, strict=True):
                    leaving[end].append([-x for x in direction])
            for three in leaving:
                self.assertEqual(len(three), 3)
                for a, b in itertools.combinations(three, 2):
                    self.is_optimal(a, b, "at a vertex")

    def test_k5_with_one_bend_is_made_again(self):
        made = self.expect(f"/usr/bin/python3 {FOLDER}/k5_one_bend.py --exact", err="58.668 degrees")
        self.assertEqual(made.out, read(f"{FOLDER}/k5_one_bend.jsonl"))

    def test_the_sum_excludes_one_bend_for_k5_alone(self):
        sums = run("for n in 5 6 7 8 9; do nauty-geng -cq -d4 -D4 $n; done | "
                   f"/usr/bin/python3 {FOLDER}/one_bend_sums.py").out
        self.assertEqual((sums.count("\n"), sums.count(": excluded")), (26, 1), sums)
        self.assertIn("D~{ n=5 at least 13.33, at most 12.25: excluded\n", sums)

    def test_are_certified_and_have_the_boxes_stated(self):
        self.expect(f"ar3d verify {FOLDER}/small_drawings.jsonl --algorithm two-bend-109", out="3 certified, 0 violated")
        lines = read(f"{FOLDER}/small_drawings.jsonl")
        self.assertNotIn("two-bend-109", lines, "no algorithm of ours drew them")
        boxes = [box(json.loads(line)) for line in lines.splitlines()]
        self.assertEqual(boxes, ["29 x 41 x 38", "14 x 14 x 14", "12 x 12 x 14"])
        self.assertHas(read(f"{SOURCE}/docs/open-questions.md"), [size.replace(" x ", "×") for size in boxes])

    def test_the_search_finds_a_drawing_or_says_that_it_finds_none(self):
        search = f"/usr/bin/python3 {FOLDER}/small_drawings.py "
        self.expect(search + "C~ 40 9 1 100000 0.1 | ar3d verify - --algorithm two-bend-109", out="1 certified, 0 violated",
                    err="box 9 x 7 x 7")
        self.expect(search + "'D~{' 2 1 1 1000 0.1", 1)
        for bad in ("'D~{' 2 1 1 1000", "'D~' 9 9 1 1000 0.1", "'E~~w' 9 9 1 1000 0.1", "'D~{' 0 9 1 1000 0.1",
                    "'D~{' 9 200 1 1000 0.1"):
            self.expect(search + bad, 2, err="usage: small_drawings")


class FaceDrawings(Program):
    """Drawings of cubic graphs along face diagonals with two bends per edge."""
    script = f"/usr/bin/python3 {FOLDER}/face_lengths.py"

    def test_one_bend_does_not_suffice_for_k4_and_two_do(self):
        self.assertEqual(answer("C~", "--bends 1", "face_lengths.py"), "unsat")
        self.expect(f"{self.script} C~ --draw | ar3d verify - --algorithm grid", out="1 certified, 0 violated")

    def test_are_certified_and_serve_each_direction(self):
        self.expect(f"ar3d verify {FOLDER}/face_drawings.jsonl --algorithm grid", out="112 certified, 0 violated")
        for drawing in map(json.loads, read(f"{FOLDER}/face_drawings.jsonl").splitlines()):
            served = set()
            for u, v, bends in drawing["edges"]:
                self.assertLessEqual(len(bends), 2)
                corners = [drawing["vertices"][u], *bends, drawing["vertices"][v]]
                steps = [between(a, b) for a, b in itertools.pairwise(corners)]
                if len(steps) == 3:
                    served |= {(axis, first > 0) for axis, (first, level, last) in enumerate(zip(*steps, strict=True))
                               if level == 0 and first * last < 0}
            self.assertEqual(len(served), 6)

    def test_what_is_no_cubic_graph_is_refused(self):
        for bad in ("'D~{'", "''", "C", "'~~'", "'C~~'"):
            self.assertNotEqual(self.expect(f"{self.script} {bad}", 1).err, "")

    def test_graphs_that_two_edges_cut_are_drawn_with_two_bends(self):
        axes = "1,1,0:1,-1,0:1,0,1:1,0,-1:0,1,1:0,1,-1"
        promise = f"--bends 2 --cosine -1/2 --exactly --directions={axes}"
        for n, count in ((8, 5), (10, 18), (12, 81)):  # of which two edges cut 1, 4 and 24
            self.expect(f"nauty-geng -q -C -d3 -D3 {n} >g.g6; /usr/bin/python3 {FOLDER}/bridgeless.py ar3d <g.g6 >d.jsonl")
            self.expect(f"ar3d verify d.jsonl --graphs g.g6 {promise}", out=f"{count} certified, 0 violated")
        for bad in ("D~{", "C", "I?`cspoX?", "E?Bw"):  # K5, a K4 cut short, a bridge, a star
            self.assertIn(bad, self.expect(f"echo '{bad}' | /usr/bin/python3 {FOLDER}/bridgeless.py ar3d", 1).err)


class OpenQuestionsLong(Program):
    def test_no_graph_of_at_most_8_vertices_has_one_bend_on_faces(self):
        for graph in run("for n in 6 8; do nauty-geng -cq -d3 -D3 $n; done").out.split():
            self.assertEqual(answer(graph, "--bends 1", "face_lengths.py"), "unsat")

    def test_the_search_draws_the_graphs_of_6_vertices_on_faces(self):
        for graph in ("EFz_", "EUxo"):
            self.expect(f"/usr/bin/python3 {FOLDER}/face_lengths.py {graph} --draw | ar3d verify - --algorithm grid", out="1 certified")

    def test_the_octahedron_has_no_lattice_drawing_by_the_second_formula(self):
        self.assertEqual(answer(OCTAHEDRON, script="lattice_lengths.py"), "unsat")  # 29 s of CPU time

    def test_three_graphs_have_no_lattice_drawing_by_a_second_solver(self):
        for graph in (K5, OCTAHEDRON, "FUzro"):
            self.assertEqual(answer(graph, solver="cvc5"), "unsat")

    def test_the_complement_of_the_seven_cycle_has_no_lattice_drawing(self):
        self.assertEqual(answer("FUzro"), "unsat")

    def test_one_graph_of_eight_vertices_has_a_lattice_drawing_by_both_formulas(self):
        for script in ("lattice_orders.py", "lattice_lengths.py"):
            self.assertEqual(answer("G?~vf_", script=script), "sat")

    def test_the_search_of_k5_reaches_the_bends_stated(self):
        self.assertIn("66.67", run(f"/usr/bin/python3 {FOLDER}/k5_one_bend.py 6 0.001").out)

    def test_the_search_finds_the_committed_drawings_again(self):
        page, found = read(f"{SOURCE}/docs/open-questions.md"), ""  # whose table of arguments has all three
        for arguments in ("'D~{' 120 22 10 5000000 0.05", "'E]~o' 40 9 15 3000000 0.1", "FUzro 60 9 12 2000000 0.15"):
            self.assertIn(f"`{arguments}`", page)
            found += run(f"/usr/bin/python3 {FOLDER}/small_drawings.py {arguments}").out
        self.assertEqual(found, read(f"{FOLDER}/small_drawings.jsonl"))


if __name__ == "__main__":
    main()
