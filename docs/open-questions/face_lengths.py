#!/usr/bin/env python3
"""Has a graph of maximum degree 3 a drawing with segments along face diagonals (+-1, +-1, 0), (+-1, 0, +-1),
(0, +-1, +-1) only, angles of exactly 120 degrees, and at most two bends (or one bend) per edge?

    face_lengths.py GRAPH6 [--bends 1|2] > formula.smt2
    z3 formula.smt2          # or: cvc5 formula.smt2

prints a formula of linear real arithmetic (SMT-LIB 2) that is satisfiable if and only if there is one, crossings
allowed: positions in space, a direction for each segment, its length and its vector. Which directions may meet or
follow one another is found by inner products.

    face_lengths.py GRAPH6 --draw | ar3d verify - --algorithm grid

has z3 make drawings whose segments have random least lengths until nothing crosses, and prints that one.
"""
import argparse
import itertools
import json
import math
import random
import re
import subprocess
from fractions import Fraction

DIRECTIONS = tuple(d for d in itertools.product((-1, 0, 1), repeat=3) if sum(map(abs, d)) == 2)
ALL = range(len(DIRECTIONS))


def dot(i, j):
    return sum(a * b for a, b in zip(DIRECTIONS[i], DIRECTIONS[j]))


def opposite(i):
    return DIRECTIONS.index(tuple(-c for c in DIRECTIONS[i]))


def read_graph6(text):
    codes = [ord(c) - 63 for c in text.strip()]
    pairs = [(u, v) for v in range(codes[0]) for u in range(v)] if codes else []
    bits = [code >> (5 - i) & 1 for code in codes[1:] for i in range(6)]
    if not pairs or codes[0] > 62 or any(not 0 <= c < 64 for c in codes) or not 0 <= len(bits) - len(pairs) < 6:
        raise SystemExit(f"not graph6 with 2 to 62 vertices: {text!r}")
    edges = [pair for pair, bit in zip(pairs, bits) if bit]
    if any(sum(v in edge for edge in edges) > 3 for v in range(codes[0])):
        raise SystemExit(f"a vertex has a degree above 3: {text!r}")
    return codes[0], edges


def images(star):
    """Of the directions of the star under the symmetries of the cube."""
    for order in itertools.permutations(range(3)):
        for signs in itertools.product((1, -1), repeat=3):
            yield tuple(DIRECTIONS.index(tuple(s * DIRECTIONS[i][k] for s, k in zip(signs, order))) for i in star)


def at_vertices(n, edges):
    """One direction for each end of an edge, 120 degrees between any two at a vertex."""
    for v in range(n):
        incident = [i for i, edge in enumerate(edges) if v in edge]
        yield from (f"(declare-const {axis}{v} Real)" for axis in "xyz")
        for i in incident:
            yield from (f"(declare-const d{v}e{i}_{k} Bool)" for k in ALL)
            yield "(assert (or " + " ".join(f"d{v}e{i}_{k}" for k in ALL) + "))"
            yield from (f"(assert (not (and d{v}e{i}_{k} d{v}e{i}_{l})))" for k, l in itertools.combinations(ALL, 2))
        yield from (f"(assert (not (and d{v}e{i}_{k} d{v}e{j}_{l})))" for i, j in itertools.combinations(incident, 2)
                    for k, l in itertools.product(ALL, repeat=2) if dot(k, l) != -1)
    # Any star of a vertex can be turned into any other of as many edges, so one of them is the first star.
    first = max(range(n), key=lambda v: sum(v in edge for edge in edges))
    incident = [i for i, edge in enumerate(edges) if first in edge]
    stars = [s for s in itertools.permutations(ALL, len(incident)) if all(dot(a, b) == -1 for a, b in itertools.combinations(s, 2))]
    assert set(images(stars[0])) == set(stars)
    yield from (f"(assert d{first}e{i}_{k})" for i, k in zip(incident, stars[0]))


def along_edge(i, u, v, bends):
    """Segment j of edge i has direction k if s_i_j_k, a length l_i_j, and the vector xi_j, yi_j, zi_j; or it is none."""
    for j in range(bends + 1):
        yield f"(declare-const l{i}_{j} Real)(assert (>= l{i}_{j} 1))(declare-const none{i}_{j} Bool)"
        yield from (f"(declare-const s{i}_{j}_{k} Bool)" for k in ALL)
        yield from (f"(declare-const {axis}{i}_{j} Real)" for axis in "xyz")
    for j in range(bends + 1):
        yield f"(assert (or none{i}_{j} " + " ".join(f"s{i}_{j}_{k}" for k in ALL) + "))"
        yield from (f"(assert (not (and s{i}_{j}_{k} s{i}_{j}_{l})))" for k, l in itertools.combinations(ALL, 2))
        yield from (f"(assert (=> none{i}_{j} (not s{i}_{j}_{k})))" for k in ALL)
        yield f"(assert (=> none{i}_{j} (= {' '.join(f'{axis}{i}_{j}' for axis in 'xyz')} 0.0)))"
        for k in ALL:
            for axis, sign in zip("xyz", DIRECTIONS[k]):
                yield f"(assert (=> s{i}_{j}_{k} (= {axis}{i}_{j} {('0.0', f'l{i}_{j}', f'(- l{i}_{j})')[sign]})))"
            last = f"none{i}_{j + 1}" if j < bends else "true"
            yield f"(assert (=> (and s{i}_{j}_{k} {last}) d{v}e{i}_{opposite(k)}))"
            before = " ".join(f"s{i}_{j - 1}_{l}" for l in ALL if dot(k, l) == 1)
            yield f"(assert (=> s{i}_{j}_{k} (or {before})))" if j else f"(assert (= s{i}_{j}_{k} d{u}e{i}_{k}))"
        yield f"(assert (=> none{i}_{j} none{i}_{j + 1}))" if j < bends else ""
    for axis in "xyz":
        yield f"(assert (= {axis}{v} (+ {axis}{u} {' '.join(f'{axis}{i}_{j}' for j in range(bends + 1))})))"


