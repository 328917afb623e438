#!/usr/bin/env python3
"""Writes a collection like the Rome graphs: one-graph GraphML files in a sub-folder a decade of n.

rome_like.py FOLDER [FILES]      11,534 files if left out; n from 10 to 110, degrees up to 13

Connected: a random tree and on average n / 3 edges more. The same bytes every time. Every hundredth file has names of nodes in other letters than ASCII.
"""

import random
import sys
from pathlib import Path


def edges_of(n, rng):
    """The edges of a connected graph on 0..n-1."""
    degree, ends, edges = [0] * n, [0], set()
    most = rng.choice([3, 3, 4, 4, 4, 5, 6, 7, 9, 13])  # largest degree
    pull = rng.choice([0, 0, 0, 0.05, 0.2, 0.4])  # how often an end is preferred that has many

    def join(u, v):
        edge = (min(u, v), max(u, v))
        if u == v or edge in edges or max(degree[u], degree[v]) == most:
            return
        edges.add(edge)
        for w in edge:
            degree[w] += 1
            ends.append(w)

    for v in range(1, n):
        while degree[v] == 0:
            join(rng.choice(ends) if rng.random() < pull else rng.randrange(max(0, v - 5), v), v)
    for _ in range(rng.randrange(2 * n // 3)):
        join(rng.choice(ends) if rng.random() < pull else rng.randrange(n), rng.randrange(n))
    return sorted(edges)


def main():
    folder, files = Path(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 11534
    rng = random.Random(1)
    for i in range(files):
        n = rng.randrange(10, 111)
        name = "Knoten-\u00e4" if i % 100 == 99 else "n"
        nodes = "".join(f'<node id="{name}{v}"/>\n' for v in range(n))
        edges = "".join(f'<edge source="{name}{u}" target="{name}{v}"/>\n' for u, v in edges_of(n, rng))
        group = folder / f"n{n // 10 * 10}"
        group.mkdir(parents=True, exist_ok=True)
        (group / f"grafo{i}.{n}.graphml").write_text(
            '<?xml version="1.0" encoding="UTF-8"?>\n<graphml>\n'
            f'<graph edgedefault="undirected">\n{nodes}{edges}</graph>\n</graphml>\n',
            encoding="utf-8")


main()
