#!/usr/bin/env python3
"""Has a 4-regular graph a drawing with segments along (+-1, +-1, +-1) only, angles of at least
arccos(-1/3), and at most two bends (or one bend) per edge? Crossings are allowed.

    lattice_lengths.py GRAPH6 [--bends 1|2] > formula.smt2
    z3 formula.smt2          # or: cvc5 formula.smt2

prints a formula of linear real arithmetic (SMT-LIB 2) that is satisfiable if and only if there is
one: positions in space, a direction at each end of an edge, an edge as its word of directions and
the lengths of its segments. Nothing is worked out by hand: which directions may meet at a vertex,
which may follow one another, and which words an edge may have are found by trying all, by inner
products. Shares only the reading of graph6 with lattice_orders.py.
"""
import argparse
import itertools
import sys

sys.dont_write_bytecode = True  # the import leaves nothing beside the scripts

from lattice_orders import read_graph6

DIRECTIONS = tuple(itertools.product((1, -1), repeat=3))


def dot(p, q):
    return sum(a * b for a, b in zip(p, q))


def wide(i, j):
    """The angle between two directions is at least arccos(-1/3); their squared length is 3."""
    return dot(DIRECTIONS[i], DIRECTIONS[j]) <= -1


def opposite(i):
    return DIRECTIONS.index(tuple(-c for c in DIRECTIONS[i]))


def all_words(bends):
    """The directions of the segments of an edge. Equal ones in turn would be one segment."""
    words = (w for k in range(1, bends + 2) for w in itertools.product(range(8), repeat=k))
    return [w for w in words if all(a != b and wide(opposite(a), b) for a, b in zip(w, w[1:]))]


def all_stars():
    """The directions of the four edges of a vertex, in all orders."""
    return [s for s in itertools.product(range(8), repeat=4)
            if all(wide(i, j) for i, j in itertools.combinations(s, 2))]


def images(star):
    """Of the directions of the star under the symmetries of the cube."""
    for order in itertools.permutations(range(3)):
        for signs in itertools.product((1, -1), repeat=3):
            yield tuple(DIRECTIONS.index(tuple(s * DIRECTIONS[i][k] for s, k in zip(signs, order)))
                        for i in star)


def formula(n, edges, bends):
    stars = all_stars()
    # Any star of vertex 0 can be turned into any other, so it may be the first one.
    assert set(images(stars[0])) == set(stars)
    text = ["(set-logic ALL)"]
    incident = [[i for i, edge in enumerate(edges) if v in edge] for v in range(n)]

    def leaves(v, i, direction):
        return f"d{v}e{i}_{direction}"

    for v in range(n):
        text += [f"(declare-const {axis}{v} Real)" for axis in "xyz"]
        for i in incident[v]:
            text += [f"(declare-const {leaves(v, i, k)} Bool)" for k in range(8)]
            text.append("(assert (or " + " ".join(leaves(v, i, k) for k in range(8)) + "))")
            for k, l in itertools.combinations(range(8), 2):
                text.append(f"(assert (not (and {leaves(v, i, k)} {leaves(v, i, l)})))")
        for i, j in itertools.combinations(incident[v], 2):
            for k, l in itertools.product(range(8), repeat=2):
                if not wide(k, l):
                    text.append(f"(assert (not (and {leaves(v, i, k)} {leaves(v, j, l)})))")
    text += [f"(assert {leaves(0, i, k)})" for i, k in zip(incident[0], stars[0])]
    words = all_words(bends)
    for i, (u, v) in enumerate(edges):
        lengths = [f"l{i}_{k}" for k in range(bends + 1)]
        text += [f"(declare-const {length} Real)" for length in lengths]
        choices = []
        for word in words:
            ends = [leaves(u, i, word[0]), leaves(v, i, opposite(word[-1]))]
            used = lengths[:len(word)]
            sums = []
            for k, axis in enumerate("xyz"):
                terms = [length if DIRECTIONS[d][k] > 0 else f"(- {length})"
                         for d, length in zip(word, used)]
                sums.append(f"(= {axis}{v} (+ {axis}{u} {' '.join(terms)}))")
            choices.append("(and " + " ".join(ends + sums + [f"(>= {x} 1)" for x in used]) + ")")
        text.append("(assert (or " + "\n  ".join(choices) + "))")
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("graph6")
    parser.add_argument("--bends", type=int, choices=(1, 2), default=2)
    options = parser.parse_args()
    print("\n".join(formula(*read_graph6(options.graph6), options.bends)))
    print("(check-sat)")


if __name__ == "__main__":
    main()
