"""refusals.py AR3D PROVED: lines, options and pairings that say something wrong or nothing at all are not called GOOD."""
import json
import pathlib
import subprocess
import sys
import tempfile

import drawings

ar3d, proved = sys.argv[1:3]
failed = []
folder = pathlib.Path(tempfile.mkdtemp())
K4 = "C~"
LINE = drawings.run(ar3d, "draw", "-", "--algorithm", "diamond", "--set", "effort=2", text=K4 + "\n").rstrip("\n")
PROMISE = drawings.run(ar3d, "list", "--promise", "diamond").split()


def judge(lines, graphs, options=(), promise=None):
    """Exit code and output; lines are joined as they are given."""
    (folder / "d").write_bytes("".join(l + "\n" for l in lines).encode("latin-1"))
    (folder / "g").write_bytes("".join(g + "\n" for g in graphs).encode("latin-1"))
    done = subprocess.run([proved, str(folder / "d"), "--graphs", str(folder / "g"), *(PROMISE if promise is None else promise), *options],
                          capture_output=True, text=True)
    return done.returncode, done.stdout + done.stderr


def expect(what, code, lines, graphs, options=(), promise=None, good=0):
    found, said = judge(lines, graphs, options, promise)
    if found != code or said.count(": GOOD") != good:
        failed.append(f"{what}: exit code {found}, not {code}: {said[:200]}")


def changed(old, new, line=LINE):
    if line.count(old) < 1:
        raise SystemExit(f"the drawing has no {old}")
    return line.replace(old, new, 1)


expect("a right drawing", 0, [LINE], [K4], good=1)
first = "[" + str(json.loads(LINE)["vertices"][1][0]) + ","
# Numbers.
for number in ["-", "007", "-007", "-0", "+4", "4.0", "4e0", "0x4", "", " 4", "4_0"]:
    expect(f"the number {number!r}", 2, [changed('"vertices":[[0,', f'"vertices":[[{number},')], [K4])
# n.
for n in ['"n":7,', '"n":"x",', '', '"n":4,"n":4,', '"n":04,']:
    expect(f"n as {n!r}", 2, [changed('"n":4,', n)], [K4])
# Unknown keys, in other places, missing or twice; space between them.
for old, new in [('"algorithm"', '"error":"degree","algorithm"'), ('"gram"', '"real_type":"double","unit_exponent":0,"gram"'),
                 ("}", ',"x":1}'), (',"gram_denominator":1', ""), ('"edges":', '"edges":[],"edges":'), ('"vertices"', '"Vertices"'),
                 (",", ", "), ("}", "} "), ('"diamond"', '"dia\\u006dond"')]:
    expect(f"{old} as {new}", 2, [changed(old, new)], [K4])
# Gram matrices: not symmetric, another one, a denominator that is none.
expect("a matrix that is not symmetric", 2, [changed("[[1,0,0],[0,1,0]", "[[1,5,0],[0,1,0]")], [K4])
expect("another matrix", 4, [changed("[[1,0,0]", "[[2,0,0]")], [K4])
for denominator, code in [("0", 4), ("-1", 4), ("2", 4), ('"x"', 2), ("[]", 2), ("", 2), ("1.0", 2)]:
    expect(f"the denominator {denominator}", code, [changed('"gram_denominator":1', f'"gram_denominator":{denominator}')], [K4])
# Graphs: the same right drawing of one edge in both formats, then lines that are not the format's.
EDGE = drawings.run(ar3d, "draw", "-", "--algorithm", "diamond", text="A_\n").rstrip("\n")
for graph in ["A_", ":An"]:
    expect(f"the graph {graph}", 0, [EDGE], [graph], good=1)
for graph in [":An:Cc garbage", ":An ", ":Ann", "A`", "A~", "A", "A_\r", ":An\r", "A__", "A_ ", ">>graph6<<A_", "", ":A~~", "A\x1f"]:
    expect(f"the graph {graph!r}", 2, [EDGE], [graph])
for graph in ["A?", ":A", ":A_", ":Ab"]:
    expect(f"the other graph {graph!r}", 4, [EDGE], [graph])
