"""A folder of graphs that changes: one listing for a session, shards that go on and are merged, files that hold no graph."""
import csv
import itertools
import os
import pathlib
import random
import shutil
import threading

from program import Program, main, run, with_fault, write

NAMES = ("a", "b", "c", "d", "e")
RUN = "ar3d study run -q --graphs in --algorithm grid --threads 1 -o r.h5"


class _Collection(Program):
    def setUp(self):
        super().setUp()
        os.mkdir("in")
        os.mkdir("out")
        for size, name in enumerate(NAMES):
            self.graph(f"in/{name}.s6", 6 + 2 * size)

    def graph(self, file, n, seed=1):
        self.expect(f"ar3d generate random-cubic -n {n} --seed {seed} -q -o {file} --force")

    def rows(self, results="r.h5"):
        """Name, n and key of every row."""
        self.makes(f"ar3d report -q {results} -o rows.html --rows rows.csv --force")
        with open("rows.csv", newline="", encoding="utf-8") as file:
            return [(row["graph_name"], row["n"], row["key"]) for row in csv.DictReader(file)]

    def makes(self, command):
        """@return false if it is the part of a shard that no graph falls into."""
        said = run(command)
        self.assertTrue(said.code == 0 or said.code == 5 and "INCOMPLETE: 0 rows" in said.out, said)
        return said.code == 0

    def is_right(self, results="r.h5"):
        """Every row is that of its graph in the results."""
        self.expect(f"ar3d check {results}", 0, "PASS")
        self.expect(f"ar3d replay --all -q {results}", 0, "0 not")


class OneListing(_Collection):
    CHANGES = (("in/b.s6", "out/b.s6"), ("out/aa.s6", "in/aa.s6"), ("out/z.s6", "in/z.s6"), ("in/a.s6", "in/y.s6"), ("out/c.s6", "in/c.s6"))

    def folder(self):
        for name in ("in", "out"):
            shutil.rmtree(name)
            os.mkdir(name)
        for name in NAMES:
            shutil.copy(f"all/{name}.s6", "in")
        for name in ("aa", "z", "c2"):
            shutil.copy(f"all/{name}.s6", f"out/{name.replace('2', '')}.s6")

    def test_a_change_at_any_listing_gives_no_contradiction(self):
        os.rename("in", "all")
        for size, name in enumerate(("aa", "z", "c2")):
            self.graph(f"all/{name}.s6", 20 + 2 * size, seed=2)
        os.mkdir("in")
        listings = {}
        for verb, (came_from, goes_to) in itertools.product(("run", "resume", "shard"), self.CHANGES):
            for k in itertools.count(1):
                self.folder()
                command = RUN + " --force" + (" --shard 1/2" if verb == "shard" else "")
                if verb == "resume":
                    self.expect(command)
                    shutil.copy("all/aa.s6", "in/new.s6")
                    command = "ar3d study resume -q r.h5"
                said = run(with_fault(f"change:{k}", IN=os.getcwd() + "/in", FROM=came_from, TO=goes_to) + command)
                self.assertIn(said.code, (0, 2), said)
                if said.code == 0:
                    self.is_right()
                    self.expect("ar3d study resume -q r.h5")
                    self.is_right()
                if os.path.exists(came_from):  # there was no K-th listing
                    break
                listings[verb] = k
        self.assertEqual(listings, {"run": 1, "resume": 1, "shard": 1})

    def test_files_that_come_later_are_named(self):
        write("slow.py", "import os, sys, time\nwhile True:\n    n, m = map(int, sys.stdin.readline().split())\n"
                         "    for _ in range(m): sys.stdin.readline()\n    os.path.exists('out/z.s6') and os.rename('out/z.s6', 'in/z.s6')\n"
                         "    print('{\"vertices\":' + str([[i, i * i, i ** 3] for i in range(n)]) + '}', flush=True)\n")
        write("s.toml", 'study = "s"\n[[algorithm]]\nname = "mine"\ncommand = ["python3", "slow.py"]\n'
                        '[[sweep]]\ngraphs = { files = "in", name = "nets" }\nalgorithms = ["grid", "mine"]\n')
        self.graph("out/z.s6", 30)
        said = self.expect("ar3d study run s.toml -o r.h5", 0, err=["1 file came after the files were listed at 20", "in/z.s6; `ar3d study resume r.h5` draws them"])
        self.assertNotIn("z.s6", [name for name, *_ in self.rows()], said)
        self.expect("ar3d study resume r.h5", 0, err="nets: 1 file new, to be drawn: z.s6")
        self.is_right()
        self.expect("ar3d report r.h5 -o r.html --json - --force", 0, "files_listed")

    def test_without_its_graphs_a_collection_does_not_live_and_says_so(self):
        write("s.toml", 'study = "s"\ngraphs_bytes = 10\n[[sweep]]\ngraphs = { files = "in", name = "nets" }\nalgorithms = "grid"\n')
        self.expect("ar3d study run s.toml -o r.h5", 0, err="the graphs of nets are more than graphs_bytes = 10")
        self.graph("in/a.s6", 20)
        self.refused("ar3d study resume r.h5", "1 file is gone or changed, a.s6 is the first")


