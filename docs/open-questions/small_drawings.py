#!/usr/bin/python3
"""Searches a small drawing on the cube grid with two bends per edge and all angles at least arccos(-1/3):

    small_drawings.py GRAPH6 SIDE NORM SEED STEPS THRESHOLD
    small_drawings.py FUzro 60 9 12 2000000 0.15 | ar3d verify - --algorithm two-bend-109

The stubs of a vertex are multiples of the vectors of a regular tetrahedron: that of the cube's diagonals, turned by an integer
quaternion of norm at most NORM. A state gives each vertex a point in a box, a tetrahedron and an order of its edges, and each stub a
length. Its cost is how much bends are too sharp and bends leave the box. STEPS random changes are tried, and those taken that raise
the cost by less than a threshold that falls from THRESHOLD to 0. The first state of cost 0 in which nothing meets is a drawing; from
there smaller and smaller boxes are tried in the same way with a quarter of the steps. Same arguments, same result; exit code 1 if
nothing was found. The drawing is written as a line of JSON on the points of two-bend-109, which are those of the cube grid seen along
(1, 1, 1), and its box on the cube grid goes to standard error. Numba compiles the inner loops."""
import collections
import itertools
import json
import math
import sys

import networkx
import numba
import numpy

DIAGONALS = numpy.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]])
Problem = collections.namedtuple("Problem", "edges slot incident degree tetrahedra near image box random")
State = collections.namedtuple("State", "at tetrahedron port length")  # port[v, i]: the vector of v's i-th edge
WHOLE = numba.uint64


@numba.njit
def below(random, n):
    """SplitMix64."""
    random[0] += WHOLE(0x9e3779b97f4a7c15)
    z = random[0]
    z = (z ^ (z >> WHOLE(30))) * WHOLE(0xbf58476d1ce4e5b9)
    z = (z ^ (z >> WHOLE(27))) * WHOLE(0x94d049bb133111eb)
    return numba.int64((z ^ (z >> WHOLE(31))) % WHOLE(n))


