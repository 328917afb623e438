"""Programs of others in `hunt` and `shrink`: one that fails is told as a failure, asked no more than needed, and leaves nothing behind."""
import json
import os
import time

from program import Program, main, read, run, write

BODY = """import os, sys, time
def answer(n, m=0, *_):
    print('{"vertices":' + str([[i, i * i, i ** 3] for i in range(n)]) + '}', flush=True)
def leave():
    if os.fork() == 0:
        os.setsid()
        os.fork()
        time.sleep(1000)
count = 0
while True:
    line = sys.stdin.readline()
    if not line: break
    n, m = map(int, line.split())
    for _ in range(m): sys.stdin.readline()
    count += 1
    if n == 2: answer(n)
    else:
        %s
"""
STUDY = """study = "s"
[[algorithm]]
name = "mine"
command = ["python3", "mine.py"]
time_limit_s = %d
%s
[[sweep]]
families = "random-cubic"
sizes = 10
algorithms = "mine"
"""
HUNT = "ar3d hunt -q --study s.toml --algorithm mine --family random-cubic -n 10 --evaluations 4 -o o "
FAILING = {  # what it does instead of an answer: kind, text
    "time.sleep(1000)": ("timeout", "no answer within 3 s"),
    "sys.exit(0)": ("crashed", "ended with code 0 before it answered"),
    "os.abort()": ("crashed", "was killed by signal 6"),
    "while True: os.write(1, b'x' * 1000000)": ("crashed", "answered more than"),
    "os.close(1); time.sleep(1000)": ("crashed", "closed its output before it answered"),
    "print('{}', flush=True)": ("crashed", "its answer is no drawing"),
}


class OwnProgramsInHunt(Program):
    def program(self, body, more="", limit=60):
        write("mine.py", BODY % body)
        write("s.toml", STUDY % (limit, more))

    def nothing_is_left(self):
        """No process has this folder as its working directory."""
        here = os.getcwd()
        left = []
        for number in filter(str.isdigit, os.listdir("/proc")):
            try:
                if int(number) != os.getpid() and os.readlink(f"/proc/{number}/cwd") == here:
                    left.append(read(f"/proc/{number}/cmdline"))
            except OSError:
                pass
        self.assertEqual(left, [])

    def test_a_crash_is_no_violation_though_a_child_holds_the_output(self):
        self.program("leave(); os.abort()")
        said = self.expect(HUNT + "--force", 5, ["NOT DRAWN: crashed: was killed by signal 6", "0 graphs drawn and certified"])
        self.assertNotIn("VIOLATED", said.out)
        self.nothing_is_left()

    def test_a_failure_is_no_violation(self):
        for body, (kind, text) in FAILING.items():
            self.program(body, limit=3 if kind == "timeout" else 60)
            said = self.expect(HUNT + "--force", 5, [f"NOT DRAWN: {kind}: {text}", "0 graphs drawn and certified", "wrote o.txt"])
            self.assertNotIn("VIOLATED", said.out)
            self.assertNotIn("box", said.out)
            self.assertFalse(os.path.exists("o.jsonl"))
            told = json.loads(run(HUNT + "--force --json").out)
            self.assertEqual((told["failure"], told["extents"], told["ratio"]), (kind, None, None))
            option = "timeout" if kind == "timeout" else "crash"
            self.expect("ar3d shrink -q o.s6 --study s.toml --algorithm mine -o p", 5, [f"NOT DRAWN: {kind}", f"--failure {option} shrinks it"])
            self.assertFalse(os.path.exists("p.s6"))
            self.expect("ar3d study run -q s.toml --force", 5)
            self.nothing_is_left()

    def test_shrink_reduces_a_failure_that_is_asked_for(self):
        self.program("os.abort() if m > 4 else answer(n)")
        self.expect(HUNT, 5, "crashed")
        shrink = "ar3d shrink -q o.s6 --study s.toml --algorithm mine --force -o p --failure "
        self.expect(shrink + "crash", 5, ["5 of 15 edges are left", "none can go", "NOT DRAWN: crashed"])
        self.expect(shrink + "timeout", 5, ["NOT DRAWN: crashed", "--failure crash shrinks it"])
        self.refused(shrink + "crash --ratio 1", "--ratio")
        self.program("answer(n)")
        self.refused(shrink + "crash", "it is drawn, so there is no crash to keep")
        for line in read("o.txt").splitlines()[1:]:  # the lines that show it again
            self.assertIn("--failure crash", line)

    def test_the_last_drawing_is_not_asked_for_twice(self):
        """The process answers only so often; what was measured stays."""
        guarantee = "guarantee = { max_degree = 4, max_bends = 0, cosine = [1, 1] }"
        self.program("answer(n) if count <= 5 else time.sleep(1000)", guarantee)
        self.expect(HUNT, 0, ["4 graphs drawn and certified", "wrote o.txt"])
        for name in ("o.s6", "o.jsonl", "o.svg", "o.txt"):
            self.assertTrue(os.path.exists(name), name)

    def test_a_failure_that_does_not_come_again_stays_one(self):
        """Slow at first, right later: what shrink keeps is what it saw."""
        self.program("answer(n) if os.path.exists('slow') else [open('slow', 'w'), time.sleep(1000)]", limit=12)
        self.expect(HUNT, 5, "timeout")
        os.remove("slow")
        self.expect("ar3d shrink -q o.s6 --study s.toml --algorithm mine --failure timeout -o p --evaluations 20", 5,
                    ["10 of 10 vertices", "NOT DRAWN: timeout"])

    def test_a_graph_that_is_refused_is_not_kept(self):
        self.program("os.abort() if m > 4 else print('{\"error\": \"too small\"}', flush=True)")
        self.expect(HUNT, 5)
        self.expect("ar3d shrink -q o.s6 --study s.toml --algorithm mine --failure crash -o p", 5, "5 of 15 edges are left")

    def test_no_child_is_left(self):
        wrong = "guarantee = { max_degree = 4, max_bends = 0, cosine = [-1, 1] }\n"  # every angle of 180 degrees
        for more in (wrong, wrong + "one_graph_per_process = true"):
            for body, ends, keeps in (("answer(n)", 4, ""), ("time.sleep(1000)", 5, "--failure timeout"), ("os.abort()", 5, "--failure crash")):
                if "sleep" in body and more != wrong:
                    continue
                self.program("leave(); " + body, more, limit=3 if "sleep" in body else 60)
                self.expect(HUNT + "--force", ends)
                self.nothing_is_left()
                self.expect(f"ar3d shrink -q o.s6 --study s.toml --algorithm mine {keeps} -o p --force --evaluations 1", ends)
                self.nothing_is_left()
                self.expect("ar3d study run -q s.toml --force", ends)
                self.nothing_is_left()


if __name__ == "__main__":
    main()
