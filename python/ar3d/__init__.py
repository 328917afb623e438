"""Proved 3D drawings of low-degree graphs with optimal angles.

    import ar3d, networkx
    graph = networkx.petersen_graph()
    drawing = ar3d.draw(graph)
    assert ar3d.certify(graph, drawing)
    drawing.vertices, drawing.bends, drawing.box      # numpy arrays of integers

Graphs are networkx or igraph graphs, texts such as graph6, arrays of edges, scipy sparse matrices or ar3d.Graph. What is wrong with an argument is a
ValueError. Arrays that come out are over memory that C++ made: nothing is copied, and they cannot be written to.
"""
from __future__ import annotations

import operator
import os
import re
import warnings
from typing import Any, Union

import numpy

os.environ.setdefault("OMP_WAIT_POLICY", "passive")  # before _core loads libgomp: threads that wait sleep, after some time
os.environ.setdefault("GOMP_SPINCOUNT", "20000")

from ._core import Certificate, Drawing, Graph, __version__, algorithms, families
from . import _core

__all__ = ["Certificate", "Drawing", "Graph", "algorithms", "as_graph", "certify", "draw", "drawing_of", "families", "generate",
           "layout", "load", "plot", "polylines", "read_results", "run_study"]


def __dir__() -> list[str]:
    return [*__all__, "__version__"]


GraphLike = Union[Graph, numpy.ndarray, Any]


def as_graph(graph: GraphLike, num_vertices: int | None = None) -> Graph:
    """The graph of whatever holds one.

    graph: an ar3d.Graph; a networkx or igraph graph (its nodes, in their order, are the vertices 0 … n - 1); a text
        with one graph in any format of the program, such as graph6, or the pathlib.Path of a file; a pandas DataFrame with
        columns such as source and target, read as a table of edges; a scipy sparse matrix (n x n; entry (u, v) that is not 0, or (v, u), or both, is the edge uv); an array or list of shape
        (m, 2) of vertices, in any order.
    num_vertices: of an array of edges; left out, the largest vertex and one more.
    Raises ValueError for loops, parallel edges, directed graphs, and vertices that there are not; warns of what is assumed, such as
    ids from 1. Cost: O(n + m).
    """
    return _graph_and_names(graph, num_vertices)[0]


def _graph_and_names(graph: GraphLike, num_vertices: int | None = None) -> tuple[Graph, list[str]]:
    if num_vertices is not None:
        num_vertices = _integer(num_vertices, "num_vertices")
        if isinstance(graph, (Graph, str, os.PathLike)) or any(hasattr(graph, own) for own in ("adj", "tocoo", "get_edgelist", "iloc")):
            raise ValueError("num_vertices is of an array of edges; this graph has its own")
    if isinstance(graph, Graph):
        return graph, []
    if hasattr(graph, "adj") and hasattr(graph, "nodes"):
        return _from_networkx(graph), _encodable(map(str, graph.nodes))
    if hasattr(graph, "get_edgelist") and hasattr(graph, "vcount"):
        if graph.is_directed():
            raise ValueError("the igraph graph is directed; graph.as_undirected() is not")
        names = _encodable(map(str, graph.vs["name"])) if "name" in graph.vs.attributes() else []
        return Graph(graph.vcount(), numpy.array(graph.get_edgelist(), dtype=numpy.int64).reshape(-1, 2)), names
    if isinstance(graph, str):
        return _core.graph_in(*_encodable([graph]), "the text")
    if isinstance(graph, os.PathLike):
        return _core.graph_of_file(os.fspath(graph))
    if hasattr(graph, "columns") and hasattr(graph, "to_csv"):
        return _from_frame(graph)
    if hasattr(graph, "tocoo"):
        return _from_sparse(graph), []
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
    return Graph(num_vertices, edges.astype(numpy.int64, copy=False)), []


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
    if not isinstance(value, str) or "\0" in value:
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
    entries = matrix.tocoo(copy=True)
    if numpy.isnan(entries.data).any():
        raise ValueError("the matrix has an entry that is nan: 0 is no edge, another number is one")
    entries.eliminate_zeros()
    entries.sum_duplicates()
    if not entries.data.all():
        raise ValueError("entries of the matrix at one place cancel: without them it is no edge, with one of them it is")
    u, v = entries.row.astype(numpy.int64), entries.col.astype(numpy.int64)
    edges = numpy.stack([numpy.minimum(u, v), numpy.maximum(u, v)], axis=1)
    return Graph(matrix.shape[0], numpy.unique(edges, axis=0) if len(edges) else edges)