def tetrahedra(most):
    """The cube's diagonals turned by all quaternions of norm at most `most`, each as short as it can be."""
    found, r = set(), math.isqrt(most)
    for a, b, c, d in itertools.product(range(-r, r + 1), repeat=4):
        if 0 < a*a + b*b + c*c + d*d <= most:
            turned = DIAGONALS @ [[a*a + b*b - c*c - d*d, 2 * (b*c + a*d), 2 * (b*d - a*c)],
                                  [2 * (b*c - a*d), a*a - b*b + c*c - d*d, 2 * (c*d + a*b)],
                                  [2 * (b*d + a*c), 2 * (c*d - a*b), a*a - b*b - c*c + d*d]]
            found.add(tuple(sorted(tuple(x // math.gcd(*v) for x in v) for v in turned.tolist())))
    return numpy.array(sorted(found))


def near_turns(every):
    """The up to 12 nearest to each tetrahedron, and which of their vectors stands for which of its."""
    near, image = [], []
    orders = numpy.array(list(itertools.permutations(range(4))))
    squares = (every ** 2).sum(2)
    for i, one in enumerate(every):
        cosines = numpy.einsum("kx,tlx->tkl", one, every) / numpy.sqrt(squares[i][:, None] * squares[:, None, :].astype(float))
        sums = sum(cosines[:, k, orders[:, k]] for k in range(4))
        others = [int(j) for j in numpy.argsort(-sums.max(1), kind="stable") if j != i][:12]
        near.append(others)
        image.append(orders[sums[others].argmax(1)])
    return numpy.array(near, int), numpy.array(image, int).reshape(len(every), -1, 4)


@numba.njit
def stub_of(p, s, e, end):
    v = p.edges[e, end]
    return p.tetrahedra[s.tetrahedron[v], s.port[v, p.slot[e, end]]]


@numba.njit
def line(p, s, e):
    """Vertex, two bends, vertex."""
    found = numpy.empty((4, 3), numpy.int64)
    for end in range(2):
        stub = stub_of(p, s, e, end)
        for k in range(3):
            found[3 * end, k] = s.at[p.edges[e, end], k]
            found[1 + end, k] = found[3 * end, k] + s.length[e, end] * stub[k]
    return found


@numba.njit
def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@numba.njit
def cost(p, s, edges):
    total = 0.0
    for e in edges:
        bends = line(p, s, e)
        middle = bends[2] - bends[1]
        far = 0
        for k in range(3):
            far += max(0, -bends[1, k], bends[1, k] - p.box[k]) + max(0, -bends[2, k], bends[2, k] - p.box[k])
        one = 0.25 * far
        for end in range(2):
            stub = stub_of(p, s, e, end)
            along = dot(middle, stub) * (1 - 2 * end)
            lengths = dot(middle, middle) * dot(stub, stub)
            if lengths == 0:
                one += 2
            elif along <= 0 or 9 * along * along < lengths:  # no turn of at most 70.53 degrees
                one += 1.0 / 3 + 0.02 - along / math.sqrt(lengths)
        total += one
    return total


@numba.njit
def meet(a, b, c, d):
    """Have two segments a point in common?"""
    for k in range(3):
        if max(a[k], b[k]) < min(c[k], d[k]) or max(c[k], d[k]) < min(a[k], b[k]):
            return False
    u, v, w = b - a, d - c, c - a
    normal = numpy.cross(u, v)
    whole = dot(normal, normal)
    if whole == 0:
        return not numpy.cross(u, w).any()
    if dot(normal, w) != 0:
        return False
    return 0 <= dot(numpy.cross(w, v), normal) <= whole and 0 <= dot(numpy.cross(w, u), normal) <= whole


@numba.njit
def nothing_meets(p, s):
    for e in range(len(p.edges)):
        one = line(p, s, e)
        if meet(one[0], one[1], one[2], one[3]):
            return False
        for f in range(e):
            other = line(p, s, f)
            for i in range(3):
                for j in range(3):
                    # Two stubs at one vertex share that point and no other.
                    at_one = i != 1 and j != 1 and p.edges[e, i // 2] == p.edges[f, j // 2]
                    if not at_one and meet(one[i], one[i + 1], other[j], other[j + 1]):
                        return False
    return True


@numba.njit
def anywhere(p, point):
    for k in range(3):
        point[k] = below(p.random, p.box[k] + 1)


@numba.njit
def step(p, s, threshold):
    """By how much the cost changed."""
    kind = below(p.random, 9)
    e = v = below(p.random, len(p.edges) if kind < 2 else len(s.at))
    touched = numpy.arange(e, e + 1) if kind < 2 else p.incident[v, :p.degree[v]]
    if len(touched) == 0:
        return 0.0
    before, at, tetrahedron, port, length = cost(p, s, touched), s.at.copy(), s.tetrahedron.copy(), s.port.copy(), s.length.copy()
    if kind < 2:
        end = below(p.random, 2)
        s.length[e, end] = max(1, s.length[e, end] + 1 - 2 * below(p.random, 2))
    elif kind < 5 and below(p.random, 16) == 0:
        anywhere(p, s.at[v])
    elif kind < 5:
        for k in range(3):
            s.at[v, k] = min(max(s.at[v, k] + below(p.random, 3) - 1, 0), p.box[k])
    elif kind < 7:
        i, j = below(p.random, 4), below(p.random, 4)
        s.port[v, i], s.port[v, j] = s.port[v, j], s.port[v, i]
    elif below(p.random, 8) == 0 or p.near.shape[1] == 0:
        s.tetrahedron[v] = below(p.random, len(p.tetrahedra))
    else:
        chosen = below(p.random, p.near.shape[1])
        s.port[v] = p.image[s.tetrahedron[v], chosen][s.port[v]]
        s.tetrahedron[v] = p.near[s.tetrahedron[v], chosen]
    change = cost(p, s, touched) - before
    if change <= threshold:
        return change
    s.at[:], s.tetrahedron[:], s.port[:], s.length[:] = at, tetrahedron, port, length
    return 0.0


@numba.njit
def found(p, s, steps, threshold):
    """Was a drawing found? It is the state then."""
    total = cost(p, s, numpy.arange(len(p.edges)))
    for i in range(steps):
        total += step(p, s, threshold * (steps - i) / steps)
        if total < 1e-9 or i % 65536 == 0:
            total = cost(p, s, numpy.arange(len(p.edges)))  # without what rounding has added up
        if total < 1e-9 and nothing_meets(p, s):
            return True
    return False


def settle(p, s):
    """Moves the drawing to the origin; its extents."""
    points = numpy.concatenate([s.at[:1], *(line(p, s, e) for e in range(len(p.edges)))])
    s.at[:] -= points.min(0)
    return points.max(0) - points.min(0)


def shrink(p, s, steps, threshold):
    """Tries smaller and smaller boxes; the box of the smallest drawing, which is the state then."""
    box, part, failures = settle(p, s), 8, 0  # 1 / part of the longest side is cut off
    best = [numpy.copy(a) for a in s]
    while failures < 9:
        longest = max(box)
        p.box[:] = box
        if part <= longest:
            p.box[:] = numpy.minimum(box, longest - longest // part)
        else:
            p.box[failures % 3] -= 1
        s.at[:] = numpy.clip(s.at, 0, p.box)
        if found(p, s, steps, threshold):
            box, failures = settle(p, s), 0
            best = [numpy.copy(a) for a in s]
        else:
            for now, then in zip(s, best):
                now[:] = then
            part, failures = (2 * part, failures) if part <= longest else (part, failures + 1)
    return box


def main(graph6, side, norm, seed, steps, threshold):
    graph = networkx.from_graph6_bytes(graph6.encode())
    edges = numpy.array(sorted(graph.edges, key=lambda edge: edge[::-1]))
    n, degree = len(graph), numpy.array([graph.degree[v] for v in graph])
    if not (0 < max(degree) <= 4 and n <= 62 and 1 <= side <= 1000 and 1 <= norm <= 100):
        raise ValueError
    incident, slot = numpy.zeros((n, 4), int), numpy.zeros((len(edges), 2), int)
    for v in range(n):
        incident[v, :degree[v]], ends = numpy.nonzero(edges == v)
        slot[incident[v, :degree[v]], ends] = range(degree[v])
    every = tetrahedra(norm)
    p = Problem(edges, slot, incident, degree, every, *near_turns(every), numpy.full(3, side), numpy.array([seed], numpy.uint64))
    s = State(numpy.zeros((n, 3), int), numpy.zeros(n, int), numpy.tile(range(4), (n, 1)), numpy.ones((len(edges), 2), int))
    for v in range(n):
        anywhere(p, s.at[v])
        s.tetrahedron[v] = below(p.random, len(every))
    if not found(p, s, steps, threshold):
        sys.exit("nothing found")
    print("box", " x ".join(map(str, shrink(p, s, steps // 4, threshold / 2))), file=sys.stderr)
    seen = lambda points: [[x + y - 2 * z, x - y, 2 * (x + y + z)] for x, y, z in points.tolist()]
    print(json.dumps({"n": n, "algorithm": "search", "gram": [[2, 0, 0], [0, 6, 0], [0, 0, 1]], "gram_denominator": 1,
                      "vertices": seen(s.at), "edges": [[*edge, seen(line(p, s, e)[1:3])] for e, edge in enumerate(edges.tolist())]},
                     separators=(",", ":")))


if __name__ == "__main__":
    try:
        graph6, side, norm, seed, steps, threshold = sys.argv[1:]
        main(graph6, int(side), int(norm), int(seed), int(steps), float(threshold))
    except (ValueError, networkx.NetworkXError):
        print("usage: small_drawings.py GRAPH6 SIDE NORM SEED STEPS THRESHOLD: degrees of at most 4, sides from 1 to 1000, norms from "
              "1 to 100", file=sys.stderr)
        sys.exit(2)
