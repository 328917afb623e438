"""`ar3d compare --turns`: two versions of anything, drawn in turns."""
import json
import os
import pathlib
import re

from program import Program, main, read, run, write

DRAWER = """import os, sys, time
percent, bend, what = int(sys.argv[1]), int(sys.argv[2]), sys.argv[3]
for header in sys.stdin:
    n, m = map(int, header.split())
    edges = [sys.stdin.readline().split() for _ in range(m)]
    total = 0
    for step in range(100 * n * (100 + percent) // 100):
        total += step
    if what == "hang" and n == 9: time.sleep(1000)
    if what == "crash" and n == 9: sys.exit("no more")
    if what in ("fork", "flee") and n == 9 and os.fork() == 0: os.setsid(); time.sleep(1000)
    if what == "flee" and n == 9: os._exit(0)
    bent = f',"edges":[[{edges[0][0]},{edges[0][1]},[[9999,0,1]]],' + ','.join(f'[{u},{v},[]]' for u, v in edges[1:]) + ']' if bend and m else ''
    print('{"vertices":[' + ','.join(f'[{i},{i * i},{i ** 3}]' for i in range(n)) + ']' + bent + '}', flush=True)
"""
STUDY = """study = "own"
[[algorithm]]
name = "mine"
command = ["/usr/bin/python3", "mine.py", "{percent}", "{bend}", "WHAT"]
time_limit_s = 1
percent = [0, 1]
bend = [0, 1]
[[sweep]]
families = ["cycle", "prism"]
sizes = [8, 9]
algorithms = [{ algorithm = "mine" }, "grid"]
exclude = [{ algorithm = "grid", family = "prism" }]
timed_repetitions = 12
"""


def git(*lines):
    run("git init -q .; git config user.name t; git config user.email t@t")
    for line in lines:
        assert run(line).code == 0, line


