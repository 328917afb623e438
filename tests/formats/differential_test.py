"""Files that networkx, igraph, pandas, scipy, nauty and Graphviz write, and R by hand, as they are and mutated in a byte, a field or
a line: each is read as the reference program reads it, or refused. differential_test.py AR3D CLASS; in the environment AR3D_READ_MANY
the reader, AR3D_SEED another seed, AR3D_SHOW the files of a verdict, such as "written refused"."""
import collections
import csv
import functools
import io
import json
import os
import random
import re
import subprocess
import tempfile
import unittest
import warnings

import igraph
import networkx
import numpy
import pandas
import scipy.io
import scipy.sparse

LETTERS = "abcdefgxyzAZ019_äß名"
ODD = LETTERS + "\"':,;-+.#(){}[]%&<>\\/ "
Graph = collections.namedtuple("Graph", "vertices edges")  # names, and pairs of names as frozensets


def of_networkx(graph):
    """The graph by its names; nothing if it has loops or parallel edges, which are refused."""
    edges = [frozenset(map(str, edge[:2])) for edge in graph.edges()]
    if len({str(v) for v in graph}) < len(graph):
        raise ValueError("a number and a name are the same text")
    if graph.is_directed() or len(set(edges)) < len(edges) or any(len(edge) < 2 for edge in edges):
        return None
    return Graph({str(v) for v in graph}, set(edges))


def sampled(rng, ids, m):
    edges = set()
    for _ in range(m):
        u, v = rng.sample(ids, 2)
        edges.add((u, v) if rng.random() < .5 and (v, u) not in edges else (v, u) if (u, v) not in edges else (u, v))
    return sorted(edges, key=lambda _: rng.random())


def is_name(text):
    """False for what lists call a number, or missing: names such as these need quotes."""
    if text in ("NA", "nan"):
        return False
    try:
        float(text.replace(",", "."))
        return text == str(int(text))
    except ValueError:
        return True


def is_header(data):
    """Can the first line of a list be "n m" as well as an edge? Then it is asked which it is."""
    first = re.fullmatch(rb"(\d+)[ ,;\t](\d+)", data.split(b"\n")[0])
    return first is not None and int(first[2]) == data.strip().count(b"\n")


class Source:
    """Random graphs: ids from 0 or 1, or names; a few vertices alone."""

    def __init__(self, rng):
        self.rng = rng
        n = rng.randint(2, 12)
        self.numbers = rng.random() < .5
        if self.numbers:
            first = 1 if rng.random() < .1 else 0
            self.ids = list(range(first, first + n))
        else:
            names = {"".join(rng.choice(LETTERS) for _ in range(rng.randint(1, 6))) for _ in range(n)} | {"aa", "b", "c"}
            self.ids = sorted(filter(is_name, names))
        self.edges = sampled(rng, self.ids, rng.randint(1, 2 * len(self.ids)))
        if rng.random() < .95 or (self.numbers and self.ids[0] == 1):  # else some are alone, which lists cannot say
            named = {v for edge in self.edges for v in edge}
            self.edges += [(v, rng.choice([u for u in self.ids if u != v])) for v in self.ids if v not in named]
            self.edges = list({frozenset(edge): edge for edge in self.edges}.values())
        if not self.numbers:  # of a first line whose names are in no other, it is unknown whether it is a heading
            degrees = collections.Counter(v for edge in self.edges for v in edge)
            self.edges += [(v, next(w for w in self.ids if w not in (u, v))) for u, v in self.edges
                           if degrees[u] == degrees[v] == 1]
            self.edges = list({frozenset(edge): edge for edge in self.edges}.values())

    def networkx(self):
        graph = networkx.Graph()
        if self.rng.random() < .5:
            graph.add_nodes_from(self.ids)
        graph.add_edges_from(self.edges)
        if self.rng.random() < .3:
            for attributes in [*graph.nodes.values(), *graph.edges.values()]:
                attributes.update(self.rng.choice([{}, {"colour": "red"}, {"weight": 2.5, "note": "a b"}]))
        return graph

    def odd_names(self):
        renamed = {v: "".join(self.rng.choice(ODD) for _ in range(self.rng.randint(1, 6))).strip(" #%+-.0") or "x" for v in self.ids}
        renamed = {v: name if list(renamed.values()).count(name) == 1 else f"{v}" for v, name in renamed.items()}
        return [(renamed[u], renamed[v]) for u, v in self.edges]


