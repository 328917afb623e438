#!/usr/bin/env python3
"""Prints the drawings of K4 on the cube grid with one bend per edge and all angles arccos(-1/3) that have
the smallest box, as lines of JSON:

    k4_one_bend.py | ar3d verify - --algorithm two-bend-109

Every vertex sends its edges along three of a, b, c, d = (1, 1, 1), (1, -1, -1), (-1, 1, -1),
(-1, -1, 1); an edge runs s times along one of them and t times against another one.
"""
import itertools
import json

VECTORS = ((1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1))


def words(size):
    """All differences of the ends of an edge with its two vectors and lengths."""
    found = {}
    for x, y in itertools.permutations(range(4), 2):
        for s, t in itertools.product(range(1, size + 1), repeat=2):
            d = tuple(s * p - t * q for p, q in zip(VECTORS[x], VECTORS[y]))
            if max(map(abs, d)) <= size:
                found[d] = (x, y, s)
    return found


def drawing(points, edges):
    """On the points of two-bend-109, which are those of the cube grid seen along (1, 1, 1)."""
    turned = lambda p: [p[0] + p[1] - 2 * p[2], p[0] - p[1], 2 * sum(p)]
    return {"n": 4, "algorithm": "two-bend-109", "gram": [[2, 0, 0], [0, 6, 0], [0, 0, 1]],
            "gram_denominator": 1, "vertices": [turned(p) for p in points],
            "edges": [[u, v, [turned(b)]] for u, v, b in edges]}


def search(size):
    found = words(size)
    minus = lambda p, q: tuple(a - b for a, b in zip(p, q))
    steps = sorted(found)
    for p, q in itertools.combinations(steps, 2):
        if minus(q, p) not in found:
            continue
        for r in steps:
            if r <= q or minus(r, p) not in found or minus(r, q) not in found:
                continue
            points = [(0, 0, 0), p, q, r]
            used = set()
            edges = []
            for u, v in itertools.combinations(range(4), 2):
                x, y, s = found[minus(points[v], points[u])]
                used |= {(u, x), (v, y)}
                edges.append((u, v, tuple(c + s * d for c, d in zip(points[u], VECTORS[x]))))
            if len(used) == 12:  # three different vectors at each vertex
                yield points, edges


def box(points, edges):
    everything = points + [b for *_, b in edges]
    return sorted(max(p[i] for p in everything) - min(p[i] for p in everything) for i in range(3))


if __name__ == "__main__":
    drawings = sorted(search(6), key=lambda found: (box(*found), found))
    for points, edges in drawings:
        if box(points, edges) == box(*drawings[0]):
            print(json.dumps(drawing(points, edges), separators=(",", ":")))
