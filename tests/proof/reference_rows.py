"""reference_rows.py AR3D PROVED: ar3d_proved judges the drawing of every row of the study `smoke`, one drawing per algorithm and
family with about 1000 vertices, and a large one of `two-bend-109` in seconds. The graphs are generated from the rows; that a drawing is its row's is told by its text."""
import pathlib
import re
import resource
import sys
import tempfile

import h5py

import drawings

ar3d, proved = sys.argv[1:3]
folder = pathlib.Path(tempfile.mkdtemp())


def generate(family, n, seed, parameters=""):
    words = [word for item in parameters.split(";") if item for word in ("--set", item)]
    return drawings.run(ar3d, "generate", family, "-n", str(n), "--seed", str(seed), "--format", "sparse6", *words).strip()


def judge(algorithm, graphs):
    """The drawings of the graphs; all of them have to be good."""
    (folder / "g").write_text("".join(g + "\n" for g in graphs))
    (folder / "d").write_text(drawings.run(ar3d, "draw", str(folder / "g"), "--algorithm", algorithm))
    promise = drawings.run(ar3d, "list", "--promise", algorithm).split()
    said = drawings.run(proved, str(folder / "d"), "--graphs", str(folder / "g"), *promise).splitlines()
    if said[-1] != f"good {len(graphs)}, refused 0, not read 0":
        raise SystemExit(f"{algorithm}: {said[-1]}")
    return (folder / "d").read_text().splitlines()


drawings.run(ar3d, "study", "run", "smoke", "-q", "-o", str(folder / "smoke.h5"))
drawings.run(ar3d, "replay", str(folder / "smoke.h5"), "--keep", "all", "-o", str(folder / "kept"))
with h5py.File(folder / "smoke.h5") as file:
    rows = [tuple(row[name].decode() if isinstance(row[name], bytes) else int(row[name])
                  for name in ("algorithm", "family", "n", "seed", "parameters")) for row in file["runs"][:]]
judged = set()
for algorithm in sorted({row[0] for row in rows}):
    judged.update(judge(algorithm, [generate(*row[1:]) for row in dict.fromkeys(rows) if row[0] == algorithm]))
kept = set((folder / "kept").read_text().splitlines())
if not kept or kept - judged:
    raise SystemExit(f"{len(kept - judged)} of {len(kept)} drawings of the study were not judged")
print(f"smoke: {len(rows)} rows, {len(kept)} different drawings, all of them good")

families = {name: int(degree) for name, degree in
            re.findall(r"^([\w-]+): .*\(degree <= (\d)", drawings.run(ar3d, "list", "families"), re.M)}
count = 0
for algorithm, degree in drawings.DEGREE.items():
    graphs = [generate(family, 1000, 1) for family, its in families.items() if its <= degree]
    count += len(judge(algorithm, graphs))
print(f"{len(families)} families, {len(drawings.DEGREE)} algorithms: {count} drawings of about 1000 vertices, all of them good")

# Long segments in all directions: comparing all pairs would take an hour.
spent = -resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
judge("two-bend-109", [generate("random-4-regular", 20000, 1)])
spent += resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
print(f"two-bend-109, 20000 vertices: {spent:.1f} s of CPU time")
if spent > 60:
    raise SystemExit(1)