def text_of(write):
    with tempfile.NamedTemporaryFile(dir="/dev/shm", suffix=".x") as file:
        write(file.name)
        with open(file.name, "rb") as written:
            return written.read()


def read_by(read, data, suffix):
    with tempfile.NamedTemporaryFile(dir="/dev/shm", suffix=suffix) as file:
        file.write(data)
        file.flush()
        return read(file.name)


# Each kind: name of the file's ending, what writes a graph as bytes, and the reference that reads bytes.

def edgelist(delimiter, data):
    def write(source):
        graph = source.networkx()
        if data == "weight":
            for _, _, attributes in graph.edges(data=True):
                attributes["weight"] = source.rng.choice([1, 2.5, -3, 1e-3])
        return text_of(lambda name: networkx.write_edgelist(graph, name, delimiter=delimiter or " ",
                                                            data=["weight"] if data == "weight" else data))

    def read(text):
        kind = (("weight", float),) if data == "weight" else data
        lines = text.decode().split("\n")
        if any(len(line.split(delimiter)) == 1 and line.strip() and line[0] != "#" for line in lines):
            raise ValueError("a line that networkx passes over")
        if delimiter is None and any(word[-1] in ",;" or word[0] in ",;" for line in lines for word in line.split()[:2]):
            raise ValueError("cut at blanks, though it is a table")
        graph = networkx.parse_edgelist(lines, delimiter=delimiter, create_using=networkx.MultiGraph, data=kind)
        if any(" {" in v and v.endswith("}") for v in graph):
            raise ValueError("attributes in a name")
        return networkx.MultiGraph(networkx.relabel_nodes(graph, str.strip))  # blanks beside a separator are none of a name
    return ".edgelist", write, read


def adjlist(source):
    return text_of(lambda name: networkx.write_adjlist(source.networkx(), name))


def table(separator, index, heading, quoting):
    columns = heading.split(",") if heading else None

    def write(source):
        edges = source.odd_names() if not source.numbers and source.rng.random() < .5 else source.edges
        frame = pandas.DataFrame(edges, columns=columns or ["a", "b"])
        if source.rng.random() < .3:
            frame["weight"] = [source.rng.choice([1, 0.5, 7]) for _ in edges]
        if columns and source.rng.random() < .3:
            frame.insert(source.rng.randrange(len(frame.columns) + 1), "label", [source.rng.choice(["", "a b", "7"]) for _ in edges])
        if index:
            frame.index += source.rng.choice([0, 1])  # pandas counts from 0, R from 1
        return frame.to_csv(sep=separator, index=index, header=bool(columns), quoting=quoting).encode()

    def read(text):
        frame = pandas.read_csv(io.BytesIO(text), sep=separator, dtype=str, keep_default_na=False, skipinitialspace=True,
                                header=0 if columns else None, index_col=0 if index else None, encoding_errors="surrogateescape")
        ends = frame[columns] if columns else frame[frame.columns[:2]]
        graph = networkx.MultiGraph()
        graph.add_edges_from(tuple(end.strip() for end in row) for row in ends.itertuples(index=False, name=None))
        if "" in graph:
            raise ValueError("an end is missing")
        return graph
    return ".csv", write, read


