#!/usr/bin/env python3
"""Has a 4-regular graph a drawing with segments along (+-1, +-1, +-1) only, angles of at least
arccos(-1/3), and at most two bends (or one bend) per edge? Crossings are allowed.

    lattice_orders.py GRAPH6 [--bends 1|2] > formula.smt2
    z3 formula.smt2          # or: cvc5 formula.smt2

prints a formula of linear real arithmetic (SMT-LIB 2) that is satisfiable if and only if there is
one. lattice_lengths.py writes another formula that says the same.

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


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("graph6")
    parser.add_argument("--bends", type=int, choices=(1, 2), default=2)
    options = parser.parse_args()
    print("\n".join(orders(*read_graph6(options.graph6), options.bends)))
    print("(check-sat)")


if __name__ == "__main__":
    main()
