"""Pictures of drawings with matplotlib."""
from __future__ import annotations

from typing import Any

import numpy
from matplotlib import pyplot
from mpl_toolkits.mplot3d.art3d import Line3DCollection

from . import Drawing, polylines


def plot(drawing: Drawing, ax: Any = None, **line: Any) -> Any:
    """See ar3d.plot."""
    if ax is None:
        ax = pyplot.figure().add_subplot(projection="3d")
    colours = [f"C{e % 10}" for e in range(len(drawing.edges))]
    ax.add_collection3d(Line3DCollection(polylines(drawing), **{"colors": colours, **line}))
    vertices = drawing.in_space(drawing.vertices)
    ax.scatter(*vertices.T, color="black", s=12, depthshade=False)
    points = numpy.vstack([vertices, drawing.in_space(drawing.bends)])
    if len(points):
        low, high = points.min(axis=0), points.max(axis=0)
        for set_limits, a, b in zip((ax.set_xlim, ax.set_ylim, ax.set_zlim), low, high):
            set_limits(a - 0.5, b + 0.5)
        ax.set_box_aspect(numpy.maximum(high - low, 1))
    return ax