def by_igraph(method, suffix, reader, named=False):
    def write(source):
        names = [str(v) for v in source.ids]
        place = {v: i for i, v in enumerate(source.ids)}
        graph = igraph.Graph(n=len(names), edges=[(place[u], place[v]) for u, v in source.edges])
        if named:
            graph.vs["name"] = names
        if source.rng.random() < .3:
            graph.es["weight"] = [source.rng.choice([1, 2.5, .5 if suffix == ".dot" else 1e-7]) for _ in graph.es]  # DOT has no 1e-07
        if source.rng.random() < .3 and not named:
            graph.vs["colour"] = "red"
        return text_of(lambda name: getattr(graph, method)(name))

    def read(text):
        graph = read_by(reader, text, suffix)
        ids = [int(v) for v in graph.vs["id"]] if suffix == ".gml" and "id" in graph.vs.attributes() else range(graph.vcount())
        if named and any("," in (name[0], name[-1]) for name in graph.vs["name"]):
            raise ValueError("cut at blanks, though it is a table")
        names = graph.vs["name"] if named and "name" in graph.vs.attributes() else ids
        made = networkx.MultiGraph()
        made.add_nodes_from(names)
        made.add_edges_from((names[e.source], names[e.target]) for e in graph.es)
        return made
    return suffix, write, reader if suffix == ".dot" else read


def lines_of(header):
    def write(source):
        graph = networkx.convert_node_labels_to_integers(source.networkx())
        return header(graph)
    return write


def matrix(field, symmetry):
    def write(source):
        graph = networkx.convert_node_labels_to_integers(source.networkx())
        found = scipy.sparse.coo_matrix(networkx.to_scipy_sparse_array(graph, weight=None, dtype=float if field == "real" else int))
        if field == "real":
            weights = {(i, j): source.rng.choice([1, .5, -3e-7]) for i, j in zip(found.row, found.col) if i < j}
            found.data = numpy.array([weights[min(i, j), max(i, j)] for i, j in zip(found.row, found.col)])
        return text_of(lambda name: scipy.io.mmwrite(name + ".mtx", found, field=field, symmetry=symmetry) or
                       os.replace(name + ".mtx", name))

    def read(text):
        found = read_by(scipy.io.mmread, text, ".mtx")
        if not scipy.sparse.issparse(found) or found.shape[0] != found.shape[1] or not all(found.data):
            raise ValueError("no graph")
        graph = networkx.MultiGraph()
        graph.add_nodes_from(range(found.shape[0]))
        graph.add_edges_from((int(i), int(j)) for i, j in zip(found.row, found.col) if i > j)
        if set(zip(found.row, found.col)) != set(zip(found.col, found.row)) or any(found.row == found.col):
            raise ValueError("no undirected graph")
        return graph
    return ".mtx", write, read


def ran(command, data):
    """What a program makes of its standard input."""
    said = subprocess.run(command, input=data, capture_output=True, check=False)
    if said.returncode or b">E" in said.stderr or b"rror" in said.stderr:
        raise ValueError(said.stderr)
    return said.stdout


def nauty_lines(option):
    """One to three graphs, in the line format of nauty that the option of copyg says."""
    def write(source):
        graphs = [networkx.convert_node_labels_to_integers(Source(source.rng).networkx()) for _ in range(source.rng.randint(1, 3))]
        return ran(["nauty-copyg", "-q", option], b"".join(networkx.to_graph6_bytes(graph, header=False) for graph in graphs))
    return {"-g": ".g6", "-s": ".s6", "-i": ".is6"}[option], write, read_nauty


@functools.lru_cache(maxsize=None)
def all_graphs(n):
    return ran(["nauty-geng", "-q", str(n)], b"").splitlines()


def geng(source):
    return b"".join(line + b"\n" for line in source.rng.sample(all_graphs(source.rng.randint(4, 7)), source.rng.randint(1, 3)))


def read_nauty(text):
    graphs = []
    for part in ran(["nauty-showg", "-e"], ran(["nauty-copyg", "-q", "-g"], text)).split(b"Graph")[1:]:
        n, m, *ends = map(int, part.split(b"\n", 1)[1].split())
        graph = networkx.MultiGraph()
        graph.add_nodes_from(range(n))
        graph.add_edges_from(zip(ends[::2], ends[1::2]))
        if graph.number_of_edges() != m:
            raise ValueError("an edge is missing")
        graphs.append(graph)
    return graphs


