"""Drawings for the tests of ar3d_proved: of every algorithm, broken in eleven ways, and laid over each other."""
import copy
import json
import random
import subprocess

DEGREE = {"diamond": 4, "grid": 3, "grid-paper": 3, "two-bend": 3, "compact": 4, "compact-120": 3, "two-bend-109": 4}
PIECES = {"lattice-109": ["diamond-lattice", "percolated-diamond-lattice"], "lattice-120": ["laves-graph", "percolated-laves-graph"],
          "two-bend-120": ["prism", "moebius-ladder"]}
FAMILIES = {3: ["binary-tree", "prism", "moebius-ladder", "random-cubic", "random-subcubic", "stars", "path"],
            4: ["torus", "squared-cycle", "square-grid", "random-4-regular", "random-max-degree", "union-k5"]}


def run(*words, text=None, codes=(0,)):
    """What a program prints."""
    done = subprocess.run(words, input=text, capture_output=True, text=True)
    if done.returncode not in codes:
        raise SystemExit(f"{' '.join(words)[:300]}: exit code {done.returncode}\n{done.stderr[-2000:]}")
    return done.stdout


def graph6(n, edges):
    """The line of a graph of at most 62 vertices."""
    pairs = {(min(e), max(e)) for e in edges}
    bits = [int((u, v) in pairs) for v in range(n) for u in range(v)]
    bits += [0] * (-len(bits) % 6)
    return chr(n + 63) + "".join(chr(63 + int("".join(map(str, bits[i:i + 6])), 2)) for i in range(0, len(bits), 6))


def text(drawing):
    return json.dumps(drawing, separators=(",", ":"))


def small_graphs(ar3d, degree, most, count):
    """Connected graphs of all kinds up to `most` vertices, at most `count` spread over them, and some of families."""
    lines = []
    for n in range(1, most + 1):
        lines += run("nauty-geng", "-cq", f"-D{degree}", str(n)).split()
    lines = lines[::max(1, len(lines) // count)]
    for family in FAMILIES[3] + (FAMILIES[4] if degree == 4 else []):
        made = run(ar3d, "generate", family, "-n", "20", "--seed", "1", "--format", "graph6", codes=(0, 2))
        lines += made.split()
    return lines


def pieces(ar3d, algorithm, count):
    """Graphs with up to 31 vertices of families that the algorithm draws, as many or a few more."""
    lines = [run(ar3d, "generate", family, "-n", str(2 + i % 30), "--seed", str(i), "--format", "graph6").strip()
             for i in range(count // 2 + 1) for family in PIECES[algorithm]]
    return sorted(set(lines))


def draw(ar3d, algorithm, graphs):
    """(drawing, its graph's line)"""
    lines = run(ar3d, "draw", "-", "--algorithm", algorithm, text="\n".join(graphs) + "\n").splitlines()
    if len(lines) != len(graphs):
        raise SystemExit("as many drawings as graphs expected")
    return [(json.loads(line), graph) for line, graph in zip(lines, graphs)]


def a_bend(d, chance):
    bends = [(e[2], i) for e in d["edges"] for i in range(len(e[2]))]
    return chance.choice(bends) if bends else None


def damage(d, kind, chance):
    """Breaks d in one way; false if d has nothing to break. Some ways leave it right."""
    edges, vertices, n = d["edges"], d["vertices"], d["n"]
    if kind in ("bend", "shorten", "cut", "zero"):
        if not (found := a_bend(d, chance)):
            return False
        bends, i = found
        axis = chance.randrange(3)
        if kind == "bend":
            bends[i][axis] += chance.choice([-1, 1])
        elif kind == "shorten":
            bends[i][axis] = int(bends[i][axis] / 10)
        elif kind == "cut":
            bends.pop(i)
        else:
            bends.insert(i, list(bends[i]))
    elif kind == "vertex":
        vertices[chance.randrange(n)][chance.randrange(3)] += chance.choice([-1, 1])
    elif kind in ("swap", "same"):
        if n < 2:
            return False
        i, j = chance.sample(range(n), 2)
        if kind == "swap":
            vertices[i], vertices[j] = vertices[j], vertices[i]
        else:
            vertices[i] = list(vertices[j])
    elif kind in ("drop", "double", "rewire"):
        if not edges or n < 3:
            return False
        e = chance.choice(edges)
        if kind == "drop":
            edges.remove(e)
        elif kind == "double":
            edges.append(copy.deepcopy(e))
        else:
            e[1] = chance.choice([w for w in range(n) if w not in e[:2]])
    elif kind == "gram":
        i = chance.randrange(3)
        d["gram"][i][i] += 1
    return True


KINDS = ["none", "bend", "vertex", "swap", "drop", "double", "shorten", "cut", "zero", "rewire", "gram", "same"]


def overlay(a, b, reach, chance):
    """Both drawings in one, b shifted so that a point of it is nearly at one of a: angles stay right."""
    every = lambda d: d["vertices"] + [p for e in d["edges"] for p in e[2]]
    p, r = chance.choice(every(a)), chance.choice(every(b))
    by = [p[i] - r[i] + chance.randint(-reach, reach) for i in range(3)]
    if chance.random() < 0.8:
        by[2] = 0 if chance.random() < 0.5 else 2 * (by[2] // 2)  # many keep the plane z = 0
    move = lambda p: [p[i] + by[i] for i in range(3)]
    n, d = a["n"], dict(a)
    d["n"] = n + b["n"]
    d["vertices"] = a["vertices"] + [move(p) for p in b["vertices"]]
    d["edges"] = a["edges"] + [[u + n, v + n, [move(p) for p in l]] for u, v, l in b["edges"]]
    return d, graph6(d["n"], [e[:2] for e in d["edges"]])


def broken(drawn, count, seed):
    """`count` times (kind, drawing, graph): as drawn, damaged, and every fourth an overlay, some of them far too large."""
    chance = random.Random(seed)
    out = []
    while len(out) < count:
        if len(out) % 4 == 3:
            a, b = chance.choice(drawn)[0], chance.choice(drawn)[0]
            out.append(("overlay", *overlay(a, b, chance.choice([1, 1, 3, 3, 8, 8, 10**12]), chance)))
            continue
        kind = KINDS[len(out) * 5 // 4 % len(KINDS)] if len(out) % 4 else chance.choice(KINDS)
        d, graph = chance.choice(drawn)
        d = copy.deepcopy(d)
        while not damage(d, kind, chance):  # a piece of a lattice has no bends
            kind = chance.choice(KINDS)
        out.append((kind, d, graph))
    return out
