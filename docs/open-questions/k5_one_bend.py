#!/usr/bin/python3
"""Seeks drawings of K5 in space with one bend per edge, tetrahedral vertices and wide bends, crossings allowed:

    k5_one_bend.py STARTS SHORTEST
    k5_one_bend.py --exact

makes the smallest angle at a bend as large as it can from STARTS random starts, with no segment shorter than SHORTEST times the mean,
and tells the widest. --exact prints a drawing on the points of two-bend-109 whose angles at vertices are exactly arccos(-1/3): its
vertices are turned by small integer quaternions near some that were found, and the lengths are solved for exactly.
"""
import fractions
import itertools
import json
import math
import sys

import numpy
import scipy.optimize

EDGES = list(itertools.combinations(range(5), 2))
FROM, TO = numpy.array(EDGES).T
TETRAHEDRON = numpy.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]])
ENDS = numpy.zeros((10, 5))
ENDS[range(10), FROM], ENDS[range(10), TO] = -1, 1
SMALL = [[3, -1, -2, 2], [1, -1, -2, -4], [1, 1, -2, -2], [3, -1, 3, 5], [-3, 0, 0, -1]]
MIRRORED = numpy.random.default_rng(3).choice([-1, 1], 5)
degrees = lambda cosine: math.degrees(math.acos(cosine))
sizes = lambda vectors: numpy.sqrt((vectors ** 2).sum(1))


def vectors(quaternions, mirrored):
    """The directions in which each edge leaves its two ends, times sqrt(3) and the square of the quaternion's size."""
    w, x, y, z = numpy.asarray(quaternions).T
    turns = numpy.array([[w*w + x*x - y*y - z*z, 2 * (x*y - w*z), 2 * (x*z + w*y)],
                         [2 * (x*y + w*z), w*w - x*x + y*y - z*z, 2 * (y*z - w*x)],
                         [2 * (x*z - w*y), 2 * (y*z + w*x), w*w - x*x - y*y + z*z]])
    found = numpy.einsum("ijv,kj->vki", turns, TETRAHEDRON) * mirrored[:, None, None]
    return found[FROM, TO - 1], found[TO, FROM]


def one_start(chance, shortest):
    """The largest cosine at a bend, quaternions and mirrors of the vertices; or None. The unknowns are 5 points, 5 quaternions,
    10 + 10 lengths with mean 1, and that cosine."""
    mirrored = chance.choice([-1, 1], 5)

    def closes(p):
        u, v = vectors(p[15:35].reshape(5, 4), mirrored) / numpy.sqrt(3)
        gaps = ENDS @ p[:15].reshape(5, 3) - p[35:45, None] * u + p[45:55, None] * v
        return numpy.concatenate([gaps.ravel(), p[:3], [p[35:55].sum() - 20], sizes(p[15:35].reshape(5, 4)) - 1])

    def bends(p):
        u, v = vectors(p[15:35].reshape(5, 4), mirrored)
        return p[55] - (u * v).sum(1) / 3

    def slopes(function):
        return lambda p: numpy.array([(function(p + d) - function(p - d)) / 2e-7 for d in 1e-7 * numpy.eye(56)]).T

    start = numpy.concatenate([chance.normal(size=35), chance.uniform(0.3, 2, 20), [1]])
    start[15:35] = (start[15:35].reshape(5, 4) / sizes(start[15:35].reshape(5, 4))[:, None]).ravel()
    end = scipy.optimize.minimize(
        lambda p: p[55], start, jac=lambda p: numpy.eye(56)[55], method="SLSQP", options={"maxiter": 400, "ftol": 1e-9},
        bounds=[(None, None)] * 35 + [(shortest, None)] * 20 + [(-1, 2)],
        constraints=[{"type": kind, "fun": f, "jac": slopes(f)} for kind, f in (("eq", closes), ("ineq", bends))]).x
    if abs(closes(end)).max() < 1e-9 and bends(end).min() > -1e-9 and end[35:55].min() > 0.999 * shortest:
        return end[55], end[15:35].reshape(5, 4), mirrored
    return None