def read_lines(read):
    return lambda text: [read(line) for line in text.split(b"\n") if line.strip()]


def of_r(table, header=None):
    """By hand what R's write.table(d, ...) writes; by read.table it is read as pandas reads it."""
    def write(source):
        rows = [[f'"{end}"' if isinstance(end, str) else str(end) for end in edge] for edge in source.edges]
        return table(rows).encode()

    def read(text):
        frame = pandas.read_csv(io.BytesIO(text), sep=r"\s+", dtype=str, keep_default_na=False, header=header, quotechar='"', comment="#")
        graph = networkx.MultiGraph()
        graph.add_edges_from(frame[frame.columns[:2]].itertuples(index=False, name=None))
        if any(v[-1:] == "," for v in graph):
            raise ValueError("cut at blanks, though it is a table")
        return graph
    return ".txt", write, read


def both_orders(source):
    return "".join(f"{u} {v}\n{v} {u}\n" for u, v in source.edges).encode()


def dot(source):
    quote = source.rng.random() < .7
    names = {v: json.dumps(str(v), ensure_ascii=False) if quote or str(v)[0].isdigit() and not str(v).isdigit() else str(v)
             for v in source.ids}
    body = "".join(f"{names[v]}{source.rng.choice(['', ' [color=x]', ';'])}\n" for v in source.ids)
    body += "".join(f"{names[u]} -- {names[v]}{source.rng.choice([';', ' [weight=2]', ''])}\n" for u, v in source.edges)
    return f"{source.rng.choice(['', 'strict '])}graph {source.rng.choice(['', 'g '])}{{\n{body}}}\n".encode()


def read_dot(text):
    program = 'BEG_G{if(isDirect($G)) print("!");} N{print("N", $.name);} E{print("E", $.tail.name, "\t", $.head.name);}'
    said = ran(["gvpr", program], text)
    if b"!" in said.splitlines():
        raise ValueError("arcs")
    counts = [int(word) for line in ran(["gc", "-n", "-e"], text).splitlines() for word in line.split()[:2]]
    graph = networkx.MultiGraph()
    for line in said.decode(errors="surrogateescape").split("\n")[:-1]:
        if line[0] == "N":
            graph.add_node(line[1:])
        else:
            graph.add_edge(*line[1:].split("\t"))
    if counts and counts[:2] != [graph.number_of_nodes(), graph.number_of_edges()]:
        raise ValueError("gc and gvpr read other graphs")
    return graph


def of_words(read, *endings):
    return lambda text: read_by(read, text, *endings)


def read_gml(text):
    """By its labels, a node without one by its id."""
    graph = networkx.parse_gml(text.decode(), label="id")
    names = {v: networkx.readwrite.gml.unescape(str(graph.nodes[v].get("label", ""))) or str(v) for v in graph}
    if len(set(names.values())) < len(names):
        raise ValueError("a label stands twice")
    return networkx.relabel_nodes(graph, names)


