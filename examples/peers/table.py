#!/usr/bin/python3
"""The table of a study of peers: medians over the graphs of each family, size and algorithm.

Usage: table.py RESULTS.h5 [LARGEST_N]

Of several settings of one algorithm each has its lines. Worst angle in degrees, at vertices and bends; edges all of whose angles are optimal, in percent;
crossings (nan where there are too many to count); volume of the box in units of the smallest vertex distance, as a power of ten; bends per
edge; time in ms: of the drawing alone for our algorithms, from request to answer for programs."""

import sys

import numpy
import pandas


def main():
    largest = None
    if len(sys.argv) == 3:
        largest = int(sys.argv[2]) if sys.argv[2].isdecimal() else sys.exit(f"table.py: LARGEST_N '{sys.argv[2]}' is no number")
    elif len(sys.argv) != 2:
        sys.exit(__doc__)
    try:
        runs = pandas.read_hdf(sys.argv[1], "runs")
    except Exception as error:    # of pandas, PyTables or HDF5
        sys.exit(f"table.py: cannot read the runs of {sys.argv[1]}: {str(error).strip().splitlines()[-1]}")
    for name in runs.columns[runs.dtypes == object]:
        runs[name] = runs[name].map(lambda x: x.decode() if isinstance(x, bytes) else x)
    if largest is not None:
        runs = runs[runs.n <= largest]
    drawn = runs[runs.status.isin(["ok", "measured", "violated"])].copy()
    drawn["worst_angle"] = numpy.fmin(drawn.smallest_vertex_angle, drawn.smallest_bend_angle)
    drawn["crossings"] = drawn.crossings.where(drawn.crossings >= 0, numpy.nan)    # -1: not counted
    drawn["optimal"] = 100 * drawn.optimal_edges / drawn.m
    drawn["volume"] = drawn.log2_relative_volume * numpy.log10(2)
    drawn["bends"] = sum(b * drawn[f"bends_{b}"] for b in range(8)) / drawn.m
    drawn["ms"] = 1000 * drawn.wall_s
    is_one = drawn.groupby("algorithm").options.nunique() <= 1    # several settings of one are told apart
    drawn["name"] = [a if is_one[a] else f"{a} ({o})" for a, o in zip(drawn.algorithm, drawn.options)]
    print("| family | n | algorithm | worst angle | optimal edges | crossings | log10 volume "
          "| bends per edge | time, ms |")
    print("|---|---|---|---|---|---|---|---|---|")
    for (family, n, algorithm), rows in drawn.groupby(["family", "n", "name"], sort=False):
        of = rows[["worst_angle", "optimal", "crossings", "volume", "bends", "ms"]].median()
        print(f"| {family} | {n} | {algorithm} | {of.worst_angle:.1f} | {of.optimal:.0f} % "
              f"| {of.crossings:.0f} | {of.volume:.1f} | {of.bends:.1f} | {of.ms:.3g} |")
    lost = runs[~runs.index.isin(drawn.index)]
    for (algorithm, status), rows in lost.groupby(["algorithm", "status"]):
        print(f"\n{len(rows)} rows of {algorithm}: {status}, {rows.message.iloc[0]}")


if __name__ == "__main__":
    main()
