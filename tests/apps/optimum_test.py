"""`ar3d optimum`, its proofs, and the table of known optima."""
import collections
import csv
import itertools
import json
import os
import pathlib
import signal
import subprocess

from program import AR3D, SOURCE, Program, main, read, run, write

TABLE = f"{SOURCE}/results/reference/optima"
PROMISE = {"109.47": "--cosine -1/3 --exactly --directions 1,1,1:1,1,-1:1,-1,1:1,-1,-1",
           "120": "--cosine -1/2 --exactly --directions 1,1,0:1,-1,0:1,0,1:1,0,-1:0,1,1:0,1,-1"}
K4, TRIANGLE = "C~\n", "Bw\n"


def extents_and_ones(drawing):
    points = drawing["vertices"] + [bend for _, _, bends in drawing["edges"] for bend in bends]
    return sorted(max(axis) - min(axis) + 1 for axis in zip(*points, strict=True))


def canonical(graphs):
    write("some.g6", "".join(graph + "\n" for graph in graphs))
    return run("nauty-labelg -q some.g6").out.split()


def edges(graph):
    bits = [ord(c) - 63 >> 5 - k & 1 for c in graph[1:] for k in range(6)]
    pairs = [(i, j) for j in range(ord(graph[0]) - 63) for i in range(j)]
    return [pair for pair, bit in zip(pairs, bits) if bit]


def graph6(n, chosen):
    bits = [int((i, j) in chosen) for j in range(n) for i in range(j)]
    bits += [0] * (-len(bits) % 6)
    return chr(63 + n) + "".join(chr(63 + int("".join(map(str, bits[i:i + 6])), 2)) for i in range(0, len(bits), 6))


def checker(test):
    """The program that is proved to accept only proofs."""
    path = pathlib.Path(AR3D).resolve().parents[1] / "proof/ar3d_unsatisfiable"
    if not path.exists():
        test.skipTest("built without the proved checker")
    return path


