#!/usr/bin/env python3
"""Has a 4-regular graph a drawing with segments along (+-1, +-1, +-1) only, angles of at least
arccos(-1/3), and at most two bends (or one bend) per edge? Crossings are allowed.

    lattice_model.py GRAPH6 [--bends 1|2] [--formula orders|lengths] > formula.smt2
    z3 formula.smt2          # or: cvc5 formula.smt2

prints a formula of linear real arithmetic (SMT-LIB 2) that is satisfiable if and only if there is
one. The two formulas say the same and share no code but the reading of the graph.

The four vectors a, b, c, d = (1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1) have sum 0. A vertex
of degree 4 sends its edges along all four (it is up) or along their negatives (down). A bend turns
by at most 70.53 degrees only from +x to -y or from -x to +y with y != x. So an edge between two
vertices of one type has one bend, +x -y; between up and down it is straight, +x, or has two bends,
+x -y +z with y != x and y != z.
"""
import argparse
import itertools

LETTERS = range(4)


def read_graph6(text):
    codes = [ord(c) - 63 for c in text.strip()]
    n = codes[0]
    if not 0 <= n < 63 or any(not 0 <= c < 64 for c in codes):
        raise SystemExit(f"not graph6 with fewer than 63 vertices: {text!r}")
    bits = [code >> (5 - i) & 1 for code in codes[1:] for i in range(6)]
    pairs = [(u, v) for v in range(n) for u in range(v)]
    if len(bits) < len(pairs):
        raise SystemExit(f"too few bits for {n} vertices: {text!r}")
    edges = [pair for pair, bit in zip(pairs, bits) if bit]
    for vertex in range(n):
        if sum(vertex in edge for edge in edges) != 4:
            raise SystemExit(f"vertex {vertex} has not degree 4: {text!r}")
    return n, edges


def orders(n, edges, bends):
    """Positions as (A, B, C, D) modulo (1, 1, 1, 1); an edge is a set of comparisons of A ... D of
    v - u."""
    lines = ["(set-logic QF_LRA)"]
    for v in range(n):
        lines.append(f"(declare-const up{v} Bool)")
        lines += [f"(declare-const p{v}_{x} Real)" for x in LETTERS]
    letter = {}
    for e, (u, v) in enumerate(edges):
        for end in (u, v):
            for x in LETTERS:
                letter[e, end, x] = f"l{e}_{end}_{x}"
                lines.append(f"(declare-const {letter[e, end, x]} Bool)")
    for v in range(n):
        at = [e for e, edge in enumerate(edges) if v in edge]
        for x in LETTERS:
            lines.append("(assert (or " + " ".join(letter[e, v, x] for e in at) + "))")
            for e, f in itertools.combinations(at, 2):
                lines.append(f"(assert (not (and {letter[e, v, x]} {letter[f, v, x]})))")
        for e in at:
            for x, y in itertools.combinations(LETTERS, 2):
                lines.append(f"(assert (not (and {letter[e, v, x]} {letter[e, v, y]})))")
    # Vertex 0 is up, and its edges have their letters in order: nothing is lost.
    lines.append("(assert up0)")
    for x, e in enumerate(e for e, edge in enumerate(edges) if 0 in edge):
        lines.append(f"(assert {letter[e, 0, x]})")

    def compare(u, v, up, x, relation, w):
        """x of v - u against w of v - u, seen from an up vertex u; mirrored from a down one."""
        a, b = (u, v) if up else (v, u)
        return f"({relation} (- p{b}_{x} p{a}_{x}) (- p{b}_{w} p{a}_{w}))"

    for e, (u, v) in enumerate(edges):
        for up in (True, False):
            type_u = f"up{u}" if up else f"(not up{u})"
            same, other = (f"up{v}", f"(not up{v})") if up else (f"(not up{v})", f"up{v}")
            for x, y in itertools.product(LETTERS, repeat=2):
                ends = f"{letter[e, u, x]} {letter[e, v, y]}"
                rest = [w for w in LETTERS if w not in (x, y)]
                if x == y:
                    lines.append(f"(assert (not (and {type_u} {same} {ends})))")
                else:
                    w, t = rest
                    facts = [compare(u, v, up, x, ">", w), compare(u, v, up, w, "=", t),
                             compare(u, v, up, w, ">", y)]
                    lines.append(f"(assert (=> (and {type_u} {same} {ends}) (and {' '.join(facts)})))")
                words = []
                if bends == 2:
                    for middle in rest:
                        base = [w for w in rest if w != middle]
                        facts = [compare(u, v, up, base[0], "=", w) for w in base[1:]]
                        facts += [compare(u, v, up, end, ">", base[0]) for end in {x, y}]
                        words.append("(and " + " ".join(
                            facts + [compare(u, v, up, base[0], ">", middle)]) + ")")
                if x == y:
                    words.append("(and " + " ".join(
                        [compare(u, v, up, x, ">", rest[0])] +
                        [compare(u, v, up, rest[0], "=", w) for w in rest[1:]]) + ")")
                words = f"(or {' '.join(words)})" if words else "false"
                lines.append(f"(assert (=> (and {type_u} {other} {ends}) {words}))")
    return lines


