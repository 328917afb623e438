"""Proved 3D drawings of low-degree graphs with optimal angles.

    import ar3d, networkx
    graph = networkx.petersen_graph()
    drawing = ar3d.draw(graph, "diamond")
    assert ar3d.certify(graph, drawing)
    drawing.vertices, drawing.bends, drawing.box      # numpy arrays of integers

Graphs are networkx graphs, arrays of edges, scipy sparse matrices or ar3d.Graph. What is wrong with an argument is a
ValueError. Arrays that come out are over memory that C++ made: nothing is copied, and they cannot be written to.
"""
from __future__ import annotations

import operator
import os
from typing import Any, Union

import numpy

os.environ.setdefault("OMP_WAIT_POLICY", "passive")  # before _core loads libgomp: threads that wait sleep

from ._core import Certificate, Drawing, Graph, __version__, algorithms, families
from . import _core

__all__ = ["Certificate", "Drawing", "Graph", "algorithms", "as_graph", "certify", "draw", "families", "generate",
           "plot", "polylines", "read_results"]

GraphLike = Union[Graph, numpy.ndarray, Any]


def as_graph(graph: GraphLike, num_vertices: int | None = None) -> Graph:
    """The graph of whatever holds one.

    graph: an ar3d.Graph; a networkx graph (its nodes, in their order, are the vertices 0 … n - 1); a scipy sparse
        matrix (n x n; entry (u, v) that is not 0, or (v, u), or both, is the edge uv); an array or list of shape
        (m, 2) of vertices, in any order.
    num_vertices: of an array of edges; left out, the largest vertex and one more.
    Raises ValueError for loops, parallel edges, directed graphs, and vertices that there are not. Cost: O(n + m).
    """
    if num_vertices is not None:
        num_vertices = _integer(num_vertices, "num_vertices")
        if isinstance(graph, Graph) or hasattr(graph, "adj") or hasattr(graph, "tocoo"):
            raise ValueError("num_vertices is of an array of edges; this graph has its own")
    if isinstance(graph, Graph):
        return graph
    if hasattr(graph, "adj") and hasattr(graph, "nodes"):
        return _from_networkx(graph)
    if hasattr(graph, "tocoo"):
        return _from_sparse(graph)
    edges = numpy.asarray(graph)
    if edges.size == 0:
        edges = numpy.zeros((0, 2), dtype=numpy.int64)
    if edges.ndim != 2 or edges.shape[1] != 2 or edges.dtype.kind not in "iu":
        raise ValueError("edges are integers, an array of shape (m, 2)")
    if edges.dtype == numpy.uint64 and edges.size and int(edges.max()) > numpy.iinfo(numpy.int64).max:
        raise ValueError("a vertex is beyond 64 bits")
    if num_vertices is None:
        num_vertices = int(edges.max()) + 1 if len(edges) else 0
    if not 0 <= num_vertices < 2**32 - 1:
        raise ValueError(f"{num_vertices} vertices: there can be 0 to 2^32 - 2")
    return Graph(num_vertices, edges.astype(numpy.int64, copy=False))


def _integer(value: Any, name: str) -> int:
    try:
        return operator.index(value)
    except TypeError:
        raise ValueError(f"{name} is an integer, not {value!r}") from None


def _settings(values: dict[str, Any]) -> dict[str, int]:
    settings = {name: _integer(value, name) for name, value in values.items()}
    for name, value in settings.items():
        if not -2**63 <= value < 2**63:
            raise ValueError(f"{name} = {value} is beyond 64 bits")
    return settings


def _name(value: Any, what: str) -> str:
    if not isinstance(value, str):
        raise ValueError(f"{what} is a name, not {value!r}")
    return value


def _from_networkx(graph: Any) -> Graph:
    if graph.is_directed() or graph.is_multigraph():
        raise ValueError("the networkx graph is directed or a multigraph; networkx.Graph(graph) is neither")
    place = {node: i for i, node in enumerate(graph.nodes)}
    edges = numpy.array([(place[u], place[v]) for u, v in graph.edges], dtype=numpy.int64).reshape(-1, 2)
    return Graph(len(place), edges)