def _from_frame(frame: Any) -> tuple[Graph, list[str]]:
    """By the program's reader of tables, so that ids and names mean what they mean in a file."""
    ends = _core.ends_of_heading([str(column) for column in frame.columns])
    if not ends:
        raise ValueError(f"the ends of edges are columns such as source and target, or from and to; these are {list(map(str, frame.columns))}")
    table = frame.iloc[:, ends].set_axis(["source", "target"], axis=1)
    (text,) = _encodable([table.to_csv(index=False, quoting=2)])  # texts in quotes
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", "the DataFrame:1: .* is a heading")
        return _core.graph_in(text, "the DataFrame")


def _encodable(texts: Any) -> list[str]:
    texts = list(texts)
    for text in texts:
        try:
            text.encode()
        except UnicodeEncodeError as error:
            raise ValueError(f"{text[error.start:error.end]!r} is no UTF-8, in {text[:40]!r}") from None
    return texts


def draw(graph: GraphLike, algorithm: str | None = None, **options: int) -> Drawing:
    """Draws a graph; the same graph, algorithm and options give the same drawing.

    algorithm: one of algorithms(); left out, grid up to degree 3 and diamond beyond, as of the program. options: those that `ar3d list algorithms` names, such as effort=2.
    Of the drawing: `vertices` (n x 3), `bends` (k x 3; those of edge e, from its smaller end, are
    bends[bend_offsets[e]:bend_offsets[e + 1]]), `edges` (m x 2, ascending), `box` (2 x 3: its lowest and highest
    corner), all int64 but edges (uint32); the squared length of an integer vector u is u @ gram @ u /
    gram_denominator; `names` are those of a networkx or igraph graph's nodes; `in_space` turns integer points into points where angles are true; `save` writes a file.
    Raises ValueError for an unknown name and for a vertex whose degree the algorithm does not draw.
    """
    given, names = _graph_and_names(graph)
    if algorithm is None:
        algorithm = "grid" if given.max_degree <= 3 else "diamond"
    return _core.draw(given, _name(algorithm, "algorithm"), _settings(options), names)


def load(path: Any) -> list[Drawing]:
    """The drawings of a file of JSON lines, as `ar3d draw` and Drawing.save write it. Raises ValueError where it is none."""
    return _core.load(os.fspath(path))


def _unpickled(line: str) -> Drawing:
    """The drawing of a pickle, which names this function: pickle finds no function of a compiled module. Raises ValueError where there is none."""
    return _core.unpickled(line)


# The page of the first drawing of a process holds the viewer and hands its two scripts to the notebook around it; the pages of
# later drawings take them from there. Their texts are the same, so the page's content security policy allows them.
_GIVE = "parent.ar3dViewer = [...document.scripts].filter(script => !script.type && script !== document.currentScript).map(script => script.text);"
_TAKE = """
const note = document.body.appendChild(document.createElement("p"));
note.textContent = "The viewer is in the first drawing of this notebook: run its cell, or scroll to it.";
const wait = setInterval(() => {
  if (!parent.ar3dViewer) return;
  clearInterval(wait);
  note.remove();
  for (const text of parent.ar3dViewer) document.body.appendChild(document.createElement("script")).text = text;
}, 100);
"""
_viewer_is_given = False


def _html_of(drawing: Drawing) -> str:
    """What a notebook shows of a drawing: the page of `ar3d view` in a frame; after the first one without the viewer's scripts."""
    import base64
    import hashlib
    import html
    import re
    import tempfile

    global _viewer_is_given
    with tempfile.TemporaryDirectory() as folder:
        page = os.path.join(folder, "drawing.html")
        drawing.save(page)
        with open(page, encoding="utf-8", newline="") as file:
            text = file.read()
    if _viewer_is_given:
        text = re.sub(r"<script>.*?</script>", "", text, flags=re.S)
    own = _TAKE if _viewer_is_given else _GIVE
    _viewer_is_given = True
    digest = base64.b64encode(hashlib.sha256(own.encode()).digest()).decode()
    text = text.replace("script-src ", f"script-src 'sha256-{digest}' ", 1).replace("</body>", f"<script>{own}</script></body>")
    return ('<iframe title="The drawing in 3D" style="width:100%;height:480px;border:0" '
            f'srcdoc="{html.escape(text)}"></iframe>')


Drawing._repr_html_ = _html_of


_COSINES = {None: (1, 1), 90: (0, 1), 109.47: (-1, 3), 120: (-1, 2)}


