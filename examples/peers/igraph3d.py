#!/usr/bin/python3
"""Draws graphs in three dimensions with igraph, for a study of ar3d.

Usage: igraph3d.py fr|kk|drl ITERATIONS

fr is Fruchterman and Reingold's layout, kk Kamada and Kawai's, drl the distributed recursive one
(which has no iterations to choose: 0). Reads graphs as edge lists ("n m", then m lines "u v") and
answers each with a line of JSON: positions rounded to nine decimals, edges straight, and the
seconds of the layout alone. Needs Debian's package python3-igraph."""

import json
import random
import sys
import time

import igraph


def graphs(lines):
    for header in lines:
        n, m = map(int, header.split())
        yield n, [tuple(map(int, lines.readline().split())) for _ in range(m)]


def layout(kind, iterations, n, edges):
    graph = igraph.Graph(n=n, edges=edges)
    random.seed(1)
    begin = time.perf_counter()
    if kind == "fr":
        made = graph.layout_fruchterman_reingold(dim=3, niter=iterations)
    elif kind == "kk":
        made = graph.layout_kamada_kawai(dim=3, maxiter=iterations)
    else:
        made = graph.layout_drl(dim=3)
    seconds = time.perf_counter() - begin
    return {"vertices": [[round(x, 9) for x in made[v]] for v in range(n)], "seconds": seconds}


def main():
    if len(sys.argv) != 3 or sys.argv[1] not in ("fr", "kk", "drl"):
        sys.exit(__doc__)
    igraph.set_random_number_generator(random)
    for n, edges in graphs(sys.stdin):
        try:
            answer = layout(sys.argv[1], int(sys.argv[2]), n, edges)
        except igraph.InternalError as error:
            answer = {"error": str(error)}
        json.dump(answer, sys.stdout)
        print(flush=True)


if __name__ == "__main__":
    main()