class Turns(Program):
    def setUp(self):
        super().setUp()
        write("mine.py", DRAWER)
        self.study()

    def study(self, what="draw", name="own.toml", text=STUDY):
        write(name, text.replace("WHAT", what))

    def compare(self, words, code, *parts, err=()):
        """@return the verdict as JSON."""
        self.expect(f"ar3d compare {words} --force -o turns.h5 --json v.json --markdown v.md", code, out=parts, err=err)
        return json.loads(read("v.json"))

    def one(self, command="/usr/bin/python3 mine.py {} draw"):
        """A study of one setting, and what makes the command of a version."""
        self.study(text=re.sub(r"(percent|bend) = .*\n", "", STUDY).replace('"{percent}", "{bend}"', '"0", "0"'))
        return lambda percent, bend=0: f"'{command.format(f'{percent} {bend}')}'"

    def test_commands_are_told_apart_by_counts_and_drawings(self):
        version = self.one()
        slower = self.compare(f"--turns {version(0)} {version(60)} --study own.toml --count", 3, "mine", "instructions +")
        self.assertEqual(slower["settings"][0]["verdict"], "REGRESSED")
        self.assertGreater(slower["settings"][0]["instructions_ratio"], 1.02)
        same = self.compare(f"--turns {version(0)} {version(0)} --study own.toml --count", 0, "PASS         mine")
        self.assertLess(abs(same["settings"][0]["instructions_ratio"] - 1), 0.01)
        self.assertEqual([cell["verdict"] for cell in same["cells"]], 3 * ["PASS"])
        self.compare(f"--turns {version(0)} {version(0, 1)} --study own.toml", 3, "3 of 3 cells: ")
        self.assertIn("grid (effort=1) is the same on both sides: not compared", run("cat v.md").out)

    def test_settings_specifications_and_commits_take_turns_alike(self):
        self.compare("--turns 'mine percent=0 bend=0' 'mine bend=1 percent=0' --study own.toml", 3, "3 of 3 cells: ")
        text = read("own.toml")
        for name, bend in (("old", 0), ("new", 1)):
            write(f"{name}.toml", text.replace("percent = [0, 1]\nbend = [0, 1]", f"percent = 0\nbend = {bend}"))
        self.compare("--turns old.toml new.toml", 3, "mine (bend=0;percent=0) -> mine (bend=1;percent=0)")
        self.one()
        git("mkdir inner; mv mine.py own.toml inner; git add -A; git commit -qm good; git tag good")
        write("inner/mine.py", DRAWER.replace("if bend and m", "if m"))
        os.chdir("inner")
        self.compare("--turns good . --build true --study own.toml", 3, "3 of 3 cells: ")
        self.expect("git commit -qam bad")
        self.compare("--turns good HEAD --build 'ls ../inner' --study own.toml", 3, "3 of 3 cells: ")
        self.refused("ar3d compare --turns good no-such --build true --study own.toml -o x.h5 -q", "no commit 'no-such'")
        self.refused("ar3d compare --turns good HEAD --build 'echo broken; false' --study own.toml -o x.h5 -q", "`echo broken; false`", "broken")

    def test_rows_of_a_graph_alternate_in_random_order_and_are_kept(self):
        version = self.one()
        run(f"ar3d compare --turns {version(0)} {version(0)} --study own.toml --rounds 20 -o kept.h5")
        said = run("ar3d compare kept.h5 --settings mine.A mine.B --json -")
        verdict = json.loads(said.out)
        self.assertEqual(verdict["settings"][0]["rounds"], 20)
        self.assertEqual({cell["time"]["pairs"] for cell in verdict["cells"]}, {20})
        self.refused("ar3d compare kept.h5 --settings mine mine.B", "'mine' is none of the settings mine.A, mine.B")
        self.expect("ar3d check kept.h5", 0, out="MEASURED")

    def test_programs_that_hang_crash_or_fork_are_named_and_gone(self):
        good = self.one()(0)
        for what, word in (("hang", "no answer within 1 s"), ("crash", "no more"), ("flee", "ended with code 0 before it answered")):
            bad = f"'/usr/bin/python3 mine.py 0 0 {what}'"
            self.compare(f"--turns {good} {bad} --study own.toml", 3, "status measured became", word)
            self.compare(f"--turns {bad} {bad} --study own.toml", 5, "came out on neither side", word)
            self.assertEqual(run(f"pgrep -f 'mine.py 0 0 {what}$'").out, "", what)
        # One that forks and answers all the same has drawn what it should.
        verdict = self.compare(f"--turns {good} '/usr/bin/python3 mine.py 0 0 fork' --study own.toml --drawings-only", 0, "DRAWINGS PASS")
        self.assertEqual([cell["verdict"] for cell in verdict["cells"]], 3 * ["PASS"])
        self.assertEqual(run("pgrep -f 'mine.py 0 0 fork$'").out, "")

    def test_an_interrupt_leaves_nothing(self):
        version = self.one()
        os.mkdir("scratch")  # other tests write to /tmp, too
        self.expect(f"env TMPDIR=scratch timeout --preserve-status -s INT 2 ar3d compare --turns {version(0)} {version(0)} --study own.toml --rounds 1000", 130,
                    err="interrupted while drawing; nothing was left behind")
        self.assertEqual(sorted(os.listdir()), ["mine.py", "own.toml", "scratch"])
        self.assertEqual(os.listdir("scratch"), [])

    def test_what_could_mean_two_things_or_nothing_is_refused(self):
        self.refused("ar3d compare --turns mine other --study own.toml", "'mine' is more than one of the settings")
        self.refused("ar3d compare --turns 'no such' grid --study own.toml", "'no such' is none of the settings")
        self.refused("ar3d compare --turns grid 'grid (effort=1)' --study own.toml", "are one setting")
        write("grid", "")
        self.refused("ar3d compare --turns grid mine --study own.toml", "'grid' is a setting and a file")
        self.refused("ar3d compare --turns ./a ./b --study smoke", "'./a' is no setting of study 'smoke', which has 0 programs")
        self.one()
        self.refused("""ar3d compare --turns 'python3 "a b"' mine.py --study own.toml""", "without quotes")
        write("other.toml", read("own.toml").replace('study = "own"', 'study = "own"\nseed = 7'))
        self.refused("ar3d compare --turns own.toml other.toml", "differ in 'seed'")
        self.refused("ar3d compare --turns HEAD . --build true --study own.toml -q", "no git repository")
        self.refused("ar3d compare own.h5 --turns 'true' 'true'", "takes no results files")

    def hint(self, pattern, words=""):
        """Follows the hint of two results whose times do not tell, with what `words` replaces in it."""
        said = run("ar3d compare a.h5 b.h5 --threshold 0.1 --time-always")
        hint = re.search(pattern, said.out)
        self.assertTrue(hint, said)
        self.expect((words or hint[1]) + " --force -o hinted.h5 --rounds 2", 6, out="2 rounds of times; 11 are needed")

    def test_hints_can_be_followed_where_they_are_printed(self):
        self.one()
        for name in ("a", "b"):
            self.expect(f"ar3d study run own.toml -q --force-timing -o {name}.h5")
        self.hint(r"keep the program of BASE under another name, .* A and B: `ar3d compare --turns A B --study b.h5`",
                  "cp mine.py kept.py; ar3d compare --turns '/usr/bin/python3 kept.py 0 0 draw' '/usr/bin/python3 mine.py 0 0 draw' --study b.h5")
        git("git add -A; git commit -qm good")
        self.expect("ar3d study run own.toml -q --force-timing --force -o a.h5")
        self.hint(r"To know more: `(ar3d compare --turns [0-9a-f]{12} \. --build true --study b.h5)`")
        write("own.toml", read("own.toml").replace("mine.py", "kept.py"))
        self.expect("ar3d study run own.toml -q --force-timing --force -o b.h5")
        self.hint(r"To know more: `(ar3d compare --turns '/usr/bin/python3 mine.py 0 0 draw' '/usr/bin/python3 kept.py 0 0 draw' --study b.h5)`")

    def test_words_say_what_was_tested_and_no_more(self):
        self.one()
        for name in ("a", "b"):
            self.expect(f"ar3d study run own.toml -q --force-timing -o {name}.h5")
        said = run("ar3d compare a.h5 b.h5 --time-always --json v.json")
        verdict = json.loads(read("v.json"))
        self.assertNotIn("version", said.out)
        self.assertTrue(all(cell["time"]["p_value"] is None for cell in verdict["cells"]), verdict)
        self.assertRegex(said.out, r"time [+-][0-9.]+ % ± [0-9.]+ %")
        self.study(name="untimed.toml", text=read("own.toml").replace("timed_repetitions = 12\n", ""))
        self.expect("ar3d study run untimed.toml -q -o u.h5; ar3d study run untimed.toml -q -o w.h5")
        self.expect("ar3d compare u.h5 w.h5 --time-always", 6, out="judged: drawings; there are too few times to judge")


if __name__ == "__main__":
    main()