def certify(graph: GraphLike, drawing: Any, bends: Any = None, algorithm: str | None = None, *, max_degree: int | None = None,
            max_bends: int | None = None, angle: float | None = None, exactly: bool = False) -> Certificate:
    """Proves in exact integers that a drawing is one of the graph and keeps what is promised, or says why not.

    drawing: an ar3d.Drawing, or points of one's own: as drawing_of() takes them, with its `bends`.
    algorithm: whose guarantee; left out, the one that drew it. The points of one's own are held to these instead, and so is a
        Drawing with one of them: no edge crosses or touches another, no edge has more than `max_bends` bends, and all angles,
        at vertices and bends, are at least `angle` degrees, or that angle if `exactly`.
    angle: 120, 109.47 (which stands for arccos(-1/3)), 90, or None: every angle will do.
    The certificate is true where it is valid, and lists all `violations` where it is not. Raises ValueError for a vertex of a
    degree above `max_degree`.
    """
    if isinstance(bends, str):
        bends, algorithm = None, bends
    given = as_graph(graph)
    if max_degree is not None and given.max_degree > _integer(max_degree, "max_degree"):
        raise ValueError(f"the graph has a vertex of degree {given.max_degree}, max_degree is {max_degree}")
    is_own = not isinstance(drawing, Drawing)
    if is_own:
        drawing = drawing_of(graph, drawing, bends)
    elif bends is not None:
        raise ValueError("bends are of points of one's own; this drawing has its bends")
    if algorithm is None and (is_own or angle is not None or max_bends is not None):
        if angle not in _COSINES:
            raise ValueError(f"angle is 120, 109.47, 90 or None, not {angle!r}")
        if exactly and angle is None:
            raise ValueError("exactly is of an angle")
        most = 2**32 - 1 if max_bends is None else _integer(max_bends, "max_bends")
        if not 0 <= most < 2**32:
            raise ValueError(f"max_bends = {most} is not from 0 to 2^32 - 1")
        return _core.certify_promise(given, drawing, most, _COSINES[angle], bool(exactly))
    if angle is not None or max_bends is not None or exactly:
        raise ValueError("an algorithm has its own angle and max_bends")
    return _core.certify(given, drawing, _name(algorithm or drawing.algorithm, "algorithm"))


def drawing_of(graph: GraphLike, positions: Any, bends: Any = None) -> Drawing:
    """A drawing of one's own, from integer points.

    positions: an array of shape (n, 3), or (n, 2) in the plane z = 0; or a dict of nodes and their points, such as a layout of
        networkx; or a layout of igraph. The numbers are whole: scale and round others first, as in numpy.rint(1000 * points).
    bends: a list of the points of every edge, in the order of as_graph(graph).edges, from its smaller end; or a dict of pairs
        of nodes and the points from the first to the second. Edges that a dict does not name, and all if left out, are straight.
    Raises ValueError for nodes without a point, points that are not whole numbers, and edges that there are not.
    """
    given = as_graph(graph)
    nodes = list(graph.nodes) if hasattr(graph, "adj") and hasattr(graph, "nodes") else list(range(given.num_vertices))
    index = {node: i for i, node in enumerate(nodes)}
    if isinstance(positions, dict):
        missing = [node for node in nodes if node not in positions]
        if missing or len(positions) > len(nodes):
            raise ValueError(f"positions are of {len(positions)} nodes, the graph has {len(nodes)}"
                             + (f"; {missing[0]!r} has none" if missing else ""))
        positions = [positions[node] for node in nodes]
    of_edges = [[]] * given.num_edges if bends is None else bends
    if isinstance(bends, dict):
        number = {(int(u), int(v)): e for e, (u, v) in enumerate(given.edges)}
        of_edges = [[]] * given.num_edges
        for pair, points in bends.items():
            ends = [index.get(node, -1) for node in pair] if isinstance(pair, tuple) else []
            u, v = ends if len(ends) == 2 else (-1, -1)
            if (min(u, v), max(u, v)) not in number:
                raise ValueError(f"bends are of {pair!r}, which is no edge of the graph")
            of_edges[number[min(u, v), max(u, v)]] = points if u < v else list(points)[::-1]
    if len(of_edges) != given.num_edges:
        raise ValueError(f"bends are of {len(of_edges)} edges, the graph has {given.num_edges}")
    return _core.drawing(given, _points(positions, "positions"), [_points(points, "bends") for points in of_edges])