class Optimum(Program):
    def setUp(self):
        super().setUp()
        write("k4.g6", K4)
        write("two.g6", TRIANGLE + K4)

    def test_prints_a_line_for_each_graph_and_writes_certified_drawings(self):
        said = self.expect("ar3d optimum two.g6 -o two.jsonl", out=["Bw: 64 lattice points, 4 x 4 x 4: no smaller box holds a drawing",
                                                                    "C~: 125 lattice points, 5 x 5 x 5"])
        self.assertEqual(said.out.count("\n"), 2)
        self.expect(f"ar3d verify two.jsonl --graphs two.g6 --bends 3 {PROMISE['109.47']}", out="2 certified, 0 violated")
        self.expect(f"ar3d verify two.jsonl --graphs two.g6 --bends 0 {PROMISE['109.47']}", 4, out="bends")
        self.assertEqual([extents_and_ones(json.loads(line)) for line in read("two.jsonl").splitlines()], [[4] * 3, [5] * 3])

    def test_in_a_plane(self):
        self.expect("ar3d optimum two.g6 --plane -o two.jsonl -q", out=["Bw: 75", "C~: 245"])
        self.expect(f"ar3d verify two.jsonl --bends 3 {PROMISE['109.47']} --plane z=0", out="2 certified")

    def test_prints_one_object(self):
        found = json.loads(self.expect("ar3d optimum k4.g6 --angle 120 --json").out)["graphs"][0]
        self.assertEqual([found[key] for key in ("graph6", "angle", "bends", "plane", "at_least", "at_most", "box")],
                         ["C~", "120", 3, False, 125, 125, [5, 5, 5]])
        self.assertEqual({one["answer"] for one in found["formulas"]}, {"unsatisfiable"}, "routed begins with the smallest box")

    def test_keeps_proofs_of_every_maximal_box(self):
        self.expect("ar3d optimum two.g6 --proofs proofs")
        with open("proofs/index.csv", encoding="ascii") as file:
            rows = list(csv.DictReader(file))
        refuted = collections.defaultdict(list)
        for row in rows:
            files = [pathlib.Path(f"proofs/{row['name']}.{ending}") for ending in ("cnf", "drat")]
            has_files = row["answer"] == "unsatisfiable" and row["variables"] != "0"
            self.assertEqual([file.exists() for file in files], [has_files] * 2, row)
            if row["answer"] == "unsatisfiable":
                refuted[row["graph6"]].append(tuple(int(row[axis]) for axis in "xyz"))
            if not has_files:
                continue
            self.assertEqual(read(files[0]).split("\n", 1)[0], f"p cnf {row['variables']} {row['clauses']}")
            self.assertEqual(read(files[0]).count("\n") - 1, int(row["clauses"]))
            self.assertTrue(all(set(line) <= set("-d 0123456789") and line.endswith("0") for line in read(files[1]).splitlines()))
            self.assertEqual(read(files[1]).splitlines()[-1], "0", "the last lemma is the empty clause")
        for graph, volume in (("Bw", 64), ("C~", 125)):
            for box in itertools.takewhile(lambda b: b[0] ** 3 < volume, itertools.combinations_with_replacement(range(2, 33), 3)):
                if box[0] * box[1] * box[2] < volume:
                    self.assertTrue(any(all(a <= b for a, b in zip(box, other)) for other in refuted[graph]), (graph, box))
        self.refused("ar3d optimum k4.g6 --proofs proofs", "proofs", "not empty")
        self.expect("ar3d optimum k4.g6 --proofs proofs --force")

    def test_has_proofs_that_the_proved_checker_accepts(self):
        self.expect("ar3d optimum k4.g6 --proofs proofs -q")
        formulas = len(list(pathlib.Path("proofs").glob("*.cnf")))
        self.assertGreaterEqual(formulas, 15)
        self.expect(f"{checker(self)} proofs/*.cnf", out=f"unsatisfiable {formulas}, refused 0, not read 0")
        first = min(pathlib.Path("proofs").glob("*.cnf"))
        write(first, "\n".join(read(first).splitlines()[:40]).replace(read(first).split()[3], "39", 1) + "\n")
        self.expect(f"{checker(self)} {first}", 4, out="REFUSED")

    def test_takes_another_solver(self):
        self.expect("ar3d optimum two.g6 --solver 'cadical -q' --proofs proofs", out=["Bw: 64", "C~: 125"])
        write("silent", "#!/bin/sh\nexit 3\n")
        os.chmod("silent", 0o755)
        self.refused("ar3d optimum k4.g6 --solver ./silent", "./silent", "without an answer (code 3)")
        self.refused("ar3d optimum k4.g6 --solver no-such-program", "no-such-program", "No such file")
        write("liar", "#!/bin/sh\necho s SATISFIABLE\necho v 999999999 0\n")
        os.chmod("liar", 0o755)
        self.refused("ar3d optimum k4.g6 --solver ./liar", "./liar", "a variable that is none")

    def test_refuses_what_it_cannot_answer_and_goes_on(self):
        write("bad.edges", "0 1\n2 3\n")
        self.refused("ar3d optimum bad.edges", "bad.edges:", "2 components")
        write("three.g6", "D~{\nBw\nE~~w\n")
        said = self.expect("ar3d optimum three.g6 --angle 120 -o three.jsonl -q", 2, out="Bw: 27", err=["three.g6:1: degree 4", "three.g6:3: degree 5"])
        self.assertEqual(said.err.count("\n"), 2)
        self.assertEqual(read("three.jsonl").count('"error"'), 2)
        self.refused("ar3d generate path -n 33 | ar3d optimum -", "33 vertices")
        self.refused("ar3d optimum k4.g6 --bends 17", "--bends")
        self.refused("ar3d optimum k4.g6 --angle 90", "--angle")
        self.refused("ar3d optimum k4.g6 --volume-below 1", "--volume-below")
        self.refused("ar3d optimum k4.g6 -o k4.g6", "k4.g6")
        self.refused("ar3d optimum k4.g6 -o -", "-")

    def test_gives_an_interval_when_time_is_up(self):
        self.expect("ar3d optimum k4.g6 --volume-below 100 -o none.jsonl", 5, out="C~: at least 100 lattice points; no drawing was found")
        self.expect("ar3d optimum k4.g6 --seconds 1e-9", 5, out="C~: 8 to ")
        self.expect("ar3d optimum k4.g6 --plane --seconds 1e-9", 5, out="no drawing was found")
        self.assertIn('"error"', read("none.jsonl"))

    def test_prints_the_interval_when_interrupted(self):
        write("petersen.g6", "IheA@GUAo\n")
        with subprocess.Popen([AR3D, "optimum", "petersen.g6", "-o", "petersen.jsonl"], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              text=True) as process:
            self.assertIn("IheA@GUAo: box ", process.stderr.readline())  # while it solves
            process.send_signal(signal.SIGINT)
            out, _ = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        self.assertRegex(out, r"^IheA@GUAo: (at least )?[0-9]+ .*lattice points")
        self.assertTrue(os.path.exists("petersen.jsonl"))


class Promises(Program):
    def test_are_those_of_the_proved_checker(self):
        """The promise of each algorithm in words gives the verdict of its guarantee."""
        write("cycle.g6", run("ar3d generate cycle -n 9 --format graph6").out)
        for algorithm in ("diamond", "compact", "grid", "compact-120", "two-bend", "two-bend-109"):
            self.expect(f"ar3d draw cycle.g6 --algorithm {algorithm} -q | ar3d verify - $(ar3d list --promise {algorithm})", out="1 certified")
        self.expect("ar3d draw cycle.g6 --algorithm diamond -q -o c.jsonl && ar3d verify c.jsonl --bends 3 --cosine -1/3 --exactly "
                    "--box 0n,8n,8n", 4, out="the extent in x")

    def test_that_are_none_are_refused(self):
        write("c.jsonl", "")
        for words, part in {"--bends 3": "--cosine", "--bends 3 --cosine x --exactly": "'x'", "--bends 3 --cosine -1/3": "--at-least",
                            "--cosine -1/3": "--bends", "--bends 3 --cosine -1/3 --exactly --box 3": "'3'",
                            "--bends 3 --cosine -1/3 --exactly --box 3n,3n,3n^40": "'3n^40'",
                            "--bends 3 --cosine -1/3 --exactly --gram 0,0,0": "Gram", "--bends 3 --cosine 1/3 --exactly": "'1/3'",
                            "--bends 3 --cosine -1/3 --exactly --gram 1,1": "'1,1'",
                            "--bends 3 --cosine -1/3 --exactly --directions 0,0,0": "'0,0,0'",
                            "--bends 3 --cosine -1/3 --exactly --algorithm diamond": "--algorithm",
                            "--bends 3 --cosine -1/3 --exactly --plane x=0": "'x=0'",
                            "--bends 3 --cosine -1/3 --exactly --at-least": "--at-least"}.items():
            self.refused("ar3d verify c.jsonl " + words, part)


