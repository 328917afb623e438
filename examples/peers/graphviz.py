#!/usr/bin/python3
"""Draws graphs in three dimensions with Graphviz, for a study of ar3d.

Usage: graphviz.py neato|sfdp

Reads graphs as edge lists ("n m", then m lines "u v") and answers each with a line of JSON:
positions with the decimals that Graphviz writes, edges straight. Needs Debian's package graphviz.
The time that it tells is that of the one Graphviz process which draws the graph, start-up
included."""

import json
import re
import subprocess
import sys
import time

POSITION = re.compile(r"^\s*(\d+)\s*\[.*?pos=\"([^\"]*)\"", re.M | re.S)


def graphs(lines):
    for header in lines:
        n, m = map(int, header.split())
        yield n, [tuple(map(int, lines.readline().split())) for _ in range(m)]


def layout(engine, n, edges):
    dot = ["graph {", "dim=3; dimen=3; start=1; node [shape=point, width=0.01];"]
    dot += [f"{v} [label=\"\"];" for v in range(n)]
    dot += [f"{u} -- {v};" for u, v in edges]
    begin = time.perf_counter()
    made = subprocess.run([engine, "-Tdot"], input="\n".join(dot + ["}"]), capture_output=True,
                          text=True, check=False)
    seconds = time.perf_counter() - begin
    if made.returncode != 0:
        return {"error": f"{engine} ended with code {made.returncode}: {made.stderr[-200:]}"}
    places = {int(name): place.split(",") for name, place in POSITION.findall(made.stdout)}
    missing = [v for v in range(n) if v not in places]
    if missing:
        return {"error": f"{engine} gave vertex {missing[0]} no position"}
    return {"vertices": [[float(x) for x in places[v]] for v in range(n)], "seconds": seconds}


def main():
    if len(sys.argv) != 2 or sys.argv[1] not in ("neato", "sfdp"):
        sys.exit(__doc__)
    for n, edges in graphs(sys.stdin):
        json.dump(layout(sys.argv[1], n, edges), sys.stdout)
        print(flush=True)


if __name__ == "__main__":
    main()