KINDS = {
    "networkx edge list": edgelist(None, True),
    "networkx edge list without data": edgelist(None, False),
    "networkx weighted edge list": edgelist(None, "weight"),
    "networkx edge list with commas": edgelist(",", False),
    "networkx edge list with tabs": edgelist("\t", True),
    "networkx adjacency list": (".adjlist", adjlist, of_words(networkx.read_adjlist, ".adjlist")),
    "networkx graph6": (".g6", lines_of(networkx.to_graph6_bytes), read_lines(networkx.from_graph6_bytes)),
    "networkx sparse6": (".s6", lines_of(networkx.to_sparse6_bytes), read_lines(networkx.from_sparse6_bytes)),
    "networkx GML": (".gml", lambda s: "\n".join(networkx.generate_gml(s.networkx())).encode(),
                     read_gml),
    "networkx GraphML": (".graphml", lambda s: "\n".join(networkx.generate_graphml(s.networkx())).encode(),
                         of_words(networkx.read_graphml, ".graphml")),
    "igraph edge list": by_igraph("write_edgelist", ".edgelist", lambda f: igraph.Graph.Read_Edgelist(f, directed=False)),
    "igraph ncol": by_igraph("write_ncol", ".ncol", lambda f: igraph.Graph.Read_Ncol(f, directed=False), True),
    "igraph GML": by_igraph("write_gml", ".gml", igraph.Graph.Read_GML),
    "igraph GraphML": by_igraph("write_graphml", ".graphml", igraph.Graph.Read_GraphML),
    "pandas table": table(",", False, "source,target", csv.QUOTE_MINIMAL),
    "pandas table with index": table(",", True, "from,to", csv.QUOTE_MINIMAL),
    "pandas table with semicolons": table(";", False, "Source,Target", csv.QUOTE_MINIMAL),
    "pandas table with tabs": table("\t", False, "src,dst", csv.QUOTE_MINIMAL),
    "R's write.csv": table(",", True, "V1,V2", csv.QUOTE_NONNUMERIC),
    "table without heading": table(",", False, "", csv.QUOTE_ALL),
    "R's write.table without names": of_r(lambda rows: "".join(" ".join(row) + "\n" for row in rows)),
    "scipy pattern": matrix("pattern", "general"),
    "scipy pattern, symmetric": matrix("pattern", "symmetric"),
    "scipy weights, symmetric": matrix("real", "symmetric"),
    "nauty graph6": nauty_lines("-g"),
    "nauty sparse6": nauty_lines("-s"),
    "nauty incremental sparse6": nauty_lines("-i"),
    "geng": (".g6", geng, read_nauty),
    "igraph DOT": by_igraph("write_dot", ".dot", read_dot),
    "DOT": (".dot", dot, read_dot),
    "dot -Tcanon": (".gv", lambda source: ran(["dot", "-Tcanon"], dot(source)), read_dot),
}

# Of these no file is read: what the list says, or R's names of rows.
REFUSED = {
    "both orders": (".edgelist", both_orders, KINDS["networkx edge list"][2]),
    "R's write.table": of_r(lambda rows: '"V1" "V2"\n' + "".join(f'"{i + 1}" {" ".join(row)}\n' for i, row in enumerate(rows)), 0),
}


def mutated(rng, data):
    lines = data.split(b"\n")
    i = rng.randrange(len(lines))
    choice = rng.randrange(7)
    if choice == 0 and data:
        at = rng.randrange(len(data))
        return data[:at] + bytes([rng.choice(b"0123456789abz ,;\t\"'#%-.:{}[]()\\\n\xc3\x00")]) + data[at + 1:]
    if choice == 1:
        at = rng.randrange(len(data) + 1)
        return data[:at] + bytes([rng.choice(b"019az ,;\t\"#-.:{}[]()\n")]) + data[at:]
    if choice == 2:
        at = rng.randrange(len(data))
        return data[:at] + data[at + 1 + rng.randrange(3):]
    if choice == 3:
        return b"\n".join(lines[:i] + lines[i + 1:])
    if choice == 4:
        return b"\n".join(lines[:i] + [lines[i]] + lines[i:])
    if choice == 5:
        words = lines[i].split(b" ")
        words[rng.randrange(len(words))] = rng.choice([b"0", b"1", b"x", b"", b"1.0", b"NA", b"7", b"{}"])
        return b"\n".join(lines[:i] + [b" ".join(words)] + lines[i + 1:])
    return data[:rng.randrange(len(data) + 1)]


