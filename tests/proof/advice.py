"""advice.py AR3D PROOF: where a drawing lies changes nothing of its advice: moved, it gets the same cuts at places moved as far."""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

import drawings

ar3d, source = sys.argv[1], pathlib.Path(sys.argv[2])
MOVES = [(2 ** 60, -(2 ** 60), 0), (10 ** 400, 7, -(10 ** 300)), (-1, 0, 1)]
# In the place of main.ml: the plans of two drawings are compared, the second of which is moved by T.
MAIN = """open Checker
let rec same t a b = match a, b with
  | Together, Together -> 0
  | Cut (h, c, low, high), Cut (g, e, low', high') ->
      let by x y = Integer.mul x y in
      let moved = Integer.add c (Integer.add (by h.px t.px) (Integer.add (by h.py t.py) (by h.pz t.pz))) in
      if h <> g || not (Integer.equal moved e) then failwith "another cut";
      1 + same t low low' + same t high high'
  | Part (h, a, b, c, d), Part (g, a', b', c', d') ->
      if h <> g then failwith "parted by another normal";
      1 + same t a a' + same t b b' + same t c c' + same t d d'
  | _ -> failwith "another tree"
let () =
  let read () = snd (Reader.drawing (input_line stdin)) in
  let d = read () in
  let plan = (Advice.plan d).cuts in
  try
    while true do
      let m = read () in
      let p = List.hd d.vertices and r = List.hd m.vertices in
      let t = { px = Integer.sub r.px p.px; py = Integer.sub r.py p.py; pz = Integer.sub r.pz p.pz } in
      Printf.printf "%d\\n" (same t plan (Advice.plan m).cuts)
    done
  with End_of_file -> ()
"""
with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name) / "proof"
    shutil.copytree(source, folder)
    (folder / "main.ml").write_text(MAIN)
    program = str(pathlib.Path(name) / "compare")
    drawings.run(str(folder / "build.sh"), program)
    for algorithm, family, n in [("diamond", "random-4-regular", "500"), ("grid", "random-cubic", "300"), ("two-bend-109", "random-4-regular", "400")]:
        graph = drawings.run(ar3d, "generate", family, "-n", n, "--seed", "1")
        line = drawings.run(ar3d, "draw", "-", "--algorithm", algorithm, text=graph).rstrip("\n")
        lines = [line]
        for move in MOVES:
            moved = json.loads(line)
            for p in moved["vertices"] + [p for e in moved["edges"] for p in e[2]]:
                p[:] = [x + by for x, by in zip(p, move)]
            lines.append(drawings.text(moved))
        said = drawings.run(program, text="".join(l + "\n" for l in lines)).split()
        print(algorithm, family, n, "cuts:", *said)
        if len(said) != len(MOVES) or len(set(said)) != 1 or int(said[0]) < 10:
            raise SystemExit("FAILED " + algorithm)