def lengths(n, edges, bends):
    """Positions in space, a letter as a number, an edge as its word and the lengths of its
    segments."""
    vectors = ((1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1))
    text = ["(set-logic ALL)"]
    for v in range(n):
        text.append(f"(declare-const sign{v} Bool)")  # true: along the vectors, false: against
        for axis in "xyz":
            text.append(f"(declare-const {axis}{v} Real)")
    incident = [[i for i, edge in enumerate(edges) if v in edge] for v in range(n)]
    for v in range(n):
        for i in incident[v]:
            text.append(f"(declare-const d{v}e{i} Int)")
            text.append(f"(assert (and (<= 0 d{v}e{i}) (<= d{v}e{i} 3)))")
        text.append(f"(assert (distinct {' '.join(f'd{v}e{i}' for i in incident[v])}))")
    text.append("(assert sign0)")
    text += [f"(assert (= d0e{i} {k}))" for k, i in enumerate(incident[0])]

    def runs(u, v, i, word):
        """v = u + the vectors of the word times positive lengths s, t, r."""
        sums = []
        for k, axis in enumerate("xyz"):
            terms = [f"(* {sign * vectors[d][k]}.0 {name}{i})".replace("-1.0", "(- 1.0)")
                     for (sign, d), name in zip(word, "str")]
            sums.append(f"(= {axis}{v} (+ {axis}{u} {' '.join(terms)}))")
        used = "str"[:len(word)]
        return "(and " + " ".join(sums + [f"(>= {name}{i} 1.0)" for name in used]) + ")"

    for i, (u, v) in enumerate(edges):
        text += [f"(declare-const {name}{i} Real)" for name in "str"]
        choices = []
        for sign in (1, -1):
            at_u = f"sign{u}" if sign > 0 else f"(not sign{u})"
            at_v = {1: f"sign{v}", -1: f"(not sign{v})"}
            for first in range(4):
                for last in range(4):
                    head = f"(= d{u}e{i} {first}) (= d{v}e{i} {last}) {at_u}"
                    if first != last:
                        word = ((sign, first), (-sign, last))
                        choices.append(f"(and {head} {at_v[sign]} {runs(u, v, i, word)})")
                    else:
                        word = ((sign, first),)
                        choices.append(f"(and {head} {at_v[-sign]} {runs(u, v, i, word)})")
                    for middle in set(range(4)) - {first, last} if bends == 2 else ():
                        word = ((sign, first), (-sign, middle), (sign, last))
                        choices.append(f"(and {head} {at_v[-sign]} {runs(u, v, i, word)})")
        text.append("(assert (or " + "\n  ".join(choices) + "))")
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("graph6")
    parser.add_argument("--bends", type=int, choices=(1, 2), default=2)
    parser.add_argument("--formula", choices=("orders", "lengths"), default="orders")
    options = parser.parse_args()
    n, edges = read_graph6(options.graph6)
    formula = orders if options.formula == "orders" else lengths
    print("\n".join(formula(n, edges, options.bends)))
    print("(check-sat)")


if __name__ == "__main__":
    main()