def _from_sparse(matrix: Any) -> Graph:
    if matrix.shape[0] != matrix.shape[1]:
        raise ValueError(f"the matrix is not square: {matrix.shape}")
    entries = matrix.tocoo()
    kept = entries.data != 0
    u, v = entries.row[kept].astype(numpy.int64), entries.col[kept].astype(numpy.int64)
    edges = numpy.stack([numpy.minimum(u, v), numpy.maximum(u, v)], axis=1)
    return Graph(matrix.shape[0], numpy.unique(edges, axis=0) if len(edges) else edges)


def draw(graph: GraphLike, algorithm: str = "diamond", **options: int) -> Drawing:
    """Draws a graph; the same graph, algorithm and options give the same drawing.

    algorithm: one of algorithms(). options: those that `ar3d list algorithms` names, such as effort=2.
    Of the drawing: `vertices` (n x 3), `bends` (k x 3; those of edge e, from its smaller end, are
    bends[bend_offsets[e]:bend_offsets[e + 1]]), `edges` (m x 2, ascending), `box` (2 x 3: its lowest and highest
    corner), all int64 but edges (uint32); the squared length of an integer vector u is u @ gram @ u /
    gram_denominator; `in_space` turns integer points into points where angles are true; `save` writes a file.
    Raises ValueError for an unknown name and for a vertex whose degree the algorithm does not draw.
    """
    return _core.draw(as_graph(graph), _name(algorithm, "algorithm"), _settings(options))


def certify(graph: GraphLike, drawing: Drawing, algorithm: str | None = None) -> Certificate:
    """Proves in exact integers that the drawing is one of the graph and keeps the algorithm's guarantee, or says why not.

    algorithm: whose guarantee; left out, the one that drew it. The certificate is true where it is valid, and lists
    all `violations` where it is not.
    """
    if not isinstance(drawing, Drawing):
        raise ValueError(f"drawing is an ar3d.Drawing, not {drawing!r}")
    return _core.certify(as_graph(graph), drawing, _name(algorithm or drawing.algorithm, "algorithm"))


def generate(family: str, n: int, seed: int = 0, **parameters: int) -> Graph:
    """A graph of a family of families() with about n vertices: the nearest number that the family has.

    parameters: those that `ar3d list families` names. Raises ValueError for unknown names and values out of range.
    """
    n, seed = _integer(n, "n"), _integer(seed, "seed")
    if not (0 <= n < 2**32 - 1 and 0 <= seed < 2**64):
        raise ValueError("n is from 0 to 2^32 - 2, the seed from 0 to 2^64 - 1")
    return _core.generate(_name(family, "family"), n, seed, _settings(parameters))


def polylines(drawing: Drawing) -> list[numpy.ndarray]:
    """The points of every edge in space, from its smaller end to its larger one, as arrays of shape (bends + 2, 3)."""
    vertices, bends = drawing.in_space(drawing.vertices), drawing.in_space(drawing.bends)
    offsets = drawing.bend_offsets
    return [numpy.vstack([vertices[u], bends[offsets[e]:offsets[e + 1]], vertices[v]])
            for e, (u, v) in enumerate(drawing.edges)]


def read_results(path: Any, table: str = "runs") -> Any:
    """A table of a results file as a pandas DataFrame: "runs", "instances", "algorithms" or "environments".

    Integers are Int64 and what is missing is NA. The frame's attrs["units"] and attrs["meaning"] name the unit and the
    meaning of the columns that have one. Needs h5py and pandas. Raises OSError if there is no such file, KeyError if
    it has no such table.
    """
    import h5py

    from . import ar3d_results

    frame = ar3d_results.read(path, table)
    with h5py.File(path, "r") as file:
        attributes = {name: value.decode() if isinstance(value, bytes) else str(value)
                      for name, value in file[table].attrs.items()}
    for kind, key in (("unit", "units"), ("meaning", "meaning")):
        found = {name: attributes.get(f"{name}.{kind}", "") for name in frame.columns}
        frame.attrs[key] = {name: text for name, text in found.items() if text}
    return frame


def plot(drawing: Drawing, ax: Any = None, **line: Any) -> Any:
    """Draws a small drawing with matplotlib, in space. Returns the axes (3D; new ones if ax is None).

    line: of every edge, as matplotlib's Line3DCollection takes it, such as linewidths=1.
    """
    from .plotting import plot as plot_drawing

    return plot_drawing(drawing, ax, **line)