def formula(n, edges, bends):
    text = ["(set-logic ALL)", *at_vertices(n, edges)]
    for i, (u, v) in enumerate(edges):
        text += along_edge(i, u, v, bends)
    return "\n".join(text)


def solved(text, names, seed):
    """z3's values of the names, or nothing."""
    text += f"\n(check-sat)\n(get-value ({' '.join(names)}))\n"
    said = subprocess.run(["z3", f"smt.random_seed={seed}", f"sat.random_seed={seed}", "-T:60", "-in"],
                          input=text, stdout=subprocess.PIPE, text=True).stdout
    if not said.startswith("sat"):
        return None
    values = re.findall(r"\((\w+) (\(- )?\(?(?:/ )?([\d.]+)(?: ([\d.]+))?\)", said)
    return {name: (-1 if minus else 1) * Fraction(above) / Fraction(below or 1) for name, minus, above, below in values}


def crossing(segments):
    """Whether two segments have a point in common that is no corner of both: exact, for integer points."""
    def minus(p, q):
        return [a - b for a, b in zip(p, q)]

    def cross(p, q):
        return [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]

    def inner(p, q):
        return sum(a * b for a, b in zip(p, q))

    for (a, b), (c, d) in itertools.combinations(segments, 2):
        if a in (c, d) or b in (c, d):
            continue  # one corner, so they make 120 degrees
        u, v, w = minus(b, a), minus(d, c), minus(c, a)
        normal = cross(u, v)
        if inner(normal, w):
            continue
        if any(normal):  # a + s u = c + t v
            s, t, size = inner(cross(w, v), normal), inner(cross(w, u), normal), inner(normal, normal)
            if 0 <= s <= size and 0 <= t <= size:
                return True
        elif not any(cross(u, w)):  # both on one line
            near, far = sorted((inner(w, u), inner(minus(d, a), u)))
            if far >= 0 and near <= inner(u, u):
                return True
    return False


def drawing(n, edges, bends, tries=60):
    text = formula(n, edges, bends)
    names = [f"{axis}{v}" for v in range(n) for axis in "xyz"]
    names += [f"{axis}{i}_{j}" for i in range(len(edges)) for j in range(bends + 1) for axis in "xyz"]
    for seed in range(tries):
        generator = random.Random(seed)
        most = (1, 6, 12, 25, 50, 100, 200)[min(seed, 6)]
        least = "".join(f"\n(assert (>= l{i}_{j} {generator.randint(1, most)}))" for i in range(len(edges)) for j in range(bends + 1))
        values = solved(text + least, names, seed)
        if not values:
            continue
        scale = math.lcm(*(value.denominator for value in values.values()))
        point = {name: int(value * scale) for name, value in values.items()}
        vertices = [tuple(point[f"{axis}{v}"] for axis in "xyz") for v in range(n)]
        ways = []
        for i, (u, _) in enumerate(edges):
            steps = [[point[f"{axis}{i}_{j}"] for axis in "xyz"] for j in range(bends + 1)]
            ways.append(list(itertools.accumulate((s for s in steps if any(s)), lambda p, s: tuple(a + b for a, b in zip(p, s)),
                                                  initial=vertices[u])))
        segments = [pair for way in ways for pair in zip(way, way[1:])]
        corners = vertices + [bend for way in ways for bend in way[1:-1]]
        if len(set(corners)) == len(corners) and not crossing(segments):
            return {"n": n, "algorithm": "search", "gram": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "gram_denominator": 1,
                    "vertices": vertices, "edges": [[u, v, way[1:-1]] for (u, v), way in zip(edges, ways)]}
    raise SystemExit(f"no drawing without crossings in {tries} tries")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("graph6")
    parser.add_argument("--bends", type=int, choices=(1, 2), default=2)
    parser.add_argument("--draw", action="store_true")
    options = parser.parse_args()
    graph = read_graph6(options.graph6)
    if options.draw:
        print(json.dumps(drawing(*graph, options.bends), separators=(",", ":")))
    else:
        print(formula(*graph, options.bends))
        print("(check-sat)")


if __name__ == "__main__":
    main()
