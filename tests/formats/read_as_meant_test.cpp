// Files as people have them, after bug reports of networkx, igraph, Graphviz, Gephi, pandas and R: each
// is read as its writer meant, with a note of what was assumed, or refused with line, column, value
// and what to do. All refusals of lists and of what is no graph stand in the table here.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "formats/format_helpers.h"

namespace ar3d::testing {
namespace {

struct MeantFile {
  const char* name;
  std::string text;
  std::string meant;  ///< graphs as "n m", with " / " between them, and notes behind " | "
  ReadOptions options = {};
};

std::string reading_of(const MeantFile& file) {
  std::vector<std::string> graphs, notes;
  try {
    GraphReader reader(TextInput(file.name, bytes_of(file.text)), file.options);
    while (const std::optional<Graph> graph = reader.next()) {
      graphs.push_back(fmt::format("{} {}", graph->num_vertices(), graph->num_edges()));
    }
    notes = reader.take_notes();
  } catch (const InputError& error) {
    return error.what();
  }
  std::string text = fmt::format("{}", fmt::join(graphs, " / "));
  for (const std::string& note : notes) text += " | " + note;
  return text;
}

const std::vector<MeantFile> kFiles = {
    {"comma-nodes.dot", "graph { a, b -- c }\n", "3 2"},
    {"backslash-label.dot", "graph { a [label=\"\\\\\"]; b; a -- b; }\n", "2 1"},
    {"backslash-name.dot", "graph { \"C:\\\\x\\\\\" -- b; c -- d }\n", "4 2"},
    {"exponent.gml", "graph [ node [ id 0 x 1e+05 ] node [ id 1 ] edge [ source 0 target 1 ] ]\n",
     "2 1"},
    {"plus-sign.gml",
     "graph [ node [ id 0 x +1.5 ] node [ id 1 ] edge [ source 0 target 1 weight +2 ] ]\n", "2 1"},
    {"creator-tab.gml",
     "Creator\t\"yFiles\"\nVersion\t\"2.18\"\ngraph\n[\n\tdirected\t0\n\tnode\n\t[\n\t\tid\t0\n\t]"
     "\n\tnode\n\t[\n\t\tid\t1\n\t]\n\tedge\n\t[\n\t\tsource\t0\n\t\ttarget\t1\n\t]\n]\n",
     "2 1"},
    {"other-first-key.gml",
     "comment \"by hand\"\ngraph [ node [ id 0 ] node [ id 1 ] edge [ source 0 target 1 ] ]\n",
     "2 1"},
    {"upper-case.gml", "graph [ Node [ id 0 ] Node [ id 1 ] Edge [ source 0 target 1 ] ]\n", "2 1"},
    {"empty-target.csv", "source,target,weight\na,,3\nb,c,4\n",
     "empty-target.csv:2:3: an end of an edge is missing"},
    {"empty-target-numbers.csv", "source,target,weight\n0,,3\n1,2,4\n",
     "empty-target-numbers.csv:2:3: an end of an edge is missing"},
    {"row-names.csv", "\"\",\"from\",\"to\"\n\"1\",0,1\n\"2\",1,2\n\"3\",2,3\n",
     "4 3 | row-names.csv:1: 'from to' is a heading, no edge"},
    {"heading-other.csv", "\"V1\",\"V2\"\n1,2\n2,3\n",
     "3 2 | heading-other.csv:1: 'V1 V2' is a heading, no edge | heading-other.csv: ids are from 1 "
     "to 3"},
    {"heading-u-v.edgelist", "u v\n0 1\n1 2\n",
     "3 2 | heading-u-v.edgelist:1: 'u v' is a heading, no edge"},
    {"heading-tab.edgelist", "source\ttarget\na\tb\nb\tc\n",
     "3 2 | heading-tab.edgelist:1: 'source target' is a heading, no edge"},
    {"float-column.csv", "source,target\n0.0,1\n1.0,2\n2.0,0\n",
     "float-column.csv:2:1: expected a vertex id, found '0.0': ids are whole numbers, without sign "
     "or zeros in front (in quotes it is a name)"},
    {"vertex-n.edgelist", "n 1\nn 2\nn 3\n", "4 3"},
    {"letters.adjlist", "# a comment\n# GMT x\n# y\nm n\nn o\no\n", "3 2"},
    {"colon-name.adjlist", "# GMT x\n# y\nx:1 x:2\nx:2\n", "2 1"},
    {"lfs-pointer.edgelist",
     "version https://git-lfs.github.com/spec/v1\noid sha256:0a1b\nsize 12345\n",
     "lfs-pointer.edgelist:1: this is a pointer of git-lfs, which is not read; `git lfs pull` "
     "fetches the file"},
    {"not-found.edgelist", "Not Found",
     "not-found.edgelist:1: 'Not Found' alone may be a message and no edge: --from edgelist reads "
     "it as one"},
    {"numeric-labels.tgf", "1 10\n2 20\n3 30\n#\n1 2\n2 3\n",
     "numeric-labels.tgf:1: this is Trivial Graph Format by its ending, which is not read; write "
     "its edges, behind the line '#', as a list"},
    {"weighted.lgl", "# 0\n1 5\n2 7\n# 1\n2 4\n",
     "weighted.lgl:1: this is LGL by its ending, which is not read; igraph reads it: "
     "Graph.Read_Lgl(FILE).write_graphml(OUTPUT)"},
    {"from-one.lst", "1: 2 3\n2: 1 3\n3: 1 2\n", "3 3 | from-one.lst: ids are from 1 to 3"},
    {"konect.txt", "% sym unweighted\n% 4 5 5\n1 2\n2 3\n3 4\n4 5\n",
     "5 4 | konect.txt:2: ids are from 1 to 5"},
    {"igraph.ncol", "1 10\n10 2\n", "3 2"},
    {"snap-isolated.txt", "# Nodes: 6 Edges: 3\n0\t1\n1\t2\n2\t3\n",
     "6 3 | snap-isolated.txt:1: 2 of 6 vertices are in no line"},
    {"vertices-written-otherwise.edges", "#vertices 5\n0 1\n",
     "5 1 | vertices-written-otherwise.edges:1: 3 of 5 vertices are in no line"},
    {"two-lists-blank-line.lst", "1: 2\n2: 1\n3:\n\n1: 3\n2:\n3: 1\n",
     "two-lists-blank-line.lst:5:1: a second line of this vertex, after line 1: a file of several "
     "graphs has '# vertices N' before each"},
    {"pairs-in-parentheses.edges", "(0, 1)\n(1, 2)\n",
     "pairs-in-parentheses.edges:1:1: '(0' is a piece of a printed list or tuple: an edge is 'u v' "
     "or 'u,v'"},
    {"tuple-names.edgelist", "(0, 0),(0, 1)\n(0, 1),(0, 2)\n",
     "tuple-names.edgelist:1: 4 columns and no heading that says which two are the ends of edges: "
     "'source' and 'target' do"},
    {"cycle-header.txt",
     "5 5\n1 2\n2 3\n3 4\n4 5\n5 1\n",
     "5 5 | cycle-header.txt:1: '5 5' is a header: vertices and edges",
     {.base = 1, .first_line = FirstLine::header}},
    {"told-edge-list.txt",
     "6 6\n2 6\n1 3\n2 4\n3 5\n4 6\n1 5\n",
     "6 6 | told-edge-list.txt:1: '6 6' is a header: vertices and edges",
     {.base = 1, .first_line = FirstLine::header}},
    {"metis-asked-for-header.graph", "7 6\n2 6\n1 3\n2 4\n3 5\n4 6\n1 5\n\n", "7 6"},
    {"gephi.csv",
     "Source,Target,Type,Id,Label,timeset,Weight\n0,1,Undirected,0,,,1.0\n1,2,Undirected,1,,,1.0\n",
     "3 2 | gephi.csv:1: 'Source Target' is a heading, no edge"},
    {"weight-that-is-none.edgelist", "alice bob 3x7\nbob eve 12:30\n",
     "weight-that-is-none.edgelist:1:11: unexpected '3x7' after the edge"},
    {"two-headers.g6", ">>graph6<<C~\n>>graph6<<D~{\n", "4 6 / 5 10"},
    {"hash-first.dot", "# by hand\ngraph { a -- b }\n", "2 1"},
    {"truncated.edges.bz2", "BZh91AY&SY\001",
     "truncated.edges.bz2:1: this is packed by bzip2, which is not read; `bunzip2` unpacks it"},
    {"blank-behind-comma.edges", "source, target\n0, 1\n1, 2\n",
     "3 2 | blank-behind-comma.edges:1: 'source target' is a heading, no edge"},
    {"blank-before-comma.edges", "a ,b\nb ,c\n", "3 2"},
    {"tab-behind-semicolon.edges", "a;\tb\nb;\tc\n", "3 2"},
    {"quoted-heading.txt", "\"source\", \"target\"\n\"0\", \"1\"\n\"1\", \"2\"\n",
     "3 2 | quoted-heading.txt:1: 'source target' is a heading, no edge"},
    {"comma-or-blank.edges", "a,b c\nb c,d\n",
     "comma-or-blank.edges:1: 'a,b c' can be cut at ',' and at blanks: names in quotes tell"},
    {"semicolon-or-comma.edges", "a;b,c\nb;d,e\n",
     "semicolon-or-comma.edges:1: 'a;b,c' can be cut at ';' and at ',': names in quotes tell"},
    {"decimal-comma.csv", "0;1;0,5\n1;2;0,7\n", "3 2"},
    {"blanks-in-names.tsv", "source\ttarget\nx y\tz, w\nz, w\tv\n",
     "3 2 | blanks-in-names.tsv:1: 'source target' is a heading, no edge"},
    {"dictionary.edgelist", "0 1 {'a': 1, 'b': 2}\n1 2 {}\n", "3 2"},
    {"dictionary.csv", "0,1,{'a': 1, 'b': 2}\n1,2,{}\n", "3 2"},
    {"field-missing.csv", "source,target,weight\na,b,1\nb,c\n",
     "field-missing.csv:3: 2 fields, but 3 in the first row"},
    {"four-columns.csv", "0,1,2,3\n1,2,3,4\n",
     "four-columns.csv:1: 4 columns and no heading that says which two are the ends of edges: "
     "'source' and 'target' do"},
    {"behind-quote.csv", "source,target\n\"a\"x,b\n",
     "behind-quote.csv:2:4: 'x,b' behind a closing quote: a quote in a name is written \"\""},
    {"no-end-quote.csv", "source,target\n\"a,b\n", "no-end-quote.csv:2:1: no quote ends '\"a,b'"},
    {"missing.csv", "source,target\na,NA\n",
     "missing.csv:2:3: 'NA' for an end of an edge says that it is missing (in quotes it is a "
     "name)"},
    {"directed.csv", "Source,Target,Type\n0,1,Directed\n",
     "directed.csv:2:5: directed edges are not read (--undirected drops directions)"},
    {"nodes.csv", "Id,Label\n0,a\n1,b\n",
     "nodes.csv:1: 'Id Label' may be a heading or an edge: no other line has one of these names; "
     "--first-line header or --first-line edge says which (in a study the keys base and "
     "first_line)"},
    {"row-names-of-r.edges", "\"1\" 0 1\n\"2\" 1 2\n",
     "row-names-of-r.edges:1:1: \"1\" may be the name of a row and no end of an edge: a heading "
     "'source' and 'target' tells"},
    {"row-names-below-heading.edges", "from to\n1 0 1\n2 1 2\n",
     "row-names-below-heading.edges:1: a heading of 2 fields above rows of 3: are these names of "
     "rows (R's row.names = FALSE leaves them out)?"},
    {"row-numbers.csv", "0,1,2\n1,2,3\n",
     "row-numbers.csv:2: the first of three columns may count the rows or be an end of an edge: a "
     "heading such as 'source target weight' tells"},
    {"weight-missing.csv", "0,1,5\n1,2,\n", "3 2"},
    {"heading-in-names.edges", "person friend\nalice bob\nbob carol\n",
     "heading-in-names.edges:1: 'person friend' may be a heading or an edge: no other line has one "
     "of these names; --first-line header or --first-line edge says which (in a study the keys "
     "base and first_line)"},
    {"heading-in-names.edges",
     "person friend\nalice bob\nbob carol\n",
     "3 2 | heading-in-names.edges:1: 'person friend' is a heading, no edge",
     {.first_line = FirstLine::header}},
    {"heading-in-names.edges",
     "person friend\nalice bob\nbob carol\n",
     "5 3",
     {.first_line = FirstLine::edge}},
    {"known-heading-in-names.edges", "from to\nalice bob\nbob carol\n",
     "3 2 | known-heading-in-names.edges:1: 'from to' is a heading, no edge"},
    {"edge-like-a-heading.edges", "u v\nv w\nw u\n", "3 3"},
    {"snap-heading.txt", "# FromNodeId\tToNodeId\n0\t1\n1\t2\n", "3 2"},
    {"FromNodeId.edges", "FromNodeId ToNodeId\n0 1\n1 2\n",
     "3 2 | FromNodeId.edges:1: 'FromNodeId ToNodeId' is a heading, no edge"},
    {"V1-V2.edges",
     "V1 V2\n1 2\n2 3\n",
     "3 2 | V1-V2.edges:1: 'V1 V2' is a heading, no edge",
     {.base = 1}},
    {"error-page.edgelist", "Error 404\nPage missing\n",
     "error-page.edgelist:1: 'Error 404' may be a heading or an edge: no other line has one of "
     "these names; --first-line header or --first-line edge says which (in a study the keys base "
     "and first_line)"},
    {"two-words.edgelist", "Not Found", "2 1", {.format = "edgelist"}},
    {"number-in-names.edges", "alice bob\nbob 7\n7 alice\n", "3 3"},
    {"name-in-numbers.edges", "7 alice\n7 8\nalice 8\n",
     "3 3 | name-in-numbers.edges:3: ids are names, as 'alice' is no number"},
    {"name-behind-numbers.edges", "0 1\n1 x\nx 0\n",
     "3 3 | name-behind-numbers.edges:2: ids are names, as 'x' is no number"},
    {"name-behind-numbers.txt", "0 1\n1 x\n",
     "name-behind-numbers.txt:2:3: expected a vertex id, found 'x'"},
    {"exponent.edges", "100000 1e+05\n",
     "exponent.edges:1:8: expected a vertex id, found '1e+05': ids are whole numbers, without sign "
     "or zeros in front (in quotes it is a name)"},
    {"leading-zeros.edges", "007 7\n7 8\n",
     "leading-zeros.edges:1:1: expected a vertex id, found '007': ids are whole numbers, without "
     "sign or zeros in front (in quotes it is a name)"},
    {"trailing-comma.edges", "a b\nb, c\n",
     "trailing-comma.edges:2:1: 'b,' may be a name or not all of it be one: quotes tell"},
    {"hash-in-name.edges", "a b\nb c#d\n",
     "hash-in-name.edges:2:3: 'c#d' may be a name or not all of it be one: quotes tell"},
    {"comment-or-name.edges", "a b\nb c\n#c d\n",
     "comment-or-name.edges:3:1: '#c d' is a comment or begins with a name: a blank behind the # "
     "or quotes tell"},
    {"tuple.edgelist", "(0, 0) (0, 1) {}\n(0, 1) (0, 2) {}\n",
     "tuple.edgelist:1:12: unexpected '1) {}' after the edge"},
    {"list-of-pairs.edges", "[0, 1]\n[1, 2]\n",
     "list-of-pairs.edges:1: this is JSON, which is not read; write an edge as 'u v' on a line"},
    {"one-id.edges", "0 1\n2\n",
     "one-id.edges:2: expected two ends of an edge, found the end of the line"},
    {"ids-from-one.edges", "1 2\n2 3\n3 1\n", "3 3 | ids-from-one.edges: ids are from 1 to 3"},
    {"ids-from-one.edges", "1 2\n2 3\n3 1\n", "3 3", {.base = 1}},
    {"ids-from-one.edges",
     "1 2\n2 3\n3 1\n",
     "4 3 | ids-from-one.edges: 1 of 4 vertices are in no line",
     {.base = 0}},
    {"gaps.edges", "1000000 1000001\n",
     "2 1 | gaps.edges: ids up to 1000001 are names: as numbers they would leave most vertices "
     "without an edge"},
    {"one-gap.edges", "0 1\n1 3\n", "4 2 | one-gap.edges: 1 of 4 vertices are in no line"},
    {"large-ids.edges", "0 99999999999999999999\n",
     "2 1 | large-ids.edges:1: ids are names, as '99999999999999999999' is no 32-bit number"},
    {"64-bit-ids.edges",
     "0 99999999999999999999\n",
     "64-bit-ids.edges:1:3: a vertex id '99999999999999999999' does not fit 64 bits",
     {.base = 0}},
    {"counts-from-one.edges", "# 3 nodes, 3 edges\n1 2\n2 3\n3 1\n",
     "3 3 | counts-from-one.edges:1: ids are from 1 to 3"},
    {"edges-stated.edges", "# Nodes: 4 Edges: 4\n0 1\n1 2\n2 3\n",
     "edges-stated.edges:1: 4 edges stated, found 3 lines of edges"},
    {"nodes-stated.edges", "# Nodes: 4 Edges: 3\n0 1\n1 2\n2 4\n",
     "4 3 | nodes-stated.edges:1: ids up to 4 of 4 vertices are names"},
    {"nodes-with-gaps.txt", "# Nodes: 3 Edges: 2\n5\t7\n7\t90\n",
     "3 2 | nodes-with-gaps.txt:1: ids up to 90 of 3 vertices are names"},
    {"nodes-either-way.txt", "# Nodes: 5 Edges: 2\n1\t2\n2\t4\n",
     "nodes-either-way.txt:3: no line names vertex 0, nor some others: --base 1 reads ids from 1, "
     "--base 0 keeps a vertex 0 without an edge (in a study the key base)"},
    {"nodes-of-names.edges", "# nodes: 4\na b\nb c\n",
     "nodes-of-names.edges:1: 4 vertices stated, but the edges have 3 names"},
    {"bipartite.txt", "% bip unweighted\n1 2\n",
     "bipartite.txt:1: a bipartite list of KONECT counts each side from 1: write the ids of the "
     "second side behind those of the first"},
    {"asymmetric.txt", "% asym unweighted\n1 2\n",
     "asymmetric.txt:1: directed edges are not read (--undirected drops directions)"},
    {"from-one.edges", "# vertices 3 from 1\n1 2\n2 3\n", "3 2"},
    {"from-one.edges",
     "# vertices 3 from 1\n1 2\n2 3\n",
     "from-one.edges:1: ids are from 1, but --base is 0",
     {.base = 0}},
    {"header-from-one.edges", "3 3\n1 2\n2 3\n3 1\n",
     "3 3 | header-from-one.edges:1: '3 3' is a header: vertices and edges | "
     "header-from-one.edges:1: ids are from 1 to 3"},
    {"header-or-edge.edges", "5 3\n1 2\n2 3\n4 5\n",
     "header-or-edge.edges:1: '5 3' may be an edge, or the header of a graph with 5 vertices and 3 "
     "edges: --base 1 --first-line edge or --base 1 --first-line header says which (in a study the "
     "keys base and first_line)"},
    {"pentagram.txt", "5 5\n2 5\n1 3\n2 4\n3 5\n1 4\n",
     "pentagram.txt:1: this may be METIS or an edge list: --from metis or --from edgelist says "
     "which"},
    {"cut-short.lst", "1: 2 3\n2: 1 3\n",
     "cut-short.lst:1: 3 is a neighbour without a line of its own: is the list cut short? A line "
     "of it alone adds it"},
    {"cut-short.adjlist", "# GMT x\na b c\nb c\n",
     "cut-short.adjlist:2: 'c' is a neighbour without a line of its own: is the list cut short? A "
     "line of it alone adds it"},
    {"line-stated.lst", "# vertices 3\n0: 1\n1: 0\n",
     "line-stated.lst:1: 3 vertices stated, 2 have a line: is the list cut short?"},
    {"some-at-both-ends.lst", "0: 1 2\n1: 0\n2:\n",
     "some-at-both-ends.lst:1: (0, 2) stands at one of its ends, others at both: all edges stand "
     "at one, or all at both"},
    {"gaps.lst", "5: 9\n9: 5 12\n12: 9\n",
     "3 2 | gaps.lst: ids up to 12 of 3 vertices have gaps: they are names"},
    {"from-one.lst",
     "1: 2\n2: 1\n",
     "from-one.lst:2: the lines are not those of vertices 0 to 1",
     {.base = 0}},
    {"multiline.adjlist", "# GMT x\na 1\nb {}\nb 0\n",
     "multiline.adjlist:3:3: '{}' is no name of a list of networkx"},
    {"words.adjlist", "x y\ny\n", "2 1"},
    {"tgf.txt", "1 10\n2 20\n#\n1 2\n",
     "tgf.txt:3: a line '#' between rows: this is Trivial Graph Format (TGF), which is not read, "
     "or an empty comment; --from edgelist reads it as an edge list"},
    {"lgl.txt", "# 0\n1 5\n# 1\n2 4\n",
     "lgl.txt:3: a second line such as '# 1': this is LGL, which is not read; igraph makes GraphML "
     "of it: Graph.Read_Lgl(FILE).write_graphml(OUTPUT)"},
    {"graph.tgf", "1 a\n2 b\n#\n1 2\n",
     "graph.tgf:1: this is Trivial Graph Format by its ending, which is not read; write its edges, "
     "behind the line '#', as a list"},
    {"page.edgelist", "<!DOCTYPE html>\n<html></html>\n",
     "page.edgelist:1: this is a page of HTML, which is not read; save the file itself"},
    {"page.txt", "<html><body>\n",
     "page.txt:1: this is a page of HTML, which is not read; save the file itself"},
    {"graph.json", "{\"nodes\": []}\n",
     "graph.json:1: this is JSON, which is not read; networkx reads it: "
     "node_link_graph(json.load(FILE)), then write_graphml"},
    {"matrix.txt", "[[0, 1], [1, 0]]\n",
     "matrix.txt:1: this is JSON, which is not read; write an edge as 'u v' on a line"},
    {"graph.net", "% by hand\n*vertices 3\n",
     "graph.net:1: this is Pajek, which is not read; examples/convert.py makes GraphML of it: "
     "networkx.write_graphml(networkx.Graph(networkx.read_pajek(FILE)), OUTPUT)"},
    {"graph.dl", "dl n = 5\n",
     "graph.dl:1: this is UCINET's DL, which is not read; igraph reads it: "
     "Graph.Read_DL(FILE).write_graphml(OUTPUT)"},
    {"graph.gdf", "nodedef>name VARCHAR\n",
     "graph.gdf:1: this is GDF, which is not read; Gephi exports it as GraphML"},
    {"graph.lgr", "LEDA.GRAPH\n",
     "graph.lgr:1: this is LEDA, which is not read; networkx reads it: read_leda(FILE), then "
     "write_graphml"},
    {"shown.txt", "Graph 1, order 3.\n  0 : 1;\n",
     "shown.txt:1: this is text of nauty's showg, which is not read; write the graphs as graph6 "
     "(geng, copyg)"},
    {"graph.gexf", "<?xml version=\"1.0\"?>\n<gexf></gexf>\n",
     "graph.gexf:1: this is GEXF, which is not read; examples/convert.py makes GraphML of it: "
     "networkx.write_graphml(networkx.Graph(networkx.read_gexf(FILE)), OUTPUT)"},
    {"packed.zip", "PK\003\004",
     "packed.zip:1: this is a zip archive (also .npz, .xlsx, .docx), which is not read; unzip it"},
    {"packed.zst", "(\265/\375",
     "packed.zst:1: this is packed by zstd, which is not read; `zstd -d` unpacks it"},
    {"comment-in-a-name.edgelist", "a\tb\nz#c\td\n",
     "comment-in-a-name.edgelist:2:1: 'z#c' may be a name or not all of it be one: quotes tell"},
    {"lost-line-break.ncol", "2 3,0 1\n",
     "lost-line-break.ncol:1:1: '2 3' is several numbers: a line break may be missing"},
    {"heading-twice.csv", "\xef\xbb\xbfSource;Target\n\xef\xbb\xbfSource;Target\n1;2\n",
     "heading-twice.csv:2:1: a byte order mark is in a name"},
    {"results.h5", "\211HDF\r\n",
     "results.h5: results (HDF5), no graph and no drawing; `ar3d replay results.h5 --keep all -o "
     "drawings.jsonl` writes their drawings"},
    {"paper.pdf", "%PDF-1.4\n",
     "paper.pdf:1: this is a PDF, which is not read; save the graph itself"},
    {"image.png", "\211PNG\r\n",
     "image.png:1: this is a picture (PNG), which is not read; save the graph itself"},
    {"edges.parquet", "PAR1x",
     "edges.parquet:1: this is Parquet, which is not read; pandas makes CSV of it: "
     "read_parquet(FILE).to_csv(OUTPUT)"},
    {"comment.g6", "# by hand\nC~\n", "4 6"},
    {"names-c.edges", "c d\nd e\ne c\n", "3 3"},
    {"names-p.edges", "p q\nq r\n", "3 2"},
    {"graph6.edges", "C~\n", "4 6"},
    {"one-word.edges", "hello\n",
     "one-word.edges:1:2: 41 vertices take 137 characters after the size, found 4"},
    {"hash.dot", "graph { a # -- c\n -- b }\n", "2 1"},
    {"subgraph-again.dot", "graph { subgraph s {c d} subgraph s {} -- a }", "3 2"},
    {"html.dot", "graph { <a> -- a }", "2 1"},
    {"digits.dot", "graph { 1a -- b }",
     "digits.dot:1:9: '1a' is no number: other names that begin with a digit stand in quotes"},
    {"two-tokens.dot", "graph { a-1 }", "2 0"},
    {"keyword.dot", "graph { node -- b }", "keyword.dot:1:14: expected [, found '--'"},
    {"attribute.dot", "graph { a [bold] }", "attribute.dot:1:16: expected =, found ']'"},
    {"second-id.gml", "graph [ node [ id 0 id 1 ] ]", "second-id.gml:1:21: a second 'id'"},
};

TEST(FilesAsPeopleHaveThem, AreReadAsMeantOrRefused) {
  for (const MeantFile& file : kFiles) {
    EXPECT_EQ(reading_of(file), file.meant) << file.name << ":\n" << file.text;
  }
}

TEST(FilesAsPeopleHaveThem, AreRefusedInOneLineThatNamesTheFile) {
  for (const MeantFile& file : kFiles) {
    EXPECT_EQ(std::ranges::count(file.meant, '\n'), 0) << file.meant;
    const bool is_read = file.meant[0] < ':' && file.meant.find(' ') < 3;
    EXPECT_TRUE(is_read || file.meant.starts_with(std::string(file.name) + ":")) << file.meant;
  }
}

}  // namespace
}  // namespace ar3d::testing