# Drawings and graphs stay in step.
PATH = drawings.run(ar3d, "draw", "-", "--algorithm", "diamond", text="Bo\n").rstrip("\n")
expect("three pairs", 0, [LINE, EDGE, PATH], [K4, "A_", "Bo"], good=3)
expect("an error between", 2, [LINE, '{"n":3,"error":"degree"}', EDGE], [K4, "Bw", "A_"], good=2)
expect("a graph that is skipped", 2, [LINE, '{"n":3,"error":"degree"}', EDGE, PATH], [K4, "A_", "Bo"], good=1)
expect("a graph that is not read", 2, [LINE, EDGE, PATH], [K4, "?x", "Bo"], good=2)
expect("another graph", 4, [EDGE], [K4])
expect("no graph left", 2, [LINE, LINE], [K4], good=1)
expect("a graph too many", 2, [LINE], [K4, K4], good=1)
expect("nothing", 2, [], [])
# Options.
for options in [["--box"], ["--help"], ["--bx", "0n,0n,0n"], ["--box=0n,0n,0n"], ["--box", "9n,9n,9n"], ["--pairs", "--pairs"], ["--x"], ["more"]]:
    expect(f"options {options}", 2, [LINE], [K4], options)
WORDS = ["--bends", "3", "--cosine", "-1/3", "--exactly", "--gram", "1,1,1"]
expect("the fewest words", 0, [LINE], [K4], promise=WORDS, good=1)
for left_out in [slice(0, 2), slice(2, 4), slice(4, 5), slice(5, 7)]:
    words = [word for word in WORDS if word not in WORDS[left_out]]
    expect(f"without {WORDS[left_out]}", 2, [LINE], [K4], promise=words)
for at, word in [(1, "-1"), (1, "0x10"), (1, "1_0"), (1, "03"), (1, ""), (3, "-1/0"), (3, "-4/3"), (3, "1/3"), (3, "-01/3"), (3, "-.3"),
                 (4, "--at-most"), (6, "1,1"), (6, "1,1,-1"), (6, "1,1,1:0"), (6, "1,1,1:1"), (6, "1,1,1,1,0,0"), (6, "1,1,1,0,0,0")]:
    expect(f"the word {word!r}", 2, [LINE], [K4], promise=[*WORDS[:at], word, *WORDS[at + 1:]])
for word in ["0,0,0", "9n,9n", "9n,9n,-9n", "9n,9n,9/0n", "9n^4/2,9n,9n", "9n,9n,9n+0", "9n,9n,9n^", "n,n,n", "9 n,9n,9n"]:
    expect(f"the box {word!r}", 2, [LINE], [K4], ["--box", word], promise=WORDS)
expect("another plane", 2, [LINE], [K4], ["--plane", "x=0"], promise=WORDS)
# Each promise counts: the right drawing misses one that is just stricter.
extents = [max(p[i] for p in every) - min(p[i] for p in every)
           for every in [json.loads(LINE)["vertices"] + [p for e in json.loads(LINE)["edges"] for p in e[2]]] for i in range(3)]
exact = [f"0n+{e}" if e else "0n" for e in extents]
expect("a box of its extents", 0, [LINE], [K4], ["--box", ",".join(exact)], promise=WORDS, good=1)
for axis in range(3):
    box = [f"0n{extents[i] - (i == axis):+}" if extents[i] != (i == axis) else "0n" for i in range(3)]
    expect(f"a box too small along {'xyz'[axis]}", 4, [LINE], [K4], ["--box", ",".join(box)], promise=WORDS)
expect("fewer bends", 4, [LINE], [K4], promise=["--bends", "1", *WORDS[2:]])
expect("another angle", 4, [LINE], [K4], promise=[*WORDS[:3], "-1/2", *WORDS[4:]])
expect("too few directions", 4, [LINE], [K4], ["--directions", "1,1,1:1,1,-1:1,-1,1"], promise=WORDS)
expect("the direction nought", 4, [LINE], [K4], ["--directions", "0,0,0"], promise=WORDS)
# A star that chooses a metric in which its needles are at 109.47 degrees (the Euclidean angles are 0.57 degrees and more).
NEEDLE = ('{"n":5,"algorithm":"diamond","gram":[[3,-301,1806],[-301,30203,-181222],[1806,-181222,1087364]],"gram_denominator":1,'
          '"vertices":[[0,0,0],[1,0,0],[100,1,0],[100,7,1],[-201,-8,-1]],"edges":[[0,1,[]],[0,2,[]],[0,3,[]],[0,4,[]]]}')