def _points(given: Any, name: str) -> numpy.ndarray:
    """Whole numbers of shape (k, 3); from (k, 2) in the plane z = 0."""
    points = numpy.asarray(getattr(given, "coords", given))
    if points.size == 0:
        return numpy.zeros((0, 3), dtype=numpy.int64)
    if points.ndim != 2 or points.shape[1] not in (2, 3) or points.dtype.kind not in "iuf":
        raise ValueError(f"{name} are points of 2 or 3 numbers each")
    whole = numpy.zeros((len(points), 3), dtype=numpy.int64)
    bad = ~(numpy.abs(points.astype(float)) < 2.0**62) | (points != numpy.rint(points))
    if bad.any():
        raise ValueError(f"{name} are whole numbers below 2^62, not {points[bad][0]}: scale and round them, as in numpy.rint(1000 * points)")
    whole[:, :points.shape[1]] = points
    return whole


def layout(graph: Any, drawing: Drawing) -> Any:
    """Where a drawing's vertices are in space, as the library of the graph takes it: a dict of nodes and points (`pos` of networkx)
    or an igraph.Layout; of other graphs an array of shape (n, 3). Bends are not part of it."""
    points = drawing.in_space(drawing.vertices)
    if hasattr(graph, "adj") and hasattr(graph, "nodes"):
        return dict(zip(graph.nodes, points))
    if hasattr(graph, "get_edgelist") and hasattr(graph, "vcount"):
        import igraph

        return igraph.Layout(points.tolist(), dim=3)
    return points


def generate(family: str, n: int, seed: int = 0, **parameters: int) -> Graph:
    """A graph of a family of families() with about n vertices: the nearest number that the family has.

    parameters: those that `ar3d list families` names. Raises ValueError for unknown names and values out of range.
    """
    n, seed = _integer(n, "n"), _integer(seed, "seed")
    if not (0 <= n < 2**32 - 1 and 0 <= seed < 2**64):
        raise ValueError("n is from 0 to 2^32 - 2, the seed from 0 to 2^64 - 1")
    graph = _core.generate(_name(family, "family"), n, seed, _settings(parameters))
    if graph.num_vertices != n:
        warnings.warn(f"{family} has no graph with {n} vertices: this has {graph.num_vertices}", stacklevel=2)
    return graph


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


def _toml_key(key: Any) -> str:
    return key if re.fullmatch("[A-Za-z0-9_-]+", _name(key, "a key")) else _toml(key)


def _toml(value: Any) -> str:
    if isinstance(value, dict):
        return "{" + ", ".join(f"{_toml_key(key)} = {_toml(one)}" for key, one in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(_toml, value)) + "]"
    import json

    return json.dumps(value, ensure_ascii=True)


def _program() -> str:
    """The program ar3d: of $AR3D, of a wheel, or of $PATH."""
    import shutil

    of_wheel = os.path.join(os.path.dirname(__file__), "bin", "ar3d")
    program = os.environ.get("AR3D") or (of_wheel if os.path.exists(of_wheel) else shutil.which("ar3d"))
    if program is None:
        raise FileNotFoundError("the program ar3d is not in $PATH; $AR3D says where it is")
    return program


def run_program() -> None:
    """The command `ar3d` of a wheel: becomes the program."""
    import sys

    os.execv(_program(), ["ar3d", *sys.argv[1:]])


def run_study(study: Any, output: Any = None, *arguments: str) -> Any:
    """Runs a study with the program `ar3d` and returns its rows as read_results does.

    study: a specification's path, the name of a study of the program, or a dict with the keys of a specification.
    output: the results file; left out, nothing is kept. arguments: further ones of `ar3d study run`.
    The program is that of $AR3D, else of the wheel, else of $PATH. Rows that are violated or incomplete are rows, too. Raises ValueError
    with the program's message where the study cannot be run.
    """
    import subprocess
    import tempfile

    program = _program()
    with tempfile.TemporaryDirectory() as folder:
        if isinstance(study, dict):
            text = "".join(f"{_toml_key(key)} = {_toml(value)}\n" for key, value in study.items())
            study = os.path.join(folder, "study.toml")
            with open(study, "w", encoding="utf-8") as file:
                file.write(text)
        results = os.path.join(folder, "results.h5") if output is None else os.fspath(output)
        done = subprocess.run([program, "study", "run", "--quiet", os.fspath(study), "-o", results, *arguments],
                              capture_output=True, text=True)
        if done.returncode not in (0, 4, 5):
            raise ValueError(done.stderr.strip())
        return read_results(results)


def plot(drawing: Drawing, ax: Any = None, **line: Any) -> Any:
    """Draws a small drawing with matplotlib, in space. Returns the axes (3D; new ones if ax is None).

    line: of every edge, as matplotlib's Line3DCollection takes it, such as linewidths=1.
    """
    from .plotting import plot as plot_drawing

    return plot_drawing(drawing, ax, **line)
