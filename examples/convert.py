#!/usr/bin/env python3
"""Makes GraphML of a graph in a format that networkx reads and ar3d does not: GEXF, Pajek, directed or weighted ones.

    python3 examples/convert.py INPUT OUTPUT.graphml

Directions, weights and parallel edges are dropped; loops stay (--simple of `ar3d study` drops them). Needs networkx.
"""
import pathlib
import sys

import networkx

READERS = {".gexf": networkx.read_gexf, ".net": networkx.read_pajek, ".paj": networkx.read_pajek, ".pajek": networkx.read_pajek,
           ".gml": networkx.read_gml, ".graphml": networkx.read_graphml, ".edgelist": networkx.read_weighted_edgelist}


def main(arguments):
    if len(arguments) != 2:
        sys.exit(__doc__)
    source, target = map(pathlib.Path, arguments)
    if source.suffix not in READERS:
        sys.exit(f"{source}: its ending is none of {' '.join(sorted(READERS))}")
    read = networkx.Graph(READERS[source.suffix](source))
    bare = networkx.Graph()
    bare.add_nodes_from((str(node), {"label": str(data.get("label", node))}) for node, data in read.nodes(data=True))
    bare.add_edges_from((str(u), str(v)) for u, v in read.edges())
    networkx.write_graphml(bare, target)


if __name__ == "__main__":
    main(sys.argv[1:])
