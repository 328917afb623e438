"""parsers.py AR3D PROOF: parsers that misread are found out by the printers and `same`, which are trusted: with each of these changes to
what is not trusted ar3d_proved calls nothing GOOD that it was not shown."""
import pathlib
import shutil
import subprocess
import sys
import tempfile

import drawings

ar3d, source = sys.argv[1], pathlib.Path(sys.argv[2])
scratch = pathlib.Path(tempfile.mkdtemp())
WORDS = ["--bends", "3", "--cosine", "-1/3", "--exactly", "--gram", "1,1,1"]
NEAR = ["--bends", "2", "--cosine", "-499999999/1000000000", "--at-least", "--gram", "1,1,1"]
AXES = ["--directions", "1,0,0"]
draw = lambda graph, algorithm: drawings.run(ar3d, "draw", "-", "--algorithm", algorithm, text=graph + "\n")
PATH, EDGE = draw("Bg", "diamond"), draw("A_", "diamond")
REAL = draw("C~", "two-bend-paper").replace("two-bend-paper", "x")
PAIRS = "List.rev !pairs)"

# What is misread, the change, the drawing, the graph's line, the promise.
MISREAD = [
    ("nothing", "reader.ml", PAIRS, PAIRS, PATH, "Bg", WORDS),
    ("nothing", "reader.ml", PAIRS, PAIRS, REAL, "C~", NEAR),
    ("a pair is added", "reader.ml", PAIRS, "List.rev ((0, 1) :: !pairs))", PATH, "BG", WORDS),
    ("pairs are doubled", "reader.ml", PAIRS, "List.rev (!pairs @ !pairs))", PATH, "Bg", WORDS),
    ("a vertex is larger by 2^k", "reader.ml", "pairs := (!x, !v) :: !pairs\n", "pairs := (!x + (1 lsl k), !v) :: !pairs\n", EDGE, ":An", WORDS),
    ("pairs are turned", "reader.ml", "pairs := (!x, !v) :: !pairs\n", "pairs := (!v, !x) :: !pairs\n", EDGE, ":An", WORDS),
    ("a metric of one's own", "reader.ml", "(cube, Integer.one))", "({ cube with xx = Integer.of_int 2 }, Integer.one))", REAL, "C~",
     [*NEAR[:6], "2,1,1"]),
    ("a text that holds more", "reader.ml", "let algorithm = text () in", 'let algorithm = text () ^ "\\",\\"x\\":\\"" in', EDGE, "A_", WORDS),
    ("--box is forgotten", "promise.ml", 'value "--box"', "None", EDGE, "A_", [*WORDS, "--box", "0n,0n,0n"]),
    ("--directions are forgotten", "promise.ml", 'value "--directions"', "None", EDGE, "A_", WORDS + AXES),
    ("--plane is forgotten", "promise.ml", 'value "--plane" <> None', "false", EDGE, "A_", [*WORDS, "--plane", "z=0"]),
]
failed = []
for what, file, old, new, drawing, graph, promise in MISREAD:
    folder = scratch / "proof"
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(source, folder)
    text = (folder / file).read_text()
    if text.count(old) != 1:
        raise SystemExit(f"{what}: {file} has not one {old}")
    (folder / file).write_text(text.replace(old, new))
    drawings.run(str(folder / "build.sh"), str(scratch / "ar3d_proved"))
    (scratch / "g").write_text(graph + "\n")
    done = subprocess.run([scratch / "ar3d_proved", "--graphs", scratch / "g", *promise], input=drawing, capture_output=True, text=True)
    said = (done.stdout + done.stderr).splitlines()[0]
    print(f"{what}: exit code {done.returncode}: {said[:100]}")
    if done.returncode != (0 if what == "nothing" else 2) or (": GOOD" in said) != (what == "nothing"):
        failed.append(what)
shutil.rmtree(scratch)
if failed:
    raise SystemExit("FAILED " + ", ".join(failed))