class Readings(unittest.TestCase):
    """What the reference and the program read of the same bytes."""

    def read(self, path):
        self.program.stdin.write(path + "\n")
        self.program.stdin.flush()
        return json.loads(self.program.stdout.readline())

    def verdict(self, kind, suffix, reference, data, marked):
        """refused, equal, alone (the reference refuses), or how the two differ.
        @param marked  what the program reads: the data with a byte order mark or other ends of lines."""
        path = f"{self.folder}/graph{suffix}"
        with open(path, "wb") as file:
            file.write(marked)
        answer = self.read(path)
        if "refused" in answer:
            self.assertEqual(answer["refused"].count("\n"), 0)
            self.message = answer["refused"]
            return "refused"
        try:
            found = reference(data)
        except Exception:  # whatever the reference says, it reads no graph
            return "alone"
        found = found if isinstance(found, list) else [found]
        if len(answer["graphs"]) != len(found):
            return f"{kind}: {len(answer['graphs'])} graphs for {len(found)}"
        for graph, wanted in zip(answer["graphs"], found):
            difference = self.difference(graph, wanted, answer["notes"], suffix)
            if difference:
                return f"{kind}: {difference}"
        return "equal"

    def difference(self, graph, found, notes, suffix):
        wanted = of_networkx(found)
        if wanted is None:
            return "read, but the reference has loops, parallel edges or arcs"
        first = 1 if any("ids are from 1" in note for note in notes) else 0
        as_read = str.strip if suffix == ".csv" else networkx.readwrite.gml.unescape if suffix == ".gml" else str
        names = [as_read(name.encode("latin1").decode(errors="surrogateescape")) for name in graph["names"]] or [str(v + first) for v in range(graph["n"])]
        edges = {frozenset((names[u], names[v])) for u, v in graph["edges"]}
        alone = set(names) - set().union(*edges, set())
        reference_alone = wanted.vertices - set().union(*wanted.edges, set())
        told = any("in no line" in note or "are names" in note or "from 1" in note for note in notes)
        if edges == wanted.edges and (alone == reference_alone or told):
            return None
        return f"{edges ^ wanted.edges} {alone ^ reference_alone}"

    def compare(self, count, seed):
        warnings.simplefilter("ignore")
        self.folder = self.enterContext(tempfile.TemporaryDirectory(dir="/dev/shm"))
        self.program = subprocess.Popen([os.environ["AR3D_READ_MANY"]], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.addCleanup(self.program.wait)
        self.addCleanup(self.program.stdin.close)
        self.addCleanup(self.program.stdout.close)
        rng = random.Random(seed)
        tally = collections.defaultdict(collections.Counter)
        different = []
        kinds = KINDS | REFUSED
        for number in range(count):
            kind = list(kinds)[number % len(kinds)]
            suffix, write, reference = kinds[kind]
            data = write(Source(rng))
            while is_header(data):
                data = write(Source(rng))
            end = b"\r\n" if rng.random() < .2 else b"\n"
            mark = b"\xef\xbb\xbf" if rng.random() < .1 else b""
            for state, text in (("written", data), ("mutated", mutated(rng, data))):
                verdict = self.verdict(kind, suffix, reference, text, mark + text.replace(b"\n", end))
                if verdict not in ("refused", "equal", "alone"):
                    different.append((verdict, state, text))
                    verdict = "different"
                tally[kind][f"{state} {verdict}"] += 1
                if os.environ.get("AR3D_SHOW") == f"{state} {verdict}":
                    print(kind, mark, end, text, getattr(self, "message", ""))
        for kind, counts in tally.items():
            print(f"{kind:34}", dict(sorted(counts.items())))
        for verdict, state, text in different[:20]:
            print(state, verdict, text)
        self.assertEqual(len(different), 0)
        for kind, counts in tally.items():
            written = sum(count for what, count in counts.items() if what.startswith("written"))
            if kind in REFUSED:
                self.assertEqual(counts["written refused"], written, kind)
            else:
                self.assertLessEqual(counts["written refused"], .02 * max(written, 50), kind)


class DifferentialReading(Readings):
    def test_a_sample_is_read_as_the_references_read_it_or_refused(self):
        self.compare(1000, 1)


class DifferentialReadingLong(Readings):
    def test_many_files_are_read_as_the_references_read_them_or_refused(self):
        self.compare(22000, int(os.environ.get("AR3D_SEED", 2)))


if __name__ == "__main__":
    import sys
    unittest.main(argv=sys.argv[:1] + sys.argv[2:])
