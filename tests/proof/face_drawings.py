"""face_drawings.py PROVED SOURCES: the committed drawings along face diagonals are those of all connected cubic graphs with at most 12
vertices, they are proved good with two bends per edge, and none of them is with one."""
import os
import pathlib
import subprocess
import sys
import tempfile

proved, sources = sys.argv[1:3]
DRAWINGS = os.path.join(sources, "docs/open-questions/face_drawings.jsonl")
FACES = "1,1,0:1,-1,0:1,0,1:1,0,-1:0,1,1:0,1,-1"
with tempfile.TemporaryDirectory() as folder:
    graphs = pathlib.Path(folder, "cubic.g6")
    graphs.write_text("".join(subprocess.run(["nauty-geng", "-cq", "-d3", "-D3", str(n)], capture_output=True, text=True, check=True).stdout
                              for n in range(4, 13, 2)))
    for bends, good, code in ((2, 112, 0), (1, 0, 4)):
        said = subprocess.run([proved, DRAWINGS, "--graphs", graphs, "--bends", str(bends), "--cosine", "-1/2", "--exactly",
                               "--gram", "1,1,1", "--directions", FACES], capture_output=True, text=True)
        if said.returncode != code or f"good {good}, refused {112 - good}, not read 0" not in said.stdout:
            raise SystemExit(f"{bends} bends: exit code {said.returncode}: {said.stdout[-200:]}{said.stderr}")