class KnownOptima(Program):
    def rows(self):
        with open(TABLE + ".csv", encoding="ascii") as file:
            return list(csv.DictReader(file))

    def test_are_drawn_in_the_boxes_stated(self):
        groups = collections.defaultdict(list)
        for row, line in zip(self.rows(), read(TABLE + ".jsonl").splitlines(), strict=True):
            if row["volume"]:
                groups[row["angle"], row["bends"], row["plane"]].append((row, line))
        for (angle, bends, plane), group in groups.items():
            write("some.jsonl", "".join(line + "\n" for _, line in group))
            write("some.g6", "".join(row["graph6"] + "\n" for row, _ in group))
            self.expect(f"ar3d verify some.jsonl --graphs some.g6 --bends {bends} {PROMISE[angle]} {'--plane z=0' if plane == '1' else ''}",
                        out=f"{len(group)} certified, 0 violated")
            for row, line in group:
                box = extents_and_ones(json.loads(line))
                self.assertEqual([str(side) for side in box], [row["x"], row["y"], row["z"]])
                self.assertEqual(box[0] * box[1] * box[2], int(row["volume"]))
                self.assertLessEqual(int(row["at_least"]), int(row["volume"]))

    def test_of_all_small_graphs_are_there(self):
        closed = collections.Counter((row["set"], row["n"]) for row in self.rows() if row["at_least"] == row["volume"])
        for name, counts in {"109-small-3": [1, 2, 6, 21], "109-small-5": [1, 2, 6, 21], "120-small-3": [1, 2, 6, 10],
                             "120-small-5": [1, 2, 6, 10]}.items():
            self.assertEqual([closed[name, str(n)] for n in (2, 3, 4, 5)], counts)
        self.assertEqual([closed[name, "6"] for name in ("109-six-3", "109-six-5", "120-six-3", "120-six-5")], [78, 78, 29, 26])
        self.assertEqual([closed["109-named-3", "6"], closed["109-named-3", "8"]], [3, 1])

    def test_shrink_with_edges_taken_away_and_with_more_bends(self):
        rows = [row for row in self.rows() if row["volume"]]
        names = dict(zip([row["graph6"] for row in rows], canonical([row["graph6"] for row in rows])))
        known = collections.defaultdict(dict)
        for row in rows:
            known[row["angle"], row["plane"], int(row["bends"])][names[row["graph6"]]] = row
        pairs = 0
        for table in known.values():
            whole = [(graph, edge) for graph in table for edge in edges(graph)]
            less = canonical([graph6(ord(g[0]) - 63, set(edges(g)) - {edge}) for g, edge in whole])
            for (graph, _), part in zip(whole, less):
                if part in table:
                    self.assertLessEqual(int(table[part]["at_least"]), int(table[graph]["volume"]), (part, graph))
                    pairs += 1
        self.assertGreater(pairs, 250)
        for (angle, plane, bends), table in known.items():
            for more in (4, 5):
                for graph, row in known.get((angle, plane, more), {}).items():
                    if graph in table and more > bends:
                        self.assertLessEqual(int(row["at_least"]), int(table[graph]["volume"]))


class KnownOptimaLong(Program):
    def test_are_found_again(self):
        for angle, table in (("109.47", "109-small-3"), ("120", "120-small-3")):
            with open(TABLE + ".csv", encoding="ascii") as file:
                rows = [row for row in csv.DictReader(file) if row["set"] == table]
            write("some.g6", "".join(row["graph6"] + "\n" for row in rows))
            found = json.loads(self.expect(f"ar3d optimum some.g6 --angle {angle} --json -q").out)["graphs"]
            self.assertEqual([str(one["at_most"]) for one in found], [row["volume"] for row in rows])


class OptimumLong(Program):
    def test_has_proofs_that_the_proved_checker_accepts(self):
        """Of all connected graphs with at most five vertices at 109.47 degrees with three bends."""
        for n in (3, 4, 5):  # one edge needs no formula: its drawing has the size of a step
            self.expect(f"nauty-geng -q -c -D4 {n} | ar3d optimum - -q --proofs proofs --force")
            formulas = len(list(pathlib.Path("proofs").glob("*.cnf")))
            self.expect(f"{checker(self)} proofs/*.cnf && rm -r proofs", out=f"unsatisfiable {formulas}, refused 0, not read 0")


if __name__ == "__main__":
    main()