class ShardsOfACollection(_Collection):
    def shard(self, part, parts):
        self.makes(f"{RUN.replace('r.h5', f's{part}.h5')} --shard {part}/{parts} --force")

    def change(self, kind):
        {"add first": lambda: self.graph("in/0.s6", 30, 3), "add last": lambda: self.graph("in/z.s6", 30, 4),
         "alter": lambda: self.graph("in/c.s6", 30, 5), "remove": lambda: os.remove("in/c.s6"),
         "rename": lambda: os.rename("in/a.s6", "in/y.s6"), "copy": lambda: shutil.copy("in/b.s6", "in/0copy.s6")}[kind]()

    def test_they_are_resumed_and_merged_whatever_changes(self):
        shutil.copytree("in", "all")
        for parts, kind in itertools.product((2, 3), ("add first", "add last", "alter", "remove", "rename", "copy")):
            shutil.rmtree("in")
            shutil.copytree("all", "in")
            every = range(1, parts + 1)
            for part in every:
                self.shard(part, parts)
            before = {part: set(self.rows(f"s{part}.h5")) for part in every}
            self.assertEqual(sum(map(len, before.values())), len(NAMES))
            self.change(kind)
            for part in every:
                if self.makes(f"ar3d study resume -q s{part}.h5"):
                    self.is_right(f"s{part}.h5")
                self.assertLessEqual(before[part], set(self.rows(f"s{part}.h5")), kind)
            self.expect(f"ar3d study merge s[1-{parts}].h5 -o m.h5 --force")
            self.is_right("m.h5")

    def test_those_made_before_and_after_a_file_came_are_one_study(self):
        self.shard(1, 2)
        self.graph("in/0.s6", 30, 3)
        shutil.copy("in/b.s6", "in/0copy.s6")
        self.shard(2, 2)
        merge = "ar3d study merge {} -o {} --force"
        said = run(merge.format("s1.h5 s2.h5", "m.h5"))
        if said.code == 5:  # new files are of shard 1, too
            self.assertIn("of graph 0", said.err)
        self.expect("ar3d study resume -q s1.h5")
        self.expect(merge.format("s1.h5 s2.h5", "m.h5"))
        self.expect(merge.format("s2.h5 s1.h5", "n.h5"))
        self.assertEqual(pathlib.Path("m.h5").read_bytes(), pathlib.Path("n.h5").read_bytes())
        self.is_right("m.h5")
        self.assertEqual(sorted(name for name, *_ in self.rows("m.h5")), ["0.s6", "0copy.s6"] + [f"{name}.s6" for name in NAMES])
        self.expect("ar3d study resume -q m.h5")
        self.is_right("m.h5")

    def test_an_unfinished_one_goes_on_after_a_file_came(self):
        for k in range(4, 40, 4):
            said = run(with_fault(f"before:{k}") + RUN + " --shard 1/2 --force")
            if said.code == 0:
                break
            self.graph(f"in/new{k}.s6", 30, k)
            if os.path.exists("r.h5.journal"):
                self.makes("ar3d study resume -q r.h5")
                self.is_right()
                os.remove("r.h5")


class OtherFiles(_Collection):
    def test_the_program_knows_its_own_files_of_any_study(self):
        self.expect(RUN.replace("r.h5", "in/one.h5"))
        self.expect("ar3d draw in/a.s6 --algorithm grid -o in/d.jsonl")
        self.expect("ar3d replay -q --keep all in/one.h5")
        shutil.copy("in/a.s6", "in/a.s6~")
        for k in range(2, 12):  # another study's journal, results and unfinished files, as a kill leaves them
            run(with_fault(f"before:{k}") + RUN.replace("r.h5", f"in/k{k}.h5"))
        self.assertTrue(any(name.endswith(".journal") for name in os.listdir("in")))
        self.expect(RUN)
        self.assertEqual(len(self.rows()), 5)
        self.expect("ar3d study resume -q r.h5")
        self.assertEqual(len(self.rows()), 5)

    def test_files_without_a_graph_do_not_stop_a_study_that_has_begun(self):
        self.expect(RUN)
        write("in/README.md", "# Graphs\n\nof mine\n")
        write("in/Thumbs.db", "\xd0\xcf\x11\xe0 no graph")
        self.graph("in/z.s6", 30)
        self.expect("ar3d study resume r.h5", 0, err=["in: 1 file new, to be drawn: z.s6", "in: 2 files without a graph, left out: ", "README.md"])
        self.assertEqual(len(self.rows()), 6)
        self.is_right()
        write("in/broken.s6", ":An\n:!\n")
        self.refused("ar3d study resume -q r.h5", "broken.s6")
        self.refused(RUN + " --force", "broken.s6" if os.path.exists("in/broken.s6") and not os.path.exists("in/README.md") else "in/")


class ChangingFolderLong(_Collection):
    def test_50_runs_beside_somebody_who_changes_the_folder(self):
        os.mkdir("all")
        for number in range(400):
            self.graph(f"all/{number}.s6", 4 + 2 * (number % 30), number)
        ends = threading.Event()

        def change(dice=random.Random(1)):
            while not ends.is_set():
                there = os.listdir("in")
                kind = dice.randrange(3) if len(there) > 50 else 0
                name = dice.choice(there) if there else ""
                if kind == 0:
                    shutil.copy(f"all/{dice.randrange(400)}.s6", "out/new")
                    os.rename("out/new", f"in/{dice.randrange(10 ** 6)}.s6")
                elif kind == 1:
                    os.rename(f"in/{name}", f"in/{dice.randrange(10 ** 6)}.s6")
                else:
                    os.remove(f"in/{name}")

        other = threading.Thread(target=change)
        other.start()
        told = {}
        try:
            for number in range(50):
                verb = "ar3d study resume -q r.h5" if number % 3 == 2 and os.path.exists("r.h5") else RUN + " --force --skip"
                said = run(verb)
                self.assertIn(said.code, (0, 2), said)
                key = (verb.split()[2], said.code)
                told[key] = told.get(key, 0) + 1
                if said.code == 0:
                    self.is_right()
        finally:
            ends.set()
            other.join()
        print(told)
        self.assertGreater(told.get(("run", 0), 0), 20)


if __name__ == "__main__":
    main()