def kernel(rows):
    """A basis of the rational solutions, by elimination."""
    rows, pivots, size = [[fractions.Fraction(int(x)) for x in row] for row in rows], [], len(rows[0])
    for column in range(size):
        top = len(pivots)
        rows[top:] = sorted(rows[top:], key=lambda row: row[column] == 0)
        if top < len(rows) and rows[top][column]:
            rows[top] = [x / rows[top][column] for x in rows[top]]
            rows = [row if row is rows[top] else [x - row[column] * y for x, y in zip(row, rows[top])] for row in rows]
            pivots.append(column)
    return [[-rows[pivots.index(c)][f] if c in pivots else fractions.Fraction(c == f) for c in range(size)]
            for f in range(size) if f not in pivots]


def exact(u, v):
    """The drawing in the directions u, v of integers with a long shortest segment; None if there is none."""
    rows = numpy.zeros((10, 3, 35), int)  # of 5 points and 20 lengths
    for (e, (a, b)), i in itertools.product(enumerate(EDGES), range(3)):
        rows[e, i, [3 * a + i, 3 * b + i, 15 + e, 25 + e]] = 1, -1, u[e, i], -v[e, i]
    rows, units = rows.reshape(30, 35)[:, 3:], numpy.concatenate([sizes(u), sizes(v)])  # the first point is 0
    longest = scipy.optimize.linprog(
        -numpy.eye(33)[32], bounds=[(None, None)] * 32 + [(0, None)], b_eq=[0] * 30 + [20], b_ub=[0] * 20,
        A_eq=numpy.vstack([numpy.hstack([rows, numpy.zeros((30, 1))]), [0] * 12 + [*units, 0]]),
        A_ub=numpy.hstack([numpy.zeros((20, 12)), -numpy.diag(units), numpy.ones((20, 1))]))
    if longest.status != 0 or longest.x[32] < 0.02:
        return None
    basis = kernel(rows)
    shares = numpy.linalg.lstsq(numpy.array(basis, float).T, longest.x[:32], rcond=None)[0]
    for most in range(1, 30):
        share = [fractions.Fraction(x / abs(shares).max()).limit_denominator(most) for x in shares]
        found = [sum(s * b[i] for s, b in zip(share, basis)) for i in range(32)]
        if min(found[12:]) > 0:
            break
    else:
        return None
    found = [int(x * math.lcm(*(x.denominator for x in found))) for x in found]
    points = numpy.array([0] * 3 + [x // math.gcd(*found) for x in found[:12]], object).reshape(5, 3)
    bends = [points[a] + found[12 + e] // math.gcd(*found) * u[e] for e, (a, _) in enumerate(EDGES)]
    turned = lambda p: [int(p[0] + p[1] - 2 * p[2]), int(p[0] - p[1]), int(2 * sum(p))]
    return {"n": 5, "algorithm": "search", "gram": [[2, 0, 0], [0, 6, 0], [0, 0, 1]], "gram_denominator": 1,
            "vertices": [turned(p) for p in points], "edges": [[a, b, [turned(c)]] for (a, b), c in zip(EDGES, bends)]}


if __name__ == "__main__":
    if sys.argv[1:] == ["--exact"]:
        u, v = (numpy.array([d // math.gcd(*map(int, d)) for d in ds]) for ds in vectors(SMALL, MIRRORED))
        print(f"{degrees(((u * v).sum(1) / sizes(u) / sizes(v)).max()):.3f} degrees", file=sys.stderr)
        print(json.dumps(exact(u, v), separators=(",", ":")))
    else:
        found = [one_start(numpy.random.default_rng(seed), float(sys.argv[2])) for seed in range(int(sys.argv[1]))]
        print(f"{degrees(min(f[0] for f in found if f)):.3f} degrees")