STAR = drawings.graph6(5, [(0, 1), (0, 2), (0, 3), (0, 4)])
expect("a drawing that chooses its metric", 4, [NEEDLE], [STAR], promise=WORDS)
expect("the same where the metric is asked for", 0, [NEEDLE], [STAR],
       promise=[*WORDS[:6], "3,30203,1087364,-301,1806,-181222"], good=1)
# Coordinates of any length.
huge = json.loads(LINE)
shift = 10 ** 400
for p in huge["vertices"] + [p for e in huge["edges"] for p in e[2]]:
    p[0] += shift
expect("coordinates of 400 digits", 0, [drawings.text(huge)], [K4], good=1)
# What neither checker reads: a NUL byte, wherever it stands, and numbers of more than 1,000 characters.
NUL = [LINE + "\0", LINE + "\0 }}} {", "\0" + LINE, changed(",", "\0,"), changed("diamond", "dia\0mond"), changed('"n":4', '"n":4\0'),
       changed("]}", '],"names":["a","b","c\0","d"]}'), "\0"]
LONG = [changed('"vertices":[[0,', f'"vertices":[[{sign}{"1" * (1000 - len(sign))}1,') for sign in ("", "-")]
for line in NUL + LONG:
    expect(f"the line {line[:300]!r}", 2, [line], [K4])
    done = subprocess.run([ar3d, "verify", folder / "d", "--graphs", folder / "g"], capture_output=True, text=True)
    said = "a NUL byte" if line in NUL else "expected an integer of 64 bits"
    if done.returncode != 2 or said not in done.stderr or len(done.stderr) > 300:
        failed.append(f"verify of {line[:300]!r}: exit code {done.returncode}: {done.stderr[:300]}")
for number, why in [("1" * 999, "expected an integer of 64 bits"), ("-" + "1" * 999, "expected an integer of 64 bits"), ("1" * 309, "expected an integer of 64 bits")]:
    expect(f"a number of {len(number)} characters", 4, [changed('"vertices":[[0,', f'"vertices":[[{number},')], [K4])
    done = subprocess.run([ar3d, "verify", folder / "d", "--graphs", folder / "g"], capture_output=True, text=True)
    if done.returncode != 2 or why not in done.stderr or "exception" in done.stderr or len(done.stderr) > 300:
        failed.append(f"verify of a number of {len(number)} characters: exit code {done.returncode}: {done.stderr[:300]}")
# The verdict says the line and the whole promise, in the words that were given.
code, said = judge([LINE, LINE], [K4, K4])
if said.splitlines()[1] != f"2: GOOD n=4 edges=6 {' '.join(PROMISE)}":
    failed.append("the verdict does not say the line and the whole promise: " + said)
# Drawings in a real type: held to an angle that rounding misses by less than 2 in 10^9; the exact angle is missed.
CUBE = drawings.run(ar3d, "generate", "prism", "-n", "8", "--format", "graph6").strip()
REAL = drawings.run(ar3d, "draw", "-", "--algorithm", "two-bend-paper", text=CUBE + "\n").rstrip("\n")
NEAR = ["--bends", "2", "--cosine", "-499999999/1000000000", "--at-least", "--gram", "1,1,1"]
expect("a real drawing", 0, [REAL], [CUBE], promise=NEAR, good=1)
expect("a real drawing, exactly", 4, [REAL], [CUBE], promise=[*NEAR[:3], "-1/2", *NEAR[4:]])
expect("a real drawing with a box", 2, [REAL], [CUBE], ["--box", "9n,9n,9n"], promise=NEAR)
expect("a real drawing with numbers as numbers", 2, [REAL.replace('"0"', "0")], [CUBE], promise=NEAR)
for line in failed:
    print("FAILED", line)
raise SystemExit(1 if failed else 0)
