"""Writes the files of this folder with networkx and igraph (Debian: python3-networkx, python3-igraph).

    /usr/bin/python3 tests/formats/foreign/write_foreign_files.py tests/formats/foreign

Every file holds the Petersen graph with its vertices in the order 0 to 9, or the union of a path of 3 vertices and a
vertex alone where the name says so. foreign_files_test.cpp reads them all.
"""
import pathlib
import sys

import igraph
import networkx as nx

PETERSEN = sorted(tuple(sorted(edge)) for edge in nx.petersen_graph().edges())


def graphs():
    """The same graphs for networkx: plain, with attributes, and one with a vertex alone."""
    plain = nx.Graph()
    plain.add_nodes_from(range(10))
    plain.add_edges_from(PETERSEN)
    rich = nx.Graph(plain, name="Petersen")
    for v in rich:
        rich.nodes[v].update(label=f"no. {v} <&>", x=v / 3, good=v % 2 == 0)
    for number, (u, v) in enumerate(rich.edges()):
        rich.edges[u, v].update(weight=number + 0.5, colour="blue")
    lonely = nx.Graph([(0, 1), (1, 2)])
    lonely.add_node(3)
    return plain, rich, lonely


def by_networkx(folder):
    plain, rich, lonely = graphs()
    nx.write_graph6(plain, folder / "networkx.g6")
    nx.write_graph6(plain, folder / "networkx-no-header.g6", header=False)
    nx.write_sparse6(plain, folder / "networkx.s6")
    nx.write_sparse6(lonely, folder / "networkx-lonely.s6")
    nx.write_edgelist(plain, folder / "networkx-attributes.edgelist")
    nx.write_edgelist(plain, folder / "networkx-plain.edgelist", data=False)
    nx.write_edgelist(rich, folder / "networkx-rich.edgelist")
    nx.write_edgelist(lonely, folder / "networkx-lonely.edgelist", data=False)
    nx.write_weighted_edgelist(rich, folder / "networkx-weighted.edgelist")
    nx.write_edgelist(plain, folder / "networkx-commas.edgelist", delimiter=",", data=False)
    nx.write_adjlist(plain, folder / "networkx.adjlist")
    nx.write_multiline_adjlist(plain, folder / "networkx-multiline.adjlist")
    nx.write_graphml_xml(plain, folder / "networkx.graphml")
    nx.write_graphml_xml(rich, folder / "networkx-rich.graphml")
    nx.write_graphml_xml(lonely, folder / "networkx-lonely.graphml")
    nx.write_graphml_xml(rich, folder / "networkx-utf16.graphml", encoding="utf-16")
    nx.write_graphml_xml(rich, folder / "networkx-latin1.graphml", encoding="iso-8859-1")
    nx.write_graphml_xml(rich.to_directed(), folder / "networkx-directed.graphml")
    nx.write_gexf(rich, folder / "networkx.gexf")
    nx.write_gml(rich, folder / "networkx.gml")
    nx.write_pajek(rich, folder / "networkx.net")


def prefixed(folder):
    """networkx's own file with the namespace under a prefix, as other libraries of XML write it."""
    import xml.etree.ElementTree as tree
    tree.register_namespace("g", "http://graphml.graphdrawing.org/xmlns")
    document = tree.parse(folder / "networkx-rich.graphml")
    document.write(folder / "networkx-prefixed.graphml", encoding="utf-8", xml_declaration=True)


def by_igraph(folder):
    plain = igraph.Graph(n=10, edges=PETERSEN)
    rich = igraph.Graph(n=10, edges=PETERSEN, vertex_attrs={"name": [f"v{v}" for v in range(10)]},
                        edge_attrs={"weight": [number + 0.5 for number in range(15)]})
    lonely = igraph.Graph(n=4, edges=[(0, 1), (1, 2)])
    plain.write_edgelist(str(folder / "igraph.edgelist"))
    lonely.write_edgelist(str(folder / "igraph-lonely.edgelist"))
    plain.write_dimacs(str(folder / "igraph.dimacs"), source=0, target=9, capacity=[1] * 15)
    for name, graph in [("igraph", plain), ("igraph-rich", rich), ("igraph-lonely", lonely)]:
        graph.write_graphml(str(folder / f"{name}.graphml"))
    plain.as_directed().write_graphml(str(folder / "igraph-directed.graphml"))
    plain.write_adjacency(str(folder / "igraph-matrix.adjacency"))
    rich.write_ncol(str(folder / "igraph.ncol"))
    plain.write_ncol(str(folder / "igraph-plain.ncol"), names=None, weights=None)
    rich.write_lgl(str(folder / "igraph.lgl"))
    rich.write_gml(str(folder / "igraph.gml"), creator="igraph")
    rich.write_pajek(str(folder / "igraph.net"))
    rich.write_leda(str(folder / "igraph.lgr"))
    rich.write_dot(str(folder / "igraph.dot"))


if __name__ == "__main__":
    target = pathlib.Path(sys.argv[1])
    by_networkx(target)
    prefixed(target)
    by_igraph(target)
