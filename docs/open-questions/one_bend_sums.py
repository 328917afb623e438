#!/usr/bin/python3
"""Does the sum of the theorem on K5 exclude one bend per edge? For each 4-regular graph on standard input (graph6, at most 62 vertices):

    nauty-geng -cq -d4 -D4 6 | one_bend_sums.py

prints the graph, what its cosines have to sum to at least (8n/3), and what they sum to at most: sqrt(8/3)/4 times the largest sum of
chords 2 sin(A/2), one for each pair of edges at a vertex, if only this is asked of them. The angles of a closed polygon of L edges sum
to at most 180 (L - 2) degrees, so its chords sum to at most 2 L sin(90 - 180/L), as the sine is concave there; the six chords of a
vertex sum to at most sqrt(96), as their squares do to at most 16."""
import itertools
import math
import sys

import scipy.optimize


def graph(line):
    n = ord(line[0]) - 63
    bits = "".join(f"{ord(c) - 63:06b}" for c in line[1:])
    pairs = [(u, v) for v in range(n) for u in range(v)]
    return n, {e for pair, bit in zip(pairs, bits) if bit == "1" for e in (pair, pair[::-1])}


def largest_sum(n, edges):
    corners = {}  # (vertex, its two neighbours) -> number
    for v in range(n):
        for pair in itertools.combinations([w for w in range(n) if (v, w) in edges], 2):
            corners[v, frozenset(pair)] = len(corners)
    if len(corners) != 6 * n:
        raise SystemExit("the graph is not 4-regular")
    sums = [([corners[c] for c in corners if c[0] == v], math.sqrt(96)) for v in range(n)]
    for size in (3, 4, 5):
        for cycle in itertools.permutations(range(n), size):
            if cycle[0] == min(cycle) and cycle[1] < cycle[-1] and all((cycle[i - 1], cycle[i]) in edges for i in range(size)):
                around = [corners[cycle[i], frozenset((cycle[i - 1], cycle[(i + 1) % size]))] for i in range(size)]
                sums.append((around, 2 * size * math.sin(math.pi / 2 - math.pi / size)))
    rows = [[float(c in members) for c in range(6 * n)] for members, _ in sums]
    return -scipy.optimize.linprog([-1] * (6 * n), A_ub=rows, b_ub=[most for _, most in sums], bounds=(0, 2)).fun


for text in sys.stdin.read().split():
    order, adjacent = graph(text)
    least, most = 8 * order / 3, math.sqrt(8 / 3) / 4 * largest_sum(order, adjacent)
    print(f"{text} n={order} at least {least:.2f}, at most {most:.2f}: {'excluded' if most < least - 1e-6 else 'not excluded'}")
