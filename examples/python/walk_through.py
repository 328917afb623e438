#!/usr/bin/env python3
"""ar3d from Python, cell by cell: `# %%` begins a cell of Jupyter, VS Code and Spyder. Writes petersen.png and growth.csv.

    cmake -B build/release -DAR3D_PYTHON=ON && ninja -C build/release ar3d_python
    PYTHONPATH=build/release/python examples/python/walk_through.py [RESULTS.h5]
"""
# %% A graph of networkx, drawn with at most three bends per edge and angles of 109.47 degrees
import sys

import matplotlib
import networkx
import numpy
import pandas
import scipy.sparse

import ar3d

matplotlib.use("Agg")
petersen = networkx.petersen_graph()
drawing = ar3d.draw(petersen, "diamond")
print(f"{drawing.algorithm}: {len(drawing.vertices)} vertices, {len(drawing.bends)} bends")
print("box", *(drawing.box[1] - drawing.box[0]))

# %% The proof, in exact integers
certificate = ar3d.certify(petersen, drawing)
assert certificate.valid, certificate.violations
print("proved; edges by number of bends:", certificate.bend_histogram)

# %% Every angle of a polyline, in floating point for once
def angles(points):
    steps = numpy.diff(points, axis=0)
    cosines = -(steps[:-1] * steps[1:]).sum(axis=1) / (
        numpy.linalg.norm(steps[:-1], axis=1) * numpy.linalg.norm(steps[1:], axis=1))
    return numpy.degrees(numpy.arccos(cosines))

bends = numpy.concatenate([angles(line) for line in ar3d.polylines(drawing)])
print(f"angles at bends: {bends.min():.2f} to {bends.max():.2f} degrees")
assert numpy.allclose(bends, numpy.degrees(numpy.arccos(-1 / 3)))

# %% The same graph as a sparse matrix and as an array of edges gives the same drawing
matrix = scipy.sparse.csr_matrix(networkx.to_numpy_array(petersen))
edges = numpy.array(petersen.edges)
for graph in (matrix, edges):
    assert (ar3d.draw(graph, "diamond").vertices == drawing.vertices).all()

# %% A picture
axes = ar3d.plot(drawing)
axes.figure.savefig("petersen.png", dpi=120)

# %% How the box of random cubic graphs grows
rows = []
for n in (50, 100, 200, 400, 800):
    for seed in range(5):
        graph = ar3d.generate("random-cubic", n, seed)
        low, high = ar3d.draw(graph, "compact").box
        rows.append({"n": n, "seed": seed, "longest_side": int((high - low).max())})
growth = pandas.DataFrame(rows)
growth.to_csv("growth.csv", index=False)
means = growth.groupby("n").longest_side.mean()
print(means.to_string())
slope = numpy.polyfit(numpy.log(means.index), numpy.log(means), 1)[0]
print(f"longest side of compact: n^{slope:.2f}")

# %% The rows of a study, with units
if len(sys.argv) > 1:
    runs = ar3d.read_results(sys.argv[1])
    print(runs.groupby("algorithm").wall_s.median(), runs.attrs["units"]["wall_s"])
