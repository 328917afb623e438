#!/usr/bin/python3
"""The table of a study of peers: medians over the graphs of each family, size and algorithm.

Usage: table.py RESULTS.h5 [LARGEST_N]

Worst angle in degrees, at vertices and bends; edges all of whose angles are optimal, in percent;
crossings; volume of the box in units of the smallest vertex distance, as a power of ten; bends per
edge; time in ms: of the drawing alone for our algorithms, from request to answer for programs."""

import sys

import numpy
import pandas


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    runs = pandas.read_hdf(sys.argv[1], "runs")
    for name in runs.columns[runs.dtypes == object]:
        runs[name] = runs[name].map(lambda x: x.decode() if isinstance(x, bytes) else x)
    if len(sys.argv) == 3:
        runs = runs[runs.n <= int(sys.argv[2])]
    drawn = runs[runs.status.isin(["ok", "measured", "violated"])].copy()
    drawn["worst_angle"] = numpy.fmin(drawn.smallest_vertex_angle, drawn.smallest_bend_angle)
    drawn["optimal"] = 100 * drawn.optimal_edges / drawn.m
    drawn["volume"] = drawn.log2_relative_volume * numpy.log10(2)
    drawn["bends"] = sum(b * drawn[f"bends_{b}"] for b in range(8)) / drawn.m
    drawn["ms"] = 1000 * drawn.wall_s
    print("| family | n | algorithm | worst angle | optimal edges | crossings | log10 volume "
          "| bends per edge | time, ms |")
    print("|---|---|---|---|---|---|---|---|---|")
    for (family, n, algorithm), rows in drawn.groupby(["family", "n", "algorithm"], sort=False):
        of = rows[["worst_angle", "optimal", "crossings", "volume", "bends", "ms"]].median()
        print(f"| {family} | {n} | {algorithm} | {of.worst_angle:.1f} | {of.optimal:.0f} % "
              f"| {of.crossings:.0f} | {of.volume:.1f} | {of.bends:.1f} | {of.ms:.3g} |")
    lost = runs[~runs.index.isin(drawn.index)]
    for (algorithm, status), rows in lost.groupby(["algorithm", "status"]):
        print(f"\n{len(rows)} rows of {algorithm}: {status}, {rows.message.iloc[0]}")


if __name__ == "__main__":
    main()
